/*
 * brushed_table.c - the table of a surface with two roughnesses: brushed.h says what is in it and
 * where. A quadrature for every word: less than a tenth of a second, of V-cavities two.
 */
#include "brushed_table.h"

#include <math.h>
#include <stdlib.h>

#include "angle.h"
#include "brdf/brushed.h"
#include "brdf/facets.h"
#include "lobe_spread.h"
#include "table_fill.h"

enum {
    NODES = 12,       /* of a piece of the quadrature */
    NODES_WALLS = 10, /* of V-cavities, who have more pieces */
    COLUMN_STEP = 2,  /* quadratures at so many columns; cubic polynomials fill the rest */
    ROWS = BRDF_BRUSHED_ROWS,
    COLUMNS = BRDF_BRUSHED_COLUMNS,
    PARTS = 8,      /* of a cell each way, for integrals over it */
    PARTS_LAST = 64 /* of the last column: of smooth surfaces nearly all directions are there */
};

/* A direction's azimuth: squares of its cosine and sine. */
struct azimuth {
    double cosine2;
    double sine2;
};

/* The azimuth of a row, by bisection, from the tangent that leaves small numbers exact. */
static struct azimuth azimuth_of(const struct facet_surface *surface, double row)
{
    double u2 = surface->alpha_u * surface->alpha_u, v2 = surface->alpha_v * surface->alpha_v;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        double sine2 = 0.5 * (low + high), cosine2 = 1.0 - sine2;
        int before = sine2 + v2 * sine2 / (u2 * cosine2 + v2 * sine2) < 2.0 * row;
        low = before ? sine2 : low;
        high = before ? high : sine2;
    }
    struct azimuth azimuth = {1.0 - low, high};
    return azimuth;
}

/* The square of the stretched cosine at a column, counted in columns, by bisection. */
static double stretched2_of(double column)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) { /* of the fourth root, so that small numbers are exact */
        double root = 0.5 * (low + high);
        int before = 0.5 * (root * root * root * root + root) * (COLUMNS - 1) < column;
        low = before ? root : low;
        high = before ? high : root;
    }
    return pow(low, 8.0);
}

/* The square of the cosine of a direction by that, for an azimuth. */
static double cosine2_of(const struct facet_surface *surface, struct azimuth azimuth,
                         double stretched2)
{
    double u2 = surface->alpha_u * surface->alpha_u, v2 = surface->alpha_v * surface->alpha_v;
    double spread = 4.0 * (u2 * azimuth.cosine2 + v2 * azimuth.sine2);
    return stretched2 * spread / ((1.0 - stretched2) + stretched2 * spread);
}

/* Words, and the squares of the cosines that they are for. */
static void words_make(const struct facet_surface *surface, float *words, double *cosine2)
{
    double stretched2[COLUMNS];
    int walls = surface->masking == BRDF_MASKING_VCAVITY;
    struct facet_rule rule = facet_rule_make(walls ? NODES_WALLS : NODES);
    for (int k = 0; k < COLUMNS; ++k) {
        stretched2[k] = stretched2_of(k);
    }
    for (int i = 0; i < ROWS * COLUMNS; ++i) {
        struct azimuth azimuth = azimuth_of(surface, (double)(i / COLUMNS) / (ROWS - 1));
        cosine2[i] = cosine2_of(surface, azimuth, stretched2[i % COLUMNS]);
        if (i % COLUMNS % COLUMN_STEP) {
            continue;
        }
        /* Not quite 0, where there is nothing to be seen. */
        struct facet_light light = {fmax(sqrt(cosine2[i]), 1e-6), sqrt(azimuth.cosine2),
                                    sqrt(azimuth.sine2)};
        struct facet_shares shares = facet_shares_of(surface, &rule, light);
        words[i] = (float)fmin(fmax(1.0 - shares.reflected - shares.passed, 0.0), 1.0);
    }
    for (int i = 0; i < ROWS; ++i) {
        brdf_table_fill(words + i * COLUMNS, COLUMNS, 0, COLUMNS - 1, 1, COLUMN_STEP);
    }
}

/* The table as it is read, `row` and `column` counted in rows and columns. */
static double read_at(const float *words, double row, double column)
{
    int i = (int)fmin(row, ROWS - 2), k = (int)fmin(column, COLUMNS - 2);
    const float *low = words + i * COLUMNS + k, *high = low + COLUMNS;
    double rest = column - k;
    double first = (double)low[0] + (double)(low[1] - low[0]) * rest;
    double second = (double)high[0] + (double)(high[1] - high[0]) * rest;
    return first + (second - first) * (row - i);
}

static double angle_of(struct azimuth azimuth)
{
    return atan2(sqrt(azimuth.sine2), sqrt(azimuth.cosine2));
}

/* Parts of a row's cells: the middle of each, in columns, and the square of the stretched cosine at
   its end. */
enum { ROW_PARTS = (COLUMNS - 2) * PARTS + PARTS_LAST };

struct parts {
    double middle[ROW_PARTS];
    double stretched2[ROW_PARTS];
};

static void parts_make(struct parts *parts)
{
    for (int k = 0; k < ROW_PARTS; ++k) {
        int part = k - (COLUMNS - 2) * PARTS;
        parts->middle[k] = (k + 0.5) / PARTS;
        parts->stretched2[k] = stretched2_of((k + 1.0) / PARTS);
        if (part >= 0) { /* dense at its end, by powers of two and more */
            parts->middle[k] = COLUMNS - 1 - pow(1.0 - (part + 0.5) / PARTS_LAST, 8.0);
            parts->stretched2[k] =
                stretched2_of(COLUMNS - 1 - pow(1.0 - (part + 1.0) / PARTS_LAST, 8.0));
        }
    }
    parts->stretched2[ROW_PARTS - 1] = 1.0;
}

/* The integral of 2 l(mu) mu dmu over a row. */
static double row_average(const struct facet_surface *surface, const float *words,
                          const struct parts *parts, double row)
{
    struct azimuth azimuth = azimuth_of(surface, row / (ROWS - 1));
    double sum = 0.0, before = 0.0;
    for (int k = 0; k < ROW_PARTS; ++k) {
        double cosine2 = cosine2_of(surface, azimuth, parts->stretched2[k]);
        sum += read_at(words, row, parts->middle[k]) * (cosine2 - before);
        before = cosine2;
    }
    return sum;
}

/* Its mean over diffuse light: over a quarter turn. */
static double average(const struct facet_surface *surface, const float *words)
{
    double sum = 0.0, before = 0.0;
    struct parts parts;
    parts_make(&parts);
    for (int i = 0; i < (ROWS - 1) * PARTS; ++i) {
        double end = angle_of(azimuth_of(surface, (double)(i + 1) / ((ROWS - 1) * PARTS)));
        sum += row_average(surface, words, &parts, (i + 0.5) / PARTS) * (end - before);
        before = end;
    }
    return sum / (0.5 * pi);
}

brdf_status brdf_brushed_table_make(const struct facet_surface *surface, float **table,
                                    size_t *words, struct brdf_error *error)
{
    float *made = calloc(BRDF_BRUSHED_WORDS, sizeof *made);
    if (!made) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                         "out of memory for what a brushed surface does");
    }
    float *losses = made + BRDF_BRUSHED_HEAD;
    double cosine2[ROWS * COLUMNS];
    words_make(surface, losses, cosine2);
    made[BRDF_BRUSHED_LOSS] = (float)average(surface, losses);
    made[BRDF_BRUSHED_SPREAD] = (float)brdf_lobe_spread(surface, losses, cosine2, ROWS * COLUMNS);
    *table = made;
    *words = BRDF_BRUSHED_WORDS;
    return BRDF_OK;
}
