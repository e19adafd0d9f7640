/*
 * rgl_values.c - visible normals of a distribution, and a function's values where the warp by them
 * leads.
 */
#include "angle.h"
#include "rgl_making.h"

#include <math.h>
#include <stdlib.h>

#include "brdf/model/measured.h"
#include "luminance.h"
#include "rgl_normals.h"
#include "rgl_table.h"

/* The direction a little further up, if it is too close to the horizon. */
static void lift(double w[3])
{
    if (w[2] < BRDF_RGL_COSINE_LEAST) {
        double flat = sqrt(w[0] * w[0] + w[1] * w[1]);
        double radius = sqrt(1.0 - BRDF_RGL_COSINE_LEAST * BRDF_RGL_COSINE_LEAST);
        w[0] *= radius / flat;
        w[1] *= radius / flat;
        w[2] = BRDF_RGL_COSINE_LEAST;
    }
}

brdf_status brdf_rgl_ask(struct brdf_rgl_making *m, const double from[3], const double to[3])
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

/* The slice of a view by itself: rounding must not take phi_i = -pi for pi. */
static struct brdf_slices slice_of(int view)
{
    struct brdf_slices slice = {.first = view, .alone = 1};
    return slice;
}

/*
 * One node of a view: where the warp leads from there, what f is, and so the value. *valid is 0
 * where that is below the surface; the value is then 0.
 */
static brdf_status node_make(struct brdf_rgl_making *m, const float *table, int view, int node,
                             int *valid)
{
    struct brdf_rgl_file *file = m->file;
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    size_t nodes = (size_t)file->size * (size_t)file->size;
    float *out = file->values + (size_t)view * (size_t)file->channels * nodes + (size_t)node;
    double direction[3];
    view_direction(file, view, direction);
    brdf_vec3 wo = brdf_vec3_make((float)direction[0], (float)direction[1], (float)direction[2]);
    layout.symmetry = 1; /* the view itself, not what it would be mirrored to */
    struct brdf_measured_view seen = brdf_measured_view_of(layout, wo, table);
    seen.slices = slice_of(view);
    struct brdf_point place = brdf_map_sample(
        layout.vndf, seen.slices, (float)(node % file->size) / (float)(file->size - 1),
        (float)(node / file->size) / (float)(file->size - 1), table);
    brdf_vec3 axis = brdf_normalize(brdf_measured_axis(layout, seen));
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
    brdf_status status = brdf_rgl_ask(m, direction, to);
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
static brdf_status luminance_make(struct brdf_rgl_making *m)
{
    struct brdf_rgl_file *file = m->file;
    size_t nodes = (size_t)file->size * (size_t)file->size;
    double(*weights)[3] = malloc((size_t)file->channels * sizeof *weights);
    if (!weights) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for luminance");
    }
    brdf_rgl_weights_find(file, weights);
    for (size_t k = 0; k < brdf_rgl_elements(file, BRDF_RGL_LUMINANCE); ++k) {
        double rgb[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < file->channels; ++i) {
            size_t place = (k / nodes * (size_t)file->channels + (size_t)i) * nodes + k % nodes;
            for (int c = 0; c < 3; ++c) {
                rgb[c] += weights[i][c] * (double)file->values[place];
            }
        }
        file->luminance[k] = (float)fmax(brdf_luminance(rgb[0], rgb[1], rgb[2]), 0.0);
    }
    free(weights);
    return BRDF_OK;
}

/* Values of all views, through the model's own warp: it will find them at the same places. */
brdf_status brdf_rgl_values_make(struct brdf_rgl_making *m)
{
    struct brdf_rgl_file *file = m->file;
    size_t nodes = (size_t)file->size * (size_t)file->size;
    float *table = NULL;
    int *valid = malloc(nodes * sizeof *valid);
    if (!valid) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for %zu values", nodes);
    }
    for (int view = 0; view < file->phi_count * file->theta_count; ++view) {
        visible_normals_make(file, view);
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
