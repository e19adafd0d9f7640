/*
 * henyeygreenstein.h - how a grain or a droplet scatters: a lobe on the whole sphere.
 *
 * Reference: Henyey and Greenstein 1941 (Diffuse radiation in the galaxy):
 *   p = (1 - g^2) / (1 + g^2 - 2 g cos)^(3/2), of mean 1 over the sphere, for g in [0, 1).
 * The angle comes and goes as `far` = 1 - cos, which keeps its digits where the lobe is narrow.
 */
#ifndef BRDF_HENYEYGREENSTEIN_H
#define BRDF_HENYEYGREENSTEIN_H

#include "math.h"
#include "vec.h"

static inline brdf_real brdf_henyeygreenstein(brdf_real far, brdf_real g)
{
    brdf_real square = (1.0f - g) * (1.0f - g) + 2.0f * g * far;
    return (1.0f - g) * (1.0f + g) / (square * sqrtf(square));
}

/*
 * A direction about +z with density p / (4 pi) [1/sr]. The inverse of the distribution with
 * s = 2 u - 1, multiplied out so that nothing is divided by g: g = 0 is the uniform sphere.
 */
static inline brdf_vec3 brdf_henyeygreenstein_sample(brdf_real g, brdf_real u, brdf_real v)
{
    brdf_real s = 2.0f * u - 1.0f;
    brdf_real below = 1.0f + g * s;
    brdf_real bracket = 1.0f - g * (0.5f * (3.0f - s) + g * (s - g * (0.5f + 0.5f * s)));
    brdf_real far = brdf_clamp(2.0f * (1.0f - u) * bracket / (below * below), 0.0f, 2.0f);
    brdf_real radius = sqrtf(far * (2.0f - far));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, 1.0f - far);
}

#endif
