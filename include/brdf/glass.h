/*
 * glass.h - the light that a rough interface between dielectrics loses on either side, by a table,
 * and how lobes that bring it back share it between reflection and transmission.
 *
 * Of light under the cosine mu, the part l(mu) neither is reflected nor passes by one facet; L is
 * the integral of 2 l(mu) mu dmu. Both have kinks where total reflection begins, which no fit
 * follows: libbrdf computes them for the material's indices when it is made (glass_table.c).
 *
 * The lobes are those of Kulla and Conty 2017. With p = (1 - mean Fresnel reflectance) of a side,
 * L' of the other side and s = min(L, L'), what is lost on a side comes back
 *   through the interface  f = p s l(wo) l(wi) / (pi L L')
 *   by reflection          f = (1 - p s / L) l(wo) l(wi) / (pi L)
 * together l(wo), and reciprocal (times 1 / eta^2 of radiance that passes), for p goes as the
 * square of the index.
 */
#ifndef BRDF_GLASS_H
#define BRDF_GLASS_H

#include "interface.h"

/*
 * The table, of two halves, for light from above and from below. Each has first L (1 + alpha^2) /
 * alpha^2, evenly in ln alpha, and then rows of l for each alpha, evenly in alpha / (1 + alpha),
 * over the root of x = mu sqrt((1 + a) / (mu^2 + a)), a = 4 alpha^2.
 */
#define BRDF_GLASS_MEANS 64
#define BRDF_GLASS_ALPHAS 24
#define BRDF_GLASS_COSINES 44
#define BRDF_GLASS_HALF (BRDF_GLASS_MEANS + BRDF_GLASS_ALPHAS * BRDF_GLASS_COSINES)
#define BRDF_GLASS_WORDS (2 * BRDF_GLASS_HALF)

#define BRDF_GLASS_ALPHA_LOW 1e-4f
#define BRDF_GLASS_ALPHA_HIGH 2.0f
#define BRDF_GLASS_LOG_LOW (-9.21034037f)
#define BRDF_GLASS_LOG_RANGE 9.90348755f /* ln 2 - ln 1e-4 */

/* Where a number in [0, 1] lies among `count` places: the one before it, and how far from that. */
struct brdf_glass_place {
    brdf_int index;
    brdf_real rest;
};

static inline struct brdf_glass_place brdf_glass_place_of(brdf_real x, int count)
{
    struct brdf_glass_place place;
    brdf_real scaled = brdf_clamp(x, 0.0f, 1.0f) * (float)(count - 1);
    brdf_real whole = brdf_min(floorf(scaled), (float)(count - 2));
    place.index = brdf_to_int(whole);
    place.rest = scaled - whole;
    return place;
}

/* The half of the table for a direction with this z. */
static inline brdf_int brdf_glass_half(brdf_mask above)
{
    return brdf_pick_int(above, 0, BRDF_GLASS_HALF);
}

static inline brdf_real brdf_glass_between(BRDF_GLOBAL const float *table, brdf_int first,
                                           struct brdf_glass_place place)
{
    brdf_real low = brdf_gather(table, first + place.index);
    brdf_real high = brdf_gather(table, first + place.index + 1);
    return low + (high - low) * place.rest;
}

/* L of one side, > 0. */
static inline brdf_real brdf_glass_mean(BRDF_GLOBAL const float *table, brdf_mask above,
                                        brdf_real alpha)
{
    brdf_real x = (brdf_log(alpha) - BRDF_GLASS_LOG_LOW) * (1.0f / BRDF_GLASS_LOG_RANGE);
    struct brdf_glass_place place = brdf_glass_place_of(x, BRDF_GLASS_MEANS);
    brdf_real scaled = brdf_glass_between(table, brdf_glass_half(above), place);
    brdf_real alpha2 = alpha * alpha;
    return brdf_max(scaled * alpha2 / (1.0f + alpha2), 1e-12f);
}

/* l of the side that is told, 0 <= mu <= 1. */
static inline brdf_real brdf_glass_loss(BRDF_GLOBAL const float *table, brdf_mask above,
                                        brdf_real alpha, brdf_real mu)
{
    brdf_real spread = 4.0f * alpha * alpha;
    brdf_real x = mu * sqrtf((1.0f + spread) / (mu * mu + spread));
    struct brdf_glass_place column = brdf_glass_place_of(sqrtf(x), BRDF_GLASS_COSINES);
    struct brdf_glass_place row =
        brdf_glass_place_of(1.5f * alpha / (1.0f + alpha), BRDF_GLASS_ALPHAS);
    brdf_int first = brdf_glass_half(above) + BRDF_GLASS_MEANS + row.index * BRDF_GLASS_COSINES;
    brdf_real low = brdf_glass_between(table, first, column);
    brdf_real high = brdf_glass_between(table, first + BRDF_GLASS_COSINES, column);
    return brdf_clamp(low + (high - low) * row.rest, 0.0f, 1.0f);
}

/* What an interface of this roughness does with what it has lost; eta is below over above. */
struct brdf_glass {
    brdf_real alpha;
    brdf_real mean_above; /* L of both sides */
    brdf_real mean_below;
    brdf_real pass; /* p s of the side above; below it is this over eta^2 */
    brdf_real eta;
};

static inline struct brdf_glass brdf_glass_make(BRDF_GLOBAL const float *table, brdf_real alpha,
                                                brdf_real eta)
{
    struct brdf_glass glass;
    glass.alpha = brdf_clamp(alpha, BRDF_GLASS_ALPHA_LOW, BRDF_GLASS_ALPHA_HIGH);
    glass.mean_above = brdf_glass_mean(table, brdf_mask_of(1), glass.alpha);
    glass.mean_below = brdf_glass_mean(table, brdf_mask_of(0), glass.alpha);
    glass.pass = brdf_interface_pass(eta) * brdf_min(glass.mean_above, glass.mean_below);
    glass.eta = eta;
    return glass;
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
