/* separate.c - the level of the diffuse part, by theta_d. */
#include "separate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bins.h"

static const double quantile = 0.3;

enum { WINDOW = 4 }; /* of the running median: so many neighbours on either side */

/* A value of f, and how much it counts. */
struct entry {
    double f;
    double weight;
};

static int by_value(const void *a, const void *b)
{
    const struct entry *x = a, *y = b;
    return (x->f > y->f) - (x->f < y->f);
}

static double quantile_of(struct entry *entries, size_t count)
{
    double sum = 0.0, below = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += entries[i].weight;
    }
    qsort(entries, count, sizeof *entries, by_value);
    for (size_t i = 0; i < count; ++i) {
        below += entries[i].weight;
        if (below >= quantile * sum) {
            return entries[i].f;
        }
    }
    return 0.0;
}

/* The solid angle of a bin's half vectors, up to a factor: sin(theta_h) d(theta_h). */
static double solid_of(const struct brdf_merl_file *file, int theta_h)
{
    return sin(lab_bin_theta_h(file, theta_h)) * (theta_h + 0.5);
}

/* The levels of one theta_d: every other phi_d is enough. */
static void levels_find(const struct brdf_merl_file *file, int theta_d, struct entry *entries,
                        double level[3])
{
    for (int c = 0; c < 3; ++c) {
        size_t count = 0;
        for (int h = 0; h < file->theta_h; ++h) {
            for (int p = 0; p < file->phi_d; p += 2) {
                struct lab_bin bin = {h, theta_d, p};
                double f = (double)file->rgb[3 * lab_bin_number(file, bin) + (size_t)c];
                double wo[3], wi[3];
                if (f >= 0.0 && lab_bin_directions(bin, wo, wi)) {
                    struct entry entry = {f, solid_of(file, h) * wo[2] * wi[2]};
                    entries[count++] = entry;
                }
            }
        }
        level[c] = quantile_of(entries, count);
    }
}

static double median_around(const double level[LAB_SEPARATE_BINS][3], int at, int channel)
{
    struct entry around[2 * WINDOW + 1];
    int count = 0;
    for (int d = at - WINDOW; d <= at + WINDOW; ++d) {
        if (d >= 0 && d < LAB_SEPARATE_BINS) {
            around[count++].f = level[d][channel];
        }
    }
    qsort(around, (size_t)count, sizeof around[0], by_value);
    return around[count / 2].f;
}

brdf_status lab_separate(const struct brdf_merl_file *file, struct lab_diffuse *diffuse,
                         struct brdf_error *error)
{
    double level[LAB_SEPARATE_BINS][3];
    size_t most = (size_t)file->theta_h * (size_t)file->phi_d;
    struct entry *entries = malloc(most * sizeof *entries);
    if (!entries) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory to sort %zu values", most);
    }
    for (int d = 0; d < LAB_SEPARATE_BINS; ++d) {
        levels_find(file, d, entries, level[d]);
    }
    for (int d = 0; d < LAB_SEPARATE_BINS; ++d) {
        for (int c = 0; c < 3; ++c) {
            diffuse->level[d][c] = median_around((const double(*)[3])level, d, c);
        }
    }
    free(entries);
    return BRDF_OK;
}
