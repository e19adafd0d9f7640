/*
 * glass_curve.h - the table of a rough interface between dielectrics: what of light under a cosine
 * mu it lets through by one facet, T(mu), or loses, l(mu), and their means over diffuse light.
 *
 * Neither has a closed form, and total reflection begins with a kink that no fit follows: libbrdf
 * computes them for the indices of a material when it is made (glass_table.c).
 *
 * For each alpha there is a row; it holds means (integrals of 2 f(mu) mu dmu) and two curves f(mu).
 * Columns are the same in all rows, so that between rows a curve's mean goes as the curve does, and
 * what is lost and what comes back agree to rounding. Where light may be reflected totally, at
 * cosines below `critical`, a curve has a part below and a part above that cosine. Cells are small
 * at both ends of the part below, where roughness makes itself felt, and above it next to it: their
 * size goes as the distance from there, down to BRDF_GLASS_NEAR.
 */
#ifndef BRDF_GLASS_CURVE_H
#define BRDF_GLASS_CURVE_H

#include "lookup.h"
#include "math.h"

#define BRDF_GLASS_BELOW 111 /* columns of a curve up to the critical cosine */
#define BRDF_GLASS_ABOVE 95  /* and from it */
#define BRDF_GLASS_COLUMNS (BRDF_GLASS_BELOW + BRDF_GLASS_ABOVE)
#define BRDF_GLASS_MEANS 4 /* three of them in use */
#define BRDF_GLASS_PASS_ABOVE 0
#define BRDF_GLASS_LOSS_ABOVE 1
#define BRDF_GLASS_LOSS_BELOW 2
#define BRDF_GLASS_ROW (BRDF_GLASS_MEANS + 2 * BRDF_GLASS_COLUMNS)
#define BRDF_GLASS_ROWS 130

/* The head: words 0 and 1, then an axis for light from above and one for light from below. */
#define BRDF_GLASS_ETA 0  /* index below over that above */
#define BRDF_GLASS_PASS 1 /* 1 - mean Fresnel reflectance from above */
#define BRDF_GLASS_AXES 8
#define BRDF_GLASS_AXIS 8
#define BRDF_GLASS_HEAD (BRDF_GLASS_AXES + 2 * BRDF_GLASS_AXIS)
#define BRDF_GLASS_WORDS (BRDF_GLASS_HEAD + BRDF_GLASS_ROWS * BRDF_GLASS_ROW)

#define BRDF_GLASS_NEAR 3e-5f
#define BRDF_GLASS_EVEN_BELOW 0.2f /* the part of the columns that is evenly spread */
#define BRDF_GLASS_EVEN_ABOVE 0.3f

#define BRDF_GLASS_ALPHA_LOW 1e-4f
#define BRDF_GLASS_ALPHA_HIGH 2.0f

/* Where columns lie, for light from one side: brdf_glass_axis_make. */
struct brdf_glass_axis {
    brdf_real critical;    /* cosine below which a smooth interface reflects everything; may be 0 */
    brdf_real below_scale; /* columns per unit of the logarithm, and of the cosine */
    brdf_real below_even;
    brdf_real above_scale;
    brdf_real above_width; /* 1 / (1 - critical) */
};

/* The axis of a side; `eta` is the index of the far side over that of the near one. */
static inline struct brdf_glass_axis brdf_glass_axis_make(brdf_real eta)
{
    struct brdf_glass_axis axis;
    float near = BRDF_GLASS_NEAR;
    axis.critical = sqrtf(brdf_max((1.0f - eta) * (1.0f + eta), 0.0f));
    brdf_mask some = axis.critical > 0.0f;
    brdf_real width = brdf_pick(some, axis.critical, 1.0f);
    brdf_real below = (float)(BRDF_GLASS_BELOW - 1) / brdf_log(1.0f + width / near);
    brdf_real above = 1.0f - axis.critical;
    axis.below_scale = 0.5f * (1.0f - BRDF_GLASS_EVEN_BELOW) * below;
    axis.below_even = BRDF_GLASS_EVEN_BELOW * (float)(BRDF_GLASS_BELOW - 1) / width;
    axis.above_scale = (1.0f - BRDF_GLASS_EVEN_ABOVE) * (float)(BRDF_GLASS_ABOVE - 1) /
                       brdf_log(1.0f + above / near);
    axis.above_width = 1.0f / above;
    return axis;
}

/* The same from the table; which side is the same for all lanes. */
static inline struct brdf_glass_axis brdf_glass_axis_of(BRDF_GLOBAL const float *table, int below)
{
    BRDF_GLOBAL const float *words = table + BRDF_GLASS_AXES + below * BRDF_GLASS_AXIS;
    struct brdf_glass_axis axis;
    axis.critical = words[0];
    axis.below_scale = words[1];
    axis.below_even = words[2];
    axis.above_scale = words[3];
    axis.above_width = words[4];
    return axis;
}

static inline struct brdf_glass_axis
brdf_glass_axis_pick(brdf_mask mask, struct brdf_glass_axis yes, struct brdf_glass_axis no)
{
    struct brdf_glass_axis axis;
    axis.critical = brdf_pick(mask, yes.critical, no.critical);
    axis.below_scale = brdf_pick(mask, yes.below_scale, no.below_scale);
    axis.below_even = brdf_pick(mask, yes.below_even, no.below_even);
    axis.above_scale = brdf_pick(mask, yes.above_scale, no.above_scale);
    axis.above_width = brdf_pick(mask, yes.above_width, no.above_width);
    return axis;
}

/* The place of a cosine in a curve; 0 <= mu <= 1. */
static inline struct brdf_place brdf_glass_column(struct brdf_glass_axis axis, brdf_real mu)
{
    float near = BRDF_GLASS_NEAR;
    brdf_mask is_below = mu < axis.critical;
    brdf_real distance = fabsf(mu - axis.critical);
    brdf_real ratio =
        (brdf_pick(is_below, mu, distance) + near) / (brdf_pick(is_below, distance, 0.0f) + near);
    brdf_real log = brdf_log(ratio);
    brdf_real below = 0.5f * (1.0f - BRDF_GLASS_EVEN_BELOW) * (float)(BRDF_GLASS_BELOW - 1) +
                      axis.below_scale * log + axis.below_even * mu;
    brdf_real left = sqrtf(brdf_clamp((1.0f - mu) * axis.above_width, 0.0f, 1.0f));
    brdf_real above = axis.above_scale * log +
                      BRDF_GLASS_EVEN_ABOVE * (float)(BRDF_GLASS_ABOVE - 1) * (1.0f - left);
    struct brdf_place place = brdf_place_of(
        brdf_pick(is_below, below, above),
        brdf_pick(is_below, (float)(BRDF_GLASS_BELOW - 1), (float)(BRDF_GLASS_ABOVE - 1)));
    place.index += brdf_pick_int(is_below, 0, BRDF_GLASS_BELOW);
    return place;
}

/* The place of a roughness among the rows, counted in rows: even in ln alpha, nearly, but for a
 * part that is even in alpha. */
static inline struct brdf_place brdf_glass_row(brdf_real alpha)
{
    float low = 2.0f * BRDF_GLASS_ALPHA_LOW;
    /* 1 / ln((2 + 1e-4) / 2e-4) */
    brdf_real log = brdf_log((alpha + BRDF_GLASS_ALPHA_LOW) / low) * 0.1085730f;
    brdf_real x = 0.85f * log + 0.15f / BRDF_GLASS_ALPHA_HIGH * alpha;
    return brdf_place_of(x * (float)(BRDF_GLASS_ROWS - 1), (float)(BRDF_GLASS_ROWS - 1));
}

/* The first word of a row, and mean number `which` between it and the next row. */
static inline brdf_int brdf_glass_row_word(struct brdf_place row)
{
    return row.index * BRDF_GLASS_ROW + BRDF_GLASS_HEAD;
}

static inline brdf_real brdf_glass_mean(BRDF_GLOBAL const float *table, struct brdf_place row,
                                        int which)
{
    brdf_int word = brdf_glass_row_word(row) + which;
    return brdf_between(brdf_gather(table, word), brdf_gather(table, word + BRDF_GLASS_ROW),
                        row.rest);
}

/* A curve: `first` is its first word, in a row's. */
static inline brdf_real brdf_glass_curve(BRDF_GLOBAL const float *table, struct brdf_place row,
                                         brdf_int first, struct brdf_place column)
{
    brdf_int word = brdf_glass_row_word(row) + first + column.index;
    return brdf_lookup(table, word, BRDF_GLASS_ROW, row.rest, column.rest);
}

#endif
