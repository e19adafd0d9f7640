/*
 * trial.h - every statistical test over one material, or over all materials of a model.
 */
#ifndef BRDFLAB_TRIAL_H
#define BRDFLAB_TRIAL_H

#include <stddef.h>

#include <brdf/info.h>
#include <brdf/material.h>

#include "finding.h"

struct lab_trial {
    size_t calls;            /* random inputs of the tests of values */
    size_t samples;          /* of a chi-square test */
    unsigned long long seed; /* another seed, other inputs and samples */
    double significance;     /* of all chi-square tests together, 0.01 for example */
    size_t comparisons;      /* how many chi-square tests that are (cases.h knows how many the
                                suite has); 0: those of this material */
};

/* Is told each finding as soon as there is one. */
typedef void lab_trial_report(const struct lab_finding *finding, void *data);

/*
 * Test a material: values (values.h), then energy, albedo by both ways, mass and chi-square from
 * each view (density.h) that shows something. Findings are results, not failures: the status tells
 * whether the tests could be made. BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_trial_run(const struct lab_trial *trial, const struct brdf_bsdf *bsdf,
                          lab_trial_report *report, void *data, struct brdf_error *error);

#endif
