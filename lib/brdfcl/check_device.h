/*
 * check_device.h - eval, pdf and sample over arrays on a device: kernels/check.cl, seen from C.
 */
#ifndef BRDFCL_CHECK_DEVICE_H
#define BRDFCL_CHECK_DEVICE_H

#include <stddef.h>

#include <brdf/stored.h>
#include <brdf/status.h>

struct brdfcl_device;
struct check_device;

enum {
    CHECK_INPUTS = 9,   /* planes: wo, wi, u */
    CHECK_OUTPUTS = 13, /* planes: f, pdf, and a sample's wi, weight, pdf, eta, delta */
    CHECK_GROUP = 256   /* calls in a work-group, at any lanes */
};

/* For `stride` calls at a time, a multiple of CHECK_GROUP. The device and the table must outlive
 * it. */
brdf_status check_device_open(struct brdfcl_device *device, const float *table, size_t table_words,
                              size_t stride, struct check_device **out, struct brdf_error *error);

/* NULL is fine. */
void check_device_close(struct check_device *check);

/* Build the kernel for the model, the flags and the choices of the material. */
brdf_status check_device_build(struct check_device *check, const struct brdf_material *material,
                               struct brdf_error *error);

/* Run it over planes of `stride` numbers each, for a material of the values `word`. */
brdf_status check_device_run(struct check_device *check, const float *word, const float *input,
                             float *output, struct brdf_error *error);

#endif
