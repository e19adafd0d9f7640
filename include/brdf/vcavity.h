/*
 * vcavity.h - masking and shadowing of facets that lie in pairs, as the walls of V-shaped grooves.
 *
 * G = min(1, 2 cos(h) cos(wo) / cos(wo, h), 2 cos(h) cos(wi) / cos(wi, h))
 * References: Torrance and Sparrow 1967; Blinn 1977; Cook and Torrance 1982; as masking of visible
 * normals, Heitz and d'Eon 2014.
 * Both fractions are k cos with k = 4 (cos(wo) + cos(wi)) / |wo + wi|^2: no angle of h is needed.
 */
#ifndef BRDF_VCAVITY_H
#define BRDF_VCAVITY_H

#include "halfvector.h"

static inline brdf_real brdf_vcavity_slope(struct brdf_half h)
{
    return 4.0f * brdf_max(h.sum.z, 0.0f) / h.square;
}

/* G / (cos(wo) cos(wi)): finite at grazing. Symmetric to the last bit. */
static inline brdf_real brdf_vcavity_visibility(struct brdf_half h, brdf_real cos_o,
                                                brdf_real cos_i)
{
    brdf_real open = 1.0f / brdf_max(cos_o * cos_i, 1e-20f);
    brdf_real masked = brdf_vcavity_slope(h) / brdf_max(brdf_max(cos_o, cos_i), 1e-10f);
    return brdf_min(open, masked);
}

/* G1(wo) / cos(wo): the part of the normals h that wo sees, G1 being the second number in G. */
static inline brdf_real brdf_vcavity_seen(struct brdf_half h, brdf_real cos_o)
{
    return brdf_min(1.0f / brdf_max(cos_o, 1e-10f), brdf_vcavity_slope(h));
}

/* Density [1/sr] of wi where h is a visible normal: G1(wo) D(h) / (4 cos(wo)), given D(h). */
static inline brdf_real brdf_vcavity_pdf(struct brdf_half h, brdf_real cos_o, brdf_real d)
{
    return 0.25f * d * brdf_vcavity_seen(h, cos_o);
}

/* G / G1(wo) <= 1: the weight of a visible normal, without Fresnel. */
static inline brdf_real brdf_vcavity_weight(struct brdf_half h, brdf_real cos_o, brdf_real cos_i)
{
    brdf_real both = brdf_vcavity_visibility(h, cos_o, cos_i) * brdf_max(cos_i, 0.0f);
    return brdf_min(both / brdf_max(brdf_vcavity_seen(h, cos_o), 1e-20f), 1.0f);
}

/*
 * From a normal with density D(h) cos(h) to a visible one: it or the opposite wall of its groove,
 * by the area that each shows to wo. u in [0, 1).
 */
static inline brdf_vec3 brdf_vcavity_visible_wall(brdf_vec3 wo, brdf_vec3 h, brdf_real u)
{
    brdf_vec3 opposite = brdf_vec3_make(-h.x, -h.y, h.z);
    brdf_real area = brdf_max(brdf_dot(wo, h), 0.0f);
    brdf_real area_opposite = brdf_max(brdf_dot(wo, opposite), 0.0f);
    return brdf_vec3_pick(u * (area + area_opposite) < area, h, opposite);
}

#endif
