/*
 * arrays.h - what is evaluated in bulk: directions and random numbers in, results out; in C on some
 * threads, or on a device.
 */
#ifndef BENCH_ARRAYS_H
#define BENCH_ARRAYS_H

#include <stddef.h>

#include <brdf/material.h>
#include <brdfcl/evaluate.h>

enum operation {
    OPERATION_SAMPLE,
    OPERATION_EVAL,
    OPERATION_PDF,
    OPERATION_BOUNCE, /* a sample, and f and pdf for its direction */
    OPERATION_COUNT
};

const char *operation_name(enum operation operation);

/* Bytes that one evaluation reads and writes, each counted once. */
int operation_bytes(enum operation operation);

struct arrays_in {
    float *wo[3];
    float *wi[3];
    float *u[3];
};

struct arrays_out {
    float *f[3];
    float *pdf;
    float *sample[8]; /* wi, weight, pdf, eta */
    int *delta;
};

/* All in one piece of memory. Zero is an empty one. */
struct arrays {
    size_t count;
    struct arrays_in in;
    struct arrays_out c;      /* what C makes of it */
    struct arrays_out opencl; /* and OpenCL */
    void *memory;
};

/* Directions from all over the hemispheres, most of them above; the same seed makes the same. */
brdf_status arrays_create(struct arrays *arrays, size_t count, unsigned seed,
                          struct brdf_error *error);
void arrays_destroy(struct arrays *arrays);

/* The operation over the elements [first, end), by the array functions of libbrdf. */
void arrays_run_c(struct arrays *arrays, const struct brdf_bsdf *bsdf, enum operation operation,
                  size_t first, size_t end);

/* The same over all of them by OpenCL, with copies to the device and back. */
brdf_status arrays_run_opencl(struct arrays *arrays, struct brdfcl_evaluator *evaluator,
                              enum operation operation, struct brdf_error *error);

/* Elements for which C and OpenCL do not have the same bits; *max_ulp is the largest difference. */
size_t arrays_compare(const struct arrays *arrays, enum operation operation, unsigned *max_ulp);

/*
 * As brdf_bsdf_create; a measured model without its file gets one that is made for it, where one
 * can be made, in $TMPDIR for a moment. BRDF_UNSUPPORTED where it cannot.
 */
brdf_status measured_bsdf_create(const char *description, struct brdf_bsdf **out,
                                 struct brdf_error *error);

#endif
