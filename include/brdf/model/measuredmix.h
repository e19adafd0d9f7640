/*
 * measuredmix - two measured isotropic BRDFs, side by side: (1 - weight) of the one, weight of the
 * other.
 *
 * What specks of two materials reflect that are too small to see, such as flakes in a paint; for a
 * material that looks halfway between two, mix their files (brdfcl mix). Values and sampling are
 * those of model/merl.h; one of the two is sampled, with its share as its chance, and the density
 * is that of both. Weights of samples stay below the larger of the two parts' own. The ends are the
 * parts, to the last bit of their values. Reference: Matusik, Pfister, Brand, McMillan, "A
 * Data-Driven Reflectance Model", 2003, for the data; Veach, "Robust Monte Carlo Methods for Light
 * Transport Simulation", 1997, section 9.2.4, for the density of the combination.
 */
#ifndef BRDF_MODEL_MEASUREDMIX_H
#define BRDF_MODEL_MEASUREDMIX_H

#include "merl.h"

#define BRDF_MEASUREDMIX_PARAMETERS(P)                                                             \
    P(CHOICE, interpolation, 0, 0, 1, "linear|nearest", "between the bins of the measurements")    \
    P(CHOICE, fill, 1, 0, 1, "false|true", "bins not measured: 0, or a value from neighbours")     \
    P(REAL, weight, 0.5f, 0.0f, 1.0f, "1", "share of the second material")                         \
    P(FILE, filename_a, 0, 0, 0, "path", "the first material, a MERL .binary file")                \
    P(FILE, filename_b, 0, 0, 0, "path", "the second material, a MERL .binary file")

struct brdf_measuredmix {
    BRDF_MEASUREDMIX_PARAMETERS(BRDF_FIELD)
};

/* The second material's table lies behind the first one's. */
#define BRDF_MEASUREDMIX_SECOND BRDF_MERL_TABLE_WORDS

static inline struct brdf_merl brdf_measuredmix_part(struct brdf_measuredmix p)
{
    struct brdf_merl part;
    part.interpolation = p.interpolation;
    part.fill = p.fill; /* which the table has seen to already */
    part.scale = 1.0f;
    return part;
}

static inline brdf_rgb brdf_measuredmix_eval(struct brdf_measuredmix p, brdf_vec3 wo, brdf_vec3 wi,
                                             BRDF_GLOBAL const float *table)
{
    struct brdf_merl part = brdf_measuredmix_part(p);
    return brdf_merl_blend(brdf_merl_eval(part, wo, wi, table),
                           brdf_merl_eval(part, wo, wi, table + BRDF_MEASUREDMIX_SECOND), p.weight);
}

static inline brdf_real brdf_measuredmix_pdf(struct brdf_measuredmix p, brdf_vec3 wo, brdf_vec3 wi,
                                             BRDF_GLOBAL const float *table)
{
    struct brdf_merl part = brdf_measuredmix_part(p);
    return (1.0f - p.weight) * brdf_merl_pdf(part, wo, wi, table) +
           p.weight * brdf_merl_pdf(part, wo, wi, table + BRDF_MEASUREDMIX_SECOND);
}

static inline struct brdf_sample brdf_measuredmix_sample(struct brdf_measuredmix p, brdf_vec3 wo,
                                                         brdf_vec3 u,
                                                         BRDF_GLOBAL const float *table)
{
    brdf_mask second = u.z < p.weight;
    /* What is left of u.z, stretched again; a share of 0 is never chosen. */
    brdf_real share = brdf_pick(second, p.weight, 1.0f - p.weight);
    brdf_real rest = brdf_pick(second, u.z, u.z - p.weight) / brdf_pick(share > 0.0f, share, 1.0f);
    brdf_vec3 again = brdf_vec3_make(u.x, u.y, brdf_clamp(rest, 0.0f, BRDF_ONE_MINUS_ULP));
    brdf_vec3 wi =
        brdf_vec3_pick(second, brdf_merl_direction(wo, again, table + BRDF_MEASUREDMIX_SECOND),
                       brdf_merl_direction(wo, again, table));
    brdf_real pdf = brdf_measuredmix_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_measuredmix_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(measuredmix, MEASUREDMIX, BRDF_REFLECTION | BRDF_TABULATED | BRDF_RECIPROCAL,
           "two measured isotropic materials side by side, by weight", "Matusik et al. 2003")
#endif
