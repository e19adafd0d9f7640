/*
 * brushed_glass_table.c - the tables of an interface with two roughnesses: brushed_glass.h says
 * what is in them and where.
 *
 * Quadratures at half of the rows, or a quarter, and half of the columns; cubic polynomials through
 * four of them fill the rest, on each side of the kinks. A quarter to half a second.
 */
#include <math.h>
#include <stdlib.h>

#include "angle.h"
#include "brdf/brushed_glass.h"
#include "brdf/interface.h"
#include "brushed_table.h"
#include "lobe_spread.h"
#include "table_fill.h"

enum {
    NODES = 10,      /* of a piece of the quadrature */
    STEP = 2,        /* of rows and columns with quadratures */
    STEP_SMOOTH = 4, /* of rows on the side without kinks */
    ROWS = BRDF_BRUSHED_GLASS_ROWS,
    COLUMNS = BRDF_BRUSHED_GLASS_COLUMNS,
    ROW_HALF = (ROWS - 1) / 2, /* where there is a kink */
    COLUMN_HALF = (COLUMNS - 1) / 2,
    LINES = 300 /* of integrals over all directions, each way */
};

/* One side in the making. */
struct making {
    struct facet_rule rule;
    struct facet_surface surface; /* as seen from that side */
    float alpha_u, alpha_v;       /* the smoother tangent's first */
    float critical;
    int row_step;
    const float *table;
    float *losses;
    double *cosine2;
};

/* The direction in the plane of the smoother tangent that has so much beside it. */
static brdf_vec3 flat_direction(double rest)
{
    return brdf_vec3_make((float)sqrt(fmax(1.0 - rest * rest, 0.0)), 0.0f, (float)rest);
}

/* One with the same part along that tangent. */
static brdf_vec3 direction(double rest, double cosine)
{
    return brdf_vec3_make((float)sqrt(fmax(1.0 - rest * rest, 0.0)),
                          (float)sqrt(fmax(rest * rest - cosine * cosine, 0.0)), (float)cosine);
}

static double place_of(const struct making *making, brdf_vec3 w, int column)
{
    struct brdf_brushed_glass glass =
        brdf_brushed_glass_make(making->alpha_u, making->alpha_v, making->critical, w);
    struct brdf_place place =
        column ? brdf_brushed_glass_column(glass) : brdf_brushed_glass_row(glass);
    return (double)place.index + (double)place.rest;
}

/* What a row has beside the smoother tangent, by bisection. */
static double rest_of(const struct making *making, int row)
{
    double low = 0.0, high = 1.0;
    if (row == 0 || row == ROWS - 1) {
        return row == 0 ? 0.0 : 1.0;
    }
    for (int i = 0; i < 50; ++i) {
        double middle = 0.5 * (low + high);
        int before = place_of(making, flat_direction(middle), 0) < row;
        low = before ? middle : low;
        high = before ? high : middle;
    }
    return 0.5 * (low + high);
}

/* The cosine at a column of it. */
static double cosine_of(const struct making *making, double rest, int column)
{
    double low = 0.0, high = rest;
    if (column == 0 || column == COLUMNS - 1) {
        return column == 0 ? 0.0 : rest;
    }
    for (int i = 0; i < 50; ++i) {
        double middle = 0.5 * (low + high);
        int before = place_of(making, direction(rest, middle), 1) < column;
        low = before ? middle : low;
        high = before ? high : middle;
    }
    return 0.5 * (low + high);
}

static float loss_of(const struct making *making, brdf_vec3 w)
{
    double x = (double)w.x, y = (double)w.y, sine = sqrt(x * x + y * y);
    /* Not quite 0, where there is nothing to be seen. */
    struct facet_light light = {fmin(fmax((double)w.z, 1e-6), 1.0), 1.0, 0.0};
    if (sine > 0.0) {
        light.along_u = x / sine;
        light.along_v = y / sine;
    }
    struct facet_shares shares = facet_shares_of(&making->surface, &making->rule, light);
    return (float)fmin(fmax(1.0 - shares.reflected - shares.passed, 0.0), 1.0);
}

/* Where all facets reflect totally no cosine is critical: columns end halfway. */
static void row_make(const struct making *making, int row)
{
    double rest = rest_of(making, row);
    int last = making->critical > 0.0f && row <= ROW_HALF ? COLUMN_HALF : COLUMNS - 1;
    float *losses = making->losses + row * COLUMNS;
    for (int i = 0; i < COLUMNS; ++i) {
        double cosine = i < last ? cosine_of(making, rest, i) : rest;
        making->cosine2[row * COLUMNS + i] = cosine * cosine;
        if (i <= last && i % STEP == 0) {
            losses[i] = loss_of(making, direction(rest, cosine));
        } else {
            losses[i] = i > last ? losses[last] : 0.0f;
        }
    }
    brdf_table_fill(losses, COLUMN_HALF + 1, 0, COLUMN_HALF, 1, STEP);
    if (last > COLUMN_HALF) {
        brdf_table_fill(losses + COLUMN_HALF, COLUMN_HALF + 1, 0, COLUMN_HALF, 1, STEP);
    }
}

static void losses_make(const struct making *making)
{
    for (int row = 0; row < ROWS; row += making->row_step) {
        row_make(making, row);
    }
    for (int i = 0; i < COLUMNS; ++i) {
        float *losses = making->losses + i;
        brdf_table_fill(losses, ROW_HALF + 1, 0, ROW_HALF, COLUMNS, making->row_step);
        brdf_table_fill(losses + ROW_HALF * COLUMNS, ROW_HALF + 1, 0, ROW_HALF, COLUMNS,
                        making->row_step);
    }
}

/* What a side loses of diffuse light, by the table as it is read: over a quarter of the disk that
   directions project to. Lines are dense where x is all of a direction, and on them where light
   grazes. */
static double average(const struct making *making, int below)
{
    double sum = 0.0, before_x = 1.0;
    for (int i = 0; i < LINES; ++i) {
        double rest = pow((i + 0.5) / LINES, 3.0), end = pow((i + 1.0) / LINES, 3.0);
        double x = sqrt(fmax(1.0 - end * end, 0.0));
        double lost = 0.0, before_y = 1.0;
        for (int k = 0; k < LINES; ++k) {
            double part = pow((k + 0.5) / LINES, 3.0), part_end = pow((k + 1.0) / LINES, 3.0);
            double y = sqrt(fmax(1.0 - part_end * part_end, 0.0));
            brdf_vec3 w = direction(rest, rest * part);
            lost += (before_y - y) * (double)brdf_brushed_glass_loss(making->table, making->alpha_u,
                                                                     making->alpha_v, !below, w);
            before_y = y;
        }
        sum += lost * rest * (before_x - x);
        before_x = x;
    }
    return sum * 4.0 / pi;
}

static void side_make(struct making *making, const struct facet_surface *surface, int below,
                      float *table)
{
    float eta = (float)(below ? 1.0 / surface->eta : surface->eta);
    making->surface = *surface;
    making->surface.alpha_u = fmin(surface->alpha_u, surface->alpha_v);
    making->surface.alpha_v = fmax(surface->alpha_u, surface->alpha_v);
    making->surface.eta = (double)eta;
    making->alpha_u = (float)making->surface.alpha_u;
    making->alpha_v = (float)making->surface.alpha_v;
    making->critical = sqrtf(brdf_max((1.0f - eta) * (1.0f + eta), 0.0f));
    making->row_step = making->critical > 0.0f ? STEP : STEP_SMOOTH;
    making->table = table;
    making->losses = table + BRDF_BRUSHED_GLASS_HEAD + below * BRDF_BRUSHED_GLASS_SIDE;
    table[BRDF_BRUSHED_GLASS_CRITICAL + below] = making->critical;
    losses_make(making);
    /* Never 0: nothing may be divided by that. */
    table[BRDF_BRUSHED_GLASS_ABOVE + below] = (float)fmax(average(making, below), 1e-12);
}

brdf_status brdf_brushed_glass_table_make(const struct facet_surface *surface, float **table,
                                          size_t *words, struct brdf_error *error)
{
    struct making making;
    float *made = calloc(BRDF_BRUSHED_GLASS_WORDS, sizeof *made);
    making.cosine2 = calloc(BRDF_BRUSHED_GLASS_SIDE, sizeof *making.cosine2);
    if (!made || !making.cosine2) {
        free(made);
        free(making.cosine2);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                         "out of memory for what a brushed interface does");
    }
    making.rule = facet_rule_make(NODES);
    made[BRDF_BRUSHED_GLASS_PASS] = brdf_interface_pass((float)surface->eta);
    for (int below = 0; below < 2; ++below) {
        side_make(&making, surface, below, made);
        double spread =
            brdf_lobe_spread(surface, making.losses, making.cosine2, BRDF_BRUSHED_GLASS_SIDE);
        made[BRDF_BRUSHED_GLASS_SPREAD] = brdf_max(made[BRDF_BRUSHED_GLASS_SPREAD], (float)spread);
    }
    free(making.cosine2);
    *table = made;
    *words = BRDF_BRUSHED_GLASS_WORDS;
    return BRDF_OK;
}
