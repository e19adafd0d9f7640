/*
 * halfvector.h - models in terms of the half vector: what they need of it, and sampling it.
 *
 * The half vector is kept as the sum wo + wi, which is the same to the last bit for (wi, wo), and
 * angles as what keeps its digits near 0: narrow lobes live there, and a cosine near 1 has lost
 * them.
 */
#ifndef BRDF_HALFVECTOR_H
#define BRDF_HALFVECTOR_H

#include "math.h"
#include "vec.h"

struct brdf_half {
    brdf_vec3 sum;    /* wo + wi; its z is cos(wo) + cos(wi) */
    brdf_real square; /* |wo + wi|^2 = 4 cos^2 of the angle between h and wo, which is that
                         between h and wi; not below 1e-18 */
    brdf_real z2;     /* sum.z^2, not below 1e-18 */
    brdf_real tan2;   /* squared tangent of the angle between h and the normal, at most 1e12 */
};

static inline struct brdf_half brdf_half_make(brdf_vec3 wo, brdf_vec3 wi)
{
    struct brdf_half h;
    h.sum = brdf_add(wo, wi);
    h.square = brdf_max(brdf_dot(h.sum, h.sum), 1e-18f);
    h.z2 = brdf_max(h.sum.z * h.sum.z, 1e-18f);
    h.tan2 = brdf_min((h.sum.x * h.sum.x + h.sum.y * h.sum.y) / h.z2, 1e12f);
    return h;
}

/* The cosine of the angle between h and wo or wi: the same bits for both. */
static inline brdf_real brdf_half_cosine(struct brdf_half h)
{
    return brdf_min(0.5f * sqrtf(h.square), 1.0f);
}

/* Density [1/sr] of wi where h has the density `density` [Walter et al. 2007, eq. 14]. */
static inline brdf_real brdf_half_pdf(struct brdf_half h, brdf_real density)
{
    return density / (2.0f * sqrtf(h.square));
}

/*
 * log(1 + x) for 0 <= x <= 1e30 with all its digits: the logarithm of the rounded sum, corrected
 * by the ratio of x to what of it is left in the sum [Goldberg 1991, theorem 4].
 */
static inline brdf_real brdf_log_1_plus(brdf_real x)
{
    brdf_real sum = 1.0f + x;
    brdf_real left = sum - 1.0f;
    brdf_mask some = left > 0.0f;
    return brdf_pick(some, brdf_log(sum) * (x / brdf_pick(some, left, 1.0f)), x);
}

/* 1 - exp(-x) for 0 <= x <= 80 with all its digits, in the same way. */
static inline brdf_real brdf_1_minus_exp(brdf_real x)
{
    brdf_real rounded = brdf_exp(-x);
    brdf_mask some = rounded < 1.0f;
    brdf_real log_rounded = brdf_log(brdf_pick(some, rounded, 0.5f));
    return brdf_pick(some, (1.0f - rounded) * (-x / log_rounded), x);
}

/* cos^n of the angle between h and the normal, n >= 0. */
static inline brdf_real brdf_half_power(struct brdf_half h, brdf_real n)
{
    return brdf_exp(-0.5f * n * brdf_log_1_plus(h.tan2));
}

/*
 * A half vector whose cosine with the normal is u^(1/k), at the azimuth of the unit vector
 * (cos_phi, sin_phi). With u uniform its density is k / (2 pi) cos^(k - 1) [1/sr]. k >= 0.5.
 */
static inline brdf_vec3 brdf_half_sample_power(brdf_real k, brdf_real u, brdf_real cos_phi,
                                               brdf_real sin_phi)
{
    brdf_real minus_log = brdf_min(-brdf_log(brdf_max(u, 1e-12f)) / k, 40.0f);
    brdf_real sine = sqrtf(brdf_1_minus_exp(2.0f * minus_log));
    return brdf_vec3_make(sine * cos_phi, sine * sin_phi, brdf_exp(-minus_log));
}

/*
 * A half vector of Gaussian slopes, with z = 1: density [1/sr] exp(-a) / (pi alpha_u alpha_v cos^3)
 * with a = (slope_x / alpha_u)^2 + (slope_y / alpha_v)^2 [Walter 2005, Notes on the Ward BRDF].
 */
static inline brdf_vec3 brdf_half_sample_slopes(brdf_real alpha_u, brdf_real alpha_v, brdf_real u,
                                                brdf_real v)
{
    brdf_real radius = sqrtf(-brdf_log(brdf_max(u, 1e-12f)));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(alpha_u * radius * turn.cos, alpha_v * radius * turn.sin, 1.0f);
}

/* Density of normals with Gaussian slopes, isotropic: exp(-tan^2 / alpha^2) / (pi alpha^2 cos^4).
 */
static inline brdf_real brdf_half_beckmann(struct brdf_half h, brdf_real alpha)
{
    brdf_real alpha2 = alpha * alpha;
    return brdf_exp(-h.tan2 / alpha2) * brdf_sqr(1.0f + h.tan2) / (BRDF_PI * alpha2);
}

/*
 * The mirror direction of wo about h, which may have any length but 0. As long as wo, to the last
 * digits: a result of length 1 where wo is a little longer would be off to one side, which at
 * grazing is seen through narrow lobes.
 */
static inline brdf_vec3 brdf_half_mirror(brdf_vec3 wo, brdf_vec3 h)
{
    return brdf_sub(brdf_scale(h, 2.0f * brdf_dot(wo, h) / brdf_dot(h, h)), wo);
}

#endif
