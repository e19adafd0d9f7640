/*
 * brushed.h - what mirrors lose that are rougher along one tangent than along the other: a table
 * over azimuth and cosine, which libbrdf computes for the two roughnesses of a material
 * (brushed_table.c), and where a direction lies in it.
 *
 * Masking depends on the direction as it is where both roughnesses are 1, and above the horizon
 * most of the loss does: columns go by the cosine that it has there (but that roughness is doubled,
 * which spreads what is near the normal). Rows go by the azimuth as it is and as it is there, half
 * each: however much rougher one tangent is, both have room. The loss is even about either tangent
 * and grazing light loses as c ln c does: with the squares of sines and, of the cosine and
 * its fourth root, the mean, it is nearly straight between words.
 */
#ifndef BRDF_BRUSHED_H
#define BRDF_BRUSHED_H

#include "lookup.h"

#define BRDF_BRUSHED_LOSS 0   /* mean over diffuse light */
#define BRDF_BRUSHED_SPREAD 1 /* `spread` of energy.h with which the lobe is sampled best */
#define BRDF_BRUSHED_HEAD 4   /* words before the first row */
#define BRDF_BRUSHED_ROWS 33
#define BRDF_BRUSHED_COLUMNS 65
#define BRDF_BRUSHED_WORDS (BRDF_BRUSHED_HEAD + BRDF_BRUSHED_ROWS * BRDF_BRUSHED_COLUMNS)

/* A direction above the surface. */
struct brdf_brushed {
    brdf_real cosine;
    brdf_real stretched; /* squares of its parts along both tangents, times those of roughness */
    brdf_real row;       /* in [0, 1] */
};

static inline struct brdf_brushed brdf_brushed_make(brdf_real alpha_u, brdf_real alpha_v,
                                                    brdf_vec3 w)
{
    struct brdf_brushed brushed;
    brdf_real x = w.x * w.x;
    brdf_real y = w.y * w.y;
    brdf_real u = (alpha_u * alpha_u) * x;
    brdf_real v = (alpha_v * alpha_v) * y;
    brushed.cosine = brdf_clamp(w.z, 0.0f, 1.0f);
    brushed.stretched = u + v;
    brushed.row = 0.5f * (y / brdf_max(x + y, 1e-20f) + v / brdf_max(u + v, 1e-30f));
    return brushed;
}

/* Of a cosine from 0 to 1: the mean with its fourth root. */
static inline brdf_real brdf_brushed_spread(brdf_real cosine)
{
    return 0.5f * (cosine + sqrtf(sqrtf(cosine)));
}

static inline struct brdf_place brdf_brushed_row(struct brdf_brushed brushed)
{
    float last = (float)(BRDF_BRUSHED_ROWS - 1);
    return brdf_place_of(last * brushed.row, last);
}

static inline struct brdf_place brdf_brushed_column(struct brdf_brushed brushed)
{
    float last = (float)(BRDF_BRUSHED_COLUMNS - 1);
    brdf_real length2 = brushed.cosine * brushed.cosine + 4.0f * brushed.stretched;
    brdf_real cosine = brushed.cosine / sqrtf(brdf_max(length2, 1e-30f));
    return brdf_place_of(last * brdf_brushed_spread(brdf_min(cosine, 1.0f)), last);
}

/* l for light from w; that of grazing light if w is below. */
static inline brdf_real brdf_brushed_loss(BRDF_GLOBAL const float *table, brdf_real alpha_u,
                                          brdf_real alpha_v, brdf_vec3 w)
{
    struct brdf_brushed brushed = brdf_brushed_make(alpha_u, alpha_v, w);
    struct brdf_place row = brdf_brushed_row(brushed);
    struct brdf_place column = brdf_brushed_column(brushed);
    brdf_int word = row.index * BRDF_BRUSHED_COLUMNS + column.index + BRDF_BRUSHED_HEAD;
    return brdf_lookup(table, word, BRDF_BRUSHED_COLUMNS, row.rest, column.rest);
}

#endif
