/*
 * abc - diffuse and a lobe with long tails: facets whose density falls as a power, as the light
 * that polished surfaces scatter does. Its parameters are published for the 100 materials of MERL.
 *
 * f = diffuse / pi + F D G / (pi cos(wo) cos(wi)), D = A / (1 + B (1 - cos(h)))^C
 *
 * Reference: Loew, Kronander, Ynnerman, Unger, "BRDF Models for Accurate and Efficient Rendering of
 * Glossy Surfaces", 2012, the microfacet model: D after Church's ABC model of
 * scattering, G of V-cavities, exact Fresnel of a dielectric.
 * Sampling: half vectors in proportion to D, whose integral over cos(h) has an inverse. D is not
 * normalised: A sets how much the lobe reflects, and nothing keeps it from reflecting more than it
 * receives. With published parameters it hardly does.
 */
#ifndef BRDF_MODEL_ABC_H
#define BRDF_MODEL_ABC_H

#include "../fresnel.h"
#include "../mixture.h"
#include "../parameters.h"
#include "../vcavity.h"

#define BRDF_ABC_PARAMETERS(P)                                                                     \
    P(COLOR, A, 50.0f, 0.0f, 1e5f, "1", "height of the lobe")                                      \
    P(REAL, B, 2000.0f, 0.01f, 1e8f, "1", "larger is narrower")                                    \
    P(REAL, C, 1.2f, 0.0f, 10.0f, "1", "how fast its tails fall")                                  \
    P(REAL, ior, 1.5f, 1.0f, 100.0f, "1", "refractive index of the surface")                       \
    P(COLOR, diffuse_reflectance, 0.1f, 0.0f, 1.0f, "1", "weight of the diffuse part")

struct brdf_abc {
    BRDF_ABC_PARAMETERS(BRDF_FIELD)
};

/* (exp(x) - 1) / x, 1 at x = 0. */
static inline brdf_real brdf_abc_slope(brdf_real x)
{
    brdf_mask small = fabsf(x) < 0.1f;
    brdf_real s = brdf_pick(small, x, 0.0f);
    brdf_real series =
        1.0f +
        s * (0.5f + s * (1.0f / 6.0f + s * (1.0f / 24.0f + s * (1.0f / 120.0f + s / 720.0f))));
    return brdf_pick(small, series, (brdf_exp(x) - 1.0f) / brdf_pick(small, 1.0f, x));
}

/* The integral of (1 + B q)^-C over q = 1 - cos(h) from 0 to 1, times B. */
static inline brdf_real brdf_abc_integral(struct brdf_abc p)
{
    brdf_real log_end = brdf_log_1_plus(p.B);
    return log_end * brdf_abc_slope((1.0f - p.C) * log_end);
}

/* (1 + B (1 - cos(h)))^-C, with all digits of 1 - cos where the lobe is. */
static inline brdf_real brdf_abc_shape(struct brdf_abc p, struct brdf_half h)
{
    brdf_real cos2 = 1.0f / (1.0f + h.tan2);
    brdf_real q = h.tan2 * cos2 / (1.0f + sqrtf(cos2));
    return brdf_exp(-p.C * brdf_log_1_plus(p.B * q));
}

/* Density [1/sr] of half vectors. */
static inline brdf_real brdf_abc_density(struct brdf_abc p, struct brdf_half h)
{
    return brdf_abc_shape(p, h) * p.B / (2.0f * BRDF_PI * brdf_abc_integral(p));
}

static inline brdf_real brdf_abc_fresnel(struct brdf_abc p, brdf_real cosine)
{
    return brdf_fresnel_dielectric(brdf_clamp(cosine, 0.0f, 1.0f), p.ior).reflectance;
}

/* The lobe without what its half vectors' density is: 4 F G A / ..., per shape, over pi. */
static inline brdf_rgb brdf_abc_lobe(struct brdf_abc p, struct brdf_half h, brdf_real visibility)
{
    brdf_real fresnel = brdf_abc_fresnel(p, brdf_half_cosine(h));
    return brdf_rgb_scale(p.A, fresnel * visibility * BRDF_1_PI);
}

/* What the lobe reflects from about wo: F A times the integral of its shape, dwi = 4 dh. */
static inline brdf_real brdf_abc_share(struct brdf_abc p, brdf_vec3 wo)
{
    brdf_real scale = 8.0f * brdf_abc_fresnel(p, wo.z) * brdf_abc_integral(p) / p.B;
    return brdf_mixture_share(brdf_rgb_scale(p.A, scale), p.diffuse_reflectance);
}

static inline brdf_rgb brdf_abc_eval(struct brdf_abc p, brdf_vec3 wo, brdf_vec3 wi,
                                     BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_rgb lobe = brdf_abc_lobe(p, h, brdf_vcavity_visibility(h, wo.z, wi.z));
    brdf_rgb f = brdf_rgb_add(brdf_rgb_scale(p.diffuse_reflectance, BRDF_1_PI),
                              brdf_rgb_scale(lobe, brdf_abc_shape(p, h)));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_abc_pdf(struct brdf_abc p, brdf_vec3 wo, brdf_vec3 wi,
                                     BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe = brdf_half_pdf(h, brdf_abc_density(p, h));
    return brdf_pick(above, brdf_mixture_pdf(brdf_abc_share(p, wo), lobe, wi), 0.0f);
}

/* A half vector with the density above: its integral up to q, turned around. */
static inline brdf_vec3 brdf_abc_half(struct brdf_abc p, brdf_real u, brdf_real v)
{
    brdf_real power = 1.0f - p.C;
    brdf_real reach = u * brdf_abc_integral(p);
    /* 1 + B q = (1 + (1 - C) reach)^(1 / (1 - C)), and exp(reach) where C = 1. */
    brdf_mask even = fabsf(power) * reach < 1e-4f;
    brdf_real raised = brdf_max(1.0f + power * reach, 1e-30f);
    brdf_real grown = brdf_log(raised) / brdf_pick(power == 0.0f, 1.0f, power);
    grown = brdf_pick(even, reach * (1.0f - 0.5f * power * reach), grown);
    grown = brdf_clamp(grown, 0.0f, 80.0f);
    brdf_real q = brdf_min(grown * brdf_abc_slope(grown) / p.B, 1.0f);
    brdf_real sine = sqrtf(q * (2.0f - q));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(sine * turn.cos, sine * turn.sin, 1.0f - q);
}

static inline struct brdf_sample brdf_abc_sample(struct brdf_abc p, brdf_vec3 wo, brdf_vec3 u,
                                                 BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real share = brdf_abc_share(p, wo);
    brdf_vec3 mirrored = brdf_half_mirror(wo, brdf_abc_half(p, u.x, u.y));
    brdf_vec3 wi = brdf_vec3_pick(u.z < share, mirrored, brdf_warp_cosine(u.x, u.y));
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real pdf = brdf_half_pdf(h, brdf_abc_density(p, h));
    /* f cos / pdf of the lobe alone: the shape divides out. */
    brdf_real norm = 2.0f * BRDF_PI * brdf_abc_integral(p) / p.B;
    brdf_real visibility = brdf_vcavity_visibility(h, wo.z, wi.z) * brdf_max(wi.z, 0.0f);
    brdf_rgb weight =
        brdf_rgb_scale(brdf_abc_lobe(p, h, visibility), norm * 2.0f * sqrtf(h.square));
    return brdf_mixture_sample(wo, wi, share, pdf, weight, p.diffuse_reflectance);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(abc, ABC, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse and a lobe with long tails, published for the MERL materials",
           "Loew, Kronander, Ynnerman, Unger 2012")
#endif
