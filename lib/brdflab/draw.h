/*
 * draw.h - directions for integrals over pairs of them: by turns from the cosine and from a
 * material, so that highlights are not missed, and weighted by the mixture of both.
 */
#ifndef BRDFLAB_DRAW_H
#define BRDFLAB_DRAW_H

#include <brdf/material.h>

struct lab_draw {
    brdf_vec3 wi;
    double weight; /* cos(theta_i) over the density of wi; 0: none, or not above the surface */
};

/* Draw number i for a viewer at wo, from uniform numbers. */
struct lab_draw lab_draw_make(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t i, brdf_vec3 u);

#endif
