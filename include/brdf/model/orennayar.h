/*
 * orennayar - rough diffuse surfaces: plaster, clay, cloth; flatter than Lambert, brighter towards
 * the light.
 *
 * With s = cos(phi_i - phi_o) sin(theta_i) sin(theta_o) and beta, alpha the smaller and the larger
 * of theta_i and theta_o, the variants are
 *
 *   eon          fujii, and light scattered several times so that nothing is lost: Portsmouth, Kutz
 *                and Hill 2025 (EON: a practical energy-preserving rough diffuse BRDF)
 *   fujii        rho / pi A (1 + r (s > 0 ? s / cos(beta) : s)), A = 1 / (1 + (1/2 - 2/(3 pi)) r):
 *                Fujii 2013 (A tiny improvement of Oren-Nayar reflectance model)
 *   full         the fit to V-shaped cavities, C1 to C3 and light reflected twice: Oren and Nayar
 *                1994 (Generalization of Lambert's reflectance model)
 *   qualitative  rho / pi (A + B max(0, s) / cos(beta)), A = 1 - sigma^2 / (2 (sigma^2 + 0.33)),
 *                B = 0.45 sigma^2 / (sigma^2 + 0.09): the same, its simplified form
 *
 * `roughness` r is that of eon and fujii; `sigma`, the standard deviation of the facets' slope
 * angle, that of full and qualitative. A variant does not look at the other one's parameter.
 * Valid at all angles; eon keeps energy exactly (reflectance 1 is reflected whole), the others lose
 * up to a quarter where rough, and at small sigma those of 1994 gain up to 5 % (full) or 1.5 %. The
 * first part of full is negative between opposite grazing directions for sigma above 38 degrees:
 * there it is 0.
 * Sampling is that of eon for all; the others get the r that is nearest, B / A.
 */
#ifndef BRDF_MODEL_ORENNAYAR_H
#define BRDF_MODEL_ORENNAYAR_H

#include "../azimuth.h"
#include "../cltc.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_ORENNAYAR_PARAMETERS(P)                                                               \
    P(CHOICE, variant, 0, 0, 3, "eon|fujii|full|qualitative", "which formula")                     \
    P(COLOR, reflectance, 0.5f, 0.0f, 1.0f, "1", "fraction that one facet reflects, rho")          \
    P(REAL, roughness, 0.5f, 0.0f, 1.0f, "1", "r, of eon and fujii; 0 is Lambert")                 \
    P(REAL, sigma, 20.0f, 0.0f, 90.0f, "deg", "spread of slopes, of full and qualitative")

struct brdf_orennayar {
    BRDF_ORENNAYAR_PARAMETERS(BRDF_FIELD)
};

#define BRDF_ORENNAYAR_EON 0
#define BRDF_ORENNAYAR_FUJII 1
#define BRDF_ORENNAYAR_FULL 2
#define BRDF_ORENNAYAR_C1 0.287793409f  /* 1/2 - 2 / (3 pi) */
#define BRDF_ORENNAYAR_C2 0.0724882125f /* 2/3 - 28 / (15 pi) */

static inline brdf_real brdf_orennayar_variance(struct brdf_orennayar p)
{
    return brdf_sqr(p.sigma * (BRDF_PI / 180.0f));
}

/* cos(alpha) and so on: the larger cosine is that of beta. Far below what a float of 1 resolves
   next to it, a cosine is as good as 0, and division by it must stay finite. */
static inline brdf_real brdf_orennayar_steep(brdf_vec3 wo, brdf_vec3 wi)
{
    return brdf_max(brdf_max(wo.z, wi.z), 1e-12f);
}

/* cos(phi) sin(theta_i) sin(theta_o): no cancellation, unlike wo . wi - cos cos. */
static inline brdf_real brdf_orennayar_s(brdf_vec3 wo, brdf_vec3 wi)
{
    return wo.x * wi.x + wo.y * wi.y;
}

/*
 * How far the albedo of fujii stays behind 1, over A r: C1 - G(mu) / pi with the G of Portsmouth et
 * al.; 1 - sin^3 there is taken apart so that grazing directions cancel nothing.
 */
static inline brdf_real brdf_orennayar_lost(brdf_real mu)
{
    brdf_real sine = sqrtf(brdf_max((1.0f - mu) * (1.0f + mu), 0.0f));
    brdf_real rest = sine * mu * (1.0f + sine + sine * sine) / (1.0f + sine);
    brdf_real g = sine * (brdf_acos(mu) - sine * mu) + 0.666666667f * (rest - sine);
    return brdf_max(BRDF_ORENNAYAR_C1 - g * BRDF_1_PI, 0.0f);
}

/* pi f of eon for a channel: one scattering, and the several whose albedo is what that one lost. */
static inline brdf_real brdf_orennayar_kept(brdf_real rho, brdf_real once, brdf_real again,
                                            brdf_real average)
{
    return rho * once + rho * rho * average / (1.0f - rho * (1.0f - average)) * again;
}

static inline brdf_rgb brdf_orennayar_fujii(struct brdf_orennayar p, brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_real s = brdf_orennayar_s(wo, wi);
    brdf_real bent = brdf_pick(s > 0.0f, s / brdf_orennayar_steep(wo, wi), s);
    brdf_real a = 1.0f / (1.0f + BRDF_ORENNAYAR_C1 * p.roughness);
    brdf_real once = brdf_max(a * (1.0f + p.roughness * bent), 0.0f);
    if (p.variant == BRDF_ORENNAYAR_FUJII) {
        return brdf_rgb_scale(p.reflectance, once);
    }
    brdf_real average = a * (1.0f + BRDF_ORENNAYAR_C2 * p.roughness);
    /* (1 - E(wo)) (1 - E(wi)) / (1 - average), each of them A r times what lost() says. */
    brdf_real again = a * p.roughness * (brdf_orennayar_lost(wo.z) * brdf_orennayar_lost(wi.z)) *
                      (1.0f / (BRDF_ORENNAYAR_C1 - BRDF_ORENNAYAR_C2));
    return brdf_rgb_make(brdf_orennayar_kept(p.reflectance.r, once, again, average),
                         brdf_orennayar_kept(p.reflectance.g, once, again, average),
                         brdf_orennayar_kept(p.reflectance.b, once, again, average));
}

static inline brdf_rgb brdf_orennayar_qualitative(struct brdf_orennayar p, brdf_vec3 wo,
                                                  brdf_vec3 wi)
{
    brdf_real variance = brdf_orennayar_variance(p);
    brdf_real s = brdf_max(brdf_orennayar_s(wo, wi), 0.0f);
    brdf_real a = 1.0f - 0.5f * variance / (variance + 0.33f);
    brdf_real b = 0.45f * variance / (variance + 0.09f);
    return brdf_rgb_scale(p.reflectance, a + b * (s / brdf_orennayar_steep(wo, wi)));
}

static inline brdf_rgb brdf_orennayar_full(struct brdf_orennayar p, brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_real variance = brdf_orennayar_variance(p);
    brdf_real k = variance / (variance + 0.09f);
    brdf_real steep = brdf_orennayar_steep(wo, wi);
    brdf_real flat = brdf_min(wo.z, wi.z);
    brdf_real sin_o = sqrtf(wo.x * wo.x + wo.y * wo.y);
    brdf_real sin_i = sqrtf(wi.x * wi.x + wi.y * wi.y);
    brdf_real s = brdf_orennayar_s(wo, wi);
    brdf_real both = sin_o * sin_i;
    brdf_mask lean = both > 1e-30f;
    brdf_real cosine = brdf_pick(lean, s / brdf_pick(lean, both, 1.0f), 0.0f);
    cosine = brdf_clamp(cosine, -1.0f, 1.0f);
    brdf_real alpha = brdf_acos(flat) * BRDF_TWO_OVER_PI; /* in quarter turns, as is beta */
    brdf_real beta = brdf_acos(steep) * BRDF_TWO_OVER_PI;
    brdf_real tangent = brdf_min(sin_o, sin_i) / steep;
    brdf_real away = brdf_min(cosine, 0.0f) * tangent * (beta * beta * beta);
    brdf_real c2 = 0.45f * k * (s / steep - away);
    brdf_real c3 = 0.125f * k * brdf_sqr(alpha * beta) * (1.0f - fabsf(cosine));
    brdf_real once =
        1.0f - 0.5f * variance / (variance + 0.33f) + c2 + c3 * (sin_o + sin_i) / (flat + steep);
    brdf_real twice = 0.17f * variance / (variance + 0.13f) * (1.0f - cosine * (beta * beta));
    brdf_rgb squares = brdf_rgb_mul(p.reflectance, p.reflectance);
    return brdf_rgb_add(brdf_rgb_scale(p.reflectance, brdf_max(once, 0.0f)),
                        brdf_rgb_scale(squares, twice));
}

static inline brdf_rgb brdf_orennayar_eval(struct brdf_orennayar p, brdf_vec3 wo, brdf_vec3 wi,
                                           BRDF_GLOBAL const float *table)
{
    (void)table;
    BRDF_KNOWN(ORENNAYAR, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_rgb f;
    if (p.variant <= BRDF_ORENNAYAR_FUJII) {
        f = brdf_orennayar_fujii(p, wo, wi);
    } else if (p.variant == BRDF_ORENNAYAR_FULL) {
        f = brdf_orennayar_full(p, wo, wi);
    } else {
        f = brdf_orennayar_qualitative(p, wo, wi);
    }
    return brdf_rgb_pick(above, brdf_rgb_scale(f, BRDF_1_PI), brdf_gray(0.0f));
}

/* The r of fujii whose ratio of the two terms is the same. */
static inline brdf_real brdf_orennayar_r(struct brdf_orennayar p)
{
    if (p.variant <= BRDF_ORENNAYAR_FUJII) {
        return p.roughness;
    }
    brdf_real variance = brdf_orennayar_variance(p);
    brdf_real a = 1.0f - 0.5f * variance / (variance + 0.33f);
    return brdf_min(0.45f * variance / (variance + 0.09f) / a, 1.0f);
}

/* The probability of a direction from the whole hemisphere, for what the cosine leaves out near the
   horizon: as fitted by Portsmouth et al. */
static inline brdf_real brdf_orennayar_uniform_share(brdf_real r, brdf_real mu)
{
    return brdf_pow(r, 0.1f) * (0.162925f + mu * (-0.372058f + (0.538233f - 0.290822f * mu) * mu));
}

static inline brdf_real brdf_orennayar_pdf(struct brdf_orennayar p, brdf_vec3 wo, brdf_vec3 wi,
                                           BRDF_GLOBAL const float *table)
{
    (void)table;
    BRDF_KNOWN(ORENNAYAR, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real r = brdf_orennayar_r(p);
    brdf_real mu = brdf_clamp(wo.z, 0.0f, 1.0f);
    brdf_real share = brdf_orennayar_uniform_share(r, mu);
    brdf_vec3 x = brdf_azimuth(wo);
    brdf_vec3 turned = brdf_vec3_make(x.x * wi.x + x.y * wi.y, x.x * wi.y - x.y * wi.x, wi.z);
    brdf_real lobe = brdf_cltc_pdf(brdf_cltc_make(mu, r), turned);
    return brdf_pick(above, share * (0.5f * BRDF_1_PI) + (1.0f - share) * lobe, 0.0f);
}

static inline struct brdf_sample brdf_orennayar_sample(struct brdf_orennayar p, brdf_vec3 wo,
                                                       brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ORENNAYAR, p);
    brdf_real r = brdf_orennayar_r(p);
    brdf_real mu = brdf_clamp(wo.z, 0.0f, 1.0f);
    brdf_vec3 lobe = brdf_cltc_sample(brdf_cltc_make(mu, r), u.x, u.y);
    struct brdf_sincos turn = brdf_sincos_2pi(u.y);
    brdf_real radius = sqrtf(brdf_max((1.0f - u.x) * (1.0f + u.x), 0.0f));
    brdf_vec3 uniform = brdf_vec3_make(radius * turn.cos, radius * turn.sin, u.x);
    brdf_vec3 w = brdf_vec3_pick(u.z < brdf_orennayar_uniform_share(r, mu), uniform, lobe);
    brdf_vec3 x = brdf_azimuth(wo);
    brdf_vec3 wi = brdf_vec3_make(x.x * w.x - x.y * w.y, x.y * w.x + x.x * w.y, w.z);
    brdf_real pdf = brdf_orennayar_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_orennayar_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(orennayar, ORENNAYAR, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "rough diffuse reflection: Oren-Nayar and its successors",
           "Oren and Nayar 1994; Portsmouth et al. 2025")
#endif
