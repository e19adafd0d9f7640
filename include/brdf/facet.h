/*
 * facet.h - the one facet of a rough dielectric interface that sends light from wi to wo, by
 * reflection or by refraction, whichever the sides of both ask for.
 *
 * Its normal is that of Walter et al. 2007, eq. 13 and 16, its reflectance Fresnel's.
 */
#ifndef BRDF_FACET_H
#define BRDF_FACET_H

#include "interface.h"
#include "vec.h"

/* The facet that sends light from wi to wo; the same bits with the two exchanged. */
struct brdf_facet {
    brdf_mask mirrors; /* wo and wi on one side */
    brdf_mask exists;
    brdf_vec3 h;           /* on the upper side */
    brdf_real reflectance; /* Fresnel's */
    brdf_real cos_o;       /* of wo, wi to the facet on their own side */
    brdf_real cos_i;
    brdf_real length2; /* of the sum of the directions, each times its index over that above */
};

/* eta: the index below over that above. */
static inline struct brdf_facet brdf_facet_between(brdf_vec3 wo, brdf_vec3 wi, brdf_real eta)
{
    struct brdf_facet facet;
    brdf_mask outside = wo.z > 0.0f;
    facet.mirrors = (outside & (wi.z > 0.0f)) | ((wo.z < 0.0f) & (wi.z < 0.0f));
    brdf_mask passes = (outside & (wi.z < 0.0f)) | ((wo.z < 0.0f) & (wi.z > 0.0f));
    brdf_vec3 above = brdf_vec3_pick(outside, wo, wi);
    brdf_vec3 below = brdf_vec3_pick(outside, wi, wo);
    brdf_vec3 sum =
        brdf_vec3_pick(facet.mirrors, brdf_add(wo, wi), brdf_add(above, brdf_scale(below, eta)));
    brdf_vec3 h = brdf_normalize(sum);
    facet.h = brdf_vec3_pick(h.z < 0.0f, brdf_negate(h), h);
    facet.length2 = brdf_max(brdf_dot(sum, sum), 1e-12f);

    brdf_real dot_o = brdf_dot(wo, facet.h);
    brdf_real dot_i = brdf_dot(wi, facet.h);
    facet.cos_o = brdf_clamp(brdf_pick(outside, dot_o, -dot_o), 0.0f, 1.0f);
    facet.cos_i = brdf_clamp(brdf_pick(wi.z > 0.0f, dot_i, -dot_i), 0.0f, 1.0f);
    facet.exists = facet.mirrors | (passes & (facet.cos_o > 0.0f) & (facet.cos_i > 0.0f));

    brdf_real cos_above = brdf_pick(outside, facet.cos_o, facet.cos_i);
    brdf_real cos_below = brdf_pick(outside, facet.cos_i, facet.cos_o);
    brdf_real mirrored = brdf_fresnel_dielectric(0.5f * (facet.cos_o + facet.cos_i),
                                                 brdf_pick(outside, eta, 1.0f / eta))
                             .reflectance;
    brdf_real between = brdf_fresnel_between(cos_above, cos_below, eta);
    facet.reflectance = brdf_pick(facet.mirrors, mirrored, between);
    return facet;
}

/* w where distributions of normals and their masking speak: mirrored to the upper side. */
static inline brdf_vec3 brdf_facet_upper(brdf_vec3 w)
{
    return brdf_vec3_make(w.x, w.y, fabsf(w.z));
}

#endif
