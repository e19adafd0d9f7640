/*
 * roughplastic - a diffuse base under a rough dielectric: satin paint, eggshell, unpolished
 * plastic.
 *
 *   f = F D G / (4 cos(wo) cos(wi))
 *     + T(wo) T(wi) / (eta^2 pi) * rho / (1 - rho K)
 * The interface is that of roughdielectric [Walter et al. 2007, eq. 20]; T is what it lets through
 * of a direction and K what it throws back of diffuse light from within, by fits (coating.h). G is
 * separable, as in Mitsuba 3. Light that would meet several facets is lost, in each passage.
 * `nonlinear` = false puts K in the place of rho K. eta below 1.1 or above 2.5 counts as these in
 * the diffuse part.
 */
#ifndef BRDF_MODEL_ROUGHPLASTIC_H
#define BRDF_MODEL_ROUGHPLASTIC_H

#include "../coating.h"
#include "../interface.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_ROUGHPLASTIC_PARAMETERS(P)                                                            \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx", "distribution of the facets' normals")        \
    P(CHOICE, nonlinear, 0, 0, 1, "false|true", "colours shift by scattering within")              \
    P(REAL, alpha, 0.1f, 1e-4f, 2.0f, "1", "roughness of the interface")                           \
    P(REAL, int_ior, 1.49f, 1.0f, 2.5f, "ior", "refractive index of the coating")                  \
    P(REAL, ext_ior, 1.000277f, 1.0f, 2.5f, "ior", "refractive index above the surface")           \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "albedo of the base")                     \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_roughplastic {
    BRDF_ROUGHPLASTIC_PARAMETERS(BRDF_FIELD)
};

static inline struct brdf_coating brdf_roughplastic_coating(struct brdf_roughplastic p)
{
    return brdf_coating_make(p.distribution, p.alpha, p.int_ior / p.ext_ior);
}

static inline brdf_rgb brdf_roughplastic_specular(struct brdf_roughplastic p, brdf_vec3 wo,
                                                  brdf_vec3 wi)
{
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real cosine = brdf_clamp(0.5f * (brdf_dot(wo, h) + brdf_dot(wi, h)), 0.0f, 1.0f);
    brdf_real fresnel = brdf_fresnel_dielectric(cosine, p.int_ior / p.ext_ior).reflectance;
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area_o = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real area_i = brdf_microfacet_area(p.distribution, wi, p.alpha, p.alpha);
    brdf_real g = brdf_microfacet_visibility(BRDF_MASKING_SEPARABLE, wo.z, wi.z, area_o, area_i);
    return brdf_rgb_scale(p.specular_reflectance, 0.25f * fresnel * d * g);
}

static inline brdf_rgb brdf_roughplastic_base(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi)
{
    struct brdf_coating coating = brdf_roughplastic_coating(p);
    struct brdf_coating_curve curve = brdf_coating_curve_of(coating);
    brdf_real passes = brdf_coating_pass(coating, curve, brdf_clamp(wo.z, 0.0f, 1.0f)) *
                       brdf_coating_pass(coating, curve, brdf_clamp(wi.z, 0.0f, 1.0f));
    brdf_rgb base =
        brdf_interface_base(p.diffuse_reflectance, brdf_coating_escape(coating), p.nonlinear);
    return brdf_rgb_scale(base, passes * BRDF_1_PI / (coating.eta * coating.eta));
}

/* The probability of sampling the lobe: by what smooth plastic would reflect, nearly. */
static inline brdf_real brdf_roughplastic_specular_share(struct brdf_roughplastic p, brdf_vec3 wo)
{
    brdf_real guess =
        brdf_coating_guess(brdf_roughplastic_coating(p), brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_real specular = (1.0f - guess) * brdf_rgb_largest(p.specular_reflectance);
    brdf_real diffuse = guess * brdf_rgb_largest(p.diffuse_reflectance);
    return specular / brdf_max(specular + diffuse, 1e-12f);
}

static inline brdf_rgb brdf_roughplastic_eval(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_rgb f =
        brdf_rgb_add(brdf_roughplastic_specular(p, wo, wi), brdf_roughplastic_base(p, wo, wi));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_roughplastic_pdf(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real share = brdf_roughplastic_specular_share(p, wo);
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real lobe = 0.25f * d / brdf_max(area, 1e-20f);
    brdf_real pdf = share * lobe + (1.0f - share) * brdf_warp_cosine_pdf(wi);
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_roughplastic_sample(struct brdf_roughplastic p, brdf_vec3 wo,
                                                          brdf_vec3 u,
                                                          BRDF_GLOBAL const float *table)
{
    brdf_mask reflects = u.z < brdf_roughplastic_specular_share(p, wo);
    brdf_vec3 h = brdf_microfacet_sample(p.distribution, wo, p.alpha, p.alpha, u.x, u.y);
    brdf_vec3 lobe = brdf_normalize(brdf_reflect(wo, h));
    brdf_vec3 wi = brdf_vec3_pick(reflects, lobe, brdf_warp_cosine(u.x, u.y));
    brdf_real pdf = brdf_roughplastic_pdf(p, wo, wi, table);
    brdf_mask valid = pdf > 1e-30f;
    brdf_real scale = wi.z / brdf_pick(valid, pdf, 1.0f);
    brdf_rgb weight = brdf_rgb_scale(brdf_roughplastic_eval(p, wo, wi, table), scale);
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(roughplastic, ROUGHPLASTIC, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse base under a rough dielectric, with scattering within",
           "Walter et al. 2007; Elias 2001; d'Eon 2021")
#endif
