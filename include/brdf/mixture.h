/*
 * mixture.h - a diffuse part and a lobe, sampled together: one of both is chosen, by u.z.
 *
 * The density is that of either, so the weight stays below the larger of the two parts' own
 * weights, each over the chance of its part.
 */
#ifndef BRDF_MIXTURE_H
#define BRDF_MIXTURE_H

#include "sample.h"
#include "warp.h"

/* The chance of the lobe, from what each part reflects. It may depend on wo, but not on wi. */
static inline brdf_real brdf_mixture_share(brdf_rgb lobe, brdf_rgb diffuse)
{
    brdf_real a = brdf_rgb_largest(lobe);
    return a / brdf_max(a + brdf_rgb_largest(diffuse), 1e-12f);
}

/* Density [1/sr] of wi, where the lobe alone would have the density `lobe`. */
static inline brdf_real brdf_mixture_pdf(brdf_real share, brdf_real lobe, brdf_vec3 wi)
{
    return share * lobe + (1.0f - share) * brdf_warp_cosine_pdf(wi);
}

/*
 * The sample wi, given f cos / pdf of each part sampled alone: `lobe_weight` with density
 * `lobe_pdf`, and `diffuse_weight` with that of a cosine.
 */
static inline struct brdf_sample brdf_mixture_sample(brdf_vec3 wo, brdf_vec3 wi, brdf_real share,
                                                     brdf_real lobe_pdf, brdf_rgb lobe_weight,
                                                     brdf_rgb diffuse_weight)
{
    brdf_real pdf = brdf_mixture_pdf(share, lobe_pdf, wi);
    /* Below 1e-20 only rounding leads, at grazing where h is lost in wo + wi. */
    brdf_mask valid = (wo.z > 0.0f) & (wi.z > 0.0f) & (pdf > 1e-20f);
    brdf_real inverse = 1.0f / brdf_pick(valid, pdf, 1.0f);
    brdf_rgb lobe = brdf_rgb_scale(lobe_weight, lobe_pdf * inverse);
    brdf_rgb diffuse = brdf_rgb_scale(diffuse_weight, brdf_warp_cosine_pdf(wi) * inverse);
    return brdf_sample_where(valid, brdf_sample_make(wi, brdf_rgb_add(lobe, diffuse), pdf));
}

#endif
