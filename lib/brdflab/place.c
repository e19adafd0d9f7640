/*
 * place.c - a new material at a place in a basis: a mixture with signed weights.
 */
#include "place.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bins.h"
#include "complete.h"
#include "logrelative.h"

/* The sum so far, one for each value of a table, and the cosines of its bins (0: below). */
struct sum {
    double *mapped;
    float *cosine;
    size_t bins;
};

static brdf_status sum_begin(struct sum *sum, const struct brdf_merl_file *file,
                             struct brdf_error *error)
{
    sum->bins = file->bins;
    sum->mapped = calloc(3 * file->bins, sizeof *sum->mapped);
    sum->cosine = calloc(file->bins, sizeof *sum->cosine);
    if (!sum->mapped || !sum->cosine) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    for (size_t bin = 0; bin < file->bins; ++bin) {
        double cosine;
        if (lab_bin_cosine(lab_bin_of(file, bin), &cosine)) {
            sum->cosine[bin] = (float)cosine;
        }
    }
    return BRDF_OK;
}

static brdf_status sum_add(struct sum *sum, const char *material, double weight,
                           struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = lab_complete_open(material, &file, error);
    for (size_t bin = 0; bin < sum->bins && !status; ++bin) {
        for (size_t c = 0; c < 3 && sum->cosine[bin] > 0.0f; ++c) {
            double f = fmax((double)file.rgb[3 * bin + c], 0.0);
            sum->mapped[3 * bin + c] +=
                weight * lab_logrelative_map(f, (double)sum->cosine[bin], 0.0);
        }
    }
    brdf_merl_free(&file);
    return status;
}

static void sum_end(const struct sum *sum, struct brdf_merl_file *file)
{
    for (size_t bin = 0; bin < sum->bins; ++bin) {
        for (size_t c = 0; c < 3 && sum->cosine[bin] > 0.0f; ++c) {
            double f =
                lab_logrelative_unmap(sum->mapped[3 * bin + c], (double)sum->cosine[bin], 0.0);
            file->rgb[3 * bin + c] = (float)fmin(f, 1e30);
        }
        file->invalid -= sum->cosine[bin] > 0.0f;
    }
}

/* The weight of material `number`: that of the mean, unless there is a start, and of the step. */
static double weight_of(const struct lab_basis *basis, size_t number, const char *start,
                        const double *step)
{
    size_t components = (size_t)basis->components;
    double weight = start ? 0.0 : 1.0 / (double)basis->count;
    for (size_t k = 0; k < components; ++k) {
        weight +=
            step[k] * basis->loading[number * components + k] / sqrt((double)(basis->count - 1));
    }
    return weight;
}

brdf_status lab_place_make(const struct lab_basis *basis, const char *const *materials,
                           const char *start, const double *step, lab_basis_progress *progress,
                           void *data, struct brdf_merl_file *file, struct brdf_error *error)
{
    struct sum sum = {NULL, NULL, 0};
    memset(file, 0, sizeof *file);
    brdf_status status = brdf_merl_create(file, error);
    if (!status) {
        status = sum_begin(&sum, file, error);
    }
    if (!status && start) {
        status = sum_add(&sum, start, 1.0, error);
    }
    for (size_t i = 0; i < basis->count && !status; ++i) {
        double weight = weight_of(basis, i, start, step);
        if (progress && progress(i, basis->count, data)) {
            status = brdf_fail(error, BRDF_CANCELLED, "stopped on request");
        } else if (fabs(weight) > 0.0) {
            status = sum_add(&sum, materials[i], weight, error);
        }
    }
    if (!status) {
        sum_end(&sum, file);
    } else {
        brdf_merl_free(file);
    }
    free(sum.mapped);
    free(sum.cosine);
    return status;
}
