/*
 * warp2d.h - warps of the unit square by densities on a grid that depend on wo: what measured
 * materials are sampled by.
 *
 * Reference: Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
 * Rendering", 2018, section 4. A map has a density on a grid of rows and columns for each of a
 * number of slices, which belong to directions wo: theta_i by phi_i. Between the nodes of the grid
 * it is bilinear, between slices linear, and so are its cumulative distributions: first the row by
 * the marginal one, then the column by the one along x at that place in y. Inside a cell both are
 * inverted exactly, for a linear density. Where the upper half of the square is the mirror image of
 * the lower one, only that and the cell beyond the middle are kept.
 */
#ifndef BRDF_WARP2D_H
#define BRDF_WARP2D_H

#include "lines.h"

/* A map; one for all lanes. */
struct brdf_map {
    struct brdf_lines marginal; /* one line along y: the integrals of the rows */
    struct brdf_lines rows;
    int mirrored; /* y and 1 - y have the same density, and the rows end after the middle */
};

struct brdf_point {
    brdf_real x; /* in [0, 1] */
    brdf_real y;
    brdf_real pdf; /* of the warp at its end that is not uniform [1] */
};

static inline struct brdf_line brdf_line_alone(brdf_int first)
{
    struct brdf_line line;
    line.first = first;
    line.next = 0.0f;
    line.two = 0;
    return line;
}

static inline struct brdf_line brdf_line_between(brdf_int first, brdf_real next)
{
    struct brdf_line line;
    line.first = first;
    line.next = next;
    line.two = 1;
    return line;
}

/* The half of the square that is kept, and back. */
static inline brdf_real brdf_map_fold(struct brdf_map map, brdf_real y)
{
    return map.mirrored ? brdf_min(y, 1.0f - y) : y;
}

static inline brdf_real brdf_map_unfold(struct brdf_map map, brdf_real whole, brdf_real y)
{
    return map.mirrored ? brdf_pick(whole > 0.5f, 1.0f - y, y) : y;
}

/* From a uniform point to one with the density of the map. */
static inline struct brdf_point brdf_map_sample(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    x = brdf_clamp(x, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);
    y = brdf_clamp(y, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);
    brdf_real whole = y;
    y = brdf_map_fold(map, y);
    struct brdf_line_cell row = brdf_line_search(
        map.marginal, slices, brdf_line_alone(0 * slices.first),
        brdf_line_guess(map.marginal, slices, 0 * slices.first, y, table), y, table);
    brdf_real ty = brdf_line_cell_sample(map.marginal, row, y);
    brdf_real density = brdf_mix(row.left, row.right, ty);

    /* The guess is that of the lower row: it can be read before the place between rows is known. */
    brdf_real guess = brdf_line_guess(map.rows, slices, row.number, x, table);
    x = x * density;
    struct brdf_line_cell column =
        brdf_line_search(map.rows, slices, brdf_line_between(row.number, ty),
                         guess / brdf_max(row.left, 1e-30f), x, table);
    brdf_real tx = brdf_line_cell_sample(map.rows, column, x);

    struct brdf_point point;
    point.x = (brdf_to_real(column.number) + tx) * (1.0f / (float)map.rows.cells);
    point.y = (brdf_to_real(row.number) + ty) * (1.0f / (float)map.marginal.cells);
    point.y = brdf_map_unfold(map, whole, point.y);
    point.pdf = brdf_mix(column.left, column.right, tx);
    return point;
}

/* The inverse: from a point (x, y) to the uniform one, with the density at (x, y). */
static inline struct brdf_point brdf_map_invert(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    brdf_real tx, ty;
    brdf_int column = brdf_grid_cell(x, map.rows.cells + 1, &tx);
    brdf_int row = brdf_grid_cell(brdf_map_fold(map, y), map.marginal.cells + 1, &ty);
    struct brdf_quad across =
        brdf_cell_read(map.marginal, slices, brdf_line_alone(0 * row), row, table);
    struct brdf_quad along =
        brdf_cell_read(map.rows, slices, brdf_line_between(row, ty), column, table);
    brdf_real part = along.b + brdf_cell_integral(tx, map.rows.cells, along.a, along.c);
    struct brdf_point point;
    point.x = brdf_clamp(part / brdf_max(brdf_mix(across.a, across.c, ty), 1e-30f), 0.0f, 1.0f);
    point.y = brdf_clamp(across.b + brdf_cell_integral(ty, map.marginal.cells, across.a, across.c),
                         0.0f, 1.0f);
    point.y = brdf_map_unfold(map, y, point.y);
    point.pdf = brdf_mix(along.a, along.c, tx);
    return point;
}

/* The density at a point. */
static inline brdf_real brdf_map_density(struct brdf_map map, struct brdf_slices slices,
                                         brdf_real x, brdf_real y, BRDF_GLOBAL const float *table)
{
    brdf_real tx, ty;
    brdf_int column = brdf_grid_cell(x, map.rows.cells + 1, &tx);
    brdf_int row = brdf_grid_cell(brdf_map_fold(map, y), map.marginal.cells + 1, &ty);
    struct brdf_quad along =
        brdf_cell_read(map.rows, slices, brdf_line_between(row, ty), column, table);
    return brdf_mix(along.a, along.c, tx);
}

#endif
