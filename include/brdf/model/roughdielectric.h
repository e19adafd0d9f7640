/*
 * roughdielectric - a rough interface between two dielectrics: frosted glass, seen from both sides.
 *
 * Reflection and refraction by one microfacet [Walter et al. 2007, eq. 20 and 21, with the normals
 * of eq. 13 and 16 and the Jacobians of eq. 14 and 17], exact Fresnel, visible normals. As Walter's
 * eq. 21 is written, radiance that passes is scaled by 1 / eta^2 [Veach 1997, 5.2].
 * Masking is Smith's: `correlated` is 1 / (1 + Lambda(wo) + Lambda(wi)) on either side, `separable`
 * what Mitsuba 3 computes. Light that would meet several facets is lost, unless `multiscatter`
 * brings it back: Kulla and Conty 2017, by glass.h. Indices that differ by less than 1/1000 count
 * as equal: light passes straight on, as a delta.
 */
#ifndef BRDF_MODEL_ROUGHDIELECTRIC_H
#define BRDF_MODEL_ROUGHDIELECTRIC_H

#include "../facet.h"
#include "../energy.h"
#include "../glass.h"
#include "../parameters.h"
#include "../round.h"
#include "../sample.h"

#define BRDF_ROUGHDIELECTRIC_PARAMETERS(P)                                                         \
    P(CHOICE, distribution, 0, 0, 1, "beckmann|ggx", "distribution of the facets' normals")        \
    P(CHOICE, masking, 0, 0, 1, "correlated|separable", "Smith masking and shadowing together")    \
    P(CHOICE, multiscatter, 0, 0, 1, "none|kullaconty", "light that meets several facets")         \
    P(DECIDED, brushed, 0, 0, 1, "false|true", "two alphas, and tables for them")                  \
    P(REAL, int_ior, 1.5046f, 0.1f, 10.0f, "ior", "refractive index below the surface")            \
    P(REAL, ext_ior, 1.000277f, 0.1f, 10.0f, "ior", "refractive index above the surface")          \
    P(ALIAS, alpha, 0, 0, 0, "alpha_u|alpha_v", "roughness along both tangents")                   \
    P(REAL, alpha_u, 0.1f, 1e-4f, 2.0f, "1", "roughness along the tangent")                        \
    P(REAL, alpha_v, 0.1f, 1e-4f, 2.0f, "1", "roughness along the bitangent")                      \
    P(COLOR, specular_reflectance, 1.0f, 0.0f, 1.0f, "1",                                          \
      "factor of the reflection; 1 is physical")                                                   \
    P(COLOR, specular_transmittance, 1.0f, 0.0f, 1.0f, "1",                                        \
      "factor of the transmission; 1 is physical")

struct brdf_roughdielectric {
    BRDF_ROUGHDIELECTRIC_PARAMETERS(BRDF_FIELD)
};

/* Is there no interface, for want of a difference? eta: the index below over that above. */
static inline brdf_mask brdf_roughdielectric_vanishes(brdf_real eta)
{
    return fabsf(eta - 1.0f) < 1e-3f;
}

/* Masking and shadowing over both cosines, and the facets' area seen from wo. */
struct brdf_roughdielectric_view {
    brdf_real visibility;
    brdf_real area_o;
};

static inline struct brdf_roughdielectric_view
brdf_roughdielectric_view_of(struct brdf_roughdielectric p, brdf_vec3 wo, brdf_vec3 wi)
{
    struct brdf_roughdielectric_view view;
    brdf_vec3 o = brdf_facet_upper(wo);
    brdf_vec3 i = brdf_facet_upper(wi);
    view.area_o = brdf_microfacet_area(p.distribution, o, p.alpha_u, p.alpha_v);
    brdf_real area_i = brdf_microfacet_area(p.distribution, i, p.alpha_u, p.alpha_v);
    view.visibility = brdf_microfacet_visibility(p.masking, o.z, i.z, view.area_o, area_i);
    return view;
}

/* f by one facet. */
static inline brdf_rgb brdf_roughdielectric_once(struct brdf_roughdielectric p, brdf_vec3 wo,
                                                 brdf_vec3 wi)
{
    brdf_real eta = p.int_ior / p.ext_ior;
    struct brdf_facet facet = brdf_facet_between(wo, wi, eta);
    struct brdf_roughdielectric_view view = brdf_roughdielectric_view_of(p, wo, wi);
    brdf_real d = brdf_microfacet_d(p.distribution, facet.h, p.alpha_u, p.alpha_v);
    brdf_real both = d * view.visibility;
    brdf_real index_o = brdf_pick(wo.z > 0.0f, 1.0f, eta); /* over ext_ior */
    brdf_real reflected = 0.25f * facet.reflectance * both;
    brdf_real passed = (1.0f - facet.reflectance) * both * (facet.cos_o * facet.cos_i) *
                       (index_o * index_o) / facet.length2;
    brdf_rgb f = brdf_rgb_pick(facet.mirrors, brdf_rgb_scale(p.specular_reflectance, reflected),
                               brdf_rgb_scale(p.specular_transmittance, passed));
    brdf_mask shown = facet.exists & !brdf_roughdielectric_vanishes(eta);
    return brdf_rgb_pick(shown, f, brdf_gray(0.0f));
}

/* The density of sampling that. */
static inline brdf_real brdf_roughdielectric_once_pdf(struct brdf_roughdielectric p, brdf_vec3 wo,
                                                      brdf_vec3 wi)
{
    brdf_real eta = p.int_ior / p.ext_ior;
    struct brdf_facet facet = brdf_facet_between(wo, wi, eta);
    brdf_vec3 o = brdf_facet_upper(wo);
    brdf_real d = brdf_microfacet_d(p.distribution, facet.h, p.alpha_u, p.alpha_v);
    brdf_real area = brdf_microfacet_area(p.distribution, o, p.alpha_u, p.alpha_v);
    brdf_real visible = d / brdf_max(area, 1e-20f); /* density of normals, over cos_o */
    brdf_real index_i = brdf_pick(wo.z > 0.0f, eta, 1.0f);
    brdf_real reflected = 0.25f * facet.reflectance * visible;
    brdf_real passed = (1.0f - facet.reflectance) * visible * (facet.cos_o * facet.cos_i) *
                       (index_i * index_i) / facet.length2;
    brdf_mask shown = facet.exists & !brdf_roughdielectric_vanishes(eta);
    return brdf_pick(shown, brdf_pick(facet.mirrors, reflected, passed), 0.0f);
}

/* Where there is no interface: straight on. */
static inline struct brdf_sample brdf_roughdielectric_straight(struct brdf_roughdielectric p,
                                                               brdf_vec3 wo)
{
    struct brdf_sample s = brdf_sample_make(brdf_negate(wo), p.specular_transmittance, 1.0f);
    s.delta = brdf_mask_of(1);
    return s;
}

static inline struct brdf_sample brdf_roughdielectric_once_sample(struct brdf_roughdielectric p,
                                                                  brdf_vec3 wo, brdf_vec3 u)
{
    brdf_mask outside = wo.z > 0.0f;
    brdf_real ratio = p.int_ior / p.ext_ior;
    brdf_real eta = brdf_pick(outside, ratio, 1.0f / ratio); /* far over near */
    brdf_vec3 o = brdf_facet_upper(wo);
    brdf_vec3 h = brdf_microfacet_sample(p.distribution, o, p.alpha_u, p.alpha_v, u.x, u.y);
    brdf_real cosine = brdf_clamp(brdf_dot(o, h), 0.0f, 1.0f);
    struct brdf_fresnel fresnel = brdf_fresnel_dielectric(cosine, eta);
    brdf_mask reflects = u.z < fresnel.reflectance;
    brdf_vec3 refracted = brdf_refract(o, h, cosine, fresnel.cos_t, eta);
    brdf_vec3 i = brdf_normalize(brdf_vec3_pick(reflects, brdf_reflect(o, h), refracted));
    brdf_mask arrives = (reflects & (i.z > 0.0f)) | (!reflects & (i.z < 0.0f));
    brdf_vec3 wi = brdf_vec3_make(i.x, i.y, brdf_pick(outside, i.z, -i.z));

    brdf_real pdf = brdf_roughdielectric_once_pdf(p, wo, wi);
    /* f cos / pdf = G2 / G1, over eta^2 if it passes: all else cancels. */
    struct brdf_roughdielectric_view view = brdf_roughdielectric_view_of(p, wo, wi);
    brdf_real seen = brdf_min(view.visibility * view.area_o * fabsf(i.z), 1.0f);
    brdf_rgb factor = brdf_rgb_pick(reflects, p.specular_reflectance,
                                    brdf_rgb_scale(p.specular_transmittance, 1.0f / (eta * eta)));
    struct brdf_sample s = brdf_sample_make(wi, brdf_rgb_scale(factor, seen), pdf);
    s.eta = brdf_pick(reflects, 1.0f, eta);

    struct brdf_sample straight = brdf_roughdielectric_straight(p, wo);
    brdf_mask vanishes = brdf_roughdielectric_vanishes(ratio);
    s.wi = brdf_vec3_pick(vanishes, straight.wi, s.wi);
    s.weight = brdf_rgb_pick(vanishes, straight.weight, s.weight);
    s.pdf = brdf_pick(vanishes, straight.pdf, s.pdf);
    s.eta = brdf_pick(vanishes, straight.eta, s.eta);
    s.delta = straight.delta & vanishes;
    /* A density below 1e-30 says that rounding has taken wi off every facet: alpha is too small. */
    return brdf_sample_where((o.z > 0.0f) & (vanishes | (arrives & (pdf > 1e-30f))), s);
}

static inline struct brdf_glass brdf_roughdielectric_glass(struct brdf_roughdielectric p,
                                                           BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHDIELECTRIC, p);
    if (p.brushed) {
        return brdf_glass_brushed(table, p.int_ior / p.ext_ior);
    }
    /* One loss for all azimuths: from below it goes by total reflection, not by masking. */
    struct brdf_round round = brdf_round_make(BRDF_ROUND_SMITH, p.alpha_u, p.alpha_v);
    return brdf_glass_make(table, round.alpha, p.int_ior / p.ext_ior);
}

/* What one facet loses of light from w; nothing where there is no interface. */
static inline brdf_real brdf_roughdielectric_loss(struct brdf_roughdielectric p,
                                                  struct brdf_glass glass, brdf_vec3 w,
                                                  BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHDIELECTRIC, p);
    brdf_real loss;
    if (p.brushed) {
        loss = brdf_brushed_glass_loss(table, p.alpha_u, p.alpha_v, w.z > 0.0f, w);
    } else {
        brdf_real cosine = brdf_clamp(fabsf(w.z), 0.0f, 1.0f);
        loss = brdf_glass_loss(table, glass, w.z > 0.0f, cosine);
    }
    brdf_mask vanishes = brdf_roughdielectric_vanishes(glass.eta);
    return brdf_pick(vanishes | (w.z == 0.0f), 0.0f, loss);
}

static inline brdf_rgb brdf_roughdielectric_eval(struct brdf_roughdielectric p, brdf_vec3 wo,
                                                 brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHDIELECTRIC, p);
    brdf_rgb f = brdf_roughdielectric_once(p, wo, wi);
    if (p.multiscatter) {
        struct brdf_glass glass = brdf_roughdielectric_glass(p, table);
        brdf_mask above_o = wo.z > 0.0f;
        brdf_mask above_i = wi.z > 0.0f;
        brdf_real lobe =
            brdf_glass_lobe(glass, above_o, above_i, brdf_roughdielectric_loss(p, glass, wo, table),
                            brdf_roughdielectric_loss(p, glass, wi, table));
        brdf_mask mirrors = (above_o & above_i) | (!above_o & !above_i);
        brdf_rgb color = brdf_rgb_pick(mirrors, p.specular_reflectance, p.specular_transmittance);
        f = brdf_rgb_add(f, brdf_rgb_scale(color, lobe));
    }
    return f;
}

static inline brdf_real brdf_roughdielectric_pdf(struct brdf_roughdielectric p, brdf_vec3 wo,
                                                 brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHDIELECTRIC, p);
    brdf_real once = brdf_roughdielectric_once_pdf(p, wo, wi);
    if (!p.multiscatter) {
        return once;
    }
    struct brdf_glass glass = brdf_roughdielectric_glass(p, table);
    brdf_mask above_o = wo.z > 0.0f;
    brdf_mask above_i = wi.z > 0.0f;
    brdf_mask mirrors = (above_o & above_i) | (!above_o & !above_i);
    brdf_real through = brdf_glass_through(glass, above_o);
    brdf_real loss = brdf_roughdielectric_loss(p, glass, wo, table);
    brdf_real cosine = brdf_clamp(fabsf(wi.z), 0.0f, 1.0f);
    brdf_real lobe =
        brdf_energy_pdf(glass.spread, cosine) * brdf_pick(mirrors, 1.0f - through, through);
    return (1.0f - loss) * once + loss * lobe;
}

/* By one facet or several, as both reflect and let through. */
static inline struct brdf_sample brdf_roughdielectric_sample(struct brdf_roughdielectric p,
                                                             brdf_vec3 wo, brdf_vec3 u,
                                                             BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(ROUGHDIELECTRIC, p);
    if (!p.multiscatter) {
        return brdf_roughdielectric_once_sample(p, wo, u);
    }
    struct brdf_glass glass = brdf_roughdielectric_glass(p, table);
    brdf_mask above = wo.z > 0.0f;
    brdf_real loss = brdf_roughdielectric_loss(p, glass, wo, table);
    brdf_mask several = u.z < loss;
    brdf_real through = brdf_glass_through(glass, above);
    brdf_mask passes = u.z < loss * through;
    brdf_vec3 lobe = brdf_energy_sample(glass.spread, u.x, u.y);
    brdf_mask up = (above & (!passes)) | ((!above) & passes);
    lobe.z = brdf_pick(up, lobe.z, -lobe.z);
    u.z = brdf_clamp((u.z - loss) / brdf_max(1.0f - loss, 1e-7f), 0.0f, BRDF_ONE_MINUS_ULP);
    struct brdf_sample s = brdf_roughdielectric_once_sample(p, wo, u);

    brdf_real index = brdf_pick(above, glass.eta, 1.0f / glass.eta);
    s.wi = brdf_vec3_pick(several, lobe, s.wi);
    s.eta = brdf_pick(several, brdf_pick(passes, index, 1.0f), s.eta);
    brdf_real pdf = brdf_roughdielectric_pdf(p, wo, s.wi, table);
    brdf_mask arrives = several | (s.pdf > 0.0f);
    brdf_mask valid = arrives & (pdf > 1e-30f) & (s.delta == 0);
    brdf_rgb f = brdf_roughdielectric_eval(p, wo, s.wi, table);
    struct brdf_sample either = brdf_sample_weigh(valid, s.wi, f, pdf);
    s.weight = brdf_rgb_pick(valid, either.weight, s.weight);
    s.pdf = brdf_pick(valid, pdf, s.pdf);
    return brdf_sample_where((wo.z != 0.0f) & (valid | s.delta), s);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(roughdielectric, ROUGHDIELECTRIC,
           BRDF_REFLECTION | BRDF_TRANSMISSION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL | BRDF_COMPUTED,
           "rough interface between two dielectrics: frosted glass",
           "Walter et al. 2007; Heitz 2014")
#endif
