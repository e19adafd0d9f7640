/*
 * thindielectric - a thin pane of glass, or a film: two smooth interfaces as one surface.
 *
 * Light that enters is reflected between the interfaces any number of times. The sum over all of
 * them is, without interference, R = 2 F / (1 + F) and T = 1 - R [Stokes 1862; Born and Wolf,
 * 1.5.2 for F]. What passes goes straight on, as the second refraction undoes the first; the shift
 * between the two is neglected. Two delta lobes, both sides; eval and pdf are 0.
 */
#ifndef BRDF_MODEL_THINDIELECTRIC_H
#define BRDF_MODEL_THINDIELECTRIC_H

#include "../fresnel.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_THINDIELECTRIC_PARAMETERS(P)                                                          \
    P(REAL, int_ior, 1.5046f, 0.1f, 10.0f, "ior", "refractive index of the pane")                  \
    P(REAL, ext_ior, 1.000277f, 0.1f, 10.0f, "ior", "refractive index on both sides of it")        \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1",                                          \
      "factor of the reflection; 1 is physical")                                                   \
    P(COLOR, specular_transmittance, 1.0f, 0.0f, 1.0f, "1",                                        \
      "factor of the transmission; 1 is physical")

struct brdf_thindielectric {
    BRDF_THINDIELECTRIC_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_thindielectric_eval(struct brdf_thindielectric p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return brdf_gray(0.0f);
}

static inline brdf_real brdf_thindielectric_pdf(struct brdf_thindielectric p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)wo;
    (void)wi;
    (void)table;
    return 0.0f;
}

static inline struct brdf_sample brdf_thindielectric_sample(struct brdf_thindielectric p,
                                                            brdf_vec3 wo, brdf_vec3 u,
                                                            BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real cosine = brdf_min(fabsf(wo.z), 1.0f);
    brdf_real once = brdf_fresnel_dielectric(cosine, p.int_ior / p.ext_ior).reflectance;
    brdf_real reflectance = 2.0f * once / (1.0f + once);
    brdf_mask reflects = u.z < reflectance;
    brdf_vec3 wi = brdf_vec3_pick(reflects, brdf_vec3_make(-wo.x, -wo.y, wo.z), brdf_negate(wo));
    brdf_rgb weight = brdf_rgb_pick(reflects, p.specular_reflectance, p.specular_transmittance);
    brdf_real pdf = brdf_pick(reflects, reflectance, 1.0f - reflectance);
    struct brdf_sample s = brdf_sample_make(wi, weight, pdf);
    s.delta = brdf_mask_of(1);
    return brdf_sample_where((cosine > 0.0f) & (pdf > 0.0f), s);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(thindielectric, THINDIELECTRIC,
           BRDF_REFLECTION | BRDF_TRANSMISSION | BRDF_DELTA | BRDF_RECIPROCAL,
           "thin pane of glass: two smooth interfaces as one", "Stokes 1862; Born and Wolf, 1.5.2")
#endif
