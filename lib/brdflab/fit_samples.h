/*
 * fit_samples.h - where a fit is compared with its target, and how.
 */
#ifndef BRDFLAB_FIT_SAMPLES_H
#define BRDFLAB_FIT_SAMPLES_H

#include "fit.h"

/* Pairs of directions, the target there, and room for a fit. One block of memory. */
struct fit_samples {
    size_t count;
    enum lab_fit_metric metric;
    float *memory;
    struct brdf_vectors wo;
    struct brdf_vectors wi;
    float *target[3]; /* g(f cos), by channel */
    float *value[3];  /* of one part, and of the blend */
    float *sum[3];
};

/* Directions, and the target at each of them; to be freed. */
brdf_status fit_samples_make(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                             struct fit_samples *samples, struct brdf_error *error);

void fit_samples_free(struct fit_samples *samples);

/* The mean square of the error of parts times their weights; of black if count is 0. */
double fit_samples_error(struct fit_samples *samples, const struct brdf_bsdf *const *parts,
                         const double *weights, int count);

#endif
