/*
 * evaluation.h - f and pdf of a material for many pairs of directions, by C or by OpenCL.
 */
#ifndef BRDFCL_EVALUATION_H
#define BRDFCL_EVALUATION_H

#include <stddef.h>

#include <brdf/material.h>
#include <brdfcl/evaluate.h>

#include "backend.h"

/* All NULL before it is opened, and where C evaluates. */
struct evaluation {
    struct brdf_bsdf *bsdf;
    struct brdfcl_device *device;
    struct brdfcl_evaluator *evaluator;
};

/* Make the material (lab_open_filled), and the device if the backend has one. To be closed also if
 * it fails. */
brdf_status evaluation_open(struct evaluation *evaluation, const struct backend *backend,
                            const char *description, int fill, struct brdf_error *error);
void evaluation_close(struct evaluation *evaluation);

/* f [1/sr] without the cosine, and the density [1/sr]. */
brdf_status evaluation_run(const struct evaluation *evaluation, size_t count,
                           struct brdf_vectors wo, struct brdf_vectors wi, struct brdf_colors f,
                           float *pdf, struct brdf_error *error);

/*
 * Read pairs of directions from a file, "-" being standard input, and print f and pdf of each as
 * CSV. A line has six numbers, wo and wi as unit vectors, between commas or spaces; a first line
 * that begins with no number is a heading, and empty lines count for nothing. The error names file
 * and line.
 */
brdf_status evaluation_print_file(const struct evaluation *evaluation, const char *path,
                                  struct brdf_error *error);

#endif
