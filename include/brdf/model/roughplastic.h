/*
 * roughplastic - a diffuse base under a rough dielectric: satin paint, eggshell, unpolished
 * plastic.
 *
 *   f = F D G / (4 cos(wo) cos(wi))
 *     + T(wo) T(wi) / (eta^2 pi) * rho / (1 - rho K)
 * The interface is that of roughdielectric [Walter et al. 2007, eq. 20]; T is what it lets through
 * of a direction and K what it throws back of diffuse light from within, by a table (coating.h). G
 * is separable, as in Mitsuba 3. Light that would meet several facets is lost, in each passage,
 * unless `multiscatter` brings it back: by a lobe of its own, and into T and K (Kulla and Conty
 * 2017).
 * `nonlinear` = false puts K in the place of rho K. The table is for one pair of indices: where
 * they vary over a surface, they do so in F only.
 */
#ifndef BRDF_MODEL_ROUGHPLASTIC_H
#define BRDF_MODEL_ROUGHPLASTIC_H

#include "../coating.h"
#include "../energy.h"
#include "../interface.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_ROUGHPLASTIC_PARAMETERS(P)                                                            \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx", "distribution of the facets' normals")        \
    P(CHOICE, nonlinear, 0, 0, 1, "false|true", "colours shift by scattering within")              \
    P(CHOICE, multiscatter, 0, 0, 1, "none|kullaconty", "light that meets several facets")         \
    P(REAL, alpha, 0.1f, 1e-4f, 2.0f, "1", "roughness of the interface")                           \
    P(REAL, int_ior, 1.49f, 1.0f, 2.5f, "ior", "refractive index of the coating")                  \
    P(REAL, ext_ior, 1.000277f, 1.0f, 2.5f, "ior", "refractive index above the surface")           \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "albedo of the base")                     \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1", "factor of the reflection; 1 is physical")

struct brdf_roughplastic {
    BRDF_ROUGHPLASTIC_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_roughplastic_specular(struct brdf_roughplastic p, brdf_vec3 wo,
                                                  brdf_vec3 wi)
{
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real cosine = brdf_clamp(0.5f * (brdf_dot(wo, h) + brdf_dot(wi, h)), 0.0f, 1.0f);
    brdf_real fresnel = brdf_fresnel_dielectric(cosine, p.int_ior / p.ext_ior).reflectance;
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area_o = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real area_i = brdf_microfacet_area(p.distribution, wi, p.alpha, p.alpha);
    brdf_real g = brdf_microfacet_visibility(BRDF_MASKING_SEPARABLE, wo.z, wi.z, area_o, area_i);
    return brdf_rgb_scale(p.specular_reflectance, 0.25f * fresnel * d * g);
}

/* Light that has been in the base, and that which has met several facets and not the base. */
static inline brdf_rgb brdf_roughplastic_diffuse(struct brdf_roughplastic p, brdf_vec3 wo,
                                                 brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    struct brdf_coating coating = brdf_coating_make(table, p.alpha, p.multiscatter);
    struct brdf_coating_view o = brdf_coating_view_of(table, coating, p.multiscatter, wo.z);
    struct brdf_coating_view i = brdf_coating_view_of(table, coating, p.multiscatter, wi.z);
    brdf_real passes = brdf_coating_pass(coating, o) * brdf_coating_pass(coating, i);
    brdf_rgb base = brdf_interface_base(p.diffuse_reflectance, coating.escape, p.nonlinear);
    brdf_rgb f = brdf_rgb_scale(base, passes * BRDF_1_PI / coating.eta2);
    if (p.multiscatter) {
        brdf_real lobe = (o.loss * i.loss) * (1.0f - coating.through) / coating.mean_loss;
        f = brdf_rgb_add(f, brdf_rgb_scale(p.specular_reflectance, lobe * BRDF_1_PI));
    }
    return f;
}

/* The probabilities of sampling the mirroring facets and that lobe; the rest is the base's. */
struct brdf_roughplastic_shares {
    brdf_real once;
    brdf_real several;
};

/* By what smooth plastic would reflect, nearly, and by what the lobe does. */
static inline struct brdf_roughplastic_shares
brdf_roughplastic_shares_of(struct brdf_roughplastic p, brdf_vec3 wo,
                            BRDF_GLOBAL const float *table)
{
    brdf_real guess =
        brdf_coating_guess(p.alpha, p.int_ior / p.ext_ior, brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_real several = 0.0f;
    if (p.multiscatter) {
        struct brdf_coating coating = brdf_coating_make(table, p.alpha, 1);
        several = (1.0f - coating.through) * brdf_coating_view_of(table, coating, 1, wo.z).loss;
    }
    brdf_real most = brdf_rgb_largest(p.specular_reflectance);
    brdf_real diffuse = guess * brdf_rgb_largest(p.diffuse_reflectance);
    brdf_real scale = 1.0f / brdf_max(((1.0f - guess) + several) * most + diffuse, 1e-12f);
    struct brdf_roughplastic_shares shares;
    shares.once = (1.0f - guess) * most * scale;
    shares.several = several * most * scale;
    return shares;
}

static inline brdf_rgb brdf_roughplastic_eval(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHPLASTIC, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_rgb f = brdf_rgb_add(brdf_roughplastic_specular(p, wo, wi),
                              brdf_roughplastic_diffuse(p, wo, wi, table));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_roughplastic_pdf(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHPLASTIC, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_roughplastic_shares shares = brdf_roughplastic_shares_of(p, wo, table);
    brdf_vec3 h = brdf_normalize(brdf_add(wo, wi));
    brdf_real d = brdf_microfacet_d(p.distribution, h, p.alpha, p.alpha);
    brdf_real area = brdf_microfacet_area(p.distribution, wo, p.alpha, p.alpha);
    brdf_real pdf = shares.once * (0.25f * d / brdf_max(area, 1e-20f)) +
                    ((1.0f - shares.once) - shares.several) * brdf_warp_cosine_pdf(wi);
    if (p.multiscatter) {
        brdf_real cosine = brdf_clamp(wi.z, 0.0f, 1.0f);
        pdf += shares.several * brdf_energy_pdf(4.0f * p.alpha * p.alpha, cosine);
    }
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_roughplastic_sample(struct brdf_roughplastic p, brdf_vec3 wo,
                                                          brdf_vec3 u,
                                                          BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHPLASTIC, p);
    struct brdf_roughplastic_shares shares = brdf_roughplastic_shares_of(p, wo, table);
    brdf_vec3 h = brdf_microfacet_sample(p.distribution, wo, p.alpha, p.alpha, u.x, u.y);
    brdf_vec3 mirrored = brdf_normalize(brdf_reflect(wo, h));
    brdf_vec3 wi = brdf_vec3_pick(u.z < shares.once, mirrored, brdf_warp_cosine(u.x, u.y));
    if (p.multiscatter) {
        brdf_mask several = (u.z >= shares.once) & (u.z < shares.once + shares.several);
        brdf_vec3 lobe = brdf_energy_sample(4.0f * p.alpha * p.alpha, u.x, u.y);
        wi = brdf_vec3_pick(several, lobe, wi);
    }
    brdf_real pdf = brdf_roughplastic_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 1e-30f, wi, brdf_roughplastic_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(roughplastic, ROUGHPLASTIC, BRDF_REFLECTION | BRDF_RECIPROCAL | BRDF_COMPUTED,
           "diffuse base under a rough dielectric, with scattering within",
           "Walter et al. 2007; Elias 2001; d'Eon 2021")
#endif
