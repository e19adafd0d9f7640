/*
 * rgl_header.c - what of a file the table of the model `measured` needs.
 */
#include "rgl_header.h"

#include <math.h>
#include <stddef.h>

#include "angle.h"
#include "brdf/measurement.h"

int brdf_rgl_theta_slices(const struct brdf_rgl_file *file)
{
    return file->theta_count > 1 ? file->theta_count : 2;
}

/* Are the rows of a grid by direction all the same? Then one cell across is enough. */
static int rows_needed(const float *grid, int rows, int columns)
{
    for (int i = columns; i < rows * columns; ++i) {
        if (grid[i] != grid[i - columns]) {
            return rows;
        }
    }
    return 2;
}

/*
 * Is every slice of a density over the square its own mirror image in y, to rounding? Visible
 * normals of isotropic materials are: they are made of D, not measured.
 */
static int is_mirrored(const float *density, int slices, int rows, int columns)
{
    for (int row = 0; row < slices * rows; ++row) {
        int opposite = row / rows * rows + (rows - 1 - row % rows);
        for (int column = 0; column < columns; ++column) {
            float a = density[(size_t)row * (size_t)columns + (size_t)column];
            float b = density[(size_t)opposite * (size_t)columns + (size_t)column];
            if (fabsf(a - b) > 1e-6f * fmaxf(fabsf(a), fabsf(b))) {
                return 0;
            }
        }
    }
    return 1;
}

void brdf_rgl_header_build(float *table, const struct brdf_rgl_file *file)
{
    int turn = file->phi_count > 2
                   ? (int)lrint(2.0 * pi /
                                ((double)file->phi_i[file->phi_count - 1] - (double)file->phi_i[0]))
                   : 1;
    table[BRDF_MEASURED_PHIS] = (float)file->phi_count;
    table[BRDF_MEASURED_THETAS] = (float)brdf_rgl_theta_slices(file);
    table[BRDF_MEASURED_VNDF_ROWS] = (float)file->vndf_rows;
    table[BRDF_MEASURED_VNDF_COLUMNS] = (float)file->vndf_columns;
    table[BRDF_MEASURED_SIZE] = (float)file->size;
    table[BRDF_MEASURED_NDF_ROWS] =
        (float)rows_needed(file->ndf, file->ndf_rows, file->ndf_columns);
    table[BRDF_MEASURED_NDF_COLUMNS] = (float)file->ndf_columns;
    table[BRDF_MEASURED_SIGMA_ROWS] =
        (float)rows_needed(file->sigma, file->sigma_rows, file->sigma_columns);
    table[BRDF_MEASURED_SIGMA_COLUMNS] = (float)file->sigma_columns;
    table[BRDF_MEASURED_ISOTROPIC] = file->phi_count <= 2 ? 1.0f : 0.0f;
    table[BRDF_MEASURED_SYMMETRY] = turn == 2 ? 2.0f : turn == 4 ? 4.0f : 1.0f;
    table[BRDF_MEASURED_MIRRORED] = (float)is_mirrored(
        file->vndf, file->phi_count * file->theta_count, file->vndf_rows, file->vndf_columns);
    table[BRDF_MEASURED_JACOBIAN] = file->jacobian ? 1.0f : 0.0f;
}
