/*
 * cooktorrance - diffuse plus Beckmann's facets in V-shaped grooves: metals and plastics.
 *
 * f = diffuse / pi + specular F D G / (4 cos(wo) cos(wi)). Reference: Cook and Torrance 1982, with
 * D of Beckmann (alpha is their slope m), G of V-cavities (vcavity.h) and exact Fresnel, of a
 * dielectric where k = 0. They divide by pi in place of 4, as do published fits: `denominator`.
 * With 4, the lobe is a microfacet model that never reflects more than it receives; with pi it
 * reflects 4 / pi of that. Valid for diffuse + specular <= 1.
 */
#ifndef BRDF_MODEL_COOKTORRANCE_H
#define BRDF_MODEL_COOKTORRANCE_H

#include "../fresnel.h"
#include "../mixture.h"
#include "../parameters.h"
#include "../vcavity.h"

#define BRDF_COOKTORRANCE_PARAMETERS(P)                                                            \
    P(CHOICE, denominator, 0, 0, 1, "four|pi", "4 of energy conservation, or pi of the paper")     \
    P(METAL, material, "Cu", 0, 0, "", "name of a metal: sets eta and k")                          \
    P(COLOR, eta, 0.0f, 0.0f, 100.0f, "1", "refractive index, real part")                          \
    P(COLOR, k, 1.0f, 0.0f, 100.0f, "1", "refractive index, imaginary part; 0 for a dielectric")   \
    P(REAL, alpha, 0.1f, 1e-4f, 2.0f, "1", "roughness: root mean square slope of the facets")      \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "weight of the lobe")                    \
    P(COLOR, diffuse_reflectance, 0.0f, 0.0f, 1.0f, "1", "weight of the diffuse part")

struct brdf_cooktorrance {
    BRDF_COOKTORRANCE_PARAMETERS(BRDF_FIELD)
};

/* What one facet reflects under an angle with this cosine, over 4 times the denominator. */
static inline brdf_rgb brdf_cooktorrance_facet(struct brdf_cooktorrance p, brdf_real cosine)
{
    brdf_real scale = p.denominator == 1 ? 4.0f * BRDF_1_PI : 1.0f;
    brdf_rgb fresnel = brdf_fresnel_conductor(brdf_clamp(cosine, 0.0f, 1.0f), p.eta, p.k);
    return brdf_rgb_scale(brdf_rgb_mul(p.specular_reflectance, fresnel), scale);
}

/* What the lobe reflects depends on the angle: a dielectric's is faint but for grazing. */
static inline brdf_real brdf_cooktorrance_share(struct brdf_cooktorrance p, brdf_real cos_o)
{
    return brdf_mixture_share(brdf_cooktorrance_facet(p, cos_o), p.diffuse_reflectance);
}

static inline brdf_rgb brdf_cooktorrance_eval(struct brdf_cooktorrance p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe =
        0.25f * brdf_half_beckmann(h, p.alpha) * brdf_vcavity_visibility(h, wo.z, wi.z);
    brdf_rgb facet = brdf_cooktorrance_facet(p, brdf_half_cosine(h));
    brdf_rgb f =
        brdf_rgb_add(brdf_rgb_scale(p.diffuse_reflectance, BRDF_1_PI), brdf_rgb_scale(facet, lobe));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_cooktorrance_pdf(struct brdf_cooktorrance p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe = brdf_vcavity_pdf(h, wo.z, brdf_half_beckmann(h, p.alpha));
    brdf_real pdf = brdf_mixture_pdf(brdf_cooktorrance_share(p, wo.z), lobe, wi);
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_cooktorrance_sample(struct brdf_cooktorrance p, brdf_vec3 wo,
                                                          brdf_vec3 u,
                                                          BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real share = brdf_cooktorrance_share(p, wo.z);
    brdf_mask is_lobe = u.z < share;
    /* u.z has chosen the lobe; what is left of it chooses the wall of the groove. */
    brdf_real wall = u.z / brdf_pick(is_lobe, share, 1.0f);
    brdf_vec3 normal = brdf_half_sample_slopes(p.alpha, p.alpha, u.x, u.y);
    normal = brdf_vcavity_visible_wall(wo, normal, wall);
    brdf_vec3 mirrored = brdf_half_mirror(wo, normal);
    brdf_vec3 wi = brdf_vec3_pick(is_lobe, mirrored, brdf_warp_cosine(u.x, u.y));
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe_pdf = brdf_vcavity_pdf(h, wo.z, brdf_half_beckmann(h, p.alpha));
    brdf_rgb weight = brdf_rgb_scale(brdf_cooktorrance_facet(p, brdf_half_cosine(h)),
                                     brdf_vcavity_weight(h, wo.z, wi.z));
    return brdf_mixture_sample(wo, wi, share, lobe_pdf, weight, p.diffuse_reflectance);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(cooktorrance, COOKTORRANCE, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse and Beckmann facets in V-shaped grooves, with exact Fresnel",
           "Cook and Torrance 1982; Heitz and d'Eon 2014")
#endif
