/*
 * disney.h - the lobes of Burley's principled model beside its facets: diffuse light and what lies
 * under a grazing eye, sheen, clearcoat, and its way from artists' parameters to roughness.
 *
 * Burley, Physically Based Shading at Disney, 2012: sections 5.2 (parameters), 5.3 (diffuse), 5.4
 * (distributions, clearcoat), 5.5 (Fresnel), 5.6 (masking), and the appendix (GTR). Burley,
 * Extending the Disney BRDF to a BSDF, 2015: the diffuse lobe apart from its retro-reflection.
 */
#ifndef BRDF_DISNEY_H
#define BRDF_DISNEY_H

#include "math.h"
#include "vec.h"

/* Schlick's (1 - cos)^5. */
static inline brdf_real brdf_disney_grazing(brdf_real cosine)
{
    brdf_real x = brdf_clamp(1.0f - cosine, 0.0f, 1.0f);
    return (x * x) * (x * x) * x;
}

static inline brdf_rgb brdf_disney_mix_rgb(brdf_rgb a, brdf_rgb b, brdf_real share)
{
    return brdf_rgb_add(brdf_rgb_scale(a, 1.0f - share), brdf_rgb_scale(b, share));
}

/* The hue of a colour: it has the luminance 1. That of black is white. */
static inline brdf_rgb brdf_disney_tint(brdf_rgb color)
{
    brdf_real luminance = brdf_rgb_luminance(color);
    brdf_mask dark = luminance < 1e-12f;
    brdf_rgb tint = brdf_rgb_scale(color, 1.0f / brdf_pick(dark, 1.0f, luminance));
    return brdf_rgb_pick(dark, brdf_gray(1.0f), tint);
}

struct brdf_disney_alpha {
    brdf_real u; /* along the tangent; never below 1/1000 */
    brdf_real v;
};

/* roughness^2, stretched by up to 10 to 1 [Burley 2012]. */
static inline struct brdf_disney_alpha brdf_disney_alpha_of(brdf_real roughness,
                                                            brdf_real anisotropic)
{
    struct brdf_disney_alpha alpha;
    brdf_real aspect = sqrtf(1.0f - 0.9f * anisotropic);
    brdf_real square = roughness * roughness;
    alpha.u = brdf_max(square / aspect, 0.001f);
    alpha.v = brdf_max(square * aspect, 0.001f);
    return alpha;
}

/*
 * f [1/sr] of a white base: Lambert's that fades where Fresnel takes the light, plus the light that
 * rough ones send back at grazing [Burley 2015]; `flatness` goes over to the look of
 * subsurface scattering, after Hanrahan and Krueger [Burley 2012, 5.3]. cos_d is that of wo or wi
 * to the half vector.
 */
static inline brdf_real brdf_disney_diffuse(brdf_real cos_o, brdf_real cos_i, brdf_real cos_d,
                                            brdf_real roughness, brdf_real flatness)
{
    brdf_real o = brdf_disney_grazing(cos_o);
    brdf_real i = brdf_disney_grazing(cos_i);
    brdf_real back = 2.0f * roughness * (cos_d * cos_d);
    brdf_real fading = (1.0f - 0.5f * o) * (1.0f - 0.5f * i);
    brdf_real retro = back * ((o + i) + o * i * (back - 1.0f));
    brdf_real flat90 = 0.5f * back;
    brdf_real flat = brdf_mix(1.0f, flat90, o) * brdf_mix(1.0f, flat90, i);
    brdf_real inverse = 1.0f / brdf_max(cos_o + cos_i, 1e-20f);
    flat = 1.25f * (flat * (inverse - 0.5f) + 0.5f);
    return BRDF_1_PI * brdf_mix(fading + retro, flat, flatness);
}

/* GTR of exponent 1, 0 < alpha < 1: density of normals [1/sr]. h is unit, z >= 0. */
static inline brdf_real brdf_gtr1_d(brdf_vec3 h, brdf_real alpha)
{
    brdf_real alpha2 = alpha * alpha;
    /* 1 + (alpha^2 - 1) cos^2, of which nothing cancels. */
    brdf_real spread = (h.x * h.x + h.y * h.y) + alpha2 * (h.z * h.z);
    return (alpha2 - 1.0f) / (BRDF_PI * brdf_log(alpha2) * brdf_max(spread, 1e-20f));
}

/* A normal with the density D(h) cos(h) [1/sr] for u, v in [0, 1). */
static inline brdf_vec3 brdf_gtr1_sample(brdf_real alpha, brdf_real u, brdf_real v)
{
    brdf_real alpha2 = alpha * alpha;
    brdf_real power = brdf_exp(brdf_log(alpha2) * (1.0f - v));
    brdf_real sin2 = brdf_clamp((power - alpha2) / (1.0f - alpha2), 0.0f, 1.0f);
    brdf_real sine = sqrtf(sin2);
    struct brdf_sincos turn = brdf_sincos_2pi(u);
    return brdf_vec3_make(sine * turn.cos, sine * turn.sin, sqrtf(1.0f - sin2));
}

/* From the gloss of a clearcoat to its roughness [Burley 2012]. */
static inline brdf_real brdf_disney_coat_alpha(brdf_real gloss)
{
    return brdf_mix(0.1f, 0.001f, gloss);
}

/* cos(w) (1 + Lambda(w)) of GGX with roughness 1/4, which masks every clearcoat. */
static inline brdf_real brdf_disney_coat_area(brdf_real cosine)
{
    brdf_real cos2 = cosine * cosine;
    return 0.5f * (cosine + sqrtf(cos2 + 0.0625f * (1.0f - brdf_min(cos2, 1.0f))));
}

#endif
