/*
 * warp2d.h - warps of the unit square by densities on a grid that depend on wo: what measured
 * materials are sampled by.
 *
 * Reference: Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
 * Rendering", 2018, section 4. A map has a density on a grid of rows and columns for each of a
 * number of slices, which belong to directions wo: theta_i by phi_i. Between the nodes of the grid
 * it is bilinear, between slices linear, and so are its cumulative distributions: first the row by
 * the marginal one, then the column by the one along x at that place in y. Inside a cell both are
 * inverted exactly, for a linear density.
 *
 * The words of a map: for each row and slice its integral from the first row on, and that along
 * the row; then for each node (row, column) and slice the density, and its integral along the row
 * from the first column on. Slices lie innermost, theta_i before phi_i: the two or four that are
 * blended are read together.
 */
#ifndef BRDF_WARP2D_H
#define BRDF_WARP2D_H

#include "quad.h"
#include "real.h"

/* The slices around a direction, and how they blend. */
struct brdf_slices {
    brdf_int first; /* the one with the smaller theta_i and phi_i */
    brdf_real low;  /* weights in theta_i, 1 together */
    brdf_real high;
    brdf_real phi_low; /* in phi_i; 1 and 0 if there is one phi_i only */
    brdf_real phi_high;
};

/* A map; one for all lanes. */
struct brdf_map {
    int rows; /* nodes along y, >= 2 */
    int columns;
    int thetas; /* slices: theta_i, >= 2, and phi_i, >= 1 */
    int phis;
    int row_words;  /* where the rows begin in the table */
    int node_words; /* and the nodes */
};

struct brdf_point {
    brdf_real x; /* in [0, 1] */
    brdf_real y;
    brdf_real pdf; /* of the warp at its end that is not uniform [1] */
};

/* How many words a map takes. */
static inline int brdf_map_size(int rows, int columns, int slices)
{
    return 2 * slices * rows * (columns + 1);
}

/* Two values at one place, blended between the slices. */
struct brdf_couple {
    brdf_real value;
    brdf_real sum;
};

static inline struct brdf_couple brdf_map_read(struct brdf_map map, struct brdf_slices slices,
                                               BRDF_GLOBAL const float *words, brdf_int place)
{
    brdf_int index = 2 * (place * (map.thetas * map.phis) + slices.first);
    struct brdf_quad q = brdf_gather_quad(words, index);
    struct brdf_couple couple;
    couple.value = q.a * slices.low + q.c * slices.high;
    couple.sum = q.b * slices.low + q.d * slices.high;
    if (map.phis > 1) {
        q = brdf_gather_quad(words + 2 * map.thetas, index);
        couple.value = couple.value * slices.phi_low +
                       (q.a * slices.low + q.c * slices.high) * slices.phi_high;
        couple.sum =
            couple.sum * slices.phi_low + (q.b * slices.low + q.d * slices.high) * slices.phi_high;
    }
    return couple;
}

static inline brdf_real brdf_mix(brdf_real a, brdf_real b, brdf_real t)
{
    return a * (1.0f - t) + b * t;
}

/* The cell of a grid that holds x in [0, 1], of `nodes` nodes; *inside is the place in it. */
static inline brdf_int brdf_map_cell(brdf_real x, int nodes, brdf_real *inside)
{
    brdf_real place = brdf_clamp(x, 0.0f, 1.0f) * (float)(nodes - 1);
    brdf_int cell = brdf_to_int(brdf_min(place, (float)nodes - 1.5f));
    *inside = place - brdf_to_real(cell);
    return cell;
}

/*
 * Where the integral of a density that goes from v0 to v1 over a cell of width 1 / cells is
 * `part`, as a fraction of the cell. The root of the quadratic that loses no digits.
 */
static inline brdf_real brdf_segment_sample(brdf_real part, int cells, brdf_real v0, brdf_real v1)
{
    brdf_real twice = 2.0f * (float)cells * part;
    brdf_real root = sqrtf(brdf_max(v0 * v0 + twice * (v1 - v0), 0.0f));
    return brdf_clamp(twice / brdf_max(v0 + root, 1e-30f), 0.0f, 1.0f);
}

/* Its inverse: the integral up to the place t of the cell. */
static inline brdf_real brdf_segment_integral(brdf_real t, int cells, brdf_real v0, brdf_real v1)
{
    return t * brdf_mix(v0, v1, 0.5f * t) * (1.0f / (float)cells);
}

/* The largest power of two that is not above n >= 1. */
static inline int brdf_map_stride(int n)
{
    int stride = 1;
    while (2 * stride <= n) {
        stride *= 2;
    }
    return stride;
}

/* The last row whose integral is below u; the first one if none is. */
static inline brdf_int brdf_map_row(struct brdf_map map, struct brdf_slices slices, brdf_real u,
                                    BRDF_GLOBAL const float *table)
{
    int last = map.rows - 2;
    brdf_int row = 0;
    for (int step = brdf_map_stride(last); step > 0; step /= 2) {
        brdf_int next = row + step;
        brdf_int inside = brdf_pick_int(next > last, 0 * next + last, next);
        brdf_real sum = brdf_map_read(map, slices, table + map.row_words, inside).value;
        row = brdf_pick_int((next <= last) & (sum < u), next, row);
    }
    return row;
}

/* The same along x, at the place y between the rows that begin with node `first`. */
static inline brdf_int brdf_map_column(struct brdf_map map, struct brdf_slices slices,
                                       brdf_int first, brdf_real y, brdf_real u,
                                       BRDF_GLOBAL const float *table)
{
    int last = map.columns - 2;
    brdf_int column = 0;
    for (int step = brdf_map_stride(last); step > 0; step /= 2) {
        brdf_int next = column + step;
        brdf_int node = first + brdf_pick_int(next > last, 0 * next + last, next);
        brdf_real below = brdf_map_read(map, slices, table + map.node_words, node).sum;
        brdf_real above =
            brdf_map_read(map, slices, table + map.node_words, node + map.columns).sum;
        column = brdf_pick_int((next <= last) & (brdf_mix(below, above, y) < u), next, column);
    }
    return column;
}

/* From a uniform point to one with the density of the map. */
static inline struct brdf_point brdf_map_sample(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    BRDF_GLOBAL const float *nodes = table + map.node_words;
    x = brdf_clamp(x, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);
    y = brdf_clamp(y, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);
    brdf_int row = brdf_map_row(map, slices, y, table);
    struct brdf_couple row0 = brdf_map_read(map, slices, table + map.row_words, row);
    struct brdf_couple row1 = brdf_map_read(map, slices, table + map.row_words, row + 1);
    brdf_real ty = brdf_segment_sample(y - row0.value, map.rows - 1, row0.sum, row1.sum);

    x = x * brdf_mix(row0.sum, row1.sum, ty);
    brdf_int column = brdf_map_column(map, slices, row * map.columns, ty, x, table);
    brdf_int node = row * map.columns + column;
    struct brdf_couple n00 = brdf_map_read(map, slices, nodes, node);
    struct brdf_couple n10 = brdf_map_read(map, slices, nodes, node + 1);
    struct brdf_couple n01 = brdf_map_read(map, slices, nodes, node + map.columns);
    struct brdf_couple n11 = brdf_map_read(map, slices, nodes, node + map.columns + 1);
    brdf_real left = brdf_mix(n00.value, n01.value, ty);
    brdf_real right = brdf_mix(n10.value, n11.value, ty);
    brdf_real tx =
        brdf_segment_sample(x - brdf_mix(n00.sum, n01.sum, ty), map.columns - 1, left, right);

    struct brdf_point point;
    point.x = (brdf_to_real(column) + tx) * (1.0f / (float)(map.columns - 1));
    point.y = (brdf_to_real(row) + ty) * (1.0f / (float)(map.rows - 1));
    point.pdf = brdf_mix(left, right, tx);
    return point;
}

/* The inverse: from a point (x, y) to the uniform one, with the density at (x, y). */
static inline struct brdf_point brdf_map_invert(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    BRDF_GLOBAL const float *nodes = table + map.node_words;
    brdf_real tx, ty;
    brdf_int column = brdf_map_cell(x, map.columns, &tx);
    brdf_int row = brdf_map_cell(y, map.rows, &ty);
    brdf_int node = row * map.columns + column;
    struct brdf_couple row0 = brdf_map_read(map, slices, table + map.row_words, row);
    struct brdf_couple row1 = brdf_map_read(map, slices, table + map.row_words, row + 1);
    struct brdf_couple n00 = brdf_map_read(map, slices, nodes, node);
    struct brdf_couple n10 = brdf_map_read(map, slices, nodes, node + 1);
    struct brdf_couple n01 = brdf_map_read(map, slices, nodes, node + map.columns);
    struct brdf_couple n11 = brdf_map_read(map, slices, nodes, node + map.columns + 1);
    brdf_real left = brdf_mix(n00.value, n01.value, ty);
    brdf_real right = brdf_mix(n10.value, n11.value, ty);
    brdf_real along =
        brdf_mix(n00.sum, n01.sum, ty) + brdf_segment_integral(tx, map.columns - 1, left, right);
    struct brdf_point point;
    point.x = brdf_clamp(along / brdf_max(brdf_mix(row0.sum, row1.sum, ty), 1e-30f), 0.0f, 1.0f);
    point.y = brdf_clamp(row0.value + brdf_segment_integral(ty, map.rows - 1, row0.sum, row1.sum),
                         0.0f, 1.0f);
    point.pdf = brdf_mix(left, right, tx);
    return point;
}

#endif
