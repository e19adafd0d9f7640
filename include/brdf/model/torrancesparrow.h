/*
 * torrancesparrow - mirror facets in V-shaped grooves: the first microfacet model.
 *
 * f = F D G / (4 cos(wo) cos(wi)), G of V-cavities (vcavity.h), exact Fresnel of a conductor, or of
 * a dielectric where k = 0. References: Torrance and Sparrow 1967; Blinn 1977, who brought it to
 * graphics. The distribution of normals D has a parameter of its own for each choice:
 *
 *   blinn     (n + 2) / (2 pi) cos^n(h), n being `exponent`
 *   beckmann  exp(-tan^2(h) / alpha^2) / (pi alpha^2 cos^4(h))
 *
 * It explains why highlights at grazing are brighter than in the mirror direction, and lie beyond
 * it. Light that would leave a groove after two reflections is lost.
 */
#ifndef BRDF_MODEL_TORRANCESPARROW_H
#define BRDF_MODEL_TORRANCESPARROW_H

#include "../fresnel.h"
#include "../parameters.h"
#include "../sample.h"
#include "../vcavity.h"

#define BRDF_TORRANCESPARROW_PARAMETERS(P)                                                         \
    P(CHOICE, distribution, 0, 0, 1, "blinn|beckmann", "distribution of the facets' normals")      \
    P(METAL, material, "Al", 0, 0, "", "name of a metal: sets eta and k")                          \
    P(COLOR, eta, 0.0f, 0.0f, 100.0f, "1", "refractive index, real part")                          \
    P(COLOR, k, 1.0f, 0.0f, 100.0f, "1", "refractive index, imaginary part; 0 for a dielectric")   \
    P(REAL, exponent, 100.0f, 0.0f, 1e5f, "1", "of `blinn`: larger is smoother")                   \
    P(REAL, alpha, 0.1f, 1e-4f, 2.0f, "1", "of `beckmann`: roughness")                             \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_torrancesparrow {
    BRDF_TORRANCESPARROW_PARAMETERS(BRDF_FIELD)
};

static inline brdf_real brdf_torrancesparrow_d(struct brdf_torrancesparrow p, struct brdf_half h)
{
    if (p.distribution == 1) {
        return brdf_half_beckmann(h, p.alpha);
    }
    return (p.exponent + 2.0f) * (0.5f * BRDF_1_PI) * brdf_half_power(h, p.exponent);
}

/* A normal with density D cos, as if seen from above. */
static inline brdf_vec3 brdf_torrancesparrow_normal(struct brdf_torrancesparrow p, brdf_real u,
                                                    brdf_real v)
{
    if (p.distribution == 1) {
        return brdf_half_sample_slopes(p.alpha, p.alpha, u, v);
    }
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_half_sample_power(p.exponent + 2.0f, u, turn.cos, turn.sin);
}

static inline brdf_rgb brdf_torrancesparrow_facet(struct brdf_torrancesparrow p, struct brdf_half h)
{
    return brdf_rgb_mul(p.specular_reflectance,
                        brdf_fresnel_conductor(brdf_half_cosine(h), p.eta, p.k));
}

static inline brdf_rgb brdf_torrancesparrow_eval(struct brdf_torrancesparrow p, brdf_vec3 wo,
                                                 brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real scale = 0.25f * brdf_torrancesparrow_d(p, h) * brdf_vcavity_visibility(h, wo.z, wi.z);
    brdf_rgb f = brdf_rgb_scale(brdf_torrancesparrow_facet(p, h), scale);
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_torrancesparrow_pdf(struct brdf_torrancesparrow p, brdf_vec3 wo,
                                                 brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    return brdf_pick(above, brdf_vcavity_pdf(h, wo.z, brdf_torrancesparrow_d(p, h)), 0.0f);
}

static inline struct brdf_sample brdf_torrancesparrow_sample(struct brdf_torrancesparrow p,
                                                             brdf_vec3 wo, brdf_vec3 u,
                                                             BRDF_GLOBAL const float *table)
{
    brdf_vec3 normal = brdf_vcavity_visible_wall(wo, brdf_torrancesparrow_normal(p, u.x, u.y), u.z);
    brdf_vec3 wi = brdf_half_mirror(wo, normal);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real pdf = brdf_torrancesparrow_pdf(p, wo, wi, table);
    /* Below 1e-20 only rounding leads, at grazing where h is lost in wo + wi. */
    brdf_mask valid = pdf > 1e-20f;
    brdf_rgb weight =
        brdf_rgb_scale(brdf_torrancesparrow_facet(p, h), brdf_vcavity_weight(h, wo.z, wi.z));
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(torrancesparrow, TORRANCESPARROW, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "mirror facets in V-shaped grooves, with exact Fresnel",
           "Torrance and Sparrow 1967; Blinn 1977; Heitz and d'Eon 2014")
#endif
