/*
 * lines.h - distributions along lines of a grid, blended between slices and between two lines.
 *
 * A line has a density at each of its nodes, linear between them, and its integral from the first
 * node on; there is a version of it for each slice. What is blended lies at fixed distances: nodes
 * side by side as pairs of density and integral, then slices (theta_i before phi_i), then lines.
 * A read brings two nodes, and they are blended as they come (quad.h), so that density and integral
 * at both ends of a cell cost one transposition. To begin searches with, there are also the
 * inverses of the integrals at BRDF_LINE_STEPS steps, as pairs of a step and the next one, in cells
 * times the whole integral, for each line and slice.
 */
#ifndef BRDF_LINES_H
#define BRDF_LINES_H

#include "quad.h"
#include "real.h"

/* Steps of the inverse distributions that searches begin with. */
#define BRDF_LINE_STEPS 32

/* Where step k is: 2 t^2 up to a half, and likewise from the other end. t = k / BRDF_LINE_STEPS. */
static inline float brdf_line_step(float t)
{
    return t < 0.5f ? 2.0f * t * t : 1.0f - 2.0f * (1.0f - t) * (1.0f - t);
}

/* The slices around a direction, and how they blend. */
struct brdf_slices {
    brdf_int first;     /* the one with the smaller theta_i and phi_i */
    brdf_real high;     /* part of the next theta_i; the rest is of the first */
    brdf_real phi_high; /* part of the next phi_i; unused if there is one phi_i only */
    int alone;          /* 1: the first slice only; the same for all lanes */
};

/* Lines of the same length; one for all lanes. */
struct brdf_lines {
    int nodes;  /* of each, >= 2 */
    int cells;  /* between them on a length of 1: nodes - 1, or more if they cover a part of it */
    int thetas; /* slices: theta_i, >= 2, and phi_i, >= 1 */
    int phis;
    int words;       /* where the nodes begin in the table */
    int guess_words; /* where the inverses begin */
};

/* A line, or what is between it and the next. */
struct brdf_line {
    brdf_int first;
    brdf_real next; /* part of the next one */
    int two;        /* 0: the first only, and no other is read */
};

/* Words from one line to the next. */
static inline int brdf_lines_apart(struct brdf_lines lines)
{
    return 2 * lines.nodes * lines.thetas * lines.phis;
}

static inline int brdf_guesses_apart(struct brdf_lines lines)
{
    return 2 * BRDF_LINE_STEPS * lines.thetas * lines.phis;
}

/* Records blended between theta_i that are `apart` words from each other. */
static inline struct brdf_quad brdf_thetas_blend(struct brdf_slices slices, int apart,
                                                 BRDF_GLOBAL const float *words, brdf_int index)
{
    struct brdf_quad q = brdf_gather_records(words, index);
    if (!slices.alone) {
        q = brdf_quad_mix(q, brdf_gather_records(words + apart, index),
                          brdf_quad_spread(slices.high));
    }
    return q;
}

/* The same between lines, too. */
static inline struct brdf_quad brdf_lines_blend(struct brdf_lines lines, struct brdf_slices slices,
                                                struct brdf_line line,
                                                BRDF_GLOBAL const float *words, brdf_int index)
{
    int apart = 2 * lines.nodes;
    struct brdf_quad q = brdf_thetas_blend(slices, apart, words, index);
    if (line.two) {
        words = words + brdf_lines_apart(lines);
        q = brdf_quad_mix(q, brdf_thetas_blend(slices, apart, words, index),
                          brdf_quad_spread(line.next));
    }
    return q;
}

/* Where the words of a node are, for the first slice that is blended. */
static inline brdf_int brdf_node_index(struct brdf_lines lines, struct brdf_slices slices,
                                       struct brdf_line line, brdf_int node)
{
    return 2 * ((line.first * (lines.thetas * lines.phis) + slices.first) * lines.nodes + node);
}

/* Four nodes side by side: density and integral of 0, then of 1; of 2, then of 3. */
struct brdf_window {
    struct brdf_quad near;
    struct brdf_quad far;
};

static inline struct brdf_window brdf_window_read(struct brdf_lines lines,
                                                  struct brdf_slices slices, struct brdf_line line,
                                                  brdf_int node, BRDF_GLOBAL const float *table)
{
    BRDF_GLOBAL const float *words = table + lines.words;
    brdf_int index = brdf_node_index(lines, slices, line, node);
    struct brdf_window window;
    window.near = brdf_lines_blend(lines, slices, line, words, index);
    window.far = brdf_lines_blend(lines, slices, line, words + 4, index);
    if (lines.phis > 1 && !slices.alone) {
        struct brdf_quad t = brdf_quad_spread(slices.phi_high);
        words = words + 2 * lines.nodes * lines.thetas;
        window.near =
            brdf_quad_mix(window.near, brdf_lines_blend(lines, slices, line, words, index), t);
        window.far =
            brdf_quad_mix(window.far, brdf_lines_blend(lines, slices, line, words + 4, index), t);
    }
    window.near = brdf_quad_transpose(window.near);
    window.far = brdf_quad_transpose(window.far);
    return window;
}

/* Density and integral at both ends of a cell: half a window. */
static inline struct brdf_quad brdf_cell_read(struct brdf_lines lines, struct brdf_slices slices,
                                              struct brdf_line line, brdf_int cell,
                                              BRDF_GLOBAL const float *table)
{
    return brdf_window_read(lines, slices, line, cell, table).near;
}

/* The cell of a grid that holds x in [0, 1], of `nodes` nodes; *inside is the place in it. */
static inline brdf_int brdf_grid_cell(brdf_real x, int nodes, brdf_real *inside)
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
static inline brdf_real brdf_cell_sample(brdf_real part, int cells, brdf_real v0, brdf_real v1)
{
    brdf_real twice = 2.0f * (float)cells * part;
    brdf_real root = sqrtf(brdf_max(v0 * v0 + twice * (v1 - v0), 0.0f));
    return brdf_clamp(twice / brdf_max(v0 + root, 1e-30f), 0.0f, 1.0f);
}

/* Its inverse: the integral up to the place t of the cell. */
static inline brdf_real brdf_cell_integral(brdf_real t, int cells, brdf_real v0, brdf_real v1)
{
    return t * brdf_mix(v0, v1, 0.5f * t) * (1.0f / (float)cells);
}

/*
 * About where the integral of a line reaches u of the whole, in cells times the whole: its inverse
 * at some places, blended between theta_i by what they have there.
 */
static inline brdf_real brdf_line_guess(struct brdf_lines lines, struct brdf_slices slices,
                                        brdf_int line, brdf_real u, BRDF_GLOBAL const float *table)
{
    brdf_real root = sqrtf(0.5f * brdf_min(u, 1.0f - u)); /* finer towards both ends */
    brdf_real place = brdf_pick(u < 0.5f, root, 1.0f - root) * (float)BRDF_LINE_STEPS;
    brdf_int step = brdf_to_int(brdf_min(place, (float)BRDF_LINE_STEPS - 0.5f));
    brdf_real t = place - brdf_to_real(step);
    struct brdf_quad q = brdf_gather_quad(
        table + lines.guess_words,
        2 * ((line * BRDF_LINE_STEPS + step) * (lines.thetas * lines.phis) + slices.first));
    brdf_real guess = brdf_mix(q.a, q.b, t);
    return slices.alone ? guess : brdf_mix(guess, brdf_mix(q.c, q.d, t), slices.high);
}

/* A search for the last cell that begins below u: a window of three cells, and what is left. */
struct brdf_line_search {
    brdf_int first; /* cell of the window */
    brdf_int low;   /* cells that it may still be */
    brdf_int high;
};

/* A window of four nodes around a cell. */
static inline brdf_int brdf_window_around(brdf_int cell, int nodes)
{
    int last = nodes > 4 ? nodes - 4 : 0;
    brdf_int first = cell - 1;
    first = brdf_pick_int(first > last, last, first);
    return brdf_pick_int(first < 0, 0, first);
}

/*
 * The next window where one missed, on the side that `left` or `right` tell. Newton's step from its
 * edge, and every second time the middle of what is left, so that it ends; integrals never fall, so
 * which windows led to a cell does not matter.
 */
static inline struct brdf_line_search brdf_window_move(struct brdf_line_search s,
                                                       struct brdf_lines lines, int step,
                                                       brdf_real u, struct brdf_window window,
                                                       brdf_mask left, brdf_mask right)
{
    s.low = brdf_pick_int(right, s.first + 3, s.low);
    s.high = brdf_pick_int(left, s.first - 1, s.high);
    brdf_int next = (s.low + s.high) >> 1;
    if (step % 2 == 0) {
        brdf_real off = u - brdf_pick(right, window.far.d, window.near.b);
        brdf_real density = brdf_max(brdf_pick(right, window.far.c, window.near.a), 1e-6f);
        off = brdf_clamp(off * (float)lines.cells / density, -65536.0f, 65536.0f);
        next = brdf_pick_int(right, s.first + 3, s.first) + brdf_to_int(brdf_floor(off));
    }
    next = brdf_pick_int(next < s.low, s.low, brdf_pick_int(next > s.high, s.high, next));
    s.first = brdf_pick_int(left | right, brdf_window_around(next, lines.nodes), s.first);
    return s;
}

/* A cell that was searched for: the densities at its ends, and the integral where it begins. */
struct brdf_line_cell {
    brdf_int number;
    brdf_real begin;
    brdf_real left;
    brdf_real right;
};

/*
 * The cell in which the integral of a line reaches u, which is between 0 and that of the whole;
 * `guess` is about where that is, in cells. Most packets of lanes find all of theirs in the first
 * window.
 */
static inline struct brdf_line_cell brdf_line_search(struct brdf_lines lines,
                                                     struct brdf_slices slices,
                                                     struct brdf_line line, brdf_real guess,
                                                     brdf_real u, BRDF_GLOBAL const float *table)
{
    int last = lines.nodes - 2;
    struct brdf_window w;
    struct brdf_line_search s;
    s.low = 0 * line.first;
    s.high = 0 * line.first + last;
    s.first =
        brdf_window_around(brdf_to_int(brdf_clamp(guess, 0.0f, (float)last + 0.5f)), lines.nodes);
    int missed = 1;
    for (int step = 0; missed; ++step) {
        w = brdf_window_read(lines, slices, line, s.first, table);
        brdf_mask left = (w.near.b >= u) & (s.first > 0);
        brdf_mask right = (w.far.d < u) & (s.first + 3 <= last);
        missed = brdf_any(left | right);
        if (missed) {
            s = brdf_window_move(s, lines, step, u, w, left, right);
        }
    }
    brdf_mask second = (w.near.d < u) & (s.first + 1 <= last);
    brdf_mask third = (w.far.b < u) & (s.first + 2 <= last);
    struct brdf_line_cell cell;
    cell.number = s.first + brdf_pick_int(third, 2, brdf_pick_int(second, 1, 0));
    cell.begin = brdf_pick(third, w.far.b, brdf_pick(second, w.near.d, w.near.b));
    cell.left = brdf_pick(third, w.far.a, brdf_pick(second, w.near.c, w.near.a));
    cell.right = brdf_pick(third, w.far.c, brdf_pick(second, w.far.a, w.near.c));
    return cell;
}

/* Where in it that is, 0 to 1. */
static inline brdf_real brdf_line_cell_sample(struct brdf_lines lines, struct brdf_line_cell cell,
                                              brdf_real u)
{
    return brdf_cell_sample(u - cell.begin, lines.cells, cell.left, cell.right);
}

#endif
