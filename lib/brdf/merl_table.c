/*
 * merl_table.c - build the table of the model `merl`: how sampling follows the data.
 *
 * For one direction wo, f(wo, wi) cos(theta_i) is split into a floor, a constant times the cosine,
 * and what rises above it. The floor is sampled by the cosine, exactly; the rest is integrated over
 * cells of the half vector h, where highlights hardly move as wo does. Wherever the density is the
 * blend of the two, f cos / pdf is the albedo, up to the variation inside a cell.
 */
#include "merl_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "brdf/model/merl.h"

enum {
    POINTS = 3, /* evaluations of a cell along each of its sides */
    CELLS = BRDF_MERL_THETA_H * BRDF_MERL_PHI_H,
    CELL_POINTS = POINTS * POINTS
};

/* The share of the cosine lobe never falls below this, so that the density is positive above. */
static const double cosine_least = 0.05;

/* The part of the cosine-weighted hemisphere where f is allowed to be below the floor. */
static const double floor_share = 0.2;

/* One row: f at points of each cell, averaged over the channels, and the weights of the points. */
struct row {
    double f[CELLS][CELL_POINTS];      /* 1/sr */
    double weight[CELLS][CELL_POINTS]; /* cos(theta_i) d(wi); sums up to pi */
};

/* Edges of the theta_h bins as (1 - cos) / 2, through the sine of the half: exact for small angles.
 */
static void edges_build(float *edges)
{
    for (int k = 0; k <= BRDF_MERL_THETA_H; ++k) {
        double root = (double)k / BRDF_MERL_THETA_H;
        double sine = sin(0.25 * pi * root * root);
        edges[k] = (float)(sine * sine);
    }
}

/* f at one point of the table's own cells, by the model itself. */
static void point_evaluate(const float *table, brdf_vec3 wo, double q, double phi, double solid,
                           double *f, double *weight)
{
    struct brdf_merl nearest = {.interpolation = BRDF_MERL_NEAREST, .fill = 1, .scale = 1.0f};
    double radius = 2.0 * sqrt(q * (1.0 - q));
    brdf_vec3 h = brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)),
                                 (float)(1.0 - 2.0 * q));
    brdf_vec3 wi = brdf_reflect(wo, h);
    *f = 0.0;
    *weight = 0.0;
    if (wi.z > 0.0f) {
        brdf_rgb rgb = brdf_merl_eval(nearest, wo, wi, table);
        *f = ((double)rgb.r + (double)rgb.g + (double)rgb.b) / 3.0;
        *weight = 4.0 * (double)brdf_dot(wo, h) * (double)wi.z * solid;
    }
}

static void row_evaluate(struct row *row, const float *table, double cosine)
{
    const float *edges = table + BRDF_MERL_EDGES;
    brdf_vec3 wo = brdf_vec3_make((float)sqrt(1.0 - cosine * cosine), 0.0f, (float)cosine);
    double step = pi / BRDF_MERL_PHI_H;
    for (int cell = 0; cell < CELLS; ++cell) {
        int k = cell / BRDF_MERL_PHI_H;
        double width = (double)edges[k + 1] - (double)edges[k];
        double solid = 4.0 * width * step / CELL_POINTS; /* both sides of wo */
        for (int i = 0; i < CELL_POINTS; ++i) {
            double q = (double)edges[k] + width * (i / POINTS + 0.5) / POINTS;
            double phi = step * (cell % BRDF_MERL_PHI_H + (i % POINTS + 0.5) / POINTS);
            point_evaluate(table, wo, q, phi, solid, &row->f[cell][i], &row->weight[cell][i]);
        }
    }
}

/* The weight of all points whose f is at most `level`. */
static double weight_below(const struct row *row, double level)
{
    double weight = 0.0;
    for (int cell = 0; cell < CELLS; ++cell) {
        for (int i = 0; i < CELL_POINTS; ++i) {
            weight += row->f[cell][i] <= level ? row->weight[cell][i] : 0.0;
        }
    }
    return weight;
}

/* A low quantile of f over the cosine-weighted hemisphere, by bisection: robust against noise. */
static double floor_find(const struct row *row)
{
    double low = 0.0;
    double high = 0.0;
    for (int cell = 0; cell < CELLS; ++cell) {
        for (int i = 0; i < CELL_POINTS; ++i) {
            high = row->f[cell][i] > high ? row->f[cell][i] : high;
        }
    }
    double wanted = floor_share * weight_below(row, high);
    for (int step = 0; step < 40; ++step) {
        double middle = 0.5 * (low + high);
        if (weight_below(row, middle) < wanted) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return high;
}

/* Cumulative chances of `count` cells, from 0 to exactly 1; equal chances where all are 0. */
static void cumulate(float *cdf, const double *mass, int count)
{
    double total = 0.0;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        total += mass[i];
    }
    for (int i = 0; i < count; ++i) {
        cdf[i] = (float)(total > 0.0 ? sum / total : (double)i / count);
        sum += mass[i];
    }
    cdf[count] = 1.0f;
}

/* What rises above the floor, integrated over cells and over rings of equal theta_h. */
struct masses {
    double cell[CELLS];
    double ring[BRDF_MERL_THETA_H];
    double above; /* all of it */
    double below; /* the floor's own integral */
};

static void masses_find(struct masses *masses, const struct row *row)
{
    double level = floor_find(row);
    memset(masses, 0, sizeof *masses);
    for (int cell = 0; cell < CELLS; ++cell) {
        for (int i = 0; i < CELL_POINTS; ++i) {
            double rise = row->f[cell][i] - level;
            masses->cell[cell] += rise > 0.0 ? rise * row->weight[cell][i] : 0.0;
            masses->below += level * row->weight[cell][i];
        }
        masses->ring[cell / BRDF_MERL_PHI_H] += masses->cell[cell];
        masses->above += masses->cell[cell];
    }
}

/* The tables of one row; the density is that of the rounded chances, which sampling uses. */
static void row_build(const struct masses *masses, float *table, int number)
{
    const float *edges = table + BRDF_MERL_EDGES;
    double all = masses->below + masses->above;
    double share = masses->above > 0.0 ? masses->below / all : 1.0;
    double cosine = share < cosine_least ? cosine_least : share;
    float *rings = table + BRDF_MERL_THETA_CDF + number * (BRDF_MERL_THETA_H + 1);
    table[BRDF_MERL_COSINE + number] = (float)cosine;
    cumulate(rings, masses->ring, BRDF_MERL_THETA_H);
    for (int k = 0; k < BRDF_MERL_THETA_H; ++k) {
        int line = number * BRDF_MERL_THETA_H + k;
        float *chances = table + BRDF_MERL_PHI_CDF + line * (BRDF_MERL_PHI_H + 1);
        float *density = table + BRDF_MERL_DENSITY + line * BRDF_MERL_PHI_H;
        double width = (double)edges[k + 1] - (double)edges[k];
        double solid = 4.0 * pi * width / BRDF_MERL_PHI_H; /* both sides of wo */
        double ring = (double)rings[k + 1] - (double)rings[k];
        cumulate(chances, masses->cell + k * BRDF_MERL_PHI_H, BRDF_MERL_PHI_H);
        for (int a = 0; a < BRDF_MERL_PHI_H; ++a) {
            double chance = ring * ((double)chances[a + 1] - (double)chances[a]);
            density[a] = (float)((1.0 - cosine) * chance / solid);
        }
    }
}

brdf_status brdf_merl_table_build(const struct brdf_merl_file *file, float **table, size_t *words,
                                  struct brdf_error *error)
{
    size_t count = BRDF_MERL_TABLE_WORDS;
    float *result = malloc(count * sizeof *result);
    struct row *row = malloc(sizeof *row);
    struct masses masses;
    if (!result || !row) {
        free(result);
        free(row);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for the %zu words of a MERL table",
                         count);
    }
    memcpy(result, file->rgb, file->bins * 3 * sizeof *result);
    edges_build(result + BRDF_MERL_EDGES);
    for (int number = 0; number < BRDF_MERL_ROWS; ++number) {
        /* At exactly grazing incidence there is nothing to tabulate: its row is taken close by. */
        double cosine = number > 0 ? number / (BRDF_MERL_ROWS - 1.0) : 0.2 / BRDF_MERL_ROWS;
        row_evaluate(row, result, cosine);
        masses_find(&masses, row);
        row_build(&masses, result, number);
    }
    free(row);
    *table = result;
    *words = count;
    return BRDF_OK;
}

brdf_status brdf_merl_table_load(const char *path, enum brdf_merl_invalid invalid, float **table,
                                 size_t *words, struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = brdf_merl_read(path, invalid, &file, error);
    if (status == BRDF_OK) {
        status = brdf_merl_table_build(&file, table, words, error);
        brdf_merl_free(&file);
    }
    return status;
}
