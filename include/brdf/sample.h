/*
 * sample.h - what sampling a model returns: one struct, no out-parameters.
 */
#ifndef BRDF_SAMPLE_H
#define BRDF_SAMPLE_H

#include "vec.h"

struct brdf_sample {
    brdf_vec3 wi;    /* sampled direction, local frame, unit, away from the surface */
    brdf_rgb weight; /* f |cos wi| / pdf [1]; for a delta lobe its coefficient / pdf */
    brdf_real pdf;   /* [1/sr] of solid angle around wi; 0 = no sample (then weight = 0);
                        for a delta lobe the probability [1] of having chosen it */
    brdf_real eta;   /* refractive index on wi's side over that on wo's side; 1 if wi reflects */
    brdf_mask delta; /* true where wi comes from a delta lobe: eval and pdf know nothing of it */
};

static inline struct brdf_sample brdf_sample_make(brdf_vec3 wi, brdf_rgb weight, brdf_real pdf)
{
    struct brdf_sample s;
    s.wi = wi;
    s.weight = weight;
    s.pdf = pdf;
    s.eta = 1.0f;
    s.delta = 0;
    return s;
}

/* The same sample where the mask is true, "no sample" elsewhere. */
static inline struct brdf_sample brdf_sample_where(brdf_mask valid, struct brdf_sample s)
{
    s.weight = brdf_rgb_pick(valid, s.weight, brdf_gray(0.0f));
    s.pdf = brdf_pick(valid, s.pdf, 0.0f);
    s.delta = s.delta & valid;
    return s;
}

/* wi as a draw from the density `pdf` of something whose value there is f: weight = f |cos wi| /
   pdf where the mask is true, "no sample" elsewhere. */
static inline struct brdf_sample brdf_sample_weigh(brdf_mask valid, brdf_vec3 wi, brdf_rgb f,
                                                   brdf_real pdf)
{
    brdf_rgb weight = brdf_rgb_scale(f, fabsf(wi.z) / brdf_pick(valid, pdf, 1.0f));
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, pdf));
}

#endif
