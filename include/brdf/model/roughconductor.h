/*
 * roughconductor - metal with a microscopically rough surface: light meets one facet.
 *
 * f = F D G / (4 cos(wo) cos(wi)); distributions D, maskings G and their sampling are those of
 * facets.h. References: Torrance and Sparrow 1967; Walter et al. 2007, eq. 20; Heitz 2014, eq. 15
 * and 99; visible normals: Heitz and d'Eon 2014, Dupuy and Benyoub 2023.
 * F is that of a conductor, exact or by Schlick's approximation from what eta and k reflect under a
 * right angle. Light that would meet several facets is lost, so that rough metals are too dark,
 * unless `multiscatter` brings it back: Kulla and Conty 2017, by energy.h.
 * As Mitsuba 3 has it: masking is `separable` for ggx and `rational` for beckmann.
 */
#ifndef BRDF_MODEL_ROUGHCONDUCTOR_H
#define BRDF_MODEL_ROUGHCONDUCTOR_H

#include "../brushed.h"
#include "../energy.h"
#include "../fresnel.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_ROUGHCONDUCTOR_PARAMETERS(P)                                                          \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx|blinn", "distribution of the facets' normals")  \
    P(CHOICE, masking, 0, 0, 1, "correlated|separable|rational|vcavity",                           \
      "Smith's exact, one by one, Beckmann's approximated; V-shaped grooves")                      \
    P(CHOICE, fresnel, 0, 0, 1, "exact|schlick", "what a facet reflects")                          \
    P(CHOICE, sample_visible, 1, 0, 1, "false|true", "sample visible normals, or all of them")     \
    P(CHOICE, multiscatter, 0, 0, 1, "none|kullaconty", "light that meets several facets")         \
    P(DECIDED, brushed, 0, 0, 1, "false|true", "two alphas, and a table for them (brushed.h)")     \
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

static inline struct brdf_facets brdf_roughconductor_facets(struct brdf_roughconductor p)
{
    struct brdf_facets facets;
    facets.distribution = p.distribution;
    facets.masking = p.masking;
    facets.visible = p.sample_visible;
    facets.alpha_u = p.alpha_u;
    facets.alpha_v = p.alpha_v;
    return facets;
}

/* What one facet reflects under an angle with this cosine. */
static inline brdf_rgb brdf_roughconductor_fresnel(struct brdf_roughconductor p, brdf_real cosine)
{
    if (p.fresnel == 0) {
        return brdf_fresnel_conductor(cosine, p.eta, p.k);
    }
    return brdf_fresnel_schlick(cosine, brdf_fresnel_conductor(1.0f, p.eta, p.k));
}

/* The same for the facet that mirrors wo into wi, with the same bits in both directions. */
static inline brdf_rgb brdf_roughconductor_facet(struct brdf_roughconductor p, brdf_vec3 wo,
                                                 brdf_vec3 wi)
{
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real cosine = brdf_clamp(0.5f * (brdf_dot(wo, h) + brdf_dot(wi, h)), 0.0f, 1.0f);
    return brdf_rgb_mul(p.specular_reflectance, brdf_roughconductor_fresnel(p, cosine));
}

static inline struct brdf_energy brdf_roughconductor_energy(struct brdf_roughconductor p,
                                                            BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHCONDUCTOR, p);
    if (p.brushed) {
        return brdf_energy_of(table[BRDF_BRUSHED_LOSS], table[BRDF_BRUSHED_SPREAD]);
    }
    return brdf_energy_make(brdf_roughconductor_facets(p));
}

/* What one facet loses of light from w. */
static inline brdf_real brdf_roughconductor_loss(struct brdf_roughconductor p,
                                                 struct brdf_energy energy, brdf_vec3 w,
                                                 BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHCONDUCTOR, p);
    if (p.brushed) {
        return brdf_brushed_loss(table, p.alpha_u, p.alpha_v, w);
    }
    return brdf_energy_loss(energy, w);
}

/* The lobe of light that has met several facets. */
static inline brdf_rgb brdf_roughconductor_lobe(struct brdf_roughconductor p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    struct brdf_energy energy = brdf_roughconductor_energy(p, table);
    brdf_real lobe = brdf_energy_lobe(energy, brdf_roughconductor_loss(p, energy, wo, table),
                                      brdf_roughconductor_loss(p, energy, wi, table));
    brdf_rgb normal = brdf_fresnel_conductor(1.0f, p.eta, p.k);
    brdf_rgb mean = p.fresnel == 0 ? brdf_fresnel_conductor_mean(p.eta, p.k)
                                   : brdf_fresnel_schlick_mean(normal);
    brdf_rgb color = brdf_rgb_mul(p.specular_reflectance, brdf_energy_color(energy, mean));
    return brdf_rgb_scale(color, lobe);
}

/* The probability of sampling that lobe: its part of all that is reflected, nearly. */
static inline brdf_real brdf_roughconductor_share(struct brdf_roughconductor p,
                                                  struct brdf_energy energy, brdf_vec3 wo,
                                                  BRDF_GLOBAL const float *table)
{
    brdf_real loss = brdf_roughconductor_loss(p, energy, wo, table);
    brdf_real several = loss * brdf_rgb_largest(brdf_fresnel_conductor(1.0f, p.eta, p.k));
    return several / ((1.0f - loss) + brdf_max(several, 1e-6f));
}

static inline brdf_rgb brdf_roughconductor_eval(struct brdf_roughconductor p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHCONDUCTOR, p);
    struct brdf_facets facets = brdf_roughconductor_facets(p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real d = brdf_facets_d(facets, h);
    brdf_real g = brdf_facets_visibility(facets, h, wo, wi);
    brdf_rgb f = brdf_rgb_scale(brdf_roughconductor_facet(p, wo, wi), 0.25f * d * g);
    if (p.multiscatter) {
        f = brdf_rgb_add(f, brdf_roughconductor_lobe(p, wo, wi, table));
    }
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_roughconductor_pdf(struct brdf_roughconductor p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHCONDUCTOR, p);
    struct brdf_facets facets = brdf_roughconductor_facets(p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real pdf = brdf_facets_pdf(facets, h, wo, brdf_facets_d(facets, h));
    if (p.multiscatter) {
        struct brdf_energy energy = brdf_roughconductor_energy(p, table);
        brdf_real share = brdf_roughconductor_share(p, energy, wo, table);
        pdf = (1.0f - share) * pdf +
              share * brdf_energy_pdf(energy.spread, brdf_clamp(wi.z, 0.0f, 1.0f));
    }
    return brdf_pick(above, pdf, 0.0f);
}

/* One of both lobes by u.z; what is left of it is for the facet. */
static inline struct brdf_sample brdf_roughconductor_sample_both(struct brdf_roughconductor p,
                                                                 brdf_vec3 wo, brdf_vec3 u,
                                                                 BRDF_GLOBAL const float *table)
{
    struct brdf_facets facets = brdf_roughconductor_facets(p);
    struct brdf_energy energy = brdf_roughconductor_energy(p, table);
    brdf_real share = brdf_roughconductor_share(p, energy, wo, table);
    brdf_mask several = u.z < share;
    u.z = brdf_clamp((u.z - share) / brdf_max(1.0f - share, 1e-7f), 0.0f, 0.99999994f);
    brdf_vec3 mirrored = brdf_half_mirror(wo, brdf_facets_sample(facets, wo, u));
    brdf_vec3 wi = brdf_vec3_pick(several, brdf_energy_sample(energy.spread, u.x, u.y), mirrored);
    brdf_real pdf = brdf_roughconductor_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 1e-20f, wi, brdf_roughconductor_eval(p, wo, wi, table), pdf);
}

static inline struct brdf_sample brdf_roughconductor_sample(struct brdf_roughconductor p,
                                                            brdf_vec3 wo, brdf_vec3 u,
                                                            BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHCONDUCTOR, p);
    if (p.multiscatter) {
        return brdf_roughconductor_sample_both(p, wo, u, table);
    }
    struct brdf_facets facets = brdf_roughconductor_facets(p);
    brdf_vec3 wi = brdf_half_mirror(wo, brdf_facets_sample(facets, wo, u));
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real pdf = brdf_roughconductor_pdf(p, wo, wi, table);
    /* Below 1e-20 only rounding leads, at grazing where h is lost in wo + wi. */
    brdf_mask valid = pdf > 1e-20f;
    brdf_real weight = brdf_facets_weight(facets, h, wo, wi);
    brdf_rgb color = brdf_rgb_scale(brdf_roughconductor_facet(p, wo, wi), weight);
    return brdf_sample_where(valid, brdf_sample_make(wi, color, pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(roughconductor, ROUGHCONDUCTOR,
           BRDF_REFLECTION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL | BRDF_COMPUTED,
           "rough metal: microfacets with a choice of distribution, masking and Fresnel",
           "Torrance and Sparrow 1967; Walter et al. 2007; Heitz 2014")
#endif
