/* mix.c - bins of several tables averaged, one by one. */
#include "mix.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bins.h"
#include "logrelative.h"

/* The tables that take part, and their shares. */
struct parts {
    const float **rgb;
    double *share; /* sums to 1 */
    size_t count;
};

static brdf_status parts_check(const struct brdf_merl_file *files, const double *weights,
                               size_t count, double *sum, struct brdf_error *error)
{
    *sum = 0.0;
    for (size_t k = 0; k < count; ++k) {
        if (!(weights[k] >= 0.0 && isfinite(weights[k]))) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT,
                             "weight %zu of the mixture is %g; weights are finite and not negative",
                             k + 1, weights[k]);
        }
        if (!files[k].rgb || files[k].bins != files[0].bins) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT,
                             "table %zu of the mixture is empty or of another size", k + 1);
        }
        *sum += weights[k];
    }
    if (!(*sum > 0.0 && isfinite(*sum))) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "a mixture needs at least one table with a weight above 0");
    }
    return BRDF_OK;
}

static brdf_status parts_make(struct parts *parts, const struct brdf_merl_file *files,
                              const double *weights, size_t count, struct brdf_error *error)
{
    double sum;
    brdf_status status = parts_check(files, weights, count, &sum, error);
    if (status) {
        return status;
    }
    parts->rgb = calloc(count, sizeof *parts->rgb);
    parts->share = calloc(count, sizeof *parts->share);
    if (!parts->rgb || !parts->share) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory to mix %zu tables", count);
    }
    for (size_t k = 0; k < count; ++k) {
        if (weights[k] > 0.0) {
            parts->rgb[parts->count] = files[k].rgb;
            parts->share[parts->count++] = weights[k] / sum;
        }
    }
    return BRDF_OK;
}

/* One value of the mixture; `i` counts all values of a table. */
static float value_mix(const struct parts *parts, size_t i, double cosine, enum lab_mix_space space)
{
    double sum = 0.0;
    int same = 1;
    for (size_t k = 0; k < parts->count; ++k) {
        double f = (double)parts->rgb[k][i];
        same = same && parts->rgb[k][i] == parts->rgb[0][i];
        sum +=
            parts->share[k] * (space == LAB_MIX_LINEAR ? f : lab_logrelative_map(f, cosine, 0.0));
    }
    if (same) {
        return parts->rgb[0][i];
    }
    return (float)(space == LAB_MIX_LINEAR ? sum : lab_logrelative_unmap(sum, cosine, 0.0));
}

static int bin_is_valid(const struct parts *parts, size_t bin)
{
    int valid = 1;
    for (size_t k = 0; k < parts->count; ++k) {
        valid = valid && parts->rgb[k][3 * bin] >= 0.0f;
    }
    return valid;
}

static void bins_mix(const struct parts *parts, enum lab_mix_space space,
                     struct brdf_merl_file *mixture)
{
    for (size_t bin = 0; bin < mixture->bins; ++bin) {
        if (bin_is_valid(parts, bin)) {
            double cosine = 1.0;
            if (space != LAB_MIX_LINEAR) {
                lab_bin_cosine(lab_bin_of(mixture, bin), &cosine);
            }
            for (size_t c = 0; c < 3; ++c) {
                mixture->rgb[3 * bin + c] = value_mix(parts, 3 * bin + c, cosine, space);
            }
            --mixture->invalid;
        }
    }
}

brdf_status lab_mix_merl(const struct brdf_merl_file *files, const double *weights, size_t count,
                         enum lab_mix_space space, struct brdf_merl_file *mixture,
                         struct brdf_error *error)
{
    struct parts parts = {NULL, NULL, 0};
    memset(mixture, 0, sizeof *mixture);
    brdf_status status = parts_make(&parts, files, weights, count, error);
    if (status == BRDF_OK) {
        status = brdf_merl_create(mixture, error);
    }
    if (status == BRDF_OK) {
        bins_mix(&parts, space, mixture);
        if (mixture->invalid == mixture->bins) {
            brdf_merl_free(mixture);
            status = brdf_fail(error, BRDF_BAD_ARGUMENT,
                               "no bin was measured in all of the materials to mix");
        }
    }
    free(parts.rgb);
    free(parts.share);
    return status;
}

int lab_mix_same(const struct brdf_merl_file *files, const double *weights, size_t count)
{
    int first = -1;
    for (size_t k = 0; k < count; ++k) {
        if (!(weights[k] > 0.0)) {
            continue;
        }
        if (first < 0) {
            first = (int)k;
        } else if (memcmp(files[first].rgb, files[k].rgb, files[k].bins * 3 * sizeof(float))) {
            return -1;
        }
    }
    return first;
}
