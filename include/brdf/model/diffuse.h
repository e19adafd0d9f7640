/*
 * diffuse - ideal diffuse (Lambertian) reflection: the same radiance in every direction.
 *
 * Reference: Lambert, Photometria, 1760. f = reflectance / pi.
 * Valid for any reflectance in [0, 1]; the side below the surface is black.
 */
#ifndef BRDF_MODEL_DIFFUSE_H
#define BRDF_MODEL_DIFFUSE_H

#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_DIFFUSE_PARAMETERS(P)                                                                 \
    P(COLOR, reflectance, 0.5f, 0.0f, 1.0f, "1", "fraction of the light that is reflected")

struct brdf_diffuse {
    BRDF_DIFFUSE_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_diffuse_eval(struct brdf_diffuse p, brdf_vec3 wo, brdf_vec3 wi,
                                         BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    return brdf_rgb_scale(p.reflectance, brdf_pick(above, BRDF_1_PI, 0.0f));
}

static inline brdf_real brdf_diffuse_pdf(struct brdf_diffuse p, brdf_vec3 wo, brdf_vec3 wi,
                                         BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)table;
    return brdf_pick(wo.z > 0.0f, brdf_warp_cosine_pdf(wi), 0.0f);
}

static inline struct brdf_sample brdf_diffuse_sample(struct brdf_diffuse p, brdf_vec3 wo,
                                                     brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_vec3 wi = brdf_warp_cosine(u.x, u.y);
    brdf_real pdf = brdf_warp_cosine_pdf(wi);
    return brdf_sample_where((wo.z > 0.0f) & (pdf > 0.0f),
                             brdf_sample_make(wi, p.reflectance, pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(diffuse, DIFFUSE, BRDF_REFLECTION | BRDF_RECIPROCAL, "ideal diffuse reflection",
           "Lambert 1760")
#endif
