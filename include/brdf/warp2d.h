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
 * from the first column on; then, to begin searches with, the inverses of both integrals at
 * BRDF_MAP_STEPS steps, as pairs of a step and the next one, in cells times the whole
 * integral. Slices lie innermost,
 * theta_i before phi_i: the two that are blended are read together.
 */
#ifndef BRDF_WARP2D_H
#define BRDF_WARP2D_H

#include "quad.h"
#include "real.h"

/* Steps of the inverse distributions that searches begin with. */
#define BRDF_MAP_STEPS 32

/* Where step k is: 2 t^2 up to a half, and likewise from the other end. t = k / BRDF_MAP_STEPS. */
static inline float brdf_map_step(float t)
{
    return t < 0.5f ? 2.0f * t * t : 1.0f - 2.0f * (1.0f - t) * (1.0f - t);
}

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
    int row_words;          /* where the rows begin in the table */
    int node_words;         /* the nodes */
    int row_guess_words;    /* the inverse of the rows' integral */
    int column_guess_words; /* and of those along each row */
};

struct brdf_point {
    brdf_real x; /* in [0, 1] */
    brdf_real y;
    brdf_real pdf; /* of the warp at its end that is not uniform [1] */
};

/* Two values at one place, blended between the slices. */
struct brdf_couple {
    brdf_real value;
    brdf_real sum;
};

/* Where the words of a row or node are, for the first slice that is blended. */
static inline brdf_int brdf_map_index(struct brdf_map map, struct brdf_slices slices,
                                      brdf_int place)
{
    return 2 * (place * (map.thetas * map.phis) + slices.first);
}

/* Words from one row or node to the next. To read that, move `words` and keep the index: the lanes
   of an index are taken apart only once. */
static inline int brdf_map_apart(struct brdf_map map)
{
    return 2 * map.thetas * map.phis;
}

static inline struct brdf_couple brdf_map_read(struct brdf_map map, struct brdf_slices slices,
                                               BRDF_GLOBAL const float *words, brdf_int index)
{
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

/*
 * About where the cumulative distribution of a line (a row, or the rows themselves) reaches u, in
 * cells times the integral of the line: its inverse at some places, blended between the slices by
 * what they have there.
 */
static inline brdf_real brdf_map_guess(struct brdf_map map, struct brdf_slices slices,
                                       BRDF_GLOBAL const float *words, brdf_int line, brdf_real u)
{
    brdf_real root = sqrtf(0.5f * brdf_min(u, 1.0f - u)); /* finer towards both ends */
    brdf_real place = brdf_pick(u < 0.5f, root, 1.0f - root) * (float)BRDF_MAP_STEPS;
    brdf_int step = brdf_to_int(brdf_min(place, (float)BRDF_MAP_STEPS - 0.5f));
    brdf_real t = place - brdf_to_real(step);
    struct brdf_quad q = brdf_gather_quad(
        words, 2 * ((line * BRDF_MAP_STEPS + step) * (map.thetas * map.phis) + slices.first));
    return brdf_mix(q.a, q.b, t) * slices.low + brdf_mix(q.c, q.d, t) * slices.high;
}

/* A search for the last cell whose integral is below u, and where it may still be. */
struct brdf_map_search {
    brdf_int cell;
    brdf_int low;
    brdf_int high;
};

static inline struct brdf_map_search brdf_map_search_begin(brdf_real guess, int cells)
{
    struct brdf_map_search search;
    search.cell = brdf_to_int(brdf_clamp(guess, 0.0f, (float)cells - 0.5f));
    search.low = 0 * search.cell;
    search.high = 0 * search.cell + (cells - 1);
    return search;
}

/*
 * One step, given the integrals at both ends of the cell and its mean density: Newton's, and every
 * second time the middle of what is left, so that it ends. *found is true for all lanes at the end;
 * integrals never fall, so which steps led to a cell does not matter.
 */
static inline struct brdf_map_search brdf_map_search_step(struct brdf_map_search s, int cells,
                                                          int step, brdf_real u, brdf_real begin,
                                                          brdf_real end, brdf_real density,
                                                          int *found)
{
    brdf_mask right = (end < u) & (s.cell < cells - 1);
    brdf_mask left = (begin >= u) & (s.cell > 0);
    brdf_mask off = right | left;
    *found = !brdf_any(off);
    s.low = brdf_pick_int(right, s.cell + 1, s.low);
    s.high = brdf_pick_int(left, s.cell - 1, s.high);
    brdf_int next = (s.low + s.high) >> 1;
    if (step % 2 == 0) {
        brdf_real ahead = (u - begin) * (float)cells / brdf_max(density, 1e-6f);
        next = s.cell + brdf_to_int(brdf_floor(brdf_clamp(ahead, -4096.0f, 4096.0f)));
    }
    next = brdf_pick_int(next < s.low, s.low, brdf_pick_int(next > s.high, s.high, next));
    s.cell = brdf_pick_int(off, next, s.cell);
    return s;
}

/* The corners of a cell at a place between its rows: density and integral along x, both blended. */
struct brdf_map_cut {
    struct brdf_couple left;
    struct brdf_couple right;
};

static inline struct brdf_map_cut brdf_map_cut_of(struct brdf_map map, struct brdf_slices slices,
                                                  brdf_int node, brdf_real y,
                                                  BRDF_GLOBAL const float *table)
{
    BRDF_GLOBAL const float *nodes = table + map.node_words;
    BRDF_GLOBAL const float *above = nodes + brdf_map_apart(map) * map.columns;
    brdf_int index = brdf_map_index(map, slices, node);
    struct brdf_couple n00 = brdf_map_read(map, slices, nodes, index);
    struct brdf_couple n10 = brdf_map_read(map, slices, nodes + brdf_map_apart(map), index);
    struct brdf_couple n01 = brdf_map_read(map, slices, above, index);
    struct brdf_couple n11 = brdf_map_read(map, slices, above + brdf_map_apart(map), index);
    struct brdf_map_cut cut;
    cut.left.value = brdf_mix(n00.value, n01.value, y);
    cut.left.sum = brdf_mix(n00.sum, n01.sum, y);
    cut.right.value = brdf_mix(n10.value, n11.value, y);
    cut.right.sum = brdf_mix(n10.sum, n11.sum, y);
    return cut;
}

/* From a uniform point to one with the density of the map. */
static inline struct brdf_point brdf_map_sample(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    BRDF_GLOBAL const float *rows = table + map.row_words;
    BRDF_GLOBAL const float *guesses = table + map.column_guess_words;
    int next_guesses = BRDF_MAP_STEPS * brdf_map_apart(map);
    int found = 0;
    struct brdf_couple row0, row1;
    struct brdf_map_cut cut;
    x = brdf_clamp(x, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);
    y = brdf_clamp(y, 5.9604645e-8f, BRDF_ONE_MINUS_ULP);

    struct brdf_map_search row = brdf_map_search_begin(
        brdf_map_guess(map, slices, table + map.row_guess_words, 0 * slices.first, y),
        map.rows - 1);
    brdf_int cell = row.cell;
    for (int step = 0; !found; ++step) {
        cell = row.cell;
        brdf_int index = brdf_map_index(map, slices, cell);
        row0 = brdf_map_read(map, slices, rows, index);
        row1 = brdf_map_read(map, slices, rows + brdf_map_apart(map), index);
        row = brdf_map_search_step(row, map.rows - 1, step, y, row0.value, row1.value,
                                   0.5f * (row0.sum + row1.sum), &found);
    }
    brdf_real ty = brdf_segment_sample(y - row0.value, map.rows - 1, row0.sum, row1.sum);

    brdf_real all = brdf_mix(row0.sum, row1.sum, ty);
    brdf_real guess = brdf_mix(brdf_map_guess(map, slices, guesses, cell, x),
                               brdf_map_guess(map, slices, guesses + next_guesses, cell, x), ty);
    struct brdf_map_search column =
        brdf_map_search_begin(guess / brdf_max(all, 1e-30f), map.columns - 1);
    x = x * all;
    brdf_int first = cell * map.columns;
    found = 0;
    for (int step = 0; !found; ++step) {
        cell = column.cell;
        cut = brdf_map_cut_of(map, slices, first + cell, ty, table);
        column = brdf_map_search_step(column, map.columns - 1, step, x, cut.left.sum, cut.right.sum,
                                      0.5f * (cut.left.value + cut.right.value), &found);
    }
    brdf_real tx =
        brdf_segment_sample(x - cut.left.sum, map.columns - 1, cut.left.value, cut.right.value);

    struct brdf_point point;
    point.x = (brdf_to_real(cell) + tx) * (1.0f / (float)(map.columns - 1));
    point.y = (brdf_to_real(row.cell) + ty) * (1.0f / (float)(map.rows - 1));
    point.pdf = brdf_mix(cut.left.value, cut.right.value, tx);
    return point;
}

/* The inverse: from a point (x, y) to the uniform one, with the density at (x, y). */
static inline struct brdf_point brdf_map_invert(struct brdf_map map, struct brdf_slices slices,
                                                brdf_real x, brdf_real y,
                                                BRDF_GLOBAL const float *table)
{
    brdf_real tx, ty;
    brdf_int column = brdf_map_cell(x, map.columns, &tx);
    brdf_int row = brdf_map_cell(y, map.rows, &ty);
    brdf_int node = row * map.columns + column;
    BRDF_GLOBAL const float *rows = table + map.row_words;
    brdf_int index = brdf_map_index(map, slices, row);
    struct brdf_couple row0 = brdf_map_read(map, slices, rows, index);
    struct brdf_couple row1 = brdf_map_read(map, slices, rows + brdf_map_apart(map), index);
    struct brdf_map_cut cut = brdf_map_cut_of(map, slices, node, ty, table);
    brdf_real along =
        cut.left.sum + brdf_segment_integral(tx, map.columns - 1, cut.left.value, cut.right.value);
    struct brdf_point point;
    point.x = brdf_clamp(along / brdf_max(brdf_mix(row0.sum, row1.sum, ty), 1e-30f), 0.0f, 1.0f);
    point.y = brdf_clamp(row0.value + brdf_segment_integral(ty, map.rows - 1, row0.sum, row1.sum),
                         0.0f, 1.0f);
    point.pdf = brdf_mix(cut.left.value, cut.right.value, tx);
    return point;
}

#endif
