/*
 * fit_samples.c - where a fit is compared with its target, and how.
 *
 * Directions lie on a grid of the half and difference angles, theta_h spaced by squares as in MERL
 * files: lobes of every width get their share of it. Beyond 80 degrees measurements are not to be
 * trusted [Ngan et al. 2005], so directions beyond are left out.
 */
#include <math.h>
#include <stdlib.h>

#include <brdf/merl.h>

#include "fit_samples.h"
#include "angle.h"

enum { THETA_H = 48, PHI_H = 8, THETA_D = 16, PHI_D = 12, ARRAYS = 15 };

struct pair {
    double wo[3];
    double wi[3];
};

/* The grid's pair with this number; 0 if one of its directions is left out. */
static int pair_of_number(size_t number, int anisotropic, struct pair *pair)
{
    size_t phi_d = number % PHI_D;
    size_t theta_d = number / PHI_D % THETA_D;
    size_t theta_h = number / PHI_D / THETA_D % THETA_H;
    size_t phi_h = number / PHI_D / THETA_D / THETA_H;
    double q = ((double)theta_h + 0.5) / THETA_H;
    /* An isotropic material is the same at every phi_h, and at phi_d and pi + phi_d: half of the
       turn is enough. The grid of phi_h begins off the axes, where anisotropy cannot be seen. */
    double turn = anisotropic ? ((double)phi_h + 0.5) * pi / PHI_H : 0.0;
    brdf_merl_directions_at(0.5 * pi * q * q, turn,
                            ((double)theta_d + 0.5) * (80.0 * degree / THETA_D),
                            ((double)phi_d + 0.5) * (pi / PHI_D), pair->wo, pair->wi);
    return fmin(pair->wo[2], pair->wi[2]) >= cos(80.0 * degree);
}

static size_t grid_size(int anisotropic)
{
    return (size_t)THETA_H * THETA_D * PHI_D * (anisotropic ? PHI_H : 1);
}

static double metric_apply(enum lab_fit_metric metric, double x)
{
    return metric == LAB_FIT_CUBE_ROOT ? cbrt(x) : metric == LAB_FIT_LOG ? log1p(x) : x;
}

static void evaluate(struct fit_samples *samples, const struct brdf_bsdf *bsdf)
{
    struct brdf_colors f = {samples->value[0], samples->value[1], samples->value[2]};
    brdf_eval_many(bsdf, samples->count, samples->wo, samples->wi, f);
}

brdf_status fit_samples_make(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                             struct fit_samples *samples, struct brdf_error *error)
{
    struct pair pair;
    size_t count = 0;
    for (size_t i = 0; i < grid_size(options->anisotropic); ++i) {
        count += (size_t)pair_of_number(i, options->anisotropic, &pair);
    }
    float *memory = malloc(ARRAYS * count * sizeof *memory);
    if (!memory) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    float *array[ARRAYS];
    for (int i = 0; i < ARRAYS; ++i) {
        array[i] = memory + (size_t)i * count;
    }
    for (size_t i = 0, k = 0; i < grid_size(options->anisotropic); ++i) {
        if (pair_of_number(i, options->anisotropic, &pair)) {
            for (int c = 0; c < 3; ++c) {
                array[c][k] = (float)pair.wo[c];
                array[3 + c][k] = (float)pair.wi[c];
            }
            ++k;
        }
    }
    samples->count = count;
    samples->metric = options->metric;
    samples->memory = memory;
    samples->wo = (struct brdf_vectors){array[0], array[1], array[2]};
    samples->wi = (struct brdf_vectors){array[3], array[4], array[5]};
    for (int c = 0; c < 3; ++c) {
        samples->target[c] = array[6 + c];
        samples->value[c] = array[9 + c];
        samples->sum[c] = array[12 + c];
    }
    evaluate(samples, target);
    for (int c = 0; c < 3; ++c) {
        for (size_t i = 0; i < count; ++i) {
            double f = fmax((double)samples->value[c][i], 0.0);
            samples->target[c][i] =
                (float)metric_apply(options->metric, f * (double)samples->wi.z[i]);
        }
    }
    return BRDF_OK;
}

void fit_samples_free(struct fit_samples *samples)
{
    free(samples->memory);
    samples->memory = NULL;
}

double fit_samples_error(struct fit_samples *samples, const struct brdf_bsdf *const *parts,
                         const double *weights, int count)
{
    double squares = 0.0;
    for (int part = 0; part < count; ++part) {
        evaluate(samples, parts[part]);
        for (int c = 0; c < 3; ++c) {
            for (size_t i = 0; i < samples->count; ++i) {
                samples->sum[c][i] = (float)weights[part] * samples->value[c][i] +
                                     (part > 0 ? samples->sum[c][i] : 0.0f);
            }
        }
    }
    for (int c = 0; c < 3; ++c) {
        for (size_t i = 0; i < samples->count; ++i) {
            double f = count > 0 ? (double)samples->sum[c][i] * (double)samples->wi.z[i] : 0.0;
            double miss = metric_apply(samples->metric, f) - (double)samples->target[c][i];
            squares += miss * miss;
        }
    }
    return squares / (3.0 * (double)samples->count);
}
