/*
 * facets.h - a surface of microfacets: a distribution of normals with a masking, and the sampling
 * that goes with both.
 *
 *   visible normals  of Smith's masking for GGX and Beckmann, of V-cavities for any distribution:
 *                    a sample weighs what the facet reflects times G2 / G1
 *   all normals      otherwise: density D cos(h), whatever the view; the weight has no bound
 *
 * `distribution`, `masking` and `visible` are the same for all lanes.
 */
#ifndef BRDF_FACETS_H
#define BRDF_FACETS_H

#include "microfacet.h"
#include "vcavity.h"

/* Beside those of microfacet.h. */
#define BRDF_MASKING_RATIONAL 2
#define BRDF_MASKING_VCAVITY 3

struct brdf_facets {
    int distribution;
    int masking;
    int visible; /* sample visible normals where they can be sampled */
    brdf_real alpha_u;
    brdf_real alpha_v;
};

/* Which of the three samplers. */
#define BRDF_FACETS_ALL 0
#define BRDF_FACETS_SMITH 1
#define BRDF_FACETS_WALLS 2

static inline int brdf_facets_sampler(struct brdf_facets facets)
{
    if (!facets.visible) {
        return BRDF_FACETS_ALL;
    }
    if (facets.masking == BRDF_MASKING_VCAVITY) {
        return BRDF_FACETS_WALLS;
    }
    return facets.distribution == BRDF_BLINN ? BRDF_FACETS_ALL : BRDF_FACETS_SMITH;
}

/*
 * brdf_microfacet_area by the rational approximation of Beckmann's G1 [Walter et al. 2007, eq. 27],
 * with s = 1 / (alpha tan(w)): cos(w) / G1(s), in a form that is finite at grazing. The error of G1
 * is below 0.35 %. Walter et al. use it for Blinn's distribution too.
 */
static inline brdf_real brdf_facets_area_rational(brdf_vec3 w, brdf_real alpha_u, brdf_real alpha_v)
{
    brdf_real x = alpha_u * w.x;
    brdf_real y = alpha_v * w.y;
    brdf_real slope = sqrtf(x * x + y * y);
    brdf_real s = brdf_clamp(w.z / brdf_max(slope, 1e-20f), 0.0f, 1.6f);
    brdf_real area = slope * (1.0f + s * (2.276f + 2.577f * s)) / (3.535f + 2.181f * s);
    return brdf_pick(s < 1.6f, brdf_max(area, w.z), w.z);
}

/* Smith's area by the chosen formula. */
static inline brdf_real brdf_facets_area(struct brdf_facets facets, brdf_vec3 w)
{
    if (facets.masking == BRDF_MASKING_RATIONAL) {
        return brdf_facets_area_rational(w, facets.alpha_u, facets.alpha_v);
    }
    return brdf_microfacet_area(facets.distribution, w, facets.alpha_u, facets.alpha_v);
}

static inline brdf_real brdf_facets_d(struct brdf_facets facets, struct brdf_half h)
{
    brdf_vec3 normal = brdf_normalize(h.sum);
    return brdf_microfacet_d(facets.distribution, normal, facets.alpha_u, facets.alpha_v);
}

/* G2 / (cos(wo) cos(wi)), symmetric to the last bit. */
static inline brdf_real brdf_facets_visibility(struct brdf_facets facets, struct brdf_half h,
                                               brdf_vec3 wo, brdf_vec3 wi)
{
    if (facets.masking == BRDF_MASKING_VCAVITY) {
        return brdf_vcavity_visibility(h, wo.z, wi.z);
    }
    int masking = facets.masking == BRDF_MASKING_CORRELATED ? BRDF_MASKING_CORRELATED
                                                            : BRDF_MASKING_SEPARABLE;
    return brdf_microfacet_visibility(masking, wo.z, wi.z, brdf_facets_area(facets, wo),
                                      brdf_facets_area(facets, wi));
}

/* Density [1/sr] of wi, given `d`, the density of normals for h. */
static inline brdf_real brdf_facets_pdf(struct brdf_facets facets, struct brdf_half h, brdf_vec3 wo,
                                        brdf_real d)
{
    int sampler = brdf_facets_sampler(facets);
    if (sampler == BRDF_FACETS_ALL) {
        /* D cos(h) / (4 cos(wo, h)) */
        return 0.125f * d * brdf_vcavity_slope(h);
    }
    if (sampler == BRDF_FACETS_WALLS) {
        return brdf_vcavity_pdf(h, wo.z, d);
    }
    brdf_real area = brdf_microfacet_area(facets.distribution, wo, facets.alpha_u, facets.alpha_v);
    return 0.25f * d / brdf_max(area, 1e-20f);
}

/* A normal with density D(h) cos(h), of any length. */
static inline brdf_vec3 brdf_facets_normal(struct brdf_facets facets, brdf_real u, brdf_real v)
{
    if (facets.distribution == BRDF_BECKMANN) {
        return brdf_half_sample_slopes(facets.alpha_u, facets.alpha_v, u, v);
    }
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_real x = facets.alpha_u * turn.cos;
    brdf_real y = facets.alpha_v * turn.sin;
    if (facets.distribution == BRDF_GGX) {
        brdf_real radius = sqrtf(u / brdf_max(1.0f - u, 1e-7f));
        return brdf_vec3_make(radius * x, radius * y, 1.0f);
    }
    /* On the ellipse of both alphas, n + 2 = 2 / radius^2. */
    brdf_real square = brdf_max(x * x + y * y, 1e-16f);
    brdf_real inverse = 1.0f / sqrtf(square);
    return brdf_half_sample_power(2.0f / square, u, x * inverse, y * inverse);
}

/* A normal to mirror wo about, of any length. u.z chooses the wall of a V-cavity. */
static inline brdf_vec3 brdf_facets_sample(struct brdf_facets facets, brdf_vec3 wo, brdf_vec3 u)
{
    int sampler = brdf_facets_sampler(facets);
    if (sampler == BRDF_FACETS_SMITH) {
        return brdf_microfacet_sample(facets.distribution, wo, facets.alpha_u, facets.alpha_v, u.x,
                                      u.y);
    }
    brdf_vec3 h = brdf_facets_normal(facets, u.x, u.y);
    return sampler == BRDF_FACETS_WALLS ? brdf_vcavity_visible_wall(wo, h, u.z) : h;
}

/* f cos(wi) / pdf without what the facet reflects: D cancels. */
static inline brdf_real brdf_facets_weight(struct brdf_facets facets, struct brdf_half h,
                                           brdf_vec3 wo, brdf_vec3 wi)
{
    int sampler = brdf_facets_sampler(facets);
    if (sampler == BRDF_FACETS_WALLS) {
        return brdf_vcavity_weight(h, wo.z, wi.z);
    }
    brdf_real g = brdf_facets_visibility(facets, h, wo, wi) * brdf_max(wi.z, 0.0f);
    if (sampler == BRDF_FACETS_ALL) {
        return 2.0f * g / brdf_max(brdf_vcavity_slope(h), 1e-20f);
    }
    g *= brdf_microfacet_area(facets.distribution, wo, facets.alpha_u, facets.alpha_v);
    /* The approximation of G1 is not that by which normals are sampled: up to 1.0035. */
    return brdf_min(g, facets.masking == BRDF_MASKING_RATIONAL ? 1.01f : 1.0f);
}

#endif
