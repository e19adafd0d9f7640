/*
 * warp.h - from uniform numbers in [0, 1)^2 to directions, and the densities of doing so.
 */
#ifndef BRDF_WARP_H
#define BRDF_WARP_H

#include "math.h"
#include "vec.h"

/* A direction around +z with density cos / pi [1/sr] (Malley's method over a polar disk). */
static inline brdf_vec3 brdf_warp_cosine(brdf_real u, brdf_real v)
{
    brdf_real radius = sqrtf(u);
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, sqrtf(brdf_max(1.0f - u, 0.0f)));
}

static inline brdf_real brdf_warp_cosine_pdf(brdf_vec3 w)
{
    return brdf_max(w.z, 0.0f) * BRDF_1_PI;
}

/* A direction on the whole sphere, density 1 / (4 pi) [1/sr]. */
static inline brdf_vec3 brdf_warp_sphere(brdf_real u, brdf_real v)
{
    brdf_real z = 1.0f - 2.0f * u;
    brdf_real radius = sqrtf(brdf_max(1.0f - z * z, 0.0f));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, z);
}

#endif
