/*
 * microfacet.h - distributions of microfacet normals, their masking, and sampling visible normals.
 *
 * `alpha_u`, `alpha_v` are the roughness along the local x and y axes, never squared or remapped.
 * Directions are local, unit, z >= 0. `distribution` and `masking` are the same for all lanes.
 */
#ifndef BRDF_MICROFACET_H
#define BRDF_MICROFACET_H

#include "halfvector.h"

#define BRDF_BECKMANN 0
#define BRDF_GGX 1
#define BRDF_BLINN 2

#define BRDF_MASKING_CORRELATED 0
#define BRDF_MASKING_SEPARABLE 1

/*
 * cos^n of the angle between h and the normal over its integral with the cosine, (n + 2) / (2 pi),
 * with the exponent that is as rough as Beckmann's alpha: n = 2 / alpha^2 - 2 [Blinn 1977; Walter
 * et al. 2007, section 5.2]. Along an azimuth n follows the ellipse of both alphas [Ashikhmin and
 * Shirley 2000]. Above alpha = 1, n is negative, down to -1.5.
 */
static inline brdf_real brdf_blinn_d(brdf_vec3 h, brdf_real alpha_u, brdf_real alpha_v)
{
    brdf_real x = h.x / alpha_u;
    brdf_real y = h.y / alpha_v;
    brdf_real sine2 = h.x * h.x + h.y * h.y;
    brdf_mask tilted = sine2 > 1e-30f;
    brdf_real half_n = (x * x + y * y) / brdf_pick(tilted, sine2, 1.0f) - 1.0f;
    brdf_real tan2 = sine2 / brdf_max(h.z * h.z, 1e-12f);
    brdf_real power = brdf_pick(tilted, brdf_exp(-half_n * brdf_log_1_plus(tan2)), 1.0f);
    return power / (BRDF_PI * alpha_u * alpha_v);
}

/*
 * Density of normals D(h) [1/sr], with integral D(h) cos h dh = 1.
 * GGX: [Trowbridge and Reitz 1975; Walter et al. 2007, eq. 33; Heitz 2014, eq. 85].
 * Beckmann: [Walter et al. 2007, eq. 25; Heitz 2014, eq. 81].
 */
static inline brdf_real brdf_microfacet_d(int distribution, brdf_vec3 h, brdf_real alpha_u,
                                          brdf_real alpha_v)
{
    brdf_real x = h.x / alpha_u;
    brdf_real y = h.y / alpha_v;
    brdf_real slope2 = x * x + y * y;
    if (distribution == BRDF_BLINN) {
        return brdf_blinn_d(h, alpha_u, alpha_v);
    }
    if (distribution == BRDF_GGX) {
        brdf_real s = slope2 + h.z * h.z;
        return 1.0f / (BRDF_PI * alpha_u * alpha_v * (s * s));
    }
    brdf_real z2 = brdf_max(h.z * h.z, 1e-12f);
    return brdf_exp(-slope2 / z2) / (BRDF_PI * alpha_u * alpha_v * (z2 * z2));
}

/*
 * The projected area of all facets that face w, hidden ones included, per area of surface:
 * cos(w) (1 + Lambda(w)) with the Lambda of Smith [Heitz 2014, eq. 72 and 66]. In this form nothing
 * is infinite at grazing. What is seen of it is cos(w), so masking of one direction is
 * G1 = cos(w) / area(w). Blinn's has no closed form.
 */
static inline brdf_real brdf_microfacet_area(int distribution, brdf_vec3 w, brdf_real alpha_u,
                                             brdf_real alpha_v)
{
    brdf_real x = alpha_u * w.x;
    brdf_real y = alpha_v * w.y;
    brdf_real slope2 = x * x + y * y; /* (alpha sin theta)^2 */
    if (distribution == BRDF_GGX) {
        return 0.5f * (w.z + sqrtf(w.z * w.z + slope2));
    }
    brdf_real slope = sqrtf(slope2);
    /* Beyond 10, Lambda is 0 in single precision. */
    brdf_real a = brdf_clamp(w.z / brdf_max(slope, 1e-20f), 0.0f, 10.0f);
    brdf_real tail = slope * (0.5f * BRDF_1_SQRT_PI) * brdf_exp(-a * a);
    return brdf_max(0.5f * w.z * (1.0f + brdf_erf(a)) + tail, w.z);
}

/*
 * Masking and shadowing over both cosines, G2 / (cos(wo) cos(wi)), from the cosines and the areas:
 * height-correlated or separable [Heitz 2014, eq. 99, 98]. Symmetric to the last bit.
 */
static inline brdf_real brdf_microfacet_visibility(int masking, brdf_real cos_o, brdf_real cos_i,
                                                   brdf_real area_o, brdf_real area_i)
{
    if (masking == BRDF_MASKING_SEPARABLE) {
        return 1.0f / brdf_max(area_o * area_i, 1e-20f);
    }
    return 1.0f / brdf_max((cos_o * area_i + cos_i * area_o) - cos_o * cos_i, 1e-20f);
}

/* Visible GGX normals by spherical caps [Dupuy and Benyoub 2023, listing 3]. */
static inline brdf_vec3 brdf_microfacet_sample_ggx(brdf_vec3 wo, brdf_real alpha_u,
                                                   brdf_real alpha_v, brdf_real u, brdf_real v)
{
    brdf_vec3 stretched = brdf_normalize(brdf_vec3_make(wo.x * alpha_u, wo.y * alpha_v, wo.z));
    brdf_real z = (1.0f - u) * (1.0f + stretched.z) - stretched.z;
    brdf_real radius = sqrtf(brdf_max(1.0f - z * z, 0.0f));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_vec3 cap = brdf_vec3_make(radius * turn.cos, radius * turn.sin, z);
    brdf_vec3 h = brdf_add(cap, stretched);
    return brdf_normalize(brdf_vec3_make(h.x * alpha_u, h.y * alpha_v, brdf_max(h.z, 0.0f)));
}

/*
 * One slope of a visible Beckmann facet of unit roughness, seen under angle theta: the first along
 * the view, the second across it. The first inverts its distribution function, written in x = erf(
 * slope) as 1 + x + tan(theta) exp(-slope^2) / sqrt(pi), by Newton steps from a fitted start [Jakob
 * 2014, section 3]. Every step stays in the open interval, so that erfinv stays finite. Four steps
 * leave an error of 2.3e-7 in u at worst, over all angles: what single precision can do.
 */
static inline brdf_real brdf_beckmann_visible_slope(brdf_real tan_theta, brdf_real u)
{
    brdf_real cot = 1.0f / brdf_max(tan_theta, 1e-6f);
    brdf_real a = brdf_min(cot, 10.0f);
    brdf_real top = brdf_erf(a);
    brdf_real gauss = tan_theta * BRDF_1_SQRT_PI;
    brdf_real target = u * (1.0f + top + gauss * brdf_exp(-a * a));
    brdf_real low = -1.0f;
    brdf_real high = top;
    brdf_real x = top - (1.0f + top) * brdf_erf(sqrtf(-brdf_log(brdf_max(u, 1e-30f))));
    for (int step = 0; step < 4; ++step) {
        x = brdf_pick((x > low) & (x < high), x, 0.5f * (low + high));
        brdf_real slope = brdf_erfinv(x);
        brdf_real value = 1.0f + x + gauss * brdf_exp(-slope * slope) - target;
        brdf_mask above = value > 0.0f;
        high = brdf_pick(above, x, high);
        low = brdf_pick(above, low, x);
        brdf_real derivative = brdf_max(1.0f - slope * tan_theta, 1e-6f);
        x = x - value / derivative;
    }
    return brdf_erfinv(brdf_clamp(x, low, high));
}

/* Visible Beckmann normals: stretch, sample slopes, unstretch [Heitz and d'Eon 2014, section 3]. */
static inline brdf_vec3 brdf_microfacet_sample_beckmann(brdf_vec3 wo, brdf_real alpha_u,
                                                        brdf_real alpha_v, brdf_real u, brdf_real v)
{
    brdf_vec3 s = brdf_normalize(brdf_vec3_make(wo.x * alpha_u, wo.y * alpha_v, wo.z));
    brdf_real sin_theta = sqrtf(s.x * s.x + s.y * s.y);
    brdf_mask tilted = sin_theta > 1e-7f;
    brdf_real inverse = 1.0f / brdf_pick(tilted, sin_theta, 1.0f);
    brdf_real cos_phi = brdf_pick(tilted, s.x * inverse, 1.0f);
    brdf_real sin_phi = brdf_pick(tilted, s.y * inverse, 0.0f);
    brdf_real tan_theta = sin_theta / brdf_max(s.z, 1e-7f);
    brdf_real along = brdf_beckmann_visible_slope(tan_theta, u);
    brdf_real across = brdf_erfinv(2.0f * v - 1.0f);
    brdf_real slope_x = (cos_phi * along - sin_phi * across) * alpha_u;
    brdf_real slope_y = (sin_phi * along + cos_phi * across) * alpha_v;
    return brdf_normalize(brdf_vec3_make(-slope_x, -slope_y, 1.0f));
}

/* A normal h with density G1(wo) D(h) max(wo.h, 0) / cos(wo) [1/sr] for u, v in [0, 1). */
static inline brdf_vec3 brdf_microfacet_sample(int distribution, brdf_vec3 wo, brdf_real alpha_u,
                                               brdf_real alpha_v, brdf_real u, brdf_real v)
{
    if (distribution == BRDF_GGX) {
        return brdf_microfacet_sample_ggx(wo, alpha_u, alpha_v, u, v);
    }
    return brdf_microfacet_sample_beckmann(wo, alpha_u, alpha_v, u, v);
}

#endif
