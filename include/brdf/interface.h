/*
 * interface.h - what the models of transparent layers share: refraction, and how much of diffuse
 * light an interface reflects.
 *
 * `eta` is the index of the far side over that of the near side, above 0.
 */
#ifndef BRDF_INTERFACE_H
#define BRDF_INTERFACE_H

#include "fresnel.h"
#include "math.h"

/*
 * w refracted by a facet with the unit normal h on w's side: `cosine` is that of w to h, `cos_t`
 * that of the result to -h (Snell's law, of both fresnel.h). Away from the surface, as w.
 */
static inline brdf_vec3 brdf_refract(brdf_vec3 w, brdf_vec3 h, brdf_real cosine, brdf_real cos_t,
                                     brdf_real eta)
{
    brdf_vec3 along = brdf_scale(h, cosine / eta - cos_t);
    return brdf_sub(along, brdf_scale(w, 1.0f / eta));
}

/*
 * Reflectance of a dielectric interface that refracts, from the cosines on both sides, > 0. It is
 * the same from either side, and with both cosines nothing cancels near total reflection.
 */
static inline brdf_real brdf_fresnel_between(brdf_real cos_near, brdf_real cos_far, brdf_real eta)
{
    brdf_real parallel = (eta * cos_near - cos_far) / brdf_max(eta * cos_near + cos_far, 1e-12f);
    brdf_real perpendicular =
        (cos_near - eta * cos_far) / brdf_max(cos_near + eta * cos_far, 1e-12f);
    return brdf_min(0.5f * (parallel * parallel + perpendicular * perpendicular), 1.0f);
}

/*
 * What a denser far side reflects of diffuse light, the integral of 2 F(cos) cos dcos for eta >= 1
 * [Duntley 1942; d'Eon 2021, A Hitchhiker's Guide to Multiple Scattering]. The closed form, written
 * in t = (eta - 1) / (eta + 1): then no term is infinite for eta = 1, and none cancels another
 * there. (atanh(t) / t - 1) / t^2, which would, is a series where t is small. To 1e-6.
 */
static inline brdf_real brdf_interface_mean_dense(brdf_real eta)
{
    brdf_real t = (eta - 1.0f) / (eta + 1.0f);
    brdf_real t2 = t * t;
    brdf_mask small = t < 0.35f;
    brdf_real wide = brdf_pick(small, 0.35f, t);
    brdf_real series =
        0.3333333333f +
        t2 * (0.2f + t2 * (0.1428571429f +
                           t2 * (0.1111111111f + t2 * (0.0909090909f + t2 * 0.0769230769f))));
    brdf_real quotient = (0.5f * brdf_log(eta) / wide - 1.0f) / (wide * wide);
    brdf_real g = brdf_pick(small, series, quotient);

    brdf_real rational = 0.6666666667f + t * 0.25f;
    rational = 3.0f + t * (1.333333333f + t * rational);
    rational = t2 * (-2.0f + t * (0.5f + t * rational));
    rational = t * (0.5833333333f + t * (3.666666667f + rational));
    brdf_real sum2 = brdf_sqr(1.0f + t);
    brdf_real logarithm = 2.0f * (t2 * sum2) * brdf_log(brdf_max(t, 1e-20f));
    brdf_real area = sum2 * brdf_sqr((1.0f + t) * (1.0f - t)) * (1.0f + t2 * (6.0f + t2));
    brdf_real q = 1.0f + t2;
    brdf_real mean = (rational + logarithm + 0.25f * area * t * g) / (q * q * q);
    return brdf_clamp(mean, 0.0f, 1.0f);
}

/*
 * The part of diffuse light that passes the interface, for any eta > 0: 1 minus the mean
 * reflectance. As much passes one way as the other, for the same radiance: T(1 / eta) = T(eta) /
 * eta^2.
 */
static inline brdf_real brdf_interface_pass(brdf_real eta)
{
    brdf_mask dense = eta >= 1.0f;
    brdf_real pass = 1.0f - brdf_interface_mean_dense(brdf_pick(dense, eta, 1.0f / eta));
    return brdf_pick(dense, pass, pass * (eta * eta));
}

/*
 * What a diffuse base below an interface sends up for a unit of diffuse light that has come in: the
 * sum over all reflections between the two, albedo / (1 - albedo K), K being what the interface
 * reflects from within. `escape` is 1 - K, > 0. With shift = 0, albedo / (1 - K): the colour of the
 * base does not depend on K.
 */
static inline brdf_real brdf_interface_base_one(brdf_real albedo, brdf_real escape, int shift)
{
    return albedo / (shift ? (1.0f - albedo) + albedo * escape : escape);
}

static inline brdf_rgb brdf_interface_base(brdf_rgb albedo, brdf_real escape, int shift)
{
    return brdf_rgb_make(brdf_interface_base_one(albedo.r, escape, shift),
                         brdf_interface_base_one(albedo.g, escape, shift),
                         brdf_interface_base_one(albedo.b, escape, shift));
}

#endif
