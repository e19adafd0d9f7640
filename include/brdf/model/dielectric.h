/*
 * dielectric - a smooth interface between two dielectrics: glass, water. It reflects or refracts.
 *
 * Two delta lobes, exact Fresnel [Born and Wolf, 1.5.2], Snell's law; both sides. Radiance that
 * passes is scaled by 1 / eta^2 (eta: far index over near index), as solid angle shrinks in the
 * denser medium [Veach 1997, 5.2]. eval and pdf are 0: no direction pair meets a delta.
 */
#ifndef BRDF_MODEL_DIELECTRIC_H
#define BRDF_MODEL_DIELECTRIC_H

#include "../fresnel.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_DIELECTRIC_PARAMETERS(P)                                                              \
    P(REAL, int_ior, 1.5046f, 0.1f, 10.0f, "ior", "refractive index below the surface")            \
    P(REAL, ext_ior, 1.000277f, 0.1f, 10.0f, "ior", "refractive index above the surface")          \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1",                                          \
      "factor of the reflection; 1 is "                                                            \
      "physical")                                                                                  \
    P(COLOR, specular_transmittance, 1.0f, 0.0f, 1.0f, "1",                                        \
      "factor of the transmission; 1 is "                                                          \
      "physical")

struct brdf_dielectric {
    BRDF_DIELECTRIC_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_dielectric_eval(struct brdf_dielectric p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return brdf_gray(0.0f);
}

static inline brdf_real brdf_dielectric_pdf(struct brdf_dielectric p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return 0.0f;
}

static inline struct brdf_sample brdf_dielectric_sample(struct brdf_dielectric p, brdf_vec3 wo,
                                                        brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask outside = wo.z > 0.0f;
    brdf_real eta = brdf_pick(outside, p.int_ior / p.ext_ior, p.ext_ior / p.int_ior);
    struct brdf_fresnel fresnel = brdf_fresnel_dielectric(fabsf(wo.z), eta);
    brdf_mask reflects = u.z < fresnel.reflectance;
    brdf_vec3 refracted =
        brdf_vec3_make(-wo.x / eta, -wo.y / eta, brdf_pick(outside, -fresnel.cos_t, fresnel.cos_t));
    brdf_vec3 wi = brdf_vec3_pick(reflects, brdf_vec3_make(-wo.x, -wo.y, wo.z), refracted);
    brdf_rgb weight = brdf_rgb_pick(reflects, p.specular_reflectance,
                                    brdf_rgb_scale(p.specular_transmittance, 1.0f / (eta * eta)));
    brdf_real pdf = brdf_pick(reflects, fresnel.reflectance, 1.0f - fresnel.reflectance);
    struct brdf_sample s = brdf_sample_make(brdf_normalize(wi), weight, pdf);
    s.eta = brdf_pick(reflects, 1.0f, eta);
    s.delta = brdf_mask_of(1);
    return brdf_sample_where((fabsf(wo.z) > 0.0f) & (pdf > 0.0f), s);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(dielectric, DIELECTRIC,
           BRDF_REFLECTION | BRDF_TRANSMISSION | BRDF_DELTA | BRDF_RECIPROCAL,
           "smooth interface between two dielectrics", "Born and Wolf; Veach 1997")
#endif
