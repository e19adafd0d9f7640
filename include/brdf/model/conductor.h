/*
 * conductor - a smooth metal: a mirror whose reflectance is that of the metal.
 *
 * One delta lobe in the mirror direction, with exact Fresnel [Born and Wolf, 14.2]. eval and pdf
 * are 0: no direction pair meets a delta. Black from below.
 */
#ifndef BRDF_MODEL_CONDUCTOR_H
#define BRDF_MODEL_CONDUCTOR_H

#include "../fresnel.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_CONDUCTOR_PARAMETERS(P)                                                               \
    P(METAL, material, "Cu", 0, 0, "", "name of a metal: sets eta and k")                          \
    P(COLOR, eta, 0.0f, 0.0f, 100.0f, "1", "refractive index, real part")                          \
    P(COLOR, k, 1.0f, 0.0f, 100.0f, "1", "refractive index, imaginary part")                       \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_conductor {
    BRDF_CONDUCTOR_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_conductor_eval(struct brdf_conductor p, brdf_vec3 wo, brdf_vec3 wi,
                                           BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return brdf_gray(0.0f);
}

static inline brdf_real brdf_conductor_pdf(struct brdf_conductor p, brdf_vec3 wo, brdf_vec3 wi,
                                           BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return 0.0f;
}

static inline struct brdf_sample brdf_conductor_sample(struct brdf_conductor p, brdf_vec3 wo,
                                                       brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    (void)u;
    (void)table;
    brdf_real cosine = brdf_clamp(wo.z, 0.0f, 1.0f);
    brdf_rgb fresnel = brdf_fresnel_conductor(cosine, p.eta, p.k);
    brdf_vec3 wi = brdf_vec3_make(-wo.x, -wo.y, wo.z);
    struct brdf_sample s =
        brdf_sample_make(wi, brdf_rgb_mul(p.specular_reflectance, fresnel), 1.0f);
    s.delta = brdf_mask_of(1);
    return brdf_sample_where(wo.z > 0.0f, s);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(conductor, CONDUCTOR, BRDF_REFLECTION | BRDF_DELTA | BRDF_RECIPROCAL,
           "smooth metal: a mirror with exact Fresnel", "Born and Wolf, 14.2")
#endif
