/*
 * lommelseeliger - a deep layer of dark grains, each of which scatters evenly and only once.
 *
 *   f = albedo / (4 pi (cos(theta_i) + cos(theta_o)))
 *
 * Reference: Seeliger 1888; Chandrasekhar 1960 (Radiative transfer), chapter III; Hapke 1993
 * (Theory of reflectance and emittance spectroscopy), section 8.
 * Valid for dark grains (albedo below about 0.3), of which light seldom meets two. A full moon of
 * it is equally bright up to its edge. Reflects albedo / 2 (1 - mu ln(1 + 1 / mu)), at most half.
 */
#ifndef BRDF_MODEL_LOMMELSEELIGER_H
#define BRDF_MODEL_LOMMELSEELIGER_H

#include "../parameters.h"
#include "../regolith.h"
#include "../sample.h"

#define BRDF_LOMMELSEELIGER_PARAMETERS(P)                                                          \
    P(COLOR, albedo, 0.3f, 0.0f, 1.0f, "1", "fraction that one grain scatters")

struct brdf_lommelseeliger {
    BRDF_LOMMELSEELIGER_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_lommelseeliger_eval(struct brdf_lommelseeliger p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    /* At least 1e-12, so that no quotient is infinite. */
    brdf_real f = (0.25f * BRDF_1_PI) / brdf_max(wo.z + wi.z, 1e-12f);
    return brdf_rgb_scale(p.albedo, brdf_pick(above, f, 0.0f));
}

static inline brdf_real brdf_lommelseeliger_pdf(struct brdf_lommelseeliger p, brdf_vec3 wo,
                                                brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)p;
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real share = brdf_regolith_share(brdf_clamp(wo.z, 0.0f, 1.0f));
    return brdf_pick(above, brdf_regolith_pdf(share, wi), 0.0f);
}

static inline struct brdf_sample brdf_lommelseeliger_sample(struct brdf_lommelseeliger p,
                                                            brdf_vec3 wo, brdf_vec3 u,
                                                            BRDF_GLOBAL const float *table)
{
    brdf_real share = brdf_regolith_share(brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_vec3 wi = brdf_regolith_sample(share, u.x, u.y);
    brdf_real pdf = brdf_lommelseeliger_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_lommelseeliger_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(lommelseeliger, LOMMELSEELIGER, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "dark grains that scatter once: the Moon", "Seeliger 1888; Chandrasekhar 1960")
#endif
