/*
 * surface.h - a material with its flags: what host and kernels evaluate, instead of the bare model.
 *
 * Where BRDF_TWOSIDED is set, the side below the surface is the mirror image of the side above:
 * both directions are mirrored in z where wo is below, and a sampled wi is mirrored back. The flag
 * is one for all lanes, so materials without it pay nothing.
 */
#ifndef BRDF_SURFACE_H
#define BRDF_SURFACE_H

#include "model.h"

static inline brdf_vec3 brdf_surface_mirror(brdf_mask below, brdf_vec3 w)
{
    w.z = brdf_pick(below, -w.z, w.z);
    return w;
}

/* f(wo, wi) [1/sr], without the cosine. */
static inline brdf_rgb brdf_surface_eval(unsigned model, unsigned flags, brdf_parameters p,
                                         brdf_vec3 wo, brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    if (flags & BRDF_TWOSIDED) {
        brdf_mask below = wo.z < 0.0f;
        wo = brdf_surface_mirror(below, wo);
        wi = brdf_surface_mirror(below, wi);
    }
    return brdf_model_eval(model, p, wo, wi, table);
}

/* Density [1/sr] with which brdf_surface_sample returns wi. */
static inline brdf_real brdf_surface_pdf(unsigned model, unsigned flags, brdf_parameters p,
                                         brdf_vec3 wo, brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    if (flags & BRDF_TWOSIDED) {
        brdf_mask below = wo.z < 0.0f;
        wo = brdf_surface_mirror(below, wo);
        wi = brdf_surface_mirror(below, wi);
    }
    return brdf_model_pdf(model, p, wo, wi, table);
}

/* A direction wi for the uniform numbers u in [0, 1)^3: x, y place it, z chooses among lobes. */
static inline struct brdf_sample brdf_surface_sample(unsigned model, unsigned flags,
                                                     brdf_parameters p, brdf_vec3 wo, brdf_vec3 u,
                                                     BRDF_GLOBAL const float *table)
{
    struct brdf_sample s;
    if (flags & BRDF_TWOSIDED) {
        brdf_mask below = wo.z < 0.0f;
        s = brdf_model_sample(model, p, brdf_surface_mirror(below, wo), u, table);
        s.wi = brdf_surface_mirror(below, s.wi);
    } else {
        s = brdf_model_sample(model, p, wo, u, table);
    }
    return s;
}

#endif
