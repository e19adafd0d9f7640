/*
 * brushed_glass.h - what a rough interface between dielectrics loses that is rougher along one
 * tangent than along the other: tables for light from above and from below, which libbrdf computes
 * for the indices and the two roughnesses of a material (brushed_glass_table.c), and where a
 * direction lies in them.
 *
 * Let x be a direction's part along the smoother tangent. The smoother that is, the more a facet
 * turns light about it and leaves x alone: where the rest, sqrt(1 - x^2), is below the critical
 * cosine, all facets reflect totally, and the loss has a kink there. Between, it has one about
 * where the cosine itself is critical. Rows go by x, columns by the cosine; both kinks are halfway
 * down their axis, where there is one. On each side of it places go by the cosine and, half each,
 * by what it is where both roughnesses are 1, as in brushed.h.
 */
#ifndef BRDF_BRUSHED_GLASS_H
#define BRDF_BRUSHED_GLASS_H

#include "brushed.h"

#define BRDF_BRUSHED_GLASS_ABOVE 0    /* mean loss over diffuse light from above */
#define BRDF_BRUSHED_GLASS_BELOW 1    /* and from below */
#define BRDF_BRUSHED_GLASS_PASS 2     /* 1 - mean Fresnel reflectance from above */
#define BRDF_BRUSHED_GLASS_SPREAD 3   /* as in brushed.h */
#define BRDF_BRUSHED_GLASS_CRITICAL 4 /* cosines, from above and from below; 0 if there is none */
#define BRDF_BRUSHED_GLASS_HEAD 8
#define BRDF_BRUSHED_GLASS_ROWS 129
#define BRDF_BRUSHED_GLASS_COLUMNS 97
#define BRDF_BRUSHED_GLASS_SIDE (BRDF_BRUSHED_GLASS_ROWS * BRDF_BRUSHED_GLASS_COLUMNS)
#define BRDF_BRUSHED_GLASS_WORDS (BRDF_BRUSHED_GLASS_HEAD + 2 * BRDF_BRUSHED_GLASS_SIDE)

/* A direction: its parts along the tangents, where the roughness is less and more, squared, and
   what is left beside the former. */
struct brdf_brushed_glass {
    brdf_real smooth2;
    brdf_real alpha_smooth2; /* squares of roughness, times 4: doubled as in brushed.h */
    brdf_real alpha_rough2;
    brdf_real rest;
    brdf_real cosine;
    brdf_real critical;
};

static inline struct brdf_brushed_glass
brdf_brushed_glass_make(brdf_real alpha_u, brdf_real alpha_v, brdf_real critical, brdf_vec3 w)
{
    struct brdf_brushed_glass glass;
    brdf_mask along_u = alpha_v > alpha_u;
    brdf_real u = w.x * w.x;
    brdf_real v = w.y * w.y;
    brdf_real smooth = brdf_min(alpha_u, alpha_v);
    brdf_real rough = brdf_max(alpha_u, alpha_v);
    glass.smooth2 = brdf_pick(along_u, u, v);
    glass.alpha_smooth2 = 4.0f * (smooth * smooth);
    glass.alpha_rough2 = 4.0f * (rough * rough);
    glass.rest = brdf_min(sqrtf(brdf_pick(along_u, v, u) + w.z * w.z), 1.0f);
    glass.cosine = brdf_min(fabsf(w.z), glass.rest);
    glass.critical = critical;
    return glass;
}

/* By the cosine of a direction with the same x, where both roughnesses are 1: small ones spread. */
static inline brdf_real brdf_brushed_glass_stretched(struct brdf_brushed_glass glass,
                                                     brdf_real smooth2, brdf_real rough2,
                                                     brdf_real cosine)
{
    brdf_real more = glass.alpha_smooth2 * smooth2 + glass.alpha_rough2 * rough2;
    return brdf_brushed_spread(cosine / sqrtf(brdf_max(cosine * cosine + more, 1e-30f)));
}

/* The mean of how far it is from `low` to `high`, and of `even`. */
static inline brdf_real brdf_brushed_glass_part(brdf_real x, brdf_real low, brdf_real high,
                                                brdf_real even)
{
    brdf_real width = high - low;
    brdf_mask wide = width > 1e-6f;
    brdf_real part = (x - low) / brdf_pick(wide, width, 1.0f);
    return 0.5f * (brdf_pick(wide, part, even) + even);
}

/* Both sides of a kink, which is at half if there is one. */
static inline brdf_real brdf_brushed_glass_halves(brdf_real critical, brdf_mask is_below,
                                                  brdf_real below, brdf_real above)
{
    brdf_real first = brdf_pick(critical > 0.0f, 0.5f, 0.0f);
    return brdf_pick(is_below, 0.5f * below, first + (1.0f - first) * above);
}

static inline struct brdf_place brdf_brushed_glass_row(struct brdf_brushed_glass glass)
{
    float last = (float)(BRDF_BRUSHED_GLASS_ROWS - 1);
    brdf_real critical = glass.critical;
    brdf_mask is_below = glass.rest < critical;
    brdf_real place = brdf_brushed_glass_stretched(glass, glass.smooth2, 0.0f, glass.rest);
    brdf_real kink = brdf_brushed_glass_stretched(glass, brdf_max(1.0f - critical * critical, 0.0f),
                                                  0.0f, critical);
    brdf_real left = brdf_max(1.0f - glass.rest / brdf_max(critical, 1e-6f), 0.0f);
    brdf_real below = brdf_brushed_glass_part(place, 0.0f, kink, 1.0f - brdf_brushed_spread(left));
    brdf_real beyond = brdf_max(glass.rest - critical, 0.0f) / (1.0f - critical);
    brdf_real above = brdf_brushed_glass_part(place, kink, 1.0f, brdf_brushed_spread(beyond));
    return brdf_place_of(last * brdf_brushed_glass_halves(critical, is_below, below, above), last);
}

static inline struct brdf_place brdf_brushed_glass_column(struct brdf_brushed_glass glass)
{
    float last = (float)(BRDF_BRUSHED_GLASS_COLUMNS - 1);
    brdf_real rest2 = glass.rest * glass.rest;
    brdf_real cosine = glass.cosine;
    brdf_real critical = brdf_min(glass.critical, glass.rest);
    brdf_mask is_below = (cosine <= critical) & (glass.critical > 0.0f);
    brdf_real place = brdf_brushed_glass_stretched(glass, glass.smooth2,
                                                   brdf_max(rest2 - cosine * cosine, 0.0f), cosine);
    brdf_real kink = brdf_brushed_glass_stretched(
        glass, glass.smooth2, brdf_max(rest2 - critical * critical, 0.0f), critical);
    brdf_real most = brdf_brushed_glass_stretched(glass, glass.smooth2, 0.0f, glass.rest);
    brdf_real left = brdf_max(1.0f - cosine / brdf_max(critical, 1e-9f), 0.0f);
    brdf_real below = brdf_brushed_glass_part(place, 0.0f, kink, 1.0f - brdf_brushed_spread(left));
    brdf_real beyond = brdf_max(cosine - critical, 0.0f) / brdf_max(glass.rest - critical, 1e-9f);
    brdf_real above =
        brdf_brushed_glass_part(place, kink, most, brdf_brushed_spread(brdf_min(beyond, 1.0f)));
    return brdf_place_of(last * brdf_brushed_glass_halves(glass.critical, is_below, below, above),
                         last);
}

/* l for light from w, on the side that is told. */
static inline brdf_real brdf_brushed_glass_loss(BRDF_GLOBAL const float *table, brdf_real alpha_u,
                                                brdf_real alpha_v, brdf_mask above, brdf_vec3 w)
{
    brdf_real critical = brdf_pick(above, table[BRDF_BRUSHED_GLASS_CRITICAL],
                                   table[BRDF_BRUSHED_GLASS_CRITICAL + 1]);
    struct brdf_brushed_glass glass = brdf_brushed_glass_make(alpha_u, alpha_v, critical, w);
    struct brdf_place row = brdf_brushed_glass_row(glass);
    struct brdf_place column = brdf_brushed_glass_column(glass);
    brdf_int word = row.index * BRDF_BRUSHED_GLASS_COLUMNS + column.index + BRDF_BRUSHED_GLASS_HEAD;
    word += brdf_pick_int(above, 0, BRDF_BRUSHED_GLASS_SIDE);
    return brdf_lookup(table, word, BRDF_BRUSHED_GLASS_COLUMNS, row.rest, column.rest);
}

#endif
