/*
 * energy.h - the light that a microfacet model loses, and a lobe that brings it back.
 *
 * Models that follow light to one facet lose what would meet more of them. Of light under a cosine
 * mu a surface of perfect mirrors loses l(mu); the lobe
 *   f(wo, wi) = l(wo) l(wi) / (pi L)        L = integral of 2 l(mu) mu dmu
 * is reciprocal and reflects l(wo) [Kulla and Conty 2017, after Kelemen and Szirmay-Kalos 2001].
 *
 * l is a fit to quadratures of the same model, made by tools/fit_energy.py: with a = 4 alpha^2 and
 * x = mu sqrt((1 + a) / (mu^2 + a)), y = (2 alpha - 1) / (1 + alpha), it is a / (mu^2 + a) times
 * polynomials in x and y, x ln x and y, and mu and y. L is a fit to the integral of that fit. They
 * hold for alpha in [1e-4, 2]; l errs by 1e-3 at most. Where two alphas differ, l and L are those
 * of a table (brushed.h), unless alphas vary over a surface: then alpha and mu are those of
 * round.h, L is that of alpha, and all of it is rough.
 */
#ifndef BRDF_ENERGY_H
#define BRDF_ENERGY_H

#include "energy_fit.h"
#include "facets.h"
#include "round.h"

/* Sizes in the fits' rows. */
#define BRDF_ENERGY_X 8
#define BRDF_ENERGY_Y 10
#define BRDF_ENERGY_LOSS_WORDS 113
#define BRDF_ENERGY_MEAN 12
#define BRDF_ENERGY_MEAN_LOG 1
#define BRDF_ENERGY_MEAN_WORDS 15

struct brdf_energy {
    struct brdf_round round;
    brdf_real curve[BRDF_ENERGY_X + 1]; /* of the powers of 2 x - 1 */
    brdf_real log[2];                   /* of x ln x and x^2 ln x */
    brdf_real flat[2];                  /* of mu and mu^2 */
    brdf_real spread;                   /* a */
    brdf_real mean_loss;                /* L */
};

static inline brdf_real brdf_energy_polynomial(BRDF_COEFFICIENTS c, int degree, brdf_real y)
{
    brdf_real sum = c[degree];
    BRDF_UNROLL
    for (int j = degree - 1; j >= 0; --j) {
        sum = sum * y + c[j];
    }
    return sum;
}

/* Which fit: those of Beckmann in the order of maskings, then those of GGX. */
static inline int brdf_energy_row(struct brdf_facets facets)
{
    if (facets.distribution == BRDF_GGX) {
        return facets.masking == BRDF_MASKING_VCAVITY ? 6 : 4 + (facets.masking & 1);
    }
    return facets.masking & 3;
}

/* L(alpha). */
static inline brdf_real brdf_energy_mean_loss(int row, brdf_real alpha, brdf_real y)
{
    BRDF_COEFFICIENTS c = brdf_energy_mean_fit + BRDF_ENERGY_MEAN_WORDS * row;
    brdf_real alpha2 = alpha * alpha;
    brdf_real tail = brdf_log(1.0f + 1.0f / (4.0f * alpha2));
    brdf_real sum =
        brdf_energy_polynomial(c, BRDF_ENERGY_MEAN, y) +
        tail * brdf_energy_polynomial(c + BRDF_ENERGY_MEAN + 1, BRDF_ENERGY_MEAN_LOG, y);
    return sum * alpha2 / (1.0f + alpha2);
}

/* All that does not depend on directions. */
static inline struct brdf_energy brdf_energy_make(struct brdf_facets facets)
{
    struct brdf_energy energy;
    int row = brdf_energy_row(facets);
    float blend = facets.masking == BRDF_MASKING_VCAVITY ? BRDF_ROUND_VCAVITY : BRDF_ROUND_SMITH;
    energy.round = brdf_round_make(blend, facets.alpha_u, facets.alpha_v);
    brdf_real alpha = energy.round.alpha;
    brdf_real y = (2.0f * alpha - 1.0f) / (1.0f + alpha);
    BRDF_COEFFICIENTS c = brdf_energy_loss_fit + BRDF_ENERGY_LOSS_WORDS * row;
    BRDF_UNROLL
    for (int i = 0; i <= BRDF_ENERGY_X; ++i) {
        int most = (120 - 10 * i) / 8;
        most = most > BRDF_ENERGY_Y ? BRDF_ENERGY_Y : most;
        energy.curve[i] = brdf_energy_polynomial(c, most, y);
        c += most + 1;
    }
    energy.log[0] = brdf_energy_polynomial(c, BRDF_ENERGY_Y, y);
    energy.log[1] = brdf_energy_polynomial(c + BRDF_ENERGY_Y + 1, BRDF_ENERGY_Y, y);
    c += 2 * (BRDF_ENERGY_Y + 1);
    energy.flat[0] = brdf_energy_polynomial(c, 2, y);
    energy.flat[1] = brdf_energy_polynomial(c + 3, 2, y);
    energy.spread = 4.0f * alpha * alpha;
    energy.mean_loss = brdf_energy_mean_loss(row, alpha, y);
    return energy;
}

/* The same where l comes from a table; no l can be had from this one. */
static inline struct brdf_energy brdf_energy_of(brdf_real mean_loss, brdf_real spread)
{
    struct brdf_energy energy;
    energy.round = brdf_round_make(0.0f, 1.0f, 1.0f);
    BRDF_UNROLL
    for (int i = 0; i <= BRDF_ENERGY_X; ++i) {
        energy.curve[i] = 0.0f;
    }
    energy.log[0] = energy.log[1] = 0.0f;
    energy.flat[0] = energy.flat[1] = 0.0f;
    energy.spread = spread;
    energy.mean_loss = mean_loss;
    return energy;
}

/* l for light from w; that of grazing light if w is below. */
static inline brdf_real brdf_energy_loss(struct brdf_energy energy, brdf_vec3 w)
{
    brdf_real mu = brdf_round_cosine(energy.round, w);
    brdf_real decay = energy.spread / (mu * mu + energy.spread);
    brdf_real x = brdf_min(mu * sqrtf((1.0f + energy.spread) / (mu * mu + energy.spread)), 1.0f);
    brdf_real t = 2.0f * x - 1.0f;
    brdf_real sum = energy.curve[BRDF_ENERGY_X];
    BRDF_UNROLL
    for (int i = BRDF_ENERGY_X - 1; i >= 0; --i) {
        sum = sum * t + energy.curve[i];
    }
    brdf_real log = x * brdf_log(brdf_max(x, 1e-6f));
    sum += log * (energy.log[0] + x * energy.log[1]) + mu * (energy.flat[0] + mu * energy.flat[1]);
    return brdf_clamp(sum * decay, 0.0f, 1.0f);
}

/* What of the lost light comes back from facets that reflect `fresnel` of it on average, again and
 * again: F^2 (1 - L) / (1 - F L) [Kulla and Conty 2017]. */
static inline brdf_rgb brdf_energy_color(struct brdf_energy energy, brdf_rgb fresnel)
{
    brdf_rgb squared = brdf_rgb_scale(brdf_rgb_mul(fresnel, fresnel), 1.0f - energy.mean_loss);
    brdf_real lost = energy.mean_loss;
    return brdf_rgb_make(squared.r / (1.0f - fresnel.r * lost),
                         squared.g / (1.0f - fresnel.g * lost),
                         squared.b / (1.0f - fresnel.b * lost));
}

/* f for facets that reflect everything, from l of both directions: the same bits both ways. */
static inline brdf_real brdf_energy_lobe(struct brdf_energy energy, brdf_real loss_o,
                                         brdf_real loss_i)
{
    return loss_o * loss_i * (BRDF_1_PI / brdf_max(energy.mean_loss, 1e-12f));
}

/*
 * A direction around +z with about the density of the lobe, mu / (mu^2 + a) up to a constant, so
 * that weights stay bounded: the square of its cosine is a ((1 + 1 / a)^u - 1). `spread` is a.
 */
static inline brdf_vec3 brdf_energy_sample(brdf_real spread, brdf_real u, brdf_real v)
{
    brdf_real rise = brdf_exp(u * brdf_log(1.0f + 1.0f / spread)) - 1.0f;
    brdf_real mu2 = brdf_clamp(spread * rise, 0.0f, 1.0f);
    brdf_real radius = sqrtf(1.0f - mu2);
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, sqrtf(mu2));
}

/* Its density [1/sr]. */
static inline brdf_real brdf_energy_pdf(brdf_real spread, brdf_real mu)
{
    brdf_real scale = brdf_log(1.0f + 1.0f / spread);
    return mu * BRDF_1_PI / ((mu * mu + spread) * scale);
}

#endif
