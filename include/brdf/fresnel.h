/*
 * fresnel.h - how much a smooth interface reflects, for unpolarised light.
 */
#ifndef BRDF_FRESNEL_H
#define BRDF_FRESNEL_H

#include "vec.h"

struct brdf_fresnel {
    brdf_real reflectance; /* [1], 0 to 1 */
    brdf_real cos_t;       /* cosine of the refracted direction, >= 0; 0 under total reflection */
};

/*
 * Dielectric, exact [Born and Wolf, Principles of Optics, 1.5.2]. cos_i in [0, 1]; eta is the index
 * of the far side over that of the near side.
 */
static inline struct brdf_fresnel brdf_fresnel_dielectric(brdf_real cos_i, brdf_real eta)
{
    brdf_real sin2_t = (1.0f - cos_i * cos_i) / (eta * eta);
    brdf_mask total = sin2_t >= 1.0f;
    brdf_real cos_t = sqrtf(brdf_max(1.0f - sin2_t, 0.0f));
    brdf_real parallel = (eta * cos_i - cos_t) / brdf_max(eta * cos_i + cos_t, 1e-12f);
    brdf_real perpendicular = (cos_i - eta * cos_t) / brdf_max(cos_i + eta * cos_t, 1e-12f);
    brdf_real mean = 0.5f * (parallel * parallel + perpendicular * perpendicular);
    struct brdf_fresnel result;
    /* At cos_i = 0 both denominators may vanish: the limit is total reflection. */
    result.reflectance = brdf_pick(total | (cos_i <= 0.0f), 1.0f, brdf_min(mean, 1.0f));
    result.cos_t = cos_t;
    return result;
}

/*
 * Conductor of complex index eta + i k against vacuum, exact for one wavelength [Born and Wolf,
 * 14.2; the real-valued form of Lazanyi and Szirmay-Kalos 2005]. cos_i in [0, 1], eta, k >= 0.
 */
static inline brdf_real brdf_fresnel_conductor_one(brdf_real cos_i, brdf_real eta, brdf_real k)
{
    brdf_real cos2 = cos_i * cos_i;
    brdf_real sin2 = 1.0f - cos2;
    brdf_real t0 = eta * eta - k * k - sin2;
    brdf_real a2_plus_b2 = sqrtf(t0 * t0 + 4.0f * eta * eta * (k * k));
    brdf_real a = sqrtf(brdf_max(0.5f * (a2_plus_b2 + t0), 0.0f));
    brdf_real t1 = a2_plus_b2 + cos2;
    brdf_real t2 = 2.0f * a * cos_i;
    brdf_real perpendicular = (t1 - t2) / brdf_max(t1 + t2, 1e-12f);
    brdf_real t3 = a2_plus_b2 * cos2 + sin2 * sin2;
    brdf_real t4 = t2 * sin2;
    brdf_real parallel = perpendicular * ((t3 - t4) / brdf_max(t3 + t4, 1e-12f));
    return brdf_clamp(0.5f * (parallel + perpendicular), 0.0f, 1.0f);
}

static inline brdf_rgb brdf_fresnel_conductor(brdf_real cos_i, brdf_rgb eta, brdf_rgb k)
{
    return brdf_rgb_make(brdf_fresnel_conductor_one(cos_i, eta.r, k.r),
                         brdf_fresnel_conductor_one(cos_i, eta.g, k.g),
                         brdf_fresnel_conductor_one(cos_i, eta.b, k.b));
}

/* What is reflected where `normal` is under a right angle, nearly [Schlick 1994, eq. 15]. */
static inline brdf_rgb brdf_fresnel_schlick(brdf_real cos_i, brdf_rgb normal)
{
    brdf_real x = 1.0f - cos_i;
    brdf_real x2 = x * x;
    brdf_real rise = x2 * x2 * x;
    return brdf_rgb_add(brdf_rgb_scale(normal, 1.0f - rise), brdf_gray(rise));
}

/*
 * Means over diffuse light, integrals of 2 F(cos) cos dcos. Of a conductor by four nodes of Gauss:
 * to 1e-3 for metals (k > 1), where F is smooth; of Schlick's approximation exact.
 */
static inline brdf_rgb brdf_fresnel_conductor_mean(brdf_rgb eta, brdf_rgb k)
{
    brdf_rgb a = brdf_rgb_scale(brdf_fresnel_conductor(0.0694318442f, eta, k), 0.0241523f);
    brdf_rgb b = brdf_rgb_scale(brdf_fresnel_conductor(0.3300094782f, eta, k), 0.2152141f);
    brdf_rgb c = brdf_rgb_scale(brdf_fresnel_conductor(0.6699905218f, eta, k), 0.4369311f);
    brdf_rgb d = brdf_rgb_scale(brdf_fresnel_conductor(0.9305681558f, eta, k), 0.3237026f);
    brdf_rgb sum = brdf_rgb_add(brdf_rgb_add(a, b), brdf_rgb_add(c, d));
    return brdf_rgb_make(brdf_min(sum.r, 1.0f), brdf_min(sum.g, 1.0f), brdf_min(sum.b, 1.0f));
}

static inline brdf_rgb brdf_fresnel_schlick_mean(brdf_rgb normal)
{
    return brdf_rgb_add(brdf_rgb_scale(normal, 20.0f / 21.0f), brdf_gray(1.0f / 21.0f));
}

#endif
