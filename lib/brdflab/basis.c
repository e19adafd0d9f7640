/*
 * basis.c - principal components of a set of materials, in the log-relative mapping.
 *
 * There are far fewer materials than values of each, so the components come from the N x N matrix
 * of inner products, whose eigenvectors tell how much of each material a component takes (Sirovich
 * 1987, the method of snapshots).
 */
#include "basis.h"

#include <math.h>
#include <stdlib.h>

#include <lapacke.h>

#include "basis_traits.h"
#include "bins.h"
#include "complete.h"
#include "logrelative.h"

/* The sub-grid: all of theta_h, where highlights are, and every third and sixth degree of the
   rest. */
enum { THETA_D_FIRST = 1, THETA_D_STEP = 3, PHI_D_FIRST = 3, PHI_D_STEP = 6 };

/* The values of a table on the sub-grid, mapped; their number. `vector` may be NULL: count only. */
static size_t vector_make(const struct brdf_merl_file *file, float *vector)
{
    size_t count = 0;
    for (int h = 0; h < file->theta_h; ++h) {
        for (int d = THETA_D_FIRST; d < file->theta_d; d += THETA_D_STEP) {
            for (int p = PHI_D_FIRST; p < file->phi_d; p += PHI_D_STEP) {
                struct lab_bin bin = {h, d, p};
                double cosine;
                if (!lab_bin_cosine(bin, &cosine)) {
                    continue;
                }
                const float *rgb = file->rgb + 3 * lab_bin_number(file, bin);
                for (size_t c = 0; c < 3 && vector; ++c) {
                    double f = fmax((double)rgb[c], 0.0);
                    vector[count + c] = (float)lab_logrelative_map(f, cosine, 0.0);
                }
                count += 3;
            }
        }
    }
    return count;
}

static double inner_product(const float *a, const float *b, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += (double)a[i] * (double)b[i];
    }
    return sum;
}

/* Read a material into row `number`; the first one tells how long the rows are. */
static brdf_status material_read(struct lab_basis *basis, const char *material, size_t number,
                                 struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = lab_complete_open(material, &file, error);
    if (!status && !basis->vector) {
        basis->dimensions = vector_make(&file, NULL);
        basis->vector = malloc(basis->count * basis->dimensions * sizeof *basis->vector);
        basis->mean = calloc(basis->dimensions, sizeof *basis->mean);
        if (!basis->vector || !basis->mean) {
            status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu materials",
                               basis->count);
        }
    }
    if (!status) {
        vector_make(&file, basis->vector + number * basis->dimensions);
        lab_traits_measure(&file, basis->trait[number]);
    }
    brdf_merl_free(&file);
    return status;
}

static void take_off_mean(struct lab_basis *basis)
{
    for (size_t i = 0; i < basis->dimensions; ++i) {
        double sum = 0.0;
        for (size_t k = 0; k < basis->count; ++k) {
            sum += (double)basis->vector[k * basis->dimensions + i];
        }
        basis->mean[i] = (float)(sum / (double)basis->count);
        for (size_t k = 0; k < basis->count; ++k) {
            basis->vector[k * basis->dimensions + i] -= basis->mean[i];
        }
    }
}

/* From eigenvalues in ascending order, and eigenvectors in rows, to the K components. */
static brdf_status components_keep(struct lab_basis *basis, const double *value,
                                   const double *vector, struct brdf_error *error)
{
    size_t n = basis->count;
    double total = 0.0;
    for (size_t i = 0; i < n; ++i) {
        total += fmax(value[i], 0.0);
    }
    if (!(value[n - 1] > 1e-12 * (double)basis->dimensions)) {
        return brdf_fail(error, BRDF_UNSUPPORTED, "the %zu materials are all the same", n);
    }
    int wanted = basis->components;
    int kept = 0;
    while (kept < wanted && value[n - 1 - (size_t)kept] > 1e-10 * value[n - 1]) {
        ++kept;
    }
    basis->components = kept;
    for (size_t k = 0; k < (size_t)kept; ++k) {
        const double *row = vector + (n - 1 - k) * n;
        basis->eigenvalue[k] = value[n - 1 - k];
        basis->explained[k] = value[n - 1 - k] / total;
        /* A component's sign is free: its largest loading is positive. */
        double sign = 1.0, largest = 0.0;
        for (size_t i = 0; i < n; ++i) {
            sign = fabs(row[i]) > largest ? (row[i] < 0.0 ? -1.0 : 1.0) : sign;
            largest = fmax(largest, fabs(row[i]));
        }
        for (size_t i = 0; i < n; ++i) {
            basis->loading[i * (size_t)kept + k] = sign * row[i];
            /* Orthonormal columns: times the root of N - 1, their standard deviation is 1. */
            basis->coordinate[i * (size_t)kept + k] = sign * row[i] * sqrt((double)(n - 1));
        }
    }
    return BRDF_OK;
}

static brdf_status components_find(struct lab_basis *basis, struct brdf_error *error)
{
    size_t n = basis->count;
    double *gram = malloc(n * n * sizeof *gram);
    double *value = malloc(n * sizeof *value);
    brdf_status status =
        gram && value ? BRDF_OK : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    for (size_t i = 0; i < n && !status; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            gram[i * n + j] = gram[j * n + i] =
                inner_product(basis->vector + i * basis->dimensions,
                              basis->vector + j * basis->dimensions, basis->dimensions);
        }
    }
    /* The matrix is symmetric, so column order leaves the eigenvectors in rows as C sees them. */
    if (!status &&
        LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'U', (lapack_int)n, gram, (lapack_int)n, value)) {
        status = brdf_fail(error, BRDF_UNSUPPORTED, "LAPACK found no eigenvalues of the materials");
    }
    if (!status) {
        status = components_keep(basis, value, gram, error);
    }
    free(gram);
    free(value);
    return status;
}

static brdf_status basis_fill(struct lab_basis *basis, const char *const *materials,
                              lab_basis_progress *progress, void *data, struct brdf_error *error)
{
    for (size_t i = 0; i < basis->count; ++i) {
        if (progress && progress(i, basis->count, data)) {
            return brdf_fail(error, BRDF_CANCELLED, "stopped on request");
        }
        brdf_status status = material_read(basis, materials[i], i, error);
        if (status) {
            return status;
        }
    }
    take_off_mean(basis);
    brdf_status status = components_find(basis, error);
    if (!status) {
        basis_traits_regress(basis);
    }
    return status;
}

brdf_status lab_basis_create(const char *const *materials, size_t count, int components,
                             lab_basis_progress *progress, void *data, struct lab_basis **out,
                             struct brdf_error *error)
{
    *out = NULL;
    if (count < 3 || count > 10000 || components < 1) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "a basis needs 3 to 10000 materials, not %zu, and 1 component or more",
                         count);
    }
    size_t wanted = (size_t)components < count - 1 ? (size_t)components : count - 1;
    struct lab_basis *basis = calloc(1, sizeof *basis);
    brdf_status status = basis ? BRDF_OK : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    if (status) {
        return status;
    }
    basis->count = count;
    basis->components = (int)wanted;
    basis->eigenvalue = calloc(wanted, sizeof *basis->eigenvalue);
    basis->explained = calloc(wanted, sizeof *basis->explained);
    basis->loading = calloc(count * wanted, sizeof *basis->loading);
    basis->coordinate = calloc(count * wanted, sizeof *basis->coordinate);
    basis->trait = calloc(count, sizeof *basis->trait);
    basis->slope = calloc(wanted, sizeof *basis->slope);
    if (!basis->eigenvalue || !basis->explained || !basis->loading || !basis->coordinate ||
        !basis->trait || !basis->slope) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    } else {
        status = basis_fill(basis, materials, progress, data, error);
    }
    if (status) {
        lab_basis_destroy(basis);
        return status;
    }
    *out = basis;
    return BRDF_OK;
}

void lab_basis_destroy(struct lab_basis *basis)
{
    if (basis) {
        free(basis->eigenvalue);
        free(basis->explained);
        free(basis->loading);
        free(basis->coordinate);
        free(basis->trait);
        free(basis->slope);
        free(basis->vector);
        free(basis->mean);
        free(basis);
    }
}

brdf_status lab_basis_project(const struct lab_basis *basis, const struct brdf_merl_file *file,
                              double *coordinates, double *residual, struct brdf_error *error)
{
    size_t n = basis->count, components = (size_t)basis->components;
    float *vector = malloc(basis->dimensions * sizeof *vector);
    if (!vector) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    vector_make(file, vector);
    for (size_t i = 0; i < basis->dimensions; ++i) {
        vector[i] -= basis->mean[i];
    }
    double square = inner_product(vector, vector, basis->dimensions);
    double reached = 0.0;
    for (size_t k = 0; k < components; ++k) {
        /* The sum of loading * vector over the set is the component times its singular value. */
        double along = 0.0;
        for (size_t i = 0; i < n; ++i) {
            const float *other = basis->vector + i * basis->dimensions;
            along += basis->loading[i * components + k] *
                     inner_product(vector, other, basis->dimensions);
        }
        reached += along * along / basis->eigenvalue[k];
        coordinates[k] = along * sqrt((double)(n - 1)) / basis->eigenvalue[k];
    }
    if (residual) {
        *residual = square > 0.0 ? sqrt(fmax(1.0 - reached / square, 0.0)) : 0.0;
    }
    free(vector);
    return BRDF_OK;
}
