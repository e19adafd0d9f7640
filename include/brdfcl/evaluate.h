/*
 * evaluate.h - a bsdf over arrays on an OpenCL device: what brdf_eval_many and its like are in C.
 *
 * The results have the same bits as those of C. Arrays are copied to the device and back; who keeps
 * data on the device had better put the shared source into a kernel of his own (brdf/source.h).
 */
#ifndef BRDFCL_EVALUATE_H
#define BRDFCL_EVALUATE_H

#include <stddef.h>

#include <brdf/material.h>
#include <brdf/status.h>
#include <brdfcl/api.h>
#include <brdfcl/device.h>

#ifdef __cplusplus
extern "C" {
#endif

struct brdfcl_evaluator;

/*
 * Build kernels for a bsdf, specialised to its model, options and sides; its numbers are data.
 * Device and bsdf must outlive the evaluator, which one thread at a time may use. On failure *out
 * is NULL. BRDF_DEVICE (with the compiler's log), BRDF_OUT_OF_MEMORY.
 */
BRDFCL_API brdf_status brdfcl_evaluator_create(struct brdfcl_device *device,
                                               const struct brdf_bsdf *bsdf,
                                               struct brdfcl_evaluator **out,
                                               struct brdf_error *error);

/* NULL is fine. */
BRDFCL_API void brdfcl_evaluator_destroy(struct brdfcl_evaluator *evaluator);

/*
 * f(wo, wi) [1/sr] of `count` elements, without the cosine. BRDF_DEVICE, BRDF_OUT_OF_MEMORY,
 * BRDF_OUT_OF_RANGE (more than 2^30 elements).
 */
BRDFCL_API brdf_status brdfcl_evaluator_eval(struct brdfcl_evaluator *evaluator, size_t count,
                                             struct brdf_vectors wo, struct brdf_vectors wi,
                                             struct brdf_colors f, struct brdf_error *error);

/* The density [1/sr] with which wi is sampled. */
BRDFCL_API brdf_status brdfcl_evaluator_pdf(struct brdfcl_evaluator *evaluator, size_t count,
                                            struct brdf_vectors wo, struct brdf_vectors wi,
                                            float *pdf, struct brdf_error *error);

/* A direction for each three uniform numbers; `eta` and `delta` of the samples may be NULL. */
BRDFCL_API brdf_status brdfcl_evaluator_sample(struct brdfcl_evaluator *evaluator, size_t count,
                                               struct brdf_vectors wo, struct brdf_vectors u,
                                               struct brdf_samples samples,
                                               struct brdf_error *error);

/* A sample, and f and pdf for its direction, in one kernel: what a bounce of a path needs. */
BRDFCL_API brdf_status brdfcl_evaluator_bounce(struct brdfcl_evaluator *evaluator, size_t count,
                                               struct brdf_vectors wo, struct brdf_vectors u,
                                               struct brdf_samples samples, struct brdf_colors f,
                                               float *pdf, struct brdf_error *error);

/*
 * Run the kernel of the last call `times` more over the arrays that are on the device, copying
 * nothing; *seconds is what all of them took together. BRDF_BAD_ARGUMENT if there was no call.
 */
BRDFCL_API brdf_status brdfcl_evaluator_repeat(struct brdfcl_evaluator *evaluator, int times,
                                               double *seconds, struct brdf_error *error);

#ifdef __cplusplus
}
#endif

#endif
