/*
 * coating.h - a rough dielectric interface over a diffuse base: what of a direction gets through
 * it, and what it throws back of diffuse light from within.
 *
 * With T(mu) and l(mu) what the interface lets through and loses of light from above by one facet,
 * T, L, L' the means of both and of the loss from below (glass_curve.h), of diffuse light from
 * within a part T / eta^2 gets out, for as much passes one way as the other, and L' is lost: the
 * interface throws back K = 1 - T / eta^2 - L'.
 *
 * With compensation, what is lost comes back as glass.h has it. The part q of it comes through, so
 * that T(mu) + q l(mu) passes; on the way out K = 1 - (T + q L) / eta^2, and nothing is lost.
 */
#ifndef BRDF_COATING_H
#define BRDF_COATING_H

#include "fresnel.h"
#include "glass_curve.h"

struct brdf_coating {
    struct brdf_place row;
    brdf_real mean_loss; /* L */
    brdf_real through;   /* q; 0 without compensation */
    brdf_real escape;    /* 1 - K */
    brdf_real eta2;      /* square of the index below over that above */
};

/* `compensates` is the same for all lanes. */
static inline struct brdf_coating brdf_coating_make(BRDF_GLOBAL const float *table, brdf_real alpha,
                                                    int compensates)
{
    struct brdf_coating coating;
    float eta = table[BRDF_GLASS_ETA];
    coating.row = brdf_glass_row(brdf_clamp(alpha, BRDF_GLASS_ALPHA_LOW, BRDF_GLASS_ALPHA_HIGH));
    coating.eta2 = eta * eta;
    brdf_real pass = brdf_glass_mean(table, coating.row, BRDF_GLASS_PASS_ABOVE);
    brdf_real below = brdf_glass_mean(table, coating.row, BRDF_GLASS_LOSS_BELOW);
    coating.mean_loss =
        brdf_max(brdf_glass_mean(table, coating.row, BRDF_GLASS_LOSS_ABOVE), 1e-12f);
    coating.through = 0.0f;
    coating.escape = pass / coating.eta2 + below;
    if (compensates) {
        brdf_real ratio = brdf_min(below / coating.mean_loss, 1.0f);
        coating.through = brdf_min(table[BRDF_GLASS_PASS] * ratio, 1.0f);
        coating.escape = (pass + coating.through * coating.mean_loss) / coating.eta2;
    }
    coating.escape = brdf_clamp(coating.escape, 1e-3f, 1.0f);
    return coating;
}

/* What one facet does with light from above under a cosine. */
struct brdf_coating_view {
    brdf_real pass; /* T */
    brdf_real loss; /* l; 0 without compensation, which alone asks for it */
};

static inline struct brdf_coating_view brdf_coating_view_of(BRDF_GLOBAL const float *table,
                                                            struct brdf_coating coating,
                                                            int compensates, brdf_real cosine)
{
    struct brdf_coating_view view;
    struct brdf_place column =
        brdf_glass_column(brdf_glass_axis_of(table, 0), brdf_clamp(cosine, 0.0f, 1.0f));
    brdf_int first = BRDF_GLASS_MEANS;
    view.pass = brdf_glass_curve(table, coating.row, first, column);
    view.loss = 0.0f;
    if (compensates) {
        view.loss = brdf_glass_curve(table, coating.row, first + BRDF_GLASS_COLUMNS, column);
    }
    return view;
}

/* All that gets through of light from this direction. */
static inline brdf_real brdf_coating_pass(struct brdf_coating coating,
                                          struct brdf_coating_view view)
{
    return view.pass + coating.through * view.loss;
}

/*
 * A guess of what passes by one facet, for sampling: what a smooth interface lets through under the
 * mean angle at which facets are met.
 */
static inline brdf_real brdf_coating_guess(brdf_real alpha, brdf_real eta, brdf_real cosine)
{
    brdf_real spread = 3.0f * alpha * alpha;
    brdf_real mean = sqrtf((cosine * cosine + spread) / (1.0f + spread));
    return 1.0f - brdf_fresnel_dielectric(brdf_min(mean, 1.0f), eta).reflectance;
}

#endif
