/*
 * fit.c - the search: many places are tried, and from the best of them it walks down.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/model.h>

#include "bake.h"
#include "fit_search.h"

enum { TRIES_A_START = 64 };

struct lab_fit_options lab_fit_defaults(const char *model)
{
    struct lab_fit_options options;
    memset(&options, 0, sizeof options);
    options.model = model;
    options.lobes = 1;
    options.metric = LAB_FIT_CUBE_ROOT;
    options.starts = 8;
    options.evaluations_max = 4000;
    return options;
}

static void parts_destroy(struct brdf_bsdf **parts, int count)
{
    for (int i = 0; i < count; ++i) {
        brdf_bsdf_destroy(parts[i]);
        parts[i] = NULL;
    }
}

static int place_compare(const void *a, const void *b)
{
    double x = ((const struct place *)a)->error;
    double y = ((const struct place *)b)->error;
    return (x > y) - (x < y);
}

/* Leave out what changes nothing, such as the exponent of a distribution that is not chosen. */
static void search_drop_idle(struct search *search)
{
    struct fit_space *space = &search->space;
    double point[FIT_COORDINATES];
    for (int i = space->size - 1; i >= 0; --i) {
        int changes = 0;
        for (unsigned long k = 0; k < 3 && !changes; ++k) {
            fit_space_start(space, k, point);
            point[i] = 0.3;
            double error = search_error(search, point);
            point[i] = 0.7;
            double other = search_error(search, point);
            changes = error < other || error > other;
        }
        if (!changes && space->size > 1) {
            fit_space_drop(space, i);
        }
    }
}

/* Try many places, and put the best first. */
static void search_places(struct search *search, struct place *places, int count)
{
    for (int i = 0; i < count && !search_stops(search); ++i) {
        fit_space_start(&search->space, search->options->seed + (unsigned long)i, places[i].point);
        places[i].error = sqrt(search_error(search, places[i].point));
        search->state.error = fmin(search->state.error, places[i].error);
    }
    qsort(places, (size_t)count, sizeof *places, place_compare);
}

static brdf_status check_options(const struct lab_fit_options *options,
                                 const struct brdf_bsdf *target, struct brdf_error *error)
{
    if (!options->model || options->lobes < 1 || options->lobes > 2 || options->starts < 1 ||
        options->starts > 1000 || options->evaluations_max < 1 ||
        options->evaluations_max > 1000000) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "a fit takes 1 or 2 lobes, 1 to 1000 starts and 1 to 1000000 evaluations");
    }
    const struct brdf_material *material = brdf_bsdf_material(target);
    if (material->flags & BRDF_DELTA || lab_has_delta(target)) {
        return brdf_fail(
            error, BRDF_UNSUPPORTED,
            "%s has a perfectly smooth part: what that reflects into the mirror direction has "
            "no values to compare, and a fit would not know of it; take a rough "
            "model of small alpha",
            brdf_model_info((int)material->model)->name);
    }
    return BRDF_OK;
}

/* From the places that were walked from, to the result. */
static brdf_status search_end(struct search *search, const struct place *places, int best_number,
                              struct lab_fit_result *result)
{
    const struct place *best = &places[best_number];
    int agree = 0;
    for (int i = 0; i < search->options->starts; ++i) {
        agree += places[i].error <= 1.01 * best->error + 1e-5 * result->error_black;
    }
    if (!isfinite(best->error)) {
        return brdf_fail(search->error, BRDF_UNSUPPORTED,
                         "no parameters of \"%s\" gave a finite error", search->options->model);
    }
    result->error = best->error;
    result->agreement = (double)agree / search->options->starts;
    result->samples = search->samples.count;
    result->evaluations = search->evaluations;
    result->part_count = search->space.part_count;
    return fit_space_parts(&search->space, best->point, result->parts, result->weights,
                           search->error);
}

static brdf_status search_run(struct search *search, struct lab_fit_result *result)
{
    int starts = search->options->starts;
    struct place *places = calloc((size_t)starts * TRIES_A_START, sizeof *places);
    int best = 0;
    brdf_status status;
    if (!places) {
        return brdf_fail(search->error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    search->state.starts = starts;
    search->state.error = HUGE_VAL;
    search_drop_idle(search);
    search_places(search, places, starts * TRIES_A_START);
    for (int i = 0; i < starts && !search->status; ++i) {
        search->state.start = i;
        search_walk(search, &places[i]);
        best = places[i].error < places[best].error ? i : best;
    }
    if (!search->status) {
        search_polish(search, &places[best]);
    }
    status = search->status ? search->status : search_end(search, places, best, result);
    free(places);
    return status;
}

brdf_status lab_fit(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                    struct lab_fit_result *result, struct brdf_error *error)
{
    struct search search;
    brdf_status status = check_options(options, target, error);
    memset(result, 0, sizeof *result);
    memset(&search, 0, sizeof search);
    search.options = options;
    search.error = error;
    if (!status) {
        status = fit_space_make(options, &search.space, error);
    }
    if (!status) {
        status = fit_samples_make(target, options, &search.samples, error);
    }
    if (!status) {
        result->error_black = sqrt(fit_samples_error(&search.samples, NULL, NULL, 0));
        status = result->error_black > 0.0
                     ? search_run(&search, result)
                     : brdf_fail(error, BRDF_UNSUPPORTED, "the material is black: nothing to fit");
    }
    fit_samples_free(&search.samples);
    return status;
}

brdf_status lab_fit_error(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                          const struct brdf_bsdf *const *parts, const double *weights, int count,
                          double *rms, struct brdf_error *error)
{
    struct fit_samples samples;
    brdf_status status = fit_samples_make(target, options, &samples, error);
    if (!status) {
        *rms = sqrt(fit_samples_error(&samples, parts, weights, count));
        fit_samples_free(&samples);
    }
    return status;
}

void lab_fit_free(struct lab_fit_result *result)
{
    parts_destroy(result->parts, result->part_count);
    memset(result, 0, sizeof *result);
}
