/*
 * evaluate_arrays.h - the arrays of an evaluator on its device: planes of numbers, in and out.
 */
#ifndef BRDFCL_LIB_EVALUATE_ARRAYS_H
#define BRDFCL_LIB_EVALUATE_ARRAYS_H

#include <brdf/material.h>

#include "opencl.h"

/* The planes of evaluate.cl. */
enum {
    EVALUATE_IN_WO = 0,
    EVALUATE_IN_WI = 3,
    EVALUATE_IN_U = 6,
    EVALUATE_IN_PLANES = 9,
    EVALUATE_OUT_F = 0,
    EVALUATE_OUT_PDF = 3,
    EVALUATE_OUT_SAMPLE = 4,
    EVALUATE_OUT_PLANES = 13
};

/* Elements are padded to whole packets at any lanes, and to whole work-groups of them. */
enum { EVALUATE_PADDING = 1024 };

struct evaluate_arrays {
    struct brdfcl_device *device;
    cl_mem input;
    cl_mem output;
    size_t padded; /* elements that are computed */
    size_t stride; /* from a plane to the next, in elements */
};

/* Make room for `count` elements; what is there stays if it has just the right size. */
brdf_status evaluate_arrays_fit(struct evaluate_arrays *arrays, size_t count,
                                struct brdf_error *error);
void evaluate_arrays_release(struct evaluate_arrays *arrays);

/* Three planes from this one on, copied in. */
brdf_status evaluate_arrays_put(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                struct brdf_vectors vectors, struct brdf_error *error);

/* One plane of 4-byte words, or three, copied out; not wanted where `to` is NULL. */
brdf_status evaluate_arrays_get(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                void *to, struct brdf_error *error);
brdf_status evaluate_arrays_get_colors(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                       struct brdf_colors to, struct brdf_error *error);

#endif
