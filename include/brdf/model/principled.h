/*
 * principled - one model for many materials by parameters that artists think in: Disney's.
 *
 *   f = (1 - metallic) (1 - spec_trans) base_color diffuse + sheen       [Burley 2015; 2012, 5.3]
 *     + F D G / (4 cos(wo) cos(wi)) + clearcoat / 4 * coat               [Burley 2012, 5.4 to 5.6]
 *     + (1 - metallic) spec_trans sqrt(base_color) refraction            [Burley 2015]
 * Parameters, their meaning and all formulas are those of Mitsuba 3's plugin: GGX with separable
 * masking and alpha = roughness^2; F mixes the exact Fresnel of a dielectric, its tinted Schlick
 * form and a metal's. Seen from below, only spec_trans shows. The coat of Mitsuba is F D G without
 * the 4 cos(wo) cos(wi) that Burley divides by; `coat` = burley has it. Radiance that passes is
 * scaled by 1 / eta^2. No part knows what others take away: f may reflect more than it receives
 * (sheen at grazing, clearcoat), as Disney's does.
 */
#ifndef BRDF_MODEL_PRINCIPLED_H
#define BRDF_MODEL_PRINCIPLED_H

#include "../disney.h"
#include "../facet.h"
#include "../halfvector.h"
#include "../microfacet.h"
#include "../parameters.h"
#include "../sample.h"
#include "../warp.h"

#define BRDF_PRINCIPLED_PARAMETERS(P)                                                              \
    P(CHOICE, coat, 0, 0, 1, "mitsuba|burley", "form of the clearcoat: F D G, or over 4 cos cos")  \
    P(COLOR, base_color, 0.5f, 0.0f, 1.0f, "1",                                                    \
      "colour of the diffuse base, the metal, the glass")                                          \
    P(REAL, roughness, 0.5f, 0.0f, 1.0f, "1", "of facets, alpha = roughness^2, and of the base")   \
    P(REAL, anisotropic, 0.0f, 0.0f, 1.0f, "1", "stretches highlights along the tangent")          \
    P(REAL, metallic, 0.0f, 0.0f, 1.0f, "1", "0: dielectric, 1: metal of the base's colour")       \
    P(REAL, spec_trans, 0.0f, 0.0f, 1.0f, "1", "0: diffuse base, 1: clear as glass")               \
    P(REAL, specular, 0.5f, 0.0f, 1.0f, "1", "reflectance at the normal over 0.08; sets eta")      \
    P(REAL, eta, 0.0f, 0.0f, 10.0f, "1", "index below over above; below 0.1: as specular says")    \
    P(REAL, spec_tint, 0.0f, 0.0f, 1.0f, "1", "tints reflections of dielectrics as the base")      \
    P(REAL, sheen, 0.0f, 0.0f, 1.0f, "1", "a glow at grazing, as of cloth")                        \
    P(REAL, sheen_tint, 0.0f, 0.0f, 1.0f, "1", "tints the sheen as the base")                      \
    P(REAL, flatness, 0.0f, 0.0f, 1.0f, "1", "from diffuse to the look of subsurface scattering")  \
    P(REAL, clearcoat, 0.0f, 0.0f, 1.0f, "1", "a second layer that reflects")                      \
    P(REAL, clearcoat_gloss, 0.0f, 0.0f, 1.0f, "1", "0: satin (alpha 0.1), 1: gloss (0.001)")      \
    P(REAL, diffuse_reflectance_sampling_rate, 1.0f, 0.1f, 10.0f, "1", "samples for the base")     \
    P(REAL, main_specular_sampling_rate, 1.0f, 0.1f, 10.0f, "1", "samples for the facets")         \
    P(REAL, clearcoat_sampling_rate, 1.0f, 0.1f, 10.0f, "1", "samples for the clearcoat")

struct brdf_principled {
    BRDF_PRINCIPLED_PARAMETERS(BRDF_FIELD)
};

/* How much of the base is a diffuse dielectric and how much a clear one; the rest is metal. */
static inline brdf_real brdf_principled_diffuse_share(struct brdf_principled p)
{
    return (1.0f - p.metallic) * (1.0f - p.spec_trans);
}

static inline brdf_real brdf_principled_clear_share(struct brdf_principled p)
{
    return (1.0f - p.metallic) * p.spec_trans;
}

/* The index below over that above. What is clear needs a difference: light must be bent. */
static inline brdf_real brdf_principled_eta(struct brdf_principled p)
{
    brdf_mask clear = p.spec_trans > 0.0f;
    brdf_real specular = brdf_max(p.specular, brdf_pick(clear, 1e-3f, 0.0f));
    brdf_real from_specular = 2.0f / (1.0f - sqrtf(0.08f * specular)) - 1.0f;
    brdf_real eta = brdf_pick(p.eta < 0.1f, from_specular, p.eta);
    return brdf_pick(clear & (fabsf(eta - 1.0f) < 1e-3f), 1.001f, eta);
}

/* Schlick's (1 - cos)^5; a thinner far side takes the cosine there [Burley 2015]. */
static inline brdf_real brdf_principled_grazing(brdf_real cosine, brdf_real eta)
{
    brdf_real far2 = 1.0f - (1.0f - cosine * cosine) / (eta * eta);
    brdf_real cos_far = sqrtf(brdf_max(far2, 0.0f));
    return brdf_disney_grazing(brdf_pick(eta > 1.0f, cosine, cos_far));
}

/* What the facets reflect of light from above: dielectric, tinted dielectric and metal, mixed. */
static inline brdf_rgb brdf_principled_fresnel(struct brdf_principled p, brdf_real reflectance,
                                               brdf_real grazing, brdf_real eta)
{
    brdf_rgb white = brdf_gray(1.0f);
    brdf_real root = (eta - 1.0f) / (eta + 1.0f);
    brdf_rgb normal = brdf_rgb_scale(brdf_disney_tint(p.base_color), root * root);
    brdf_rgb tinted = brdf_disney_mix_rgb(normal, white, grazing);
    brdf_rgb dielectric = brdf_disney_mix_rgb(brdf_gray(reflectance), tinted, p.spec_tint);
    brdf_rgb metal = brdf_disney_mix_rgb(p.base_color, white, grazing);
    brdf_rgb f = brdf_disney_mix_rgb(dielectric, metal, p.metallic);
    /* Where Fresnel reflects nothing, for an index of 1, Mitsuba's metal does not either. */
    return brdf_rgb_pick(reflectance > 0.0f, f, brdf_gray(0.0f));
}

/*
 * All that mirrors about the half vector, seen from above: facets and coat. `both`: D G / (4
 * cos(wo) cos(wi)) of the facets.
 */
static inline brdf_rgb brdf_principled_mirrored(struct brdf_principled p, brdf_real cos_o,
                                                brdf_real cos_i, struct brdf_facet facet,
                                                brdf_real both)
{
    brdf_real eta = brdf_principled_eta(p);
    brdf_real grazing = brdf_principled_grazing(0.5f * (facet.cos_o + facet.cos_i), eta);
    brdf_rgb facets = brdf_principled_fresnel(p, facet.reflectance, grazing, eta);
    brdf_real d = brdf_gtr1_d(facet.h, brdf_disney_coat_alpha(p.clearcoat_gloss));
    brdf_real areas = brdf_disney_coat_area(cos_o) * brdf_disney_coat_area(cos_i);
    brdf_real g = p.coat ? 0.25f : cos_o * cos_i;
    brdf_real coat = 0.25f * p.clearcoat * brdf_mix(0.04f, 1.0f, grazing) * d * g / areas;
    return brdf_rgb_add(brdf_rgb_scale(facets, both), brdf_gray(coat));
}

/* Diffuse base and sheen, seen from above. */
static inline brdf_rgb brdf_principled_base(struct brdf_principled p, brdf_real cos_o,
                                            brdf_real cos_i, brdf_real cos_d)
{
    brdf_real share = brdf_principled_diffuse_share(p);
    brdf_real diffuse = brdf_disney_diffuse(cos_o, cos_i, cos_d, p.roughness, p.flatness);
    brdf_real glow = (1.0f - p.metallic) * p.sheen * brdf_disney_grazing(cos_d);
    brdf_rgb tint =
        brdf_disney_mix_rgb(brdf_gray(1.0f), brdf_disney_tint(p.base_color), p.sheen_tint);
    brdf_rgb f =
        brdf_rgb_add(brdf_rgb_scale(p.base_color, share * diffuse), brdf_rgb_scale(tint, glow));
    return brdf_rgb_pick(share > 0.0f, f, brdf_gray(0.0f));
}

static inline brdf_rgb brdf_principled_eval(struct brdf_principled p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real eta = brdf_principled_eta(p);
    brdf_real clear = brdf_principled_clear_share(p);
    struct brdf_disney_alpha alpha = brdf_disney_alpha_of(p.roughness, p.anisotropic);
    struct brdf_facet facet = brdf_facet_between(wo, wi, eta);
    brdf_vec3 o = brdf_facet_upper(wo);
    brdf_vec3 i = brdf_facet_upper(wi);
    brdf_real area_o = brdf_microfacet_area(BRDF_GGX, o, alpha.u, alpha.v);
    brdf_real area_i = brdf_microfacet_area(BRDF_GGX, i, alpha.u, alpha.v);
    brdf_real both = brdf_microfacet_d(BRDF_GGX, facet.h, alpha.u, alpha.v) *
                     brdf_microfacet_visibility(BRDF_MASKING_SEPARABLE, o.z, i.z, area_o, area_i);

    brdf_real cos_d = 0.5f * (facet.cos_o + facet.cos_i);
    brdf_rgb above = brdf_rgb_add(brdf_principled_mirrored(p, o.z, i.z, facet, 0.25f * both),
                                  brdf_principled_base(p, o.z, i.z, cos_d));
    brdf_rgb below = brdf_gray(clear * facet.reflectance * (0.25f * both));
    brdf_mask outside = wo.z > 0.0f;
    brdf_real index_o = brdf_pick(outside, 1.0f, eta); /* over that above */
    brdf_real passed = clear * (1.0f - facet.reflectance) * both * (facet.cos_o * facet.cos_i) *
                       (index_o * index_o) / facet.length2;
    brdf_rgb root =
        brdf_rgb_make(sqrtf(p.base_color.r), sqrtf(p.base_color.g), sqrtf(p.base_color.b));
    brdf_rgb f = brdf_rgb_pick(facet.mirrors, brdf_rgb_pick(outside, above, below),
                               brdf_rgb_scale(root, passed));
    return brdf_rgb_pick(facet.exists, f, brdf_gray(0.0f));
}

/* The probabilities of sampling by the base's cosine, the coat's and the facets' normals. */
struct brdf_principled_chances {
    brdf_real base;
    brdf_real coat;
    brdf_real facets;
    brdf_real bent; /* of those that the facets let through, how many to follow */
};

static inline struct brdf_principled_chances brdf_principled_chances_of(struct brdf_principled p,
                                                                        brdf_mask outside)
{
    struct brdf_principled_chances chances;
    brdf_real clear = brdf_principled_clear_share(p);
    brdf_real base = brdf_principled_diffuse_share(p) * p.diffuse_reflectance_sampling_rate;
    brdf_real coat = 0.25f * p.clearcoat * p.clearcoat_sampling_rate;
    brdf_real inverse = 1.0f / (base + coat + p.main_specular_sampling_rate);
    chances.base = brdf_pick(outside, base * inverse, 0.0f);
    chances.coat = brdf_pick(outside, coat * inverse, 0.0f);
    chances.facets = brdf_pick(outside, p.main_specular_sampling_rate * inverse,
                               brdf_pick(clear > 0.0f, 1.0f, 0.0f));
    chances.bent = brdf_pick(outside, clear, 1.0f);
    return chances;
}

static inline brdf_real brdf_principled_pdf(struct brdf_principled p, brdf_vec3 wo, brdf_vec3 wi,
                                            BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask outside = wo.z > 0.0f;
    brdf_real eta = brdf_principled_eta(p);
    struct brdf_principled_chances chances = brdf_principled_chances_of(p, outside);
    struct brdf_disney_alpha alpha = brdf_disney_alpha_of(p.roughness, p.anisotropic);
    struct brdf_facet facet = brdf_facet_between(wo, wi, eta);
    brdf_real d = brdf_microfacet_d(BRDF_GGX, facet.h, alpha.u, alpha.v);
    brdf_real area = brdf_microfacet_area(BRDF_GGX, brdf_facet_upper(wo), alpha.u, alpha.v);
    brdf_real visible = chances.facets * d / brdf_max(area, 1e-20f); /* over cos_o */
    brdf_real bent = chances.bent * (1.0f - facet.reflectance);
    brdf_real index_i = brdf_pick(outside, eta, 1.0f);
    brdf_real passed =
        bent * visible * (facet.cos_o * facet.cos_i) * (index_i * index_i) / facet.length2;

    brdf_real coat = brdf_gtr1_d(facet.h, brdf_disney_coat_alpha(p.clearcoat_gloss)) * facet.h.z;
    brdf_real cos_d = brdf_max(0.5f * (facet.cos_o + facet.cos_i), 1e-9f);
    brdf_real mirrored = 0.25f * (1.0f - bent) * visible + 0.25f * chances.coat * coat / cos_d +
                         chances.base * brdf_warp_cosine_pdf(wi);
    return brdf_pick(facet.exists, brdf_pick(facet.mirrors, mirrored, passed), 0.0f);
}

static inline struct brdf_sample brdf_principled_sample(struct brdf_principled p, brdf_vec3 wo,
                                                        brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    brdf_mask outside = wo.z > 0.0f;
    brdf_real ratio = brdf_principled_eta(p);
    brdf_real eta = brdf_pick(outside, ratio, 1.0f / ratio); /* far over near */
    struct brdf_principled_chances chances = brdf_principled_chances_of(p, outside);
    struct brdf_disney_alpha alpha = brdf_disney_alpha_of(p.roughness, p.anisotropic);
    brdf_vec3 o = brdf_facet_upper(wo);

    brdf_mask by_base = u.z < chances.base;
    brdf_mask by_coat = !by_base & (u.z < chances.base + chances.coat);
    brdf_vec3 h = brdf_vec3_pick(
        by_coat, brdf_gtr1_sample(brdf_disney_coat_alpha(p.clearcoat_gloss), u.x, u.y),
        brdf_microfacet_sample_ggx(o, alpha.u, alpha.v, u.x, u.y));
    brdf_real cosine = brdf_clamp(brdf_dot(o, h), 0.0f, 1.0f);
    struct brdf_fresnel fresnel = brdf_fresnel_dielectric(cosine, eta);
    brdf_real bent = chances.facets * chances.bent * (1.0f - fresnel.reflectance);
    brdf_mask passes = !by_base & !by_coat & (u.z - (chances.base + chances.coat) < bent);

    brdf_vec3 refracted = brdf_normalize(brdf_refract(o, h, cosine, fresnel.cos_t, eta));
    brdf_vec3 i = brdf_vec3_pick(passes, refracted, brdf_half_mirror(o, h));
    i = brdf_vec3_pick(by_base, brdf_warp_cosine(u.x, u.y), i);
    brdf_mask arrives = (passes & (i.z < 0.0f)) | (!passes & (i.z > 0.0f));
    brdf_vec3 wi = brdf_vec3_make(i.x, i.y, brdf_pick(outside, i.z, -i.z));

    brdf_real pdf = brdf_principled_pdf(p, wo, wi, table);
    /* A density below 1e-20 says that rounding has taken wi off every facet. */
    brdf_mask valid = (o.z > 0.0f) & arrives & (pdf > 1e-20f);
    brdf_rgb f = brdf_principled_eval(p, wo, wi, table);
    struct brdf_sample s = brdf_sample_weigh(valid, wi, f, pdf);
    s.eta = brdf_pick(passes, eta, 1.0f);
    return s;
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(principled, PRINCIPLED,
           BRDF_REFLECTION | BRDF_TRANSMISSION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL,
           "many materials by an artist's parameters: Disney's", "Burley 2012; Burley 2015")
#endif
