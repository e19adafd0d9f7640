/*
 * trial.c - every test over one material.
 */
#include "trial.h"

#include <brdf/model.h>

#include "albedo.h"
#include "density.h"
#include "energy.h"
#include "statistics.h"
#include "values.h"

/* Inputs of the tests that compare: each costs several evaluations. */
static size_t some(size_t calls)
{
    return calls / 4 + 1;
}

static void run_values(const struct lab_trial *trial, const struct brdf_bsdf *bsdf,
                       lab_trial_report *report, void *data)
{
    const struct lab_finding findings[] = {
        lab_try_finite(bsdf, trial->calls, 4 * trial->seed),
        lab_try_reciprocal(bsdf, some(trial->calls), 4 * trial->seed + 1),
        lab_try_isotropic(bsdf, some(trial->calls), 4 * trial->seed + 2),
        lab_try_weight(bsdf, some(trial->calls), 4 * trial->seed + 3),
    };
    for (size_t i = 0; i < sizeof findings / sizeof findings[0]; ++i) {
        report(&findings[i], data);
    }
}

static brdf_status run_view(const struct lab_trial *trial, const struct brdf_bsdf *bsdf, int view,
                            double limit, lab_trial_report *report, void *data,
                            struct brdf_error *error)
{
    brdf_vec3 wo = lab_view_direction(view);
    struct lab_finding albedo;
    struct lab_density density;
    struct lab_finding energy = lab_try_energy(bsdf, wo, LAB_ALBEDO_SAMPLES);
    report(&energy, data);
    brdf_status status = lab_try_albedo(bsdf, wo, LAB_ALBEDO_SAMPLES, &albedo, error);
    if (!status) {
        report(&albedo, data);
        status = lab_try_density(bsdf, view, trial->samples, trial->seed, limit, &density, error);
    }
    if (!status) {
        report(&density.mass, data);
        report(&density.chi2, data);
    }
    return status;
}

brdf_status lab_trial_run(const struct lab_trial *trial, const struct brdf_bsdf *bsdf,
                          lab_trial_report *report, void *data, struct brdf_error *error)
{
    int views = lab_view_count(brdf_bsdf_material(bsdf)->flags);
    size_t comparisons = trial->comparisons ? trial->comparisons : (size_t)views;
    double limit = lab_sidak(trial->significance, comparisons);
    brdf_status status = BRDF_OK;
    run_values(trial, bsdf, report, data);
    for (int view = 0; view < views && !status; ++view) {
        status = run_view(trial, bsdf, view, limit, report, data, error);
    }
    return status;
}
