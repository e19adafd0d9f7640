/*
 * rgl_make.c - RGL files out of functions: the same steps as from measurements.
 */
#include "rgl_format.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "brdf/model/measured.h"
#include "rgl_normals.h"
#include "rgl_table.h"

static const double pi = 3.14159265358979323846;

/* The least cosine at which a function is asked: at the horizon itself many have no value. */
static const double cosine_least = 1e-3;

/* What is being made. */
struct making {
    brdf_rgl_function *f;
    void *data;
    struct brdf_rgl_grid grid; /* without zeros */
    struct brdf_rgl_file *file;
    double *values; /* of one pair of directions, a channel each */
    struct brdf_error *error;
};

/* The direction a little further up, if it is too close to the horizon. */
static void lift(double w[3])
{
    if (w[2] < cosine_least) {
        double flat = sqrt(w[0] * w[0] + w[1] * w[1]);
        double radius = sqrt(1.0 - cosine_least * cosine_least);
        w[0] *= radius / flat;
        w[1] *= radius / flat;
        w[2] = cosine_least;
    }
}

/* f(wo, wi) into making->values; both directions a little further up where they need it. */
static brdf_status ask(struct making *m, const double from[3], const double to[3])
{
    double wo[3] = {from[0], from[1], from[2]};
    double wi[3] = {to[0], to[1], to[2]};
    lift(wo);
    lift(wi);
    m->f(wo, wi, m->grid.channels, m->grid.wavelengths, m->values, m->data);
    for (int i = 0; i < m->grid.channels; ++i) {
        if (!(fabs(m->values[i]) <= BRDF_RGL_VALUE_MAX)) {
            return brdf_fail(m->error, BRDF_BAD_ARGUMENT,
                             "no file is made: f is %g for wo (%g, %g, %g), wi (%g, %g, %g)",
                             m->values[i], wo[0], wo[1], wo[2], wi[0], wi[1], wi[2]);
        }
    }
    return BRDF_OK;
}

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

/* Counts, memory, and the directions of wo: equal steps of phi_i and of cos(theta_i). */
static brdf_status file_begin(struct making *m)
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
        file->theta_i[i] = (float)acos(1.0 - (double)i / (grid->thetas - 1));
    }
    return BRDF_OK;
}

/* Retro-reflection of every direction of the grid, as the mean over the channels. */
static brdf_status back_find(struct making *m, double *back)
{
    const struct brdf_rgl_file *file = m->file;
    double largest = 0.0;
    for (int k = 0; k < file->ndf_rows * file->ndf_columns; ++k) {
        double w[3], sum = 0.0;
        brdf_rgl_direction(k / file->ndf_columns, file->ndf_rows, k % file->ndf_columns,
                           file->ndf_columns, w);
        double cosine = w[2] > cosine_least ? w[2] : cosine_least;
        brdf_status status = ask(m, w, w);
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

static brdf_status normals_make(struct making *m)
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
    for (size_t k = 0; k < count && !status; ++k) {
        file->ndf[k] = (float)normals.d[k];
        file->sigma[k] = (float)normals.sigma[k];
    }
    free(memory);
    return status;
}

static void view_direction(const struct brdf_rgl_file *file, int view, double wo[3])
{
    double phi = (double)file->phi_i[view / file->theta_count];
    double theta = (double)file->theta_i[view % file->theta_count];
    wo[0] = sin(theta) * cos(phi);
    wo[1] = sin(theta) * sin(phi);
    wo[2] = cos(theta);
}

/* D(m) max(wo . m, 0) and the Jacobian of the square, adding up to 1 as in published files. */
static void visible_normals_make(struct brdf_rgl_file *file, int view)
{
    size_t count = (size_t)file->vndf_rows * (size_t)file->vndf_columns;
    float *out = file->vndf + (size_t)view * count;
    double wo[3], sum = 0.0;
    view_direction(file, view, wo);
    for (size_t k = 0; k < count; ++k) {
        int row = (int)k / file->vndf_columns;
        int column = (int)k % file->vndf_columns;
        double normal[3], root = (double)column / (file->vndf_columns - 1);
        brdf_rgl_direction(row, file->vndf_rows, column, file->vndf_columns, normal);
        double seen = wo[0] * normal[0] + wo[1] * normal[1] + wo[2] * normal[2];
        float d = file->ndf[(file->phi_count == 1 ? 0 : row * file->ndf_columns) + column];
        double sine = sin(0.5 * pi * root * root);
        double value = seen > 0.0 ? (double)d * seen * root * sine : 0.0;
        out[k] = (float)value;
        sum += value;
    }
    for (size_t k = 0; k < count; ++k) {
        out[k] = (float)((double)out[k] / sum);
    }
}

/*
 * One node of a view: where the warp leads from there, what f is, and so the value. *valid is 0
 * where that is below the surface; the value is then 0.
 */
static brdf_status node_make(struct making *m, const float *table, int view, int node, int *valid)
{
    struct brdf_rgl_file *file = m->file;
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    size_t nodes = (size_t)file->size * (size_t)file->size;
    float *out = file->values + (size_t)view * (size_t)file->channels * nodes + (size_t)node;
    double direction[3];
    view_direction(file, view, direction);
    brdf_vec3 wo = brdf_vec3_make((float)direction[0], (float)direction[1], (float)direction[2]);
    struct brdf_measured_view seen = brdf_measured_view_of(layout, wo, table);
    struct brdf_point place = brdf_map_sample(
        layout.vndf, seen.slices, (float)(node % file->size) / (float)(file->size - 1),
        (float)(node / file->size) / (float)(file->size - 1), table);
    brdf_vec3 axis = layout.isotropic ? seen.azimuth : brdf_vec3_make(1.0f, 0.0f, 0.0f);
    brdf_vec3 wi = brdf_normalize(brdf_reflect(wo, brdf_measured_normal(place, axis)));
    float factor = brdf_measured_factor(layout, seen, place.x, place.y, table);
    *valid = wi.z > 0.0f && factor > 0.0f;
    for (int i = 0; i < file->channels; ++i) {
        out[(size_t)i * nodes] = 0.0f;
    }
    if (!*valid) {
        return BRDF_OK;
    }
    const double to[3] = {(double)wi.x, (double)wi.y, (double)wi.z};
    brdf_status status = ask(m, direction, to);
    for (int i = 0; i < file->channels && !status; ++i) {
        out[(size_t)i * nodes] = (float)(m->values[i] * (double)wi.z / (double)factor);
    }
    return status;
}

/* Nodes below the surface beside valid ones take the mean of these: the horizon is not dimmed. */
static void edges_fill(float *values, const int *valid, int size)
{
    for (int node = 0; node < size * size; ++node) {
        double sum = 0.0;
        int count = 0;
        for (int k = 0; k < 9 && !valid[node]; ++k) {
            int row = node / size + k / 3 - 1;
            int column = node % size + k % 3 - 1;
            if (row >= 0 && row < size && column >= 0 && column < size &&
                valid[row * size + column]) {
                sum += (double)values[row * size + column];
                ++count;
            }
        }
        if (count) {
            values[node] = (float)(sum / count);
        }
    }
}

/* Luminance of Rec. 709, which is what published files hold. */
static brdf_status luminance_make(struct making *m)
{
    static const double parts[3] = {0.2126, 0.7152, 0.0722};
    struct brdf_rgl_file *file = m->file;
    size_t nodes = (size_t)file->size * (size_t)file->size;
    double(*weights)[3] = malloc((size_t)file->channels * sizeof *weights);
    if (!weights) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for luminance");
    }
    brdf_rgl_weights_find(file, weights);
    for (size_t k = 0; k < brdf_rgl_elements(file, BRDF_RGL_LUMINANCE); ++k) {
        double sum = 0.0;
        for (int i = 0; i < file->channels; ++i) {
            size_t place = (k / nodes * (size_t)file->channels + (size_t)i) * nodes + k % nodes;
            for (int c = 0; c < 3; ++c) {
                sum += parts[c] * weights[i][c] * (double)file->values[place];
            }
        }
        file->luminance[k] = sum > 0.0 ? (float)sum : 0.0f;
    }
    free(weights);
    return BRDF_OK;
}

/* Values of all views, through the model's own warp: it will find them at the same places. */
static brdf_status values_make(struct making *m)
{
    struct brdf_rgl_file *file = m->file;
    size_t nodes = (size_t)file->size * (size_t)file->size;
    float *table = NULL;
    int *valid = malloc(nodes * sizeof *valid);
    if (!valid) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for %zu values", nodes);
    }
    brdf_status status = brdf_rgl_table_of_normals(file, &table, m->error);
    for (int view = 0; view < file->phi_count * file->theta_count && !status; ++view) {
        for (int node = 0; node < (int)nodes && !status; ++node) {
            status = node_make(m, table, view, node, &valid[node]);
        }
        for (int i = 0; i < file->channels && !status; ++i) {
            edges_fill(file->values + (size_t)(view * file->channels + i) * nodes, valid,
                       file->size);
        }
    }
    free(table);
    free(valid);
    return status ? status : luminance_make(m);
}

brdf_status brdf_rgl_make(brdf_rgl_function *f, void *data, const struct brdf_rgl_grid *grid,
                          struct brdf_rgl_file *file, struct brdf_error *error)
{
    struct making m = {f, data, {0}, file, NULL, error};
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
    for (int view = 0; view < file->phi_count * file->theta_count && !status; ++view) {
        visible_normals_make(file, view);
    }
    status = status ? status : values_make(&m);
    free(m.values);
    if (status) {
        brdf_rgl_free(file);
    }
    return status;
}
