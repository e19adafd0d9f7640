/*
 * check.h - C against OpenCL: do both give the same bits?
 */
#ifndef BRDFCL_CHECK_H
#define BRDFCL_CHECK_H

#include <stddef.h>

#include <brdf/status.h>
#include <brdfcl/api.h>

#ifdef __cplusplus
extern "C" {
#endif

struct brdfcl_device; /* device.h */

/* What came of one operation of one model. */
struct brdfcl_check_result {
    const char *model;
    const char *operation; /* "eval", "pdf" or "sample" */
    int lanes;             /* of the device */
    size_t compared;       /* calls; a sample counts once, with all its members */
    size_t differing;      /* calls of which at least one bit differs */
    unsigned max_ulp;      /* largest difference of any number [units in the last place] */
    const char *first;     /* the first call that differs, in words; NULL where none does */
};

/* Is told each result; the strings last until it returns. */
typedef void brdfcl_check_report(const struct brdfcl_check_result *result, void *data);

/*
 * Evaluate a model (its tag, 0 ... brdf_model_count() - 1) in C and on the device, at the device's
 * lanes, over at least `count` calls of each operation: 64 materials with parameters from all over
 * their ranges, random directions and numbers, grazing ones and limits among them. The same seed
 * gives the same calls. Calls `report` three times. Differences are results, not failures: the
 * status tells whether the check could be made. A model that reads a file gets one made in $TMPDIR.
 */
BRDFCL_API brdf_status brdfcl_check_model(struct brdfcl_device *device, int model, size_t count,
                                          unsigned seed, brdfcl_check_report *report, void *data,
                                          struct brdf_error *error);

#ifdef __cplusplus
}
#endif

#endif
