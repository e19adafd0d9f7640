/*
 * rgl_table.c - build the table of the model `measured`: the file's arrays, normalised, integrated
 * and laid out so that what is blended lies side by side.
 */
#define _POSIX_C_SOURCE 200809L

#include "rgl_table.h"

#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "brdf/model/measured.h"
#include "rgl_format.h"
#include "rgl_header.h"

/* The part of the file that slice (phi, theta) of the table is made of. */
static size_t slice_source(const struct brdf_rgl_file *file, int slice)
{
    int thetas = brdf_rgl_theta_slices(file);
    int theta = slice % thetas;
    return (size_t)(slice / thetas * file->theta_count +
                    (theta < file->theta_count ? theta : file->theta_count - 1));
}

static void knots_build(float *table, const struct brdf_measured_layout *layout,
                        const struct brdf_rgl_file *file)
{
    float *theta = table + layout->theta_words;
    memcpy(table + layout->phi_words, file->phi_i, (size_t)file->phi_count * sizeof *table);
    if (file->theta_count > 1) {
        memcpy(theta, file->theta_i, (size_t)file->theta_count * sizeof *table);
    } else {
        theta[0] = 0.0f;
        theta[1] = (float)(0.5 * pi);
    }
}

static double node_value(const float *data, size_t node)
{
    return data[node] > 0.0f ? (double)data[node] : 0.0; /* noise may be negative */
}

/* The integral of a bilinear density over the square; 0 if there is nothing. */
static double map_integral(const float *data, int rows, int columns)
{
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            double part = (row == 0 || row == rows - 1 ? 0.5 : 1.0) *
                          (column == 0 || column == columns - 1 ? 0.5 : 1.0);
            sum += part * node_value(data, (size_t)(row * columns + column));
        }
    }
    return sum / ((rows - 1.0) * (columns - 1.0));
}

/* The nodes of one slice of a line: pairs of a density and the integral up to there. */
static float *line_nodes(float *table, const struct brdf_lines *lines, int line, int slice)
{
    return table + lines->words + (size_t)line * (size_t)brdf_lines_apart(*lines) +
           2 * (size_t)slice * (size_t)lines->nodes;
}

/* The place, in cells, where the integrals of a line reach `wanted`. */
static double line_invert(const float *nodes, int count, double wanted)
{
    int cell = 0;
    while (cell < count - 2 && (double)nodes[2 * cell + 3] < wanted) {
        ++cell;
    }
    double begin = (double)nodes[2 * cell + 1];
    double width = (double)nodes[2 * cell + 3] - begin;
    double inside = width > 0.0 ? (wanted - begin) / width : 0.0;
    return cell + (inside < 0.0 ? 0.0 : inside > 1.0 ? 1.0 : inside);
}

/* The inverse of a line, whose integral is `all`, at the steps, each with the next, times that. */
static void guesses_build(float *table, const struct brdf_lines *lines, int line, int slice,
                          double all)
{
    const float *nodes = line_nodes(table, lines, line, slice);
    float *words = table + lines->guess_words + (size_t)line * (size_t)brdf_guesses_apart(*lines) +
                   2 * (size_t)slice;
    size_t apart = 2 * (size_t)(lines->thetas * lines->phis);
    for (int step = 0; step < BRDF_LINE_STEPS; ++step) {
        float *pair = words + apart * (size_t)step;
        for (int i = 0; i < 2; ++i) {
            float u = brdf_line_step((float)(step + i) / (float)BRDF_LINE_STEPS);
            pair[i] = (float)(all * line_invert(nodes, lines->nodes, all * (double)u));
        }
    }
}

/*
 * One slice of a map: densities, and their integrals up to each node. Where there is nothing at
 * all, a density of 1 keeps every sample finite.
 */
static void slice_build(float *table, const struct brdf_map *map, int slice, const float *data)
{
    int rows = map->marginal.cells + 1;
    int columns = map->rows.nodes;
    float *across = line_nodes(table, &map->marginal, 0, slice);
    double total = map_integral(data, rows, columns);
    double norm = total > 1e-30 ? 1.0 / total : 0.0;
    double flat = total > 1e-30 ? 0.0 : 1.0;
    double sum = 0.0;
    double before = 0.0;
    for (int row = 0; row < map->marginal.nodes; ++row) {
        float *nodes = line_nodes(table, &map->rows, row, slice);
        double along = 0.0;
        double left = 0.0;
        for (int column = 0; column < columns; ++column) {
            double value = flat + norm * node_value(data, (size_t)(row * columns + column));
            along += column > 0 ? 0.5 * (left + value) / (columns - 1.0) : 0.0;
            nodes[2 * column] = (float)value;
            nodes[2 * column + 1] = (float)along;
            left = value;
        }
        guesses_build(table, &map->rows, row, slice, along);
        sum += row > 0 ? 0.5 * (before + along) / (rows - 1.0) : 0.0;
        across[2 * row] = (float)along;
        across[2 * row + 1] = (float)sum;
        before = along;
    }
    guesses_build(table, &map->marginal, 0, slice, 1.0);
}

/* Colours of one slice, each with the density that the map of luminance has there. */
static void colors_build(float *table, const struct brdf_measured_layout *layout, int slice,
                         const float *values)
{
    size_t slices = (size_t)(layout->thetas * layout->phis);
    size_t nodes = (size_t)layout->size * (size_t)layout->size;
    for (int row = 0; row < layout->size; ++row) {
        const float *line = line_nodes(table, &layout->luminance.rows, row, slice);
        for (int column = 0; column < layout->size; ++column) {
            size_t node = (size_t)row * (size_t)layout->size + (size_t)column;
            float *color = table + layout->color_words + 4 * (node * slices + (size_t)slice);
            for (size_t channel = 0; channel < 3; ++channel) {
                color[channel] = values[channel * nodes + node];
            }
            color[3] = line[2 * column];
        }
    }
}

/* Every cell of a grid as its four corners. */
static void cells_build(float *words, const float *grid, int rows, int columns)
{
    for (int row = 0; row < rows - 1; ++row) {
        for (int column = 0; column < columns - 1; ++column) {
            const float *corner = grid + row * columns + column;
            for (int k = 0; k < 4; ++k) {
                float value = corner[k / 2 * columns + k % 2];
                *words++ = value > 0.0f ? value : 0.0f;
            }
        }
    }
}

static void normals_fill(float *table, const struct brdf_measured_layout *layout,
                         const struct brdf_rgl_file *file)
{
    size_t vndf = (size_t)file->vndf_rows * (size_t)file->vndf_columns;
    knots_build(table, layout, file);
    for (int slice = 0; slice < layout->thetas * layout->phis; ++slice) {
        slice_build(table, &layout->vndf, slice, file->vndf + slice_source(file, slice) * vndf);
    }
    cells_build(table + layout->ndf_words, file->ndf, layout->ndf_rows, layout->ndf_columns);
    cells_build(table + layout->sigma_words, file->sigma, layout->sigma_rows,
                layout->sigma_columns);
}

static void values_fill(float *table, const struct brdf_measured_layout *layout,
                        const struct brdf_rgl_file *file)
{
    size_t square = (size_t)file->size * (size_t)file->size;
    for (int slice = 0; slice < layout->thetas * layout->phis; ++slice) {
        size_t source = slice_source(file, slice);
        slice_build(table, &layout->luminance, slice, file->luminance + source * square);
        colors_build(table, layout, slice, file->values + source * 3 * square);
    }
}

/* About how many words the table will have; to be known before ints are trusted to hold it. */
static double words_estimate(const struct brdf_rgl_file *file)
{
    double views = (double)file->phi_count * brdf_rgl_theta_slices(file);
    double steps = BRDF_LINE_STEPS;
    return views * (2.0 * file->vndf_rows * (file->vndf_columns + 1.0 + steps) + 4.0 * steps +
                    2.0 * file->size * (3.0 * file->size + 1.0 + steps)) +
           4.0 * file->ndf_rows * file->ndf_columns + 4.0 * file->sigma_rows * file->sigma_columns;
}

/* Memory for a file's table, with its header and the normals. */
static brdf_status table_begin(const struct brdf_rgl_file *file, float **table, int *words,
                               struct brdf_error *error)
{
    float header[BRDF_MEASURED_HEADER] = {0.0f};
    void *memory = NULL;
    if (words_estimate(file) > 1e9) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "a measurement of %d x %d directions, %d x %d normals and %d x %d values "
                         "needs a table of more than 4 GB",
                         file->phi_count, file->theta_count, file->vndf_rows, file->vndf_columns,
                         file->size, file->size);
    }
    brdf_rgl_header_build(header, file);
    struct brdf_measured_layout layout = brdf_measured_layout_of(header);
    size_t bytes = (size_t)layout.words * sizeof(float);
    if (posix_memalign(&memory, 64, bytes) != 0) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for a table of %d words",
                         layout.words);
    }
    memset(memory, 0, bytes);
    memcpy(memory, header, sizeof header);
    *table = memory;
    *words = layout.words;
    normals_fill(*table, &layout, file);
    return BRDF_OK;
}

brdf_status brdf_rgl_table_of_normals(const struct brdf_rgl_file *file, float **table,
                                      struct brdf_error *error)
{
    int words;
    return table_begin(file, table, &words, error);
}

brdf_status brdf_rgl_table_build(struct brdf_rgl_file *file, float **table, size_t *words,
                                 struct brdf_error *error)
{
    float *result;
    int count;
    brdf_status status = brdf_rgl_to_rgb(file, error);
    status = status ? status : table_begin(file, &result, &count, error);
    if (!status) {
        struct brdf_measured_layout layout = brdf_measured_layout_of(result);
        values_fill(result, &layout, file);
        *table = result;
        *words = (size_t)count;
    }
    return status;
}

brdf_status brdf_rgl_table_load(const char *path, float **table, size_t *words,
                                struct brdf_error *error)
{
    struct brdf_rgl_file file;
    brdf_status status = brdf_rgl_read(path, &file, error);
    if (!status) {
        status = brdf_rgl_table_build(&file, table, words, error);
        brdf_rgl_free(&file);
    }
    return status;
}
