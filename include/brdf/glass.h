/*
 * glass.h - the lobes that bring back what a rough interface between dielectrics loses, to either
 * side, and how they share it between reflection and transmission.
 *
 * Of light under the cosine mu, the part l(mu) neither is reflected nor passes by one facet; L is
 * its mean over diffuse light (glass_curve.h, brushed_glass.h). The lobes are those of Kulla and
 * Conty 2017. With p = (1 - mean Fresnel reflectance) of a side, L' of the other side and
 * s = min(L, L'), what is lost on a side comes back
 *
 *   through the interface  f = p s l(wo) l(wi) / (pi L L')
 *
 *   by reflection          f = (1 - p s / L) l(wo) l(wi) / (pi L)
 *
 * together l(wo), and reciprocal (times 1 / eta^2 of radiance that passes), for p goes as the
 * square of the index.
 */
#ifndef BRDF_GLASS_H
#define BRDF_GLASS_H

#include "brushed_glass.h"
#include "glass_curve.h"

/* What an interface of this roughness does with what it has lost; eta is below over above. */
struct brdf_glass {
    struct brdf_place row;
    brdf_real spread;     /* with which energy.h samples the lobes */
    brdf_real mean_above; /* L of both sides */
    brdf_real mean_below;
    brdf_real pass; /* p s of the side above; below it is this over eta^2 */
    brdf_real eta;
};

static inline struct brdf_glass brdf_glass_make(BRDF_GLOBAL const float *table, brdf_real alpha,
                                                brdf_real eta)
{
    struct brdf_glass glass;
    brdf_real inside = brdf_clamp(alpha, BRDF_GLASS_ALPHA_LOW, BRDF_GLASS_ALPHA_HIGH);
    glass.row = brdf_glass_row(inside);
    glass.spread = 4.0f * inside * inside;
    /* Never 0: nothing may be divided by that. */
    glass.mean_above = brdf_max(brdf_glass_mean(table, glass.row, BRDF_GLASS_LOSS_ABOVE), 1e-12f);
    glass.mean_below = brdf_max(brdf_glass_mean(table, glass.row, BRDF_GLASS_LOSS_BELOW), 1e-12f);
    glass.pass = table[BRDF_GLASS_PASS] * brdf_min(glass.mean_above, glass.mean_below);
    glass.eta = eta;
    return glass;
}

/* The same by the tables of brushed_glass.h, which have no rows for alpha. */
static inline struct brdf_glass brdf_glass_brushed(BRDF_GLOBAL const float *table, brdf_real eta)
{
    struct brdf_glass glass;
    glass.row = brdf_place_of(0.0f, 1.0f);
    glass.spread = table[BRDF_BRUSHED_GLASS_SPREAD];
    glass.mean_above = table[BRDF_BRUSHED_GLASS_ABOVE];
    glass.mean_below = table[BRDF_BRUSHED_GLASS_BELOW];
    glass.pass = table[BRDF_BRUSHED_GLASS_PASS] * brdf_min(glass.mean_above, glass.mean_below);
    glass.eta = eta;
    return glass;
}

/* l of the side that is told, by the table of roughdielectric; 0 <= mu <= 1. */
static inline brdf_real brdf_glass_loss(BRDF_GLOBAL const float *table, struct brdf_glass glass,
                                        brdf_mask above, brdf_real mu)
{
    struct brdf_glass_axis axis =
        brdf_glass_axis_pick(above, brdf_glass_axis_of(table, 0), brdf_glass_axis_of(table, 1));
    brdf_int first = brdf_pick_int(above, BRDF_GLASS_MEANS, BRDF_GLASS_MEANS + BRDF_GLASS_COLUMNS);
    return brdf_glass_curve(table, glass.row, first, brdf_glass_column(axis, mu));
}

/* Of what is lost by light from this side: the part that comes back through the interface. */
static inline brdf_real brdf_glass_through(struct brdf_glass glass, brdf_mask above)
{
    brdf_real pass = brdf_pick(above, glass.pass, glass.pass / (glass.eta * glass.eta));
    return brdf_min(pass / brdf_pick(above, glass.mean_above, glass.mean_below), 1.0f);
}

/* Both lobes' f, from l of both directions. */
static inline brdf_real brdf_glass_lobe(struct brdf_glass glass, brdf_mask above_o,
                                        brdf_mask above_i, brdf_real loss_o, brdf_real loss_i)
{
    brdf_mask mirrors = (above_o & above_i) | (!above_o & !above_i);
    brdf_real both = loss_o * loss_i * BRDF_1_PI;
    brdf_real mean = brdf_pick(above_o, glass.mean_above, glass.mean_below);
    brdf_real back = both * (1.0f - brdf_glass_through(glass, above_o)) / mean;
    brdf_real radiance = brdf_pick(above_o, 1.0f / (glass.eta * glass.eta), 1.0f);
    brdf_real through = both * ((glass.pass / glass.mean_above) / glass.mean_below) * radiance;
    return brdf_pick(mirrors, back, through);
}

#endif
