/*
 * plastic - a diffuse base under a smooth dielectric: polished plastic, varnish, glazed tiles.
 *
 * The interface reflects F(wo) as a delta. The rest enters, is scattered diffusely, and some of
 * it is thrown back by the interface from within, again and again; summed up,
 *   f = (1 - F(wo)) (1 - F(wi)) / (eta^2 pi) * rho / (1 - rho K)
 * with K the interface's mean reflectance from within [Elias 2001; d'Eon 2021], by its closed form.
 * A base of albedo 1 reflects everything, exactly. `nonlinear` = false puts K in the place of rho
 * K: colours do not shift by internal scattering, as in Mitsuba 3's default; the base is brighter.
 */
#ifndef BRDF_MODEL_PLASTIC_H
#define BRDF_MODEL_PLASTIC_H

#include "../interface.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_PLASTIC_PARAMETERS(P)                                                                 \
    P(CHOICE, nonlinear, 0, 0, 1, "false|true", "colours shift by scattering within")              \
    P(REAL, int_ior, 1.49f, 0.1f, 10.0f, "ior", "refractive index of the coating")                 \
    P(REAL, ext_ior, 1.000277f, 0.1f, 10.0f, "ior", "refractive index above the surface")          \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "albedo of the base")                     \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_plastic {
    BRDF_PLASTIC_PARAMETERS(BRDF_FIELD)
};

static inline brdf_real brdf_plastic_fresnel(struct brdf_plastic p, brdf_vec3 w)
{
    brdf_real cosine = brdf_clamp(w.z, 0.0f, 1.0f);
    return brdf_fresnel_dielectric(cosine, p.int_ior / p.ext_ior).reflectance;
}

/* The diffuse part of f without the factors of the two directions. */
static inline brdf_rgb brdf_plastic_base(struct brdf_plastic p)
{
    brdf_real inverse = p.ext_ior / p.int_ior;
    brdf_rgb base =
        brdf_interface_base(p.diffuse_reflectance, brdf_interface_pass(inverse), p.nonlinear);
    return brdf_rgb_scale(base, inverse * inverse * BRDF_1_PI);
}

/* The probability of sampling the reflection: its part of all the light that is sent to wo. */
static inline brdf_real brdf_plastic_specular_share(struct brdf_plastic p, brdf_real fresnel_o,
                                                    brdf_rgb base)
{
    brdf_real pass = brdf_interface_pass(p.int_ior / p.ext_ior);
    brdf_real specular = fresnel_o * brdf_rgb_largest(p.specular_reflectance);
    brdf_real diffuse = (1.0f - fresnel_o) * pass * BRDF_PI * brdf_rgb_largest(base);
    return specular / brdf_max(specular + diffuse, 1e-20f);
}

static inline brdf_rgb brdf_plastic_eval(struct brdf_plastic p, brdf_vec3 wo, brdf_vec3 wi,
                                         BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real passes = (1.0f - brdf_plastic_fresnel(p, wo)) * (1.0f - brdf_plastic_fresnel(p, wi));
    brdf_rgb f = brdf_rgb_scale(brdf_plastic_base(p), passes);
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_plastic_pdf(struct brdf_plastic p, brdf_vec3 wo, brdf_vec3 wi,
                                         BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real share =
        brdf_plastic_specular_share(p, brdf_plastic_fresnel(p, wo), brdf_plastic_base(p));
    return brdf_pick(above, (1.0f - share) * brdf_warp_cosine_pdf(wi), 0.0f);
}

static inline struct brdf_sample brdf_plastic_sample(struct brdf_plastic p, brdf_vec3 wo,
                                                     brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real fresnel_o = brdf_plastic_fresnel(p, wo);
    brdf_rgb base = brdf_plastic_base(p);
    brdf_real share = brdf_plastic_specular_share(p, fresnel_o, base);
    brdf_mask reflects = u.z < share;
    brdf_vec3 wi =
        brdf_vec3_pick(reflects, brdf_vec3_make(-wo.x, -wo.y, wo.z), brdf_warp_cosine(u.x, u.y));
    brdf_real chance = brdf_max(brdf_pick(reflects, share, 1.0f - share), 1e-20f);
    brdf_real passes = (1.0f - fresnel_o) * (1.0f - brdf_plastic_fresnel(p, wi));
    brdf_rgb weight = brdf_rgb_pick(reflects, brdf_rgb_scale(p.specular_reflectance, fresnel_o),
                                    brdf_rgb_scale(base, passes * BRDF_PI));
    brdf_real pdf = brdf_pick(reflects, share, (1.0f - share) * brdf_warp_cosine_pdf(wi));
    struct brdf_sample s = brdf_sample_make(wi, brdf_rgb_scale(weight, 1.0f / chance), pdf);
    s.delta = reflects;
    return brdf_sample_where((wo.z > 0.0f) & (wi.z > 0.0f) & (pdf > 0.0f), s);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(plastic, PLASTIC, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse base under a smooth dielectric, with scattering within",
           "Elias 2001; d'Eon 2021")
#endif
