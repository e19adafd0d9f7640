/*
 * phong - the modified Phong model: a diffuse part and a cosine lobe about the mirror direction.
 *
 * Reference: Phong 1975; normalised and reciprocal as in Lafortune and Willems 1994, eq. 8:
 *   f = diffuse / pi + specular (n + 2) / (2 pi) cos^n(angle between wi and the mirror of wo).
 * Valid for diffuse + specular <= 1, else it can reflect more than it receives. Narrow lobes lose
 * energy towards grazing (the albedo of the specular part falls as cos(wo)): that is the model.
 */
#ifndef BRDF_MODEL_PHONG_H
#define BRDF_MODEL_PHONG_H

#include "../frame.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_PHONG_PARAMETERS(P)                                                                   \
    P(REAL, exponent, 30.0f, 0.0f, 1e5f, "1", "width of the lobe: larger is narrower")             \
    P(COLOR, specular_reflectance, 0.2f, 0.0f, 1.0f, "1", "weight of the lobe")                    \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "weight of the diffuse part")

struct brdf_phong {
    BRDF_PHONG_PARAMETERS(BRDF_FIELD)
};

/*
 * cos^n of the angle between wi and the mirror direction of wo; symmetric in the two. 1 - cos comes
 * from the difference of the two, and its logarithm from that of the rounded cos,
 * corrected by the ratio of both differences from 1 [Goldberg 1991, theorem 4]:
 * cos itself has too few digits left near 1, where narrow lobes are.
 */
static inline brdf_real brdf_phong_lobe(struct brdf_phong p, brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_vec3 off = brdf_vec3_make(wi.x + wo.x, wi.y + wo.y, wi.z - wo.z);
    brdf_real far = 0.5f * brdf_dot(off, off); /* 1 - cos */
    brdf_mask inside = far < 1.0f;
    brdf_real cosine = brdf_pick(inside, 1.0f - far, 1.0f);
    brdf_real lost = 1.0f - cosine; /* what of `far` is left in `cosine` */
    brdf_real log_cosine =
        brdf_pick(lost > 0.0f, brdf_log(cosine) * (far / brdf_pick(lost > 0.0f, lost, 1.0f)), -far);
    return brdf_pick(inside, brdf_exp(p.exponent * log_cosine), 0.0f);
}

/* The probability of sampling the lobe rather than the diffuse part. */
static inline brdf_real brdf_phong_specular_share(struct brdf_phong p)
{
    brdf_real specular = brdf_rgb_largest(p.specular_reflectance);
    brdf_real diffuse = brdf_rgb_largest(p.diffuse_reflectance);
    return specular / brdf_max(specular + diffuse, 1e-12f);
}

static inline brdf_rgb brdf_phong_eval(struct brdf_phong p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real lobe = (p.exponent + 2.0f) * (0.5f * BRDF_1_PI) * brdf_phong_lobe(p, wo, wi);
    brdf_rgb f = brdf_rgb_add(brdf_rgb_scale(p.diffuse_reflectance, BRDF_1_PI),
                              brdf_rgb_scale(p.specular_reflectance, lobe));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_phong_pdf(struct brdf_phong p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_real share = brdf_phong_specular_share(p);
    brdf_real lobe = (p.exponent + 1.0f) * (0.5f * BRDF_1_PI) * brdf_phong_lobe(p, wo, wi);
    brdf_real pdf = share * lobe + (1.0f - share) * brdf_warp_cosine_pdf(wi);
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_phong_sample(struct brdf_phong p, brdf_vec3 wo, brdf_vec3 u,
                                                   BRDF_GLOBAL const float *table)
{
    /* About the mirror direction: cos = u^(1 / (n + 1)); 1 - cos with all its digits, as above. */
    brdf_real log_cosine = brdf_log(brdf_max(u.x, 1e-12f)) / (p.exponent + 1.0f);
    brdf_real rounded = brdf_exp(log_cosine);
    brdf_mask few = rounded < 1.0f;
    brdf_real log_rounded = brdf_log(brdf_pick(few, rounded, 0.5f));
    brdf_real far = brdf_pick(few, (1.0f - rounded) * (log_cosine / log_rounded), -log_cosine);
    brdf_real cosine = 1.0f - far;
    brdf_real sine = sqrtf(brdf_max(far * (2.0f - far), 0.0f));
    struct brdf_sincos turn = brdf_sincos_2pi(u.y);
    brdf_frame mirror = brdf_frame_from_normal(brdf_vec3_make(-wo.x, -wo.y, wo.z));
    brdf_vec3 lobe =
        brdf_to_world(mirror, brdf_vec3_make(sine * turn.cos, sine * turn.sin, cosine));
    brdf_vec3 wi =
        brdf_vec3_pick(u.z < brdf_phong_specular_share(p), lobe, brdf_warp_cosine(u.x, u.y));
    brdf_real pdf = brdf_phong_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_phong_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(phong, PHONG, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "diffuse and a normalised cosine lobe about the mirror direction",
           "Phong 1975; Lafortune and Willems 1994")
#endif
