/*
 * rgl_make.c - RGL files out of functions: the same steps as from measurements.
 */
#include "angle.h"
#include "rgl_format.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rgl_making.h"
#include "rgl_normals.h"

static brdf_status grid_check(struct brdf_rgl_grid *grid, struct brdf_error *error)
{
    grid->phis = grid->phis ? grid->phis : 1;
    grid->thetas = grid->thetas ? grid->thetas : 8;
    grid->symmetry = grid->symmetry ? grid->symmetry : 1;
    grid->normals = grid->normals ? grid->normals : grid->phis > 1 ? 64 : 128;
    grid->size = grid->size ? grid->size : 32;
    grid->channels = grid->channels ? grid->channels : 3;
    grid->description = grid->description ? grid->description : "";
    int phis_fit = grid->phis == 1 || (grid->phis >= 3 && grid->phis <= 256);
    int symmetry_fits = grid->symmetry == 1 || grid->symmetry == 2 || grid->symmetry == 4;
    int channels_fit =
        grid->wavelengths ? grid->channels >= 1 && grid->channels <= 4096 : grid->channels == 3;
    if (!phis_fit || !symmetry_fits || !channels_fit || grid->thetas < 2 || grid->thetas > 256 ||
        grid->normals < 4 || grid->normals > 1024 || grid->size < 2 || grid->size > 1024) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "no file is made: phis must be 1 or 3 to 256, thetas 2 to 256, symmetry "
                         "1, 2 or 4, normals 4 to 1024, size 2 to 1024, channels 3, or with "
                         "wavelengths 1 to 4096");
    }
    return BRDF_OK;
}

/*
 * Counts, memory, and the directions of wo: equal steps of phi_i, and of cos(theta_i) to the power
 * of 2/3, which are finer towards grazing, where lobes change most from view to view.
 */
static brdf_status file_begin(struct brdf_rgl_making *m)
{
    struct brdf_rgl_file *file = m->file;
    const struct brdf_rgl_grid *grid = &m->grid;
    int isotropic = grid->phis == 1;
    file->phi_count = grid->phis;
    file->theta_count = grid->thetas;
    file->ndf_rows = file->sigma_rows = isotropic ? 2 : grid->normals;
    file->ndf_columns = file->sigma_columns = grid->normals;
    file->vndf_rows = file->vndf_columns = grid->normals;
    file->size = grid->size;
    file->channels = grid->channels;
    file->jacobian = 1;
    file->description = malloc(strlen(grid->description) + 1);
    m->values = malloc((size_t)grid->channels * sizeof *m->values);
    if (!file->description || !m->values) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for %d channels", grid->channels);
    }
    strcpy(file->description, grid->description);
    brdf_status status = brdf_rgl_reserve(file, grid->wavelengths != NULL, m->error);
    if (status) {
        return status;
    }
    if (grid->wavelengths) {
        memcpy(file->wavelengths, grid->wavelengths, (size_t)grid->channels * sizeof(float));
    }
    for (int i = 0; i < grid->phis; ++i) {
        double part = isotropic ? 0.5 : (double)i / (grid->phis - 1) / grid->symmetry;
        file->phi_i[i] = (float)(pi * (2.0 * part - 1.0));
    }
    for (int i = 0; i < grid->thetas; ++i) {
        file->theta_i[i] = (float)acos(pow(1.0 - (double)i / (grid->thetas - 1), 1.5));
    }
    return BRDF_OK;
}

/* Retro-reflection of every direction of the grid, as the mean over the channels. */
static brdf_status back_find(struct brdf_rgl_making *m, double *back)
{
    const struct brdf_rgl_file *file = m->file;
    double largest = 0.0;
    for (int k = 0; k < file->ndf_rows * file->ndf_columns; ++k) {
        double w[3], sum = 0.0;
        brdf_rgl_direction(k / file->ndf_columns, file->ndf_rows, k % file->ndf_columns,
                           file->ndf_columns, w);
        double cosine = w[2] > BRDF_RGL_COSINE_LEAST ? w[2] : BRDF_RGL_COSINE_LEAST;
        brdf_status status = brdf_rgl_ask(m, w, w);
        if (status) {
            return status;
        }
        for (int i = 0; i < m->grid.channels; ++i) {
            sum += m->values[i] > 0.0 ? m->values[i] * cosine / m->grid.channels : 0.0;
        }
        back[k] = sum;
        largest = sum > largest ? sum : largest;
    }
    if (largest <= 0.0) { /* black, or nothing comes back: any distribution will do */
        for (int k = 0; k < file->ndf_rows * file->ndf_columns; ++k) {
            back[k] = 1.0;
        }
    }
    return BRDF_OK;
}

static brdf_status normals_make(struct brdf_rgl_making *m)
{
    struct brdf_rgl_file *file = m->file;
    size_t count = brdf_rgl_elements(file, BRDF_RGL_NDF);
    double *memory = malloc(3 * count * sizeof *memory);
    if (!memory) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for %zu normals", count);
    }
    struct brdf_rgl_normals normals = {file->ndf_rows, file->ndf_columns, m->grid.phis == 1, memory,
                                       memory + count};
    brdf_status status = back_find(m, memory + 2 * count);
    status = status ? status : brdf_rgl_normals_find(&normals, memory + 2 * count, m->error);
    status = status ? status : brdf_rgl_views_blend(m, &normals);
    status = status ? status : brdf_rgl_normals_end(&normals, m->error);
    for (size_t k = 0; k < count && !status; ++k) {
        file->ndf[k] = (float)normals.d[k];
        file->sigma[k] = (float)normals.sigma[k];
    }
    free(memory);
    return status;
}

brdf_status brdf_rgl_make(brdf_rgl_function *f, void *data, const struct brdf_rgl_grid *grid,
                          struct brdf_rgl_file *file, struct brdf_error *error)
{
    struct brdf_rgl_making m = {f, data, {0}, file, NULL, error};
    if (!f || !file) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_rgl_make needs a function and a file to fill");
    }
    memset(file, 0, sizeof *file);
    if (grid) {
        m.grid = *grid;
    }
    brdf_status status = grid_check(&m.grid, error);
    status = status ? status : file_begin(&m);
    status = status ? status : normals_make(&m);
    status = status ? status : brdf_rgl_values_make(&m);
    free(m.values);
    if (status) {
        brdf_rgl_free(file);
    }
    return status;
}
