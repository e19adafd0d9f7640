/*
 * wood - finished wood: fibres under a clear coat, whose highlight moves otherwise than a
 * surface's.
 *
 *   f = F D G / (4 cos(wo) cos(wi))
 *     + T(wo) T(wi) (diffuse_reflectance / pi + k_f g(beta, psi_h) / cos^2(psi_d / 2))
 * Marschner, Westin, Arbree and Moon 2005: psi are inclinations to the plane across the fibres
 * after refraction, psi_h their sum, psi_d their difference; T is what the smooth coat lets
 * through, 1 - F. The surface lobe, which the paper leaves open, is a microfacet's.
 * Deviations: k_f = fiber_reflectance / (2 eta), so that lying fibres, lit from the normal, return
 * fiber_reflectance; g is normalised (the authors' shader multiplies by beta, where the paper
 * divides); f is what multiplies the cosine above the surface, which makes it reciprocal (their
 * shader takes the cosine below). Light that the coat throws back into the wood is lost.
 */
#ifndef BRDF_MODEL_WOOD_H
#define BRDF_MODEL_WOOD_H

#include "../fiber.h"
#include "../fresnel.h"
#include "../halfvector.h"
#include "../interface.h"
#include "../microfacet.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_WOOD_PARAMETERS(P)                                                                    \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx", "distribution of the coat's normals")         \
    P(REAL, eta, 1.5f, 1.0f, 2.5f, "ior", "refractive index of the coat")                          \
    P(REAL, alpha, 0.1f, 1e-4f, 2.0f, "1", "roughness of the coat")                                \
    P(REAL, beta, 0.2f, 0.01f, 2.0f, "rad", "width of the fibres' highlight")                      \
    P(COLOR, fiber_axis, 0.5f, 0.0f, 1.0f, "1",                                                    \
      "direction of the fibres as colour c, as in a normal map: 2 c - 1; grey: along the tangent") \
    P(COLOR, fiber_reflectance, 0.2f, 0.0f, 1.0f, "1", "colour of the fibres' highlight")          \
    P(COLOR, diffuse_reflectance, 0.3f, 0.0f, 1.0f, "1", "colour of the wood below")               \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the coat; 1 is physical")

struct brdf_wood {
    BRDF_WOOD_PARAMETERS(BRDF_FIELD)
};

static inline struct brdf_fiber brdf_wood_fiber(struct brdf_wood p)
{
    brdf_vec3 axis = brdf_vec3_make(2.0f * p.fiber_axis.r - 1.0f, 2.0f * p.fiber_axis.g - 1.0f,
                                    2.0f * p.fiber_axis.b - 1.0f);
    brdf_mask points = brdf_dot(axis, axis) > 1e-4f; /* a grey of 8 bits is not quite 1/2 */
    axis = brdf_vec3_pick(points, axis, brdf_vec3_make(1.0f, 0.0f, 0.0f));
    return brdf_fiber_make(axis, p.beta, p.eta);
}

/* What the smooth coat lets through of a direction. */
static inline brdf_real brdf_wood_pass(brdf_vec3 w, brdf_real eta)
{
    brdf_real cosine = brdf_clamp(w.z, 0.0f, 1.0f);
    return 1.0f - brdf_fresnel_between(cosine, brdf_fiber_inside(w, eta).z, eta);
}

static inline brdf_rgb brdf_wood_coat(struct brdf_wood p, brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real cosine = brdf_clamp(0.5f * (brdf_dot(wo, h) + brdf_dot(wi, h)), 0.0f, 1.0f);
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area_o = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real area_i = brdf_microfacet_area(p.distribution, wi, p.alpha, p.alpha);
    brdf_real g = brdf_microfacet_visibility(BRDF_MASKING_CORRELATED, wo.z, wi.z, area_o, area_i);
    brdf_real fresnel = brdf_fresnel_dielectric(cosine, p.eta).reflectance;
    return brdf_rgb_scale(p.specular_reflectance, 0.25f * fresnel * d * g);
}

static inline brdf_rgb brdf_wood_eval(struct brdf_wood p, brdf_vec3 wo, brdf_vec3 wi,
                                      BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real lobe = brdf_fiber_lobe(brdf_wood_fiber(p), wo, wi) * (0.5f / p.eta);
    brdf_rgb below = brdf_rgb_add(brdf_rgb_scale(p.diffuse_reflectance, BRDF_1_PI),
                                  brdf_rgb_scale(p.fiber_reflectance, lobe));
    brdf_real passes = brdf_wood_pass(wo, p.eta) * brdf_wood_pass(wi, p.eta);
    brdf_rgb f = brdf_rgb_add(brdf_wood_coat(p, wo, wi), brdf_rgb_scale(below, passes));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

/* The probabilities of sampling each part, by what it would reflect. */
struct brdf_wood_chances {
    brdf_real coat;
    brdf_real fibers;
    brdf_real diffuse;
};

static inline struct brdf_wood_chances
brdf_wood_chances_of(struct brdf_wood p, struct brdf_fiber_cone cone, brdf_vec3 wo)
{
    brdf_real passes = brdf_wood_pass(wo, p.eta);
    brdf_real coat = (1.0f - passes) * brdf_rgb_largest(p.specular_reflectance);
    brdf_real fibers = passes * brdf_max(cone.mass, 0.01f) * brdf_rgb_largest(p.fiber_reflectance);
    brdf_real diffuse = passes * brdf_rgb_largest(p.diffuse_reflectance);
    brdf_real inverse = 1.0f / brdf_max(coat + fibers + diffuse, 1e-12f);
    struct brdf_wood_chances chances;
    chances.coat = coat * inverse;
    chances.fibers = fibers * inverse;
    chances.diffuse = diffuse * inverse;
    return chances;
}

static inline brdf_real brdf_wood_pdf(struct brdf_wood p, brdf_vec3 wo, brdf_vec3 wi,
                                      BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_fiber fiber = brdf_wood_fiber(p);
    struct brdf_fiber_cone cone = brdf_fiber_cone_of(fiber, wo);
    struct brdf_wood_chances chances = brdf_wood_chances_of(p, cone, wo);
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real pdf = chances.coat * (0.25f * d / brdf_max(area, 1e-20f)) +
                    chances.fibers * brdf_fiber_pdf(fiber, cone, wi) +
                    chances.diffuse * brdf_warp_cosine_pdf(wi);
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_wood_sample(struct brdf_wood p, brdf_vec3 wo, brdf_vec3 u,
                                                  BRDF_GLOBAL const float *table)
{
    struct brdf_fiber fiber = brdf_wood_fiber(p);
    struct brdf_fiber_cone cone = brdf_fiber_cone_of(fiber, wo);
    struct brdf_wood_chances chances = brdf_wood_chances_of(p, cone, wo);
    brdf_vec3 h = brdf_microfacet_sample(p.distribution, wo, p.alpha, p.alpha, u.x, u.y);
    brdf_vec3 wi = brdf_half_mirror(wo, h);
    brdf_vec3 by_fibers = brdf_fiber_sample(fiber, cone, u.x, u.y);
    wi = brdf_vec3_pick(u.z < chances.coat, wi, by_fibers);
    wi = brdf_vec3_pick(u.z < chances.coat + chances.fibers, wi, brdf_warp_cosine(u.x, u.y));

    brdf_real pdf = brdf_wood_pdf(p, wo, wi, table);
    /* A density below 1e-20 says that rounding has taken wi off its lobe. */
    return brdf_sample_weigh(pdf > 1e-20f, wi, brdf_wood_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(wood, WOOD, BRDF_REFLECTION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL,
           "finished wood: a clear coat over fibres with a highlight of their own",
           "Marschner, Westin, Arbree and Moon 2005")
#endif
