/*
 * check_variants.h - C against OpenCL for some of a model's variants, for tests that are in a
 * hurry.
 *
 * A kernel is compiled for every variant (check_cases.h), which takes longer than running it.
 */
#ifndef BRDFCL_CHECK_VARIANTS_H
#define BRDFCL_CHECK_VARIANTS_H

#include <brdfcl/check.h>

struct check_share {
    int part;  /* of the variants every `parts`th, from this one on; 0 <= part */
    int parts; /* >= 1; more parts than variants count as that many */
};

/* brdfcl_check_model, but for a share of the variants, which has all of the `count` calls. */
brdf_status check_model_share(struct brdfcl_device *device, int model, size_t count, unsigned seed,
                              struct check_share share, brdfcl_check_report *report, void *data,
                              struct brdf_error *error);

#endif
