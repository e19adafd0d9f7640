/*
 * blinnphong - a diffuse part and a cosine lobe of the half vector about the normal.
 *
 * f = diffuse / pi + specular c cos^n(h). Reference: Blinn 1977. The factor c is a choice:
 * `energy`, (n + 2) (n + 4) / (8 pi (2^(-n/2) + n)), reflects all light that comes along the normal
 * and less of any other (Giesen 2009); `distribution`, (n + 2) / (2 pi), makes the projected
 * lobe a distribution of normals, and the whole reflects up to 4 times what it receives.
 * Narrow lobes lose energy towards grazing, as cos^2(wo). Highlights get narrower at grazing, as
 * those of microfacets do: that is what this model is for.
 */
#ifndef BRDF_MODEL_BLINNPHONG_H
#define BRDF_MODEL_BLINNPHONG_H

#include "../halfvector.h"
#include "../mixture.h"
#include "../parameters.h"

#define BRDF_BLINNPHONG_PARAMETERS(P)                                                              \
    P(CHOICE, normalisation, 0, 0, 1, "energy|distribution",                                       \
      "all light along the normal is reflected, or the lobe is a distribution of normals")         \
    P(REAL, exponent, 30.0f, 0.0f, 1e5f, "1", "width of the lobe: larger is narrower")             \
    P(COLOR, specular_reflectance, 0.2f, 0.0f, 1.0f, "1", "weight of the lobe")                    \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "weight of the diffuse part")

struct brdf_blinnphong {
    BRDF_BLINNPHONG_PARAMETERS(BRDF_FIELD)
};

/* The factor c over (n + 2) / (2 pi). */
static inline brdf_real brdf_blinnphong_factor(struct brdf_blinnphong p)
{
    if (p.normalisation == 1) {
        return 1.0f;
    }
    brdf_real n = p.exponent;
    return (n + 4.0f) / (4.0f * (brdf_exp(-0.346573590f * n) + n)); /* ln 2 / 2 */
}

/* Density of wi where h has the density (n + 2) / (2 pi) cos^(n + 1)(h). */
static inline brdf_real brdf_blinnphong_lobe_pdf(struct brdf_blinnphong p, struct brdf_half h)
{
    brdf_real scale = (p.exponent + 2.0f) * (0.5f * BRDF_1_PI);
    return brdf_half_pdf(h, scale * brdf_half_power(h, p.exponent + 1.0f));
}

static inline brdf_rgb brdf_blinnphong_eval(struct brdf_blinnphong p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real scale = (p.exponent + 2.0f) * (0.5f * BRDF_1_PI) * brdf_blinnphong_factor(p);
    brdf_real lobe = scale * brdf_half_power(h, p.exponent);
    brdf_rgb f = brdf_rgb_add(brdf_rgb_scale(p.diffuse_reflectance, BRDF_1_PI),
                              brdf_rgb_scale(p.specular_reflectance, lobe));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_blinnphong_pdf(struct brdf_blinnphong p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real share = brdf_mixture_share(p.specular_reflectance, p.diffuse_reflectance);
    brdf_real lobe = brdf_blinnphong_lobe_pdf(p, brdf_half_make(wo, wi));
    return brdf_pick(above, brdf_mixture_pdf(share, lobe, wi), 0.0f);
}

static inline struct brdf_sample brdf_blinnphong_sample(struct brdf_blinnphong p, brdf_vec3 wo,
                                                        brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real share = brdf_mixture_share(p.specular_reflectance, p.diffuse_reflectance);
    struct brdf_sincos turn = brdf_sincos_2pi(u.y);
    brdf_vec3 normal = brdf_half_sample_power(p.exponent + 2.0f, u.x, turn.cos, turn.sin);
    brdf_vec3 mirrored = brdf_half_mirror(wo, normal);
    brdf_vec3 wi = brdf_vec3_pick(u.z < share, mirrored, brdf_warp_cosine(u.x, u.y));
    struct brdf_half h = brdf_half_make(wo, wi);
    /* f cos / pdf of the lobe: the power cancels but for one cosine of h, as brdf_half_power has
       it. */
    brdf_real weight = 2.0f * brdf_blinnphong_factor(p) * sqrtf(h.square * (1.0f + h.tan2)) * wi.z;
    return brdf_mixture_sample(wo, wi, share, brdf_blinnphong_lobe_pdf(p, h),
                               brdf_rgb_scale(p.specular_reflectance, weight),
                               p.diffuse_reflectance);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(blinnphong, BLINNPHONG, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse and a cosine lobe of the half vector about the normal",
           "Blinn 1977; Giesen 2009")
#endif
