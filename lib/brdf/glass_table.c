/*
 * glass_table.c - the table of a rough interface: glass_curve.h says what is in it and where.
 *
 * Quadratures at a third of the rows and half of the columns; cubic polynomials through four of
 * them fill the rest, so that the table may be read linearly. Some hundredths of a second.
 */
#include "glass_table.h"

#include <math.h>
#include <stdlib.h>

#include "brdf/glass_curve.h"
#include "brdf/interface.h"
#include "facet_shares.h"
#include "table_fill.h"

enum {
    NODES = 8, /* of a piece of the quadrature */
    ROW_STEP = 3,
    COLUMN_STEP = 2,
    ROWS = (BRDF_GLASS_ROWS - 1) / ROW_STEP + 1, /* with quadratures */
    PARTS = 8                                    /* of a cell, for integrals over it */
};

/* A table in the making. */
struct making {
    struct facet_rule rule;
    const struct facet_surface *surface; /* from above */
    int coating;
    double cosine[2][BRDF_GLASS_COLUMNS];  /* of the columns, from above and from below */
    double measure[2][BRDF_GLASS_COLUMNS]; /* integrals of 2 mu times the column's hat */
    float *table;
};

static struct brdf_glass_axis axis_of(const struct making *making, int below)
{
    return brdf_glass_axis_of(making->table, below);
}

static double place_number(struct brdf_place place)
{
    return (double)place.index + (double)place.rest;
}

/* The cosine at a column, by bisection: columns rise with cosines. */
static double cosine_of(struct brdf_glass_axis axis, int column)
{
    double critical = (double)axis.critical;
    int is_below = column < BRDF_GLASS_BELOW;
    double low = is_below ? 0.0 : critical, high = is_below ? critical : 1.0;
    if (column == BRDF_GLASS_BELOW - 1 || column == BRDF_GLASS_BELOW) {
        return critical;
    }
    for (int i = 0; i < 40; ++i) {
        double middle = 0.5 * (low + high);
        int before = place_number(brdf_glass_column(axis, (float)middle)) < column;
        low = before ? middle : low;
        high = before ? high : middle;
    }
    return 0.5 * (low + high);
}

/* The part of the columns that is in use, first to last. */
static void columns_of(struct brdf_glass_axis axis, int part, int *first, int *last)
{
    *first = part == 0 ? 0 : BRDF_GLASS_BELOW;
    *last = part == 0 ? BRDF_GLASS_BELOW - 1 : BRDF_GLASS_COLUMNS - 1;
    if (part == 0 && !(axis.critical > 0.0f)) {
        *last = -1;
    }
}

/* Columns of one side: where they are, and what a number there adds to the mean. */
static void side_prepare(struct making *making, int below)
{
    struct brdf_glass_axis axis = axis_of(making, below);
    double *cosine = making->cosine[below], *measure = making->measure[below];
    for (int i = 0; i < BRDF_GLASS_COLUMNS; ++i) {
        cosine[i] = cosine_of(axis, i);
        measure[i] = 0.0;
    }
    for (int part = 0; part < 2; ++part) {
        int first, last;
        columns_of(axis, part, &first, &last);
        for (int i = first; i < last; ++i) {
            double width = (cosine[i + 1] - cosine[i]) / PARTS;
            for (int k = 0; k < PARTS; ++k) {
                double mu = cosine[i] + width * (k + 0.5);
                double rest = place_number(brdf_glass_column(axis, (float)mu)) - i;
                rest = fmin(fmax(rest, 0.0), 1.0);
                measure[i] += 2.0 * mu * width * (1.0 - rest);
                measure[i + 1] += 2.0 * mu * width * rest;
            }
        }
    }
}

/* alpha of a row, by bisection. */
static double alpha_of(int row)
{
    double low = (double)BRDF_GLASS_ALPHA_LOW, high = (double)BRDF_GLASS_ALPHA_HIGH;
    for (int i = 0; i < 40; ++i) {
        double middle = 0.5 * (low + high);
        int before = place_number(brdf_glass_row((float)middle)) < row;
        low = before ? middle : low;
        high = before ? high : middle;
    }
    return 0.5 * (low + high);
}

static struct facet_surface surface_of(const struct making *making, double alpha, int below)
{
    struct facet_surface surface = *making->surface;
    surface.alpha_u = surface.alpha_v = alpha;
    surface.eta = below ? 1.0 / surface.eta : surface.eta;
    return surface;
}

static float lost(struct facet_shares shares)
{
    return (float)fmin(fmax(1.0 - shares.reflected - shares.passed, 0.0), 1.0);
}

/* Curves of one side; what passes only if there is room for it. */
static void curves_make(const struct making *making, double alpha, int below, float *passed,
                        float *losses)
{
    struct facet_surface surface = surface_of(making, alpha, below);
    for (int part = 0; part < 2; ++part) {
        int first, last;
        columns_of(axis_of(making, below), part, &first, &last);
        for (int i = first; i <= last; i += COLUMN_STEP) {
            /* Not quite 0, where there is nothing to be seen. */
            double mu = fmax(making->cosine[below][i], 1e-6);
            struct facet_light light = {mu, 1.0, 0.0};
            struct facet_shares shares = facet_shares_of(&surface, &making->rule, light);
            losses[i] = lost(shares);
            if (passed) {
                passed[i] = (float)shares.passed;
            }
        }
        if (last >= first) {
            brdf_table_fill(losses + first, last - first + 1, 0, last - first, 1, COLUMN_STEP);
        }
        if (last >= first && passed) {
            brdf_table_fill(passed + first, last - first + 1, 0, last - first, 1, COLUMN_STEP);
        }
    }
}

/* The mean loss from below where there is no curve of it; in quarters, for it has more kinks. */
static float mean_loss(const struct making *making, double alpha)
{
    struct facet_surface surface = surface_of(making, alpha, 1);
    double critical = (double)axis_of(making, 1).critical;
    double sum = 0.0;
    for (int i = 0; i < 4 * NODES; ++i) {
        int part = i / NODES, k = i % NODES;
        double width = 0.5 * (part < 2 ? critical : 1.0 - critical);
        double first = (part < 2 ? 0.0 : critical) + (part % 2) * width;
        if (width > 0.0) {
            struct facet_light light = {first + width * making->rule.at[k], 1.0, 0.0};
            sum += 2.0 * light.mu * width * making->rule.weight[k] *
                   (double)lost(facet_shares_of(&surface, &making->rule, light));
        }
    }
    return (float)sum;
}

static float *row_of(const struct making *making, int row)
{
    return making->table + BRDF_GLASS_HEAD + row * BRDF_GLASS_ROW;
}

static void row_make(const struct making *making, int number)
{
    double alpha = alpha_of(number);
    float *row = row_of(making, number);
    float *first = row + BRDF_GLASS_MEANS, *second = first + BRDF_GLASS_COLUMNS;
    if (making->coating) {
        curves_make(making, alpha, 0, first, second);
        row[BRDF_GLASS_LOSS_BELOW] = mean_loss(making, alpha);
    } else {
        curves_make(making, alpha, 0, NULL, first);
        curves_make(making, alpha, 1, NULL, second);
    }
}

/* Means of the curves as they are read. */
static void row_average(const struct making *making, float *row)
{
    int below = !making->coating;
    double first = 0.0, second = 0.0;
    for (int i = 0; i < BRDF_GLASS_COLUMNS; ++i) {
        const float *numbers = row + BRDF_GLASS_MEANS + i;
        first += making->measure[0][i] * (double)numbers[0];
        second += making->measure[below][i] * (double)numbers[BRDF_GLASS_COLUMNS];
    }
    row[making->coating ? BRDF_GLASS_PASS_ABOVE : BRDF_GLASS_LOSS_ABOVE] = (float)first;
    row[making->coating ? BRDF_GLASS_LOSS_ABOVE : BRDF_GLASS_LOSS_BELOW] = (float)second;
}

static void head_make(struct making *making)
{
    float *table = making->table;
    float eta = (float)making->surface->eta;
    table[BRDF_GLASS_ETA] = eta;
    table[BRDF_GLASS_PASS] = brdf_interface_pass(eta);
    for (int below = 0; below < 2; ++below) {
        struct brdf_glass_axis axis = brdf_glass_axis_make(below ? 1.0f / eta : eta);
        float *words = table + BRDF_GLASS_AXES + below * BRDF_GLASS_AXIS;
        words[0] = axis.critical;
        words[1] = axis.below_scale;
        words[2] = axis.below_even;
        words[3] = axis.above_scale;
        words[4] = axis.above_width;
    }
}

/* Rows by quadrature, all of them or the four around one roughness, and those between; no other row
   is read then. */
static void rows_make(struct making *making)
{
    int first = 0, last = ROWS - 1;
    if (making->surface->alpha_u > 0.0) {
        int row = (int)place_number(brdf_glass_row((float)making->surface->alpha_u)) / ROW_STEP;
        first = row < 1 ? 0 : row > ROWS - 3 ? ROWS - 4 : row - 1;
        last = first + 3;
    }
    for (int row = first; row <= last; ++row) {
        row_make(making, row * ROW_STEP);
    }
    for (int word = 0; word < BRDF_GLASS_ROW; ++word) {
        brdf_table_fill(row_of(making, 0) + word, BRDF_GLASS_ROWS, first * ROW_STEP,
                        last * ROW_STEP, BRDF_GLASS_ROW, ROW_STEP);
    }
    for (int row = first * ROW_STEP; row <= last * ROW_STEP; ++row) {
        row_average(making, row_of(making, row));
    }
}

brdf_status brdf_glass_table_make(const struct facet_surface *surface, int coating, float **table,
                                  size_t *words, struct brdf_error *error)
{
    struct making *making = malloc(sizeof *making);
    float *made = calloc(BRDF_GLASS_WORDS, sizeof *made);
    if (!making || !made) {
        free(making);
        free(made);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                         "out of memory for what a rough interface does");
    }
    making->rule = facet_rule_make(NODES);
    making->surface = surface;
    making->coating = coating;
    making->table = made;
    head_make(making);
    side_prepare(making, 0);
    side_prepare(making, 1);
    rows_make(making);
    free(making);
    *table = made;
    *words = BRDF_GLASS_WORDS;
    return BRDF_OK;
}
