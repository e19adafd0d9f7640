/*
 * merl - a measured isotropic BRDF: the 90 x 90 x 180 table of a MERL `.binary` file.
 *
 * Reference: Matusik, Pfister, Brand, McMillan, "A Data-Driven Reflectance Model", 2003 (the data
 * and its spacing); Rusinkiewicz, "A New Change of Variables for Efficient BRDF Representation",
 * 1998 (the half and difference angles).
 * Sampling: half vectors drawn from a table made of the data itself, as proposed by Lawrence,
 * Rusinkiewicz, Ramamoorthi 2004 and by Dupuy et al. 2015, but kept whole instead of factored: for
 * each of 17 values of cos(theta_o) the part of f cos(theta_i) above a constant floor is tabulated
 * over the half vector, with its Jacobian; the floor itself is sampled by the cosine. The density
 * is the linear blend of the two nearest rows, so it is continuous in theta_o. Valid above the
 * surface for every direction; bins that the measurement lacks are filled when the file is read, or
 * 0 where `fill` is false. No energy is added or removed: data that reflects more than it receives,
 * does so. Deviation: the reference code looks up the bin that the angles fall into ("nearest");
 * "linear" blends the eight bins around, each bin's value belonging to its centre.
 */
#ifndef BRDF_MODEL_MERL_H
#define BRDF_MODEL_MERL_H

#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

/* Bins of the data: theta_h grows with the square of its bin, theta_d and phi_d linearly. */
#define BRDF_MERL_THETA_H 90
#define BRDF_MERL_THETA_D 90
#define BRDF_MERL_PHI_D 180

/* Cells of the sampling tables: rows of cos(theta_o), and azimuths of h from wo's, in [0, pi]. */
#define BRDF_MERL_ROWS 17
#define BRDF_MERL_PHI_H 16

/*
 * The table, in words, from its first: the data [theta_h][theta_d][phi_d][rgb] in 1/sr; the edges
 * of the theta_h bins as (1 - cos theta_h) / 2; then by row the chance of the cosine lobe, the
 * cumulative chances of theta_h, those of phi_h for each theta_h, and the density of h in 1/sr,
 * times the chance of not being the cosine lobe.
 */
#define BRDF_MERL_EDGES (BRDF_MERL_THETA_H * BRDF_MERL_THETA_D * BRDF_MERL_PHI_D * 3)
#define BRDF_MERL_COSINE (BRDF_MERL_EDGES + BRDF_MERL_THETA_H + 1)
#define BRDF_MERL_THETA_CDF (BRDF_MERL_COSINE + BRDF_MERL_ROWS)
#define BRDF_MERL_PHI_CDF (BRDF_MERL_THETA_CDF + BRDF_MERL_ROWS * (BRDF_MERL_THETA_H + 1))
#define BRDF_MERL_DENSITY                                                                          \
    (BRDF_MERL_PHI_CDF + BRDF_MERL_ROWS * BRDF_MERL_THETA_H * (BRDF_MERL_PHI_H + 1))
#define BRDF_MERL_TABLE_WORDS                                                                      \
    (BRDF_MERL_DENSITY + BRDF_MERL_ROWS * BRDF_MERL_THETA_H * BRDF_MERL_PHI_H)

enum brdf_merl_interpolation { BRDF_MERL_LINEAR, BRDF_MERL_NEAREST };

#define BRDF_MERL_PARAMETERS(P)                                                                    \
    P(CHOICE, interpolation, 0, 0, 1, "linear|nearest", "between the bins of the measurement")     \
    P(CHOICE, fill, 1, 0, 1, "false|true", "bins not measured: 0, or a value from neighbours")     \
    P(REAL, scale, 1.0f, 0.0f, 100.0f, "1", "factor on the measured values")                       \
    P(FILE, filename, 0, 0, 0, "path", "the measurement, a MERL .binary file")

struct brdf_merl {
    BRDF_MERL_PARAMETERS(BRDF_FIELD)
};

/* A pair of directions in bins: bin k holds [k, k + 1), its centre is k + 1/2. */
struct brdf_merl_place {
    brdf_real theta_h;
    brdf_real theta_d;
    brdf_real phi_d; /* folded into half a turn, which is what makes f reciprocal */
};

/* The bin coordinate of theta_h for a (not unit) half vector: 90 sqrt(theta_h / (pi / 2)). */
static inline brdf_real brdf_merl_theta_h(brdf_vec3 h)
{
    brdf_real theta = brdf_atan2(sqrtf(h.x * h.x + h.y * h.y), h.z);
    return (float)BRDF_MERL_THETA_H * sqrtf(brdf_max(theta, 0.0f) * (2.0f * BRDF_1_PI));
}

/*
 * Rusinkiewicz' angles without rotating anything: theta_d from the lengths of sum and difference,
 * phi_d from the components of the difference along the two tangents at h (times |flat| |sum|).
 * Exchanging wo and wi only negates the difference, and phi_d is folded by that very sign, so the
 * result has the same bits.
 */
static inline struct brdf_merl_place brdf_merl_find(brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_vec3 sum = brdf_add(wo, wi);
    brdf_vec3 difference = brdf_sub(wo, wi);
    brdf_real flat = sum.x * sum.x + sum.y * sum.y;
    brdf_real length = sqrtf(brdf_dot(sum, sum));
    brdf_real x = sum.z * (sum.x * difference.x + sum.y * difference.y) - flat * difference.z;
    brdf_real y = length * (sum.x * difference.y - sum.y * difference.x);
    brdf_mask fold = (y < 0.0f) | ((y == 0.0f) & (x < 0.0f));
    brdf_real phi = brdf_atan2(brdf_pick(fold, -y, y), brdf_pick(fold, -x, x));
    brdf_real theta = brdf_atan2(sqrtf(brdf_dot(difference, difference)), length);
    struct brdf_merl_place place;
    place.theta_h = brdf_merl_theta_h(sum);
    place.theta_d = theta * ((float)BRDF_MERL_THETA_D * 2.0f * BRDF_1_PI);
    place.phi_d = brdf_max(phi, 0.0f) * ((float)BRDF_MERL_PHI_D * BRDF_1_PI);
    return place;
}

/* The bin that holds a coordinate; both ends belong to the outermost bins. */
static inline brdf_int brdf_merl_bin(brdf_real place, int count)
{
    return brdf_to_int(brdf_clamp(place, 0.0f, (float)count - 0.5f));
}

static inline brdf_rgb brdf_merl_value(BRDF_GLOBAL const float *table, brdf_int bin)
{
    brdf_int word = 3 * bin;
    return brdf_rgb_make(brdf_gather(table, word), brdf_gather(table, word + 1),
                         brdf_gather(table, word + 2));
}

static inline brdf_rgb brdf_merl_nearest(struct brdf_merl_place place,
                                         BRDF_GLOBAL const float *table)
{
    brdf_int h = brdf_merl_bin(place.theta_h, BRDF_MERL_THETA_H);
    brdf_int d = brdf_merl_bin(place.theta_d, BRDF_MERL_THETA_D);
    brdf_int p = brdf_merl_bin(place.phi_d, BRDF_MERL_PHI_D);
    return brdf_merl_value(table, (h * BRDF_MERL_THETA_D + d) * BRDF_MERL_PHI_D + p);
}

static inline brdf_rgb brdf_merl_blend(brdf_rgb a, brdf_rgb b, brdf_real t)
{
    return brdf_rgb_add(brdf_rgb_scale(a, 1.0f - t), brdf_rgb_scale(b, t));
}

static inline brdf_rgb brdf_merl_linear(struct brdf_merl_place place,
                                        BRDF_GLOBAL const float *table)
{
    brdf_real h = brdf_clamp(place.theta_h - 0.5f, 0.0f, (float)BRDF_MERL_THETA_H - 1.0f);
    brdf_real d = brdf_clamp(place.theta_d - 0.5f, 0.0f, (float)BRDF_MERL_THETA_D - 1.0f);
    brdf_real p = place.phi_d - 0.5f;
    p = brdf_clamp(brdf_pick(p < 0.0f, p + (float)BRDF_MERL_PHI_D, p), 0.0f,
                   (float)BRDF_MERL_PHI_D);
    brdf_int h0 = brdf_merl_bin(h, BRDF_MERL_THETA_H - 1);
    brdf_int d0 = brdf_merl_bin(d, BRDF_MERL_THETA_D - 1);
    brdf_int p0 = brdf_merl_bin(p, BRDF_MERL_PHI_D);
    brdf_int p1 = brdf_pick_int(p0 == BRDF_MERL_PHI_D - 1, 0 * p0, p0 + 1);
    brdf_real th = h - brdf_to_real(h0);
    brdf_real td = d - brdf_to_real(d0);
    brdf_real tp = p - brdf_to_real(p0);
    brdf_rgb plane[2];
    for (int i = 0; i < 2; ++i) {
        brdf_int lower = ((h0 + i) * BRDF_MERL_THETA_D + d0) * BRDF_MERL_PHI_D;
        brdf_int upper = lower + BRDF_MERL_PHI_D;
        plane[i] = brdf_merl_blend(brdf_merl_blend(brdf_merl_value(table, lower + p0),
                                                   brdf_merl_value(table, lower + p1), tp),
                                   brdf_merl_blend(brdf_merl_value(table, upper + p0),
                                                   brdf_merl_value(table, upper + p1), tp),
                                   td);
    }
    return brdf_merl_blend(plane[0], plane[1], th);
}

static inline brdf_rgb brdf_merl_eval(struct brdf_merl p, brdf_vec3 wo, brdf_vec3 wi,
                                      BRDF_GLOBAL const float *table)
{
    struct brdf_merl_place place = brdf_merl_find(wo, wi);
    brdf_rgb f = p.interpolation == BRDF_MERL_NEAREST ? brdf_merl_nearest(place, table)
                                                      : brdf_merl_linear(place, table);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    return brdf_rgb_scale(f, brdf_pick(above, p.scale, 0.0f));
}

/* The two rows of the sampling tables around wo, and how they blend. */
struct brdf_merl_rows {
    brdf_int first;
    brdf_real blend;  /* of the second row */
    brdf_real cosine; /* chance of the cosine lobe in the blend */
    brdf_real split;  /* that, plus the chance of the first row */
};

static inline struct brdf_merl_rows brdf_merl_rows_of(brdf_vec3 wo, BRDF_GLOBAL const float *table)
{
    struct brdf_merl_rows rows;
    brdf_real row = brdf_clamp(wo.z, 0.0f, 1.0f) * ((float)BRDF_MERL_ROWS - 1.0f);
    rows.first = brdf_merl_bin(row, BRDF_MERL_ROWS - 1);
    rows.blend = row - brdf_to_real(rows.first);
    brdf_real first = brdf_gather(table + BRDF_MERL_COSINE, rows.first);
    brdf_real second = brdf_gather(table + BRDF_MERL_COSINE, rows.first + 1);
    rows.cosine = first * (1.0f - rows.blend) + second * rows.blend;
    rows.split = rows.cosine + (1.0f - rows.blend) * (1.0f - first);
    return rows;
}

/* wo's azimuth as a unit vector in the plane; +x along the normal, where it has none. */
static inline brdf_vec3 brdf_merl_azimuth(brdf_vec3 wo)
{
    return brdf_normalize(
        brdf_vec3_make(brdf_pick((wo.x == 0.0f) & (wo.y == 0.0f), 1.0f, wo.x), wo.y, 0.0f));
}

static inline brdf_real brdf_merl_pdf(struct brdf_merl p, brdf_vec3 wo, brdf_vec3 wi,
                                      BRDF_GLOBAL const float *table)
{
    (void)p;
    brdf_vec3 sum = brdf_add(wo, wi);
    brdf_vec3 azimuth = brdf_merl_azimuth(wo);
    brdf_real phi = brdf_atan2(fabsf(azimuth.x * sum.y - azimuth.y * sum.x),
                               azimuth.x * sum.x + azimuth.y * sum.y);
    brdf_int h = brdf_merl_bin(brdf_merl_theta_h(sum), BRDF_MERL_THETA_H);
    brdf_int a = brdf_merl_bin(phi * ((float)BRDF_MERL_PHI_H * BRDF_1_PI), BRDF_MERL_PHI_H);
    struct brdf_merl_rows rows = brdf_merl_rows_of(wo, table);
    brdf_int cell = (rows.first * BRDF_MERL_THETA_H + h) * BRDF_MERL_PHI_H + a;
    brdf_real first = brdf_gather(table + BRDF_MERL_DENSITY, cell);
    brdf_real second =
        brdf_gather(table + BRDF_MERL_DENSITY, cell + BRDF_MERL_THETA_H * BRDF_MERL_PHI_H);
    brdf_real density = first * (1.0f - rows.blend) + second * rows.blend;
    /* d(wi) = 4 (wo . h) d(h), and wo . h is half the length of wo + wi. */
    brdf_real jacobian = 2.0f * sqrtf(brdf_max(brdf_dot(sum, sum), 1e-12f));
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    return brdf_pick(above, rows.cosine * wi.z * BRDF_1_PI + density / jacobian, 0.0f);
}

/* Where u falls into a cumulative table of `count` cells: the cell, and the place inside it. */
struct brdf_merl_draw {
    brdf_int cell;
    brdf_real inside; /* in [0, 1] */
};

/* Binary search without branches; `highest` is the largest power of two below the count. */
static inline struct brdf_merl_draw brdf_merl_draw(BRDF_GLOBAL const float *cdf, brdf_int base,
                                                   int count, int highest, brdf_real u)
{
    struct brdf_merl_draw draw;
    draw.cell = 0 * base;
    for (int step = highest; step > 0; step /= 2) {
        brdf_int next = draw.cell + step;
        next = brdf_pick_int(next > count - 1, 0 * next + (count - 1), next);
        draw.cell = brdf_pick_int(brdf_gather(cdf, base + next) <= u, next, draw.cell);
    }
    brdf_real low = brdf_gather(cdf, base + draw.cell);
    brdf_real high = brdf_gather(cdf, base + draw.cell + 1);
    draw.inside = brdf_clamp((u - low) / brdf_max(high - low, 1e-30f), 0.0f, 1.0f);
    return draw;
}

/* A half vector from one row of the tables: theta_h by u, phi_h by v, uniform inside the cell. */
static inline brdf_vec3 brdf_merl_half(brdf_int row, brdf_real u, brdf_real v, brdf_vec3 azimuth,
                                       BRDF_GLOBAL const float *table)
{
    struct brdf_merl_draw h = brdf_merl_draw(
        table + BRDF_MERL_THETA_CDF, row * (BRDF_MERL_THETA_H + 1), BRDF_MERL_THETA_H, 64, u);
    brdf_mask left = v < 0.5f; /* the table holds one side of wo; the other is its mirror image */
    struct brdf_merl_draw a = brdf_merl_draw(
        table + BRDF_MERL_PHI_CDF, (row * BRDF_MERL_THETA_H + h.cell) * (BRDF_MERL_PHI_H + 1),
        BRDF_MERL_PHI_H, BRDF_MERL_PHI_H / 2, brdf_pick(left, 2.0f * v, 2.0f * v - 1.0f));
    brdf_real low = brdf_gather(table + BRDF_MERL_EDGES, h.cell);
    brdf_real high = brdf_gather(table + BRDF_MERL_EDGES, h.cell + 1);
    brdf_real q = low + (high - low) * h.inside; /* (1 - cos theta_h) / 2: uniform in solid angle */
    brdf_real radius = 2.0f * sqrtf(brdf_max(q * (1.0f - q), 0.0f));
    struct brdf_sincos turn =
        brdf_sincos_2pi((brdf_to_real(a.cell) + a.inside) * (0.5f / (float)BRDF_MERL_PHI_H));
    brdf_real side = brdf_pick(left, turn.sin, -turn.sin);
    return brdf_vec3_make(radius * (turn.cos * azimuth.x - side * azimuth.y),
                          radius * (turn.cos * azimuth.y + side * azimuth.x), 1.0f - 2.0f * q);
}

/* A direction drawn from the tables, without its density. */
static inline brdf_vec3 brdf_merl_direction(brdf_vec3 wo, brdf_vec3 u,
                                            BRDF_GLOBAL const float *table)
{
    struct brdf_merl_rows rows = brdf_merl_rows_of(wo, table);
    brdf_int row = brdf_pick_int(u.z < rows.split, rows.first, rows.first + 1);
    brdf_vec3 normal = brdf_merl_half(row, u.x, u.y, brdf_merl_azimuth(wo), table);
    return brdf_vec3_pick(u.z < rows.cosine, brdf_warp_cosine(u.x, u.y), brdf_reflect(wo, normal));
}

static inline struct brdf_sample brdf_merl_sample(struct brdf_merl p, brdf_vec3 wo, brdf_vec3 u,
                                                  BRDF_GLOBAL const float *table)
{
    brdf_vec3 wi = brdf_merl_direction(wo, u, table);
    brdf_real pdf = brdf_merl_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_merl_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(merl, MERL, BRDF_REFLECTION | BRDF_TABULATED | BRDF_RECIPROCAL,
           "a measured isotropic material, from a MERL .binary file", "Matusik et al. 2003")
#endif
