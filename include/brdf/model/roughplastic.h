/*
 * roughplastic - a diffuse base under a rough dielectric: satin paint, eggshell, unpolished
 * plastic.
 *
 *   f = F D G / (4 cos(wo) cos(wi))
 *     + T(wo) T(wi) / (eta^2 pi) * rho / (1 - rho K)
 * The interface is that of roughdielectric [Walter et al. 2007, eq. 20]; T is what it lets through
 * of a direction and K what it throws back of diffuse light from within, by fits (coating.h). G is
 * separable, as in Mitsuba 3. Light that would meet several facets is lost, in each passage, unless
 * `multiscatter` brings it back: by a lobe of its own, and into T and K (Kulla and Conty 2017, by
 * glass.h).
 * `nonlinear` = false puts K in the place of rho K. eta below 1.1 or above 2.5 counts as these in
 * the diffuse part.
 */
#ifndef BRDF_MODEL_ROUGHPLASTIC_H
#define BRDF_MODEL_ROUGHPLASTIC_H

#include "../coating.h"
#include "../energy.h"
#include "../glass.h"
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

static inline struct brdf_coating brdf_roughplastic_coating(struct brdf_roughplastic p)
{
    return brdf_coating_make(p.distribution, p.alpha, p.int_ior / p.ext_ior);
}

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

static inline struct brdf_glass brdf_roughplastic_glass(struct brdf_roughplastic p,
                                                        BRDF_GLOBAL const float *table)
{
    return brdf_glass_make(table, p.alpha, p.int_ior / p.ext_ior);
}

/* What one facet of the interface loses of light from w above. */
static inline brdf_real brdf_roughplastic_loss(struct brdf_glass glass, brdf_vec3 w,
                                               BRDF_GLOBAL const float *table)
{
    return brdf_glass_loss(table, brdf_mask_of(1), glass.alpha, brdf_clamp(w.z, 0.0f, 1.0f));
}

static inline brdf_rgb brdf_roughplastic_base(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    struct brdf_coating coating = brdf_roughplastic_coating(p);
    struct brdf_coating_curve curve = brdf_coating_curve_of(coating);
    brdf_real pass_o = brdf_coating_pass(coating, curve, brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_real pass_i = brdf_coating_pass(coating, curve, brdf_clamp(wi.z, 0.0f, 1.0f));
    brdf_real escape = brdf_coating_escape(coating);
    if (p.multiscatter) {
        struct brdf_glass glass = brdf_roughplastic_glass(p, table);
        brdf_real through = brdf_glass_through(glass, brdf_mask_of(1));
        brdf_real back = 1.0f - brdf_glass_through(glass, brdf_mask_of(0));
        pass_o += through * brdf_roughplastic_loss(glass, wo, table);
        pass_i += through * brdf_roughplastic_loss(glass, wi, table);
        escape = brdf_max(escape - back * glass.mean_below, 0.01f);
    }
    brdf_rgb base = brdf_interface_base(p.diffuse_reflectance, escape, p.nonlinear);
    return brdf_rgb_scale(base, pass_o * pass_i * BRDF_1_PI / (coating.eta * coating.eta));
}

/* The lobe of light that has met several facets of the interface and not the base. */
static inline brdf_rgb brdf_roughplastic_lobe(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    struct brdf_glass glass = brdf_roughplastic_glass(p, table);
    brdf_mask above = brdf_mask_of(1);
    brdf_real lobe = brdf_glass_lobe(glass, above, above, brdf_roughplastic_loss(glass, wo, table),
                                     brdf_roughplastic_loss(glass, wi, table));
    return brdf_rgb_scale(p.specular_reflectance, lobe);
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
        brdf_coating_guess(brdf_roughplastic_coating(p), brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_real several = 0.0f;
    if (p.multiscatter) {
        struct brdf_glass glass = brdf_roughplastic_glass(p, table);
        several = (1.0f - brdf_glass_through(glass, brdf_mask_of(1))) *
                  brdf_roughplastic_loss(glass, wo, table);
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
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_rgb f = brdf_rgb_add(brdf_roughplastic_specular(p, wo, wi),
                              brdf_roughplastic_base(p, wo, wi, table));
    if (p.multiscatter) {
        f = brdf_rgb_add(f, brdf_roughplastic_lobe(p, wo, wi, table));
    }
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_roughplastic_pdf(struct brdf_roughplastic p, brdf_vec3 wo,
                                              brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
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
