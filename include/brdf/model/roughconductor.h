/*
 * roughconductor - metal with a microscopically rough surface: light meets one facet.
 *
 * f = F D G / (4 cos(wo) cos(wi)) with exact conductor Fresnel F, D of Beckmann or GGX, G of Smith.
 * References: Torrance and Sparrow 1967; Walter et al. 2007, eq. 20; Heitz 2014, eq. 15 and 99;
 * visible normals: Heitz and d'Eon 2014, Dupuy and Benyoub 2023.
 * Light that would meet several facets is lost, so that rough metals are too dark: a property of
 * the model. Masking is height-correlated; `separable` is what Mitsuba 3 computes.
 */
#ifndef BRDF_MODEL_ROUGHCONDUCTOR_H
#define BRDF_MODEL_ROUGHCONDUCTOR_H

#include "../fresnel.h"
#include "../halfvector.h"
#include "../microfacet.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_ROUGHCONDUCTOR_PARAMETERS(P)                                                          \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx", "distribution of the facets' normals")        \
    P(CHOICE, masking, 0, 0, 1, "correlated|separable", "Smith masking and shadowing together")    \
    P(METAL, material, "Cu", 0, 0, "", "name of a metal: sets eta and k")                          \
    P(COLOR, eta, 0.0f, 0.0f, 100.0f, "1", "refractive index, real part")                          \
    P(COLOR, k, 1.0f, 0.0f, 100.0f, "1", "refractive index, imaginary part")                       \
    P(ALIAS, alpha, 0, 0, 0, "alpha_u|alpha_v", "roughness along both tangents")                   \
    P(REAL, alpha_u, 0.1f, 1e-4f, 2.0f, "1", "roughness along the tangent")                        \
    P(REAL, alpha_v, 0.1f, 1e-4f, 2.0f, "1", "roughness along the bitangent")                      \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_roughconductor {
    BRDF_ROUGHCONDUCTOR_PARAMETERS(BRDF_FIELD)
};

/* What one facet that mirrors wo into wi reflects; the same bits in both directions. */
static inline brdf_rgb brdf_roughconductor_facet(struct brdf_roughconductor p, brdf_vec3 wo,
                                                 brdf_vec3 wi)
{
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real cos_h = brdf_clamp(0.5f * (brdf_dot(wo, h) + brdf_dot(wi, h)), 0.0f, 1.0f);
    return brdf_rgb_mul(p.specular_reflectance, brdf_fresnel_conductor(cos_h, p.eta, p.k));
}

static inline brdf_rgb brdf_roughconductor_eval(struct brdf_roughconductor p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha_u, p.alpha_v);
    brdf_real area_o = brdf_microfacet_area(p.distribution, wo, p.alpha_u, p.alpha_v);
    brdf_real area_i = brdf_microfacet_area(p.distribution, wi, p.alpha_u, p.alpha_v);
    brdf_real g = brdf_microfacet_visibility(p.masking, wo.z, wi.z, area_o, area_i);
    brdf_rgb f = brdf_rgb_scale(brdf_roughconductor_facet(p, wo, wi), 0.25f * d * g);
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_roughconductor_pdf(struct brdf_roughconductor p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha_u, p.alpha_v);
    brdf_real area = brdf_microfacet_area(p.distribution, wo, p.alpha_u, p.alpha_v);
    return brdf_pick(above, 0.25f * d / brdf_max(area, 1e-20f), 0.0f);
}

static inline struct brdf_sample brdf_roughconductor_sample(struct brdf_roughconductor p,
                                                            brdf_vec3 wo, brdf_vec3 u,
                                                            BRDF_GLOBAL const float *table)
{
    brdf_vec3 h = brdf_microfacet_sample(p.distribution, wo, p.alpha_u, p.alpha_v, u.x, u.y);
    brdf_vec3 wi = brdf_half_mirror(wo, h);
    brdf_real pdf = brdf_roughconductor_pdf(p, wo, wi, table);
    brdf_mask valid = (wo.z > 0.0f) & (wi.z > 0.0f) & (pdf > 0.0f);
    /* f cos / pdf = F G2 / G1: D cancels, so that the weight never exceeds the reflectance. */
    brdf_real area_o = brdf_microfacet_area(p.distribution, wo, p.alpha_u, p.alpha_v);
    brdf_real area_i = brdf_microfacet_area(p.distribution, wi, p.alpha_u, p.alpha_v);
    brdf_real g = brdf_microfacet_visibility(p.masking, wo.z, wi.z, area_o, area_i);
    g = brdf_min(g * area_o * wi.z, 1.0f);
    brdf_rgb weight = brdf_rgb_scale(brdf_roughconductor_facet(p, wo, wi), g);
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(roughconductor, ROUGHCONDUCTOR, BRDF_REFLECTION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL,
           "rough metal: microfacets with exact Fresnel",
           "Torrance and Sparrow 1967; Walter et al. 2007; Heitz 2014")
#endif
