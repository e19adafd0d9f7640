/*
 * round.h - the surface that is equally rough along both tangents and loses about as much light as
 * one that is not, so that fits and tables over one alpha serve both.
 *
 * Smith's masking of a direction w depends on tan(w) alpha(w), alpha(w) being the roughness along
 * w's azimuth. The round surface with roughness `alpha` is masked as much under the tangent
 * tan(w) alpha(w) / alpha: there its loss is looked up. That alone determines alpha up to what
 * happens across w; the blend of both means below was chosen against quadratures of GGX and
 * Beckmann, over pairs from 0.01 to 2: docs/models/roughconductor.md has the errors that remain.
 * Where both alphas are equal, alpha and cosines are theirs to the last bit.
 */
#ifndef BRDF_ROUND_H
#define BRDF_ROUND_H

#include "vec.h"

/* How far alpha lies from the arithmetic mean, at 0, towards the root of the mean square, at 1. */
#define BRDF_ROUND_SMITH 0.8f
#define BRDF_ROUND_VCAVITY 0.55f

struct brdf_round {
    brdf_real alpha;
    brdf_real stretch_u; /* square of alpha_u / alpha */
    brdf_real stretch_v;
    brdf_mask same; /* alpha_u = alpha_v */
};

static inline struct brdf_round brdf_round_make(float blend, brdf_real alpha_u, brdf_real alpha_v)
{
    struct brdf_round round;
    brdf_real mean = 0.5f * (alpha_u + alpha_v);
    brdf_real root = sqrtf(0.5f * (alpha_u * alpha_u + alpha_v * alpha_v));
    round.alpha = brdf_clamp(mean + blend * (root - mean), 1e-4f, 2.0f);
    brdf_real u = alpha_u / round.alpha;
    brdf_real v = alpha_v / round.alpha;
    round.stretch_u = u * u;
    round.stretch_v = v * v;
    round.same = alpha_u == alpha_v;
    return round;
}

/* The cosine under which the round surface is masked as much as this one is from w; z >= 0. */
static inline brdf_real brdf_round_cosine(struct brdf_round round, brdf_vec3 w)
{
    brdf_real across = round.stretch_u * (w.x * w.x) + round.stretch_v * (w.y * w.y);
    brdf_real cosine = brdf_clamp(w.z, 0.0f, 1.0f);
    brdf_real stretched = cosine / sqrtf(brdf_max(cosine * cosine + across, 1e-30f));
    return brdf_pick(round.same, cosine, brdf_min(stretched, 1.0f));
}

#endif
