/*
 * ashikhminshirley - an anisotropic lobe with Fresnel over a diffuse part that gives way to it.
 *
 * Reference: Ashikhmin and Shirley 2000, An anisotropic Phong BRDF model, eq. 4 and 5:
 *   lobe     sqrt((n_u + 1) (n_v + 1)) / (8 pi) cos(h)^(n_u cos^2(phi_h) + n_v sin^2(phi_h))
 *            F / (cos(wi, h) max(cos(wo), cos(wi)))
 *   diffuse  28 R_d / (23 pi) (1 - R_s) (1 - (1 - cos(wo) / 2)^5) (1 - (1 - cos(wi) / 2)^5)
 * with F of Schlick, R_s being `specular_reflectance`, R_d `diffuse_reflectance`.
 * Valid for any values: never reflects more than it receives. The diffuse part is that of a
 * polished surface and falls towards grazing, where the lobe takes over.
 */
#ifndef BRDF_MODEL_ASHIKHMINSHIRLEY_H
#define BRDF_MODEL_ASHIKHMINSHIRLEY_H

#include "../halfvector.h"
#include "../mixture.h"
#include "../parameters.h"

#define BRDF_ASHIKHMINSHIRLEY_PARAMETERS(P)                                                        \
    P(ALIAS, exponent, 0, 0, 0, "exponent_u|exponent_v", "width of the lobe in both directions")   \
    P(REAL, exponent_u, 100.0f, 0.0f, 1e5f, "1", "width of the lobe along the tangent")            \
    P(REAL, exponent_v, 100.0f, 0.0f, 1e5f, "1", "width of the lobe along the bitangent")          \
    P(COLOR, specular_reflectance, 0.2f, 0.0f, 1.0f, "1", "reflectance of the lobe at the normal") \
    P(COLOR, diffuse_reflectance, 0.5f, 0.0f, 1.0f, "1", "reflectance of the base")

struct brdf_ashikhminshirley {
    BRDF_ASHIKHMINSHIRLEY_PARAMETERS(BRDF_FIELD)
};

static inline brdf_rgb brdf_ashikhminshirley_but(brdf_rgb c)
{
    return brdf_rgb_make(1.0f - c.r, 1.0f - c.g, 1.0f - c.b);
}

static inline brdf_real brdf_ashikhminshirley_fifth(brdf_real x)
{
    return brdf_sqr(x * x) * x;
}

/* Fresnel [Schlick 1994]. */
static inline brdf_rgb brdf_ashikhminshirley_fresnel(struct brdf_ashikhminshirley p,
                                                     brdf_real cosine)
{
    brdf_real grazing = brdf_ashikhminshirley_fifth(1.0f - brdf_clamp(cosine, 0.0f, 1.0f));
    brdf_rgb rest = brdf_ashikhminshirley_but(p.specular_reflectance);
    return brdf_rgb_add(p.specular_reflectance, brdf_rgb_scale(rest, grazing));
}

/* Of the diffuse part, pi f but for 1 - (1 - cos(wi) / 2)^5. */
static inline brdf_rgb brdf_ashikhminshirley_base(struct brdf_ashikhminshirley p, brdf_real cos_o)
{
    brdf_real o = 1.0f - brdf_ashikhminshirley_fifth(1.0f - 0.5f * cos_o);
    brdf_rgb rest = brdf_ashikhminshirley_but(p.specular_reflectance);
    return brdf_rgb_scale(brdf_rgb_mul(p.diffuse_reflectance, rest), 28.0f / 23.0f * o);
}

static inline brdf_real brdf_ashikhminshirley_share(struct brdf_ashikhminshirley p, brdf_real cos_o)
{
    return brdf_mixture_share(brdf_ashikhminshirley_fresnel(p, cos_o),
                              brdf_ashikhminshirley_base(p, cos_o));
}

/* Density of h: sqrt((n_u + 1) (n_v + 1)) / (2 pi) cos^e(h), e in between n_u and n_v. */
static inline brdf_real brdf_ashikhminshirley_density(struct brdf_ashikhminshirley p,
                                                      struct brdf_half h)
{
    brdf_real x2 = h.sum.x * h.sum.x;
    brdf_real y2 = h.sum.y * h.sum.y;
    brdf_real e = (p.exponent_u * x2 + p.exponent_v * y2) / brdf_max(x2 + y2, 1e-30f);
    brdf_real scale = sqrtf((p.exponent_u + 1.0f) * (p.exponent_v + 1.0f)) * (0.5f * BRDF_1_PI);
    return scale * brdf_half_power(h, e);
}

static inline brdf_rgb brdf_ashikhminshirley_eval(struct brdf_ashikhminshirley p, brdf_vec3 wo,
                                                  brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real cos_d = brdf_half_cosine(h);
    brdf_real lobe = 0.25f * brdf_ashikhminshirley_density(p, h) /
                     (cos_d * brdf_max(brdf_max(wo.z, wi.z), 1e-10f));
    /* The two cosines before the colours, so that (wi, wo) has the same bits. */
    brdf_real o = 1.0f - brdf_ashikhminshirley_fifth(1.0f - 0.5f * wo.z);
    brdf_real i = 1.0f - brdf_ashikhminshirley_fifth(1.0f - 0.5f * wi.z);
    brdf_rgb rest = brdf_ashikhminshirley_but(p.specular_reflectance);
    brdf_rgb diffuse = brdf_rgb_scale(brdf_rgb_mul(p.diffuse_reflectance, rest),
                                      28.0f / 23.0f * BRDF_1_PI * (o * i));
    brdf_rgb f =
        brdf_rgb_add(diffuse, brdf_rgb_scale(brdf_ashikhminshirley_fresnel(p, cos_d), lobe));
    return brdf_rgb_pick(above, f, brdf_gray(0.0f));
}

static inline brdf_real brdf_ashikhminshirley_pdf(struct brdf_ashikhminshirley p, brdf_vec3 wo,
                                                  brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe = brdf_half_pdf(h, brdf_ashikhminshirley_density(p, h));
    brdf_real pdf = brdf_mixture_pdf(brdf_ashikhminshirley_share(p, wo.z), lobe, wi);
    return brdf_pick(above, pdf, 0.0f);
}

/* A half vector with the density above; the azimuth is that of a circle, stretched. */
static inline brdf_vec3 brdf_ashikhminshirley_normal(struct brdf_ashikhminshirley p, brdf_real u,
                                                     brdf_real v)
{
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_real x = turn.cos * sqrtf(p.exponent_v + 1.0f);
    brdf_real y = turn.sin * sqrtf(p.exponent_u + 1.0f);
    brdf_real inverse = 1.0f / sqrtf(x * x + y * y);
    brdf_real cos_phi = x * inverse;
    brdf_real sin_phi = y * inverse;
    brdf_real e = p.exponent_u * (cos_phi * cos_phi) + p.exponent_v * (sin_phi * sin_phi);
    return brdf_half_sample_power(e + 1.0f, u, cos_phi, sin_phi);
}

static inline struct brdf_sample brdf_ashikhminshirley_sample(struct brdf_ashikhminshirley p,
                                                              brdf_vec3 wo, brdf_vec3 u,
                                                              BRDF_GLOBAL const float *table)
{
    (void)table;
    brdf_real share = brdf_ashikhminshirley_share(p, wo.z);
    brdf_vec3 normal = brdf_ashikhminshirley_normal(p, u.x, u.y);
    brdf_vec3 mirrored = brdf_half_mirror(wo, normal);
    brdf_vec3 wi = brdf_vec3_pick(u.z < share, mirrored, brdf_warp_cosine(u.x, u.y));
    struct brdf_half h = brdf_half_make(wo, wi);
    brdf_real lobe_pdf = brdf_half_pdf(h, brdf_ashikhminshirley_density(p, h));
    /* f cos / pdf of the lobe is F cos(wi) / max(cos(wo), cos(wi)): at most F. */
    brdf_real weight = wi.z / brdf_max(brdf_max(wo.z, wi.z), 1e-10f);
    brdf_rgb facet = brdf_ashikhminshirley_fresnel(p, brdf_half_cosine(h));
    brdf_real i = 1.0f - brdf_ashikhminshirley_fifth(1.0f - 0.5f * wi.z);
    return brdf_mixture_sample(wo, wi, share, lobe_pdf, brdf_rgb_scale(facet, weight),
                               brdf_rgb_scale(brdf_ashikhminshirley_base(p, wo.z), i));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(ashikhminshirley, ASHIKHMINSHIRLEY, BRDF_REFLECTION | BRDF_ANISOTROPIC | BRDF_RECIPROCAL,
           "anisotropic cosine lobe with Fresnel over a diffuse base", "Ashikhmin and Shirley 2000")
#endif
