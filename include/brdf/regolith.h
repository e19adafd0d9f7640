/*
 * regolith.h - directions out of a deep layer of dark grains, as on the Moon.
 *
 * Light that has met one grain leaves with f cos(wi) proportional to x / (x + mu), where x and mu
 * are the cosines of wi and wo: a density without a closed inverse. The straight line
 * share + 2 (1 - share) x of the same value at x = 1 and the same integral has one, and no
 * direction carries more than 1.12 times the mean weight.
 */
#ifndef BRDF_REGOLITH_H
#define BRDF_REGOLITH_H

#include "math.h"
#include "vec.h"

/* The integral of x / (x + mu) over x in [0, 1]: 1 - mu ln(1 + 1 / mu). */
static inline brdf_real brdf_regolith_mass(brdf_real mu)
{
    brdf_real cosine = brdf_max(mu, 1e-12f);
    return 1.0f - cosine * brdf_log((1.0f + cosine) / cosine);
}

/* The part of a uniform hemisphere; what is left of 1 goes as the cosine. In [0.37, 1]. */
static inline brdf_real brdf_regolith_share(brdf_real mu)
{
    return brdf_clamp(2.0f - 1.0f / ((1.0f + mu) * brdf_regolith_mass(mu)), 0.0f, 1.0f);
}

static inline brdf_vec3 brdf_regolith_sample(brdf_real share, brdf_real u, brdf_real v)
{
    brdf_real root = sqrtf(share * share + 4.0f * (1.0f - share) * u);
    brdf_real z = brdf_min(2.0f * u / brdf_max(share + root, 1e-12f), 1.0f);
    brdf_real radius = sqrtf((1.0f - z) * (1.0f + z));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, z);
}

/* [1/sr], for w above the horizon. */
static inline brdf_real brdf_regolith_pdf(brdf_real share, brdf_vec3 w)
{
    return (0.5f * share + (1.0f - share) * w.z) * BRDF_1_PI;
}

#endif
