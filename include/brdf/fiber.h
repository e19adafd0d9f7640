/*
 * fiber.h - light that parallel fibres scatter below a smooth surface: a highlight on a cone around
 * them, seen through the refraction of the surface.
 *
 * Marschner, Westin, Arbree and Moon 2005, who take their fibres from Marschner et al.
 * 2003 (hair): a mirror that is a cylinder sends light of inclination psi to the plane across the
 * fibre to all directions of inclination -psi, a cone; irregular fibres blur the cone.
 */
#ifndef BRDF_FIBER_H
#define BRDF_FIBER_H

#include "frame.h"
#include "math.h"

struct brdf_fiber {
    brdf_frame frame; /* n along the fibre; s, across it, leans to the surface's normal */
    brdf_real beta;   /* [rad] how far the cone is blurred: a standard deviation, > 0 */
    brdf_real eta;    /* index below the surface over that above, >= 1 */
};

/* `axis` need not be unit; that of zero length stands upright. */
static inline struct brdf_fiber brdf_fiber_make(brdf_vec3 axis, brdf_real beta, brdf_real eta)
{
    struct brdf_fiber fiber;
    fiber.frame = brdf_frame_from_tangent(brdf_normalize(axis), brdf_vec3_make(0.0f, 0.0f, 1.0f));
    fiber.beta = beta;
    fiber.eta = eta;
    return fiber;
}

/* The square of the cosine under which grazing light goes on below the surface. */
static inline brdf_real brdf_fiber_critical2(brdf_real eta)
{
    return (eta - 1.0f) * (eta + 1.0f) / (eta * eta);
}

/* A direction above the surface, refracted; it still points away from what it meets there. */
static inline brdf_vec3 brdf_fiber_inside(brdf_vec3 w, brdf_real eta)
{
    brdf_real z = w.z / eta;
    return brdf_vec3_make(w.x / eta, w.y / eta, sqrtf(brdf_fiber_critical2(eta) + z * z));
}

/* And back; z = 0 where it does not get out. From z, as x and y say little of it at grazing. */
static inline brdf_vec3 brdf_fiber_outside(brdf_vec3 w, brdf_real eta)
{
    brdf_real critical = sqrtf(brdf_fiber_critical2(eta));
    brdf_real z2 = (w.z - critical) * (w.z + critical);
    return brdf_normalize(brdf_vec3_make(w.x * eta, w.y * eta, eta * sqrtf(brdf_max(z2, 0.0f))));
}

/* Inclination psi of a direction to the plane across the fibre. */
struct brdf_fiber_angle {
    brdf_real sin;
    brdf_real cos; /* >= 0 */
    brdf_real psi; /* [rad], in [-pi/2, pi/2] */
};

static inline struct brdf_fiber_angle brdf_fiber_angle_of(struct brdf_fiber fiber, brdf_vec3 w)
{
    struct brdf_fiber_angle angle;
    brdf_real s = brdf_dot(w, fiber.frame.s);
    brdf_real t = brdf_dot(w, fiber.frame.t);
    angle.sin = brdf_dot(w, fiber.frame.n);
    angle.cos = sqrtf(s * s + t * t);
    angle.psi = brdf_atan2(angle.sin, angle.cos);
    return angle;
}

/*
 * The Gaussian g(beta, psi) [1/rad], with integral 1 over psi: divided by beta, not multiplied as
 * in the shader that came with the paper.
 */
static inline brdf_real brdf_fiber_gauss(brdf_real beta, brdf_real psi)
{
    brdf_real x = psi / beta;
    return brdf_exp(-0.5f * (x * x)) * 0.398942280f / beta;
}

/*
 * g(beta, psi_h) / cos^2(psi_d / 2) [1/sr], psi_h the sum and psi_d the difference of the
 * inclinations inside. The cosine accounts for the cone, which shrinks with its angle.
 */
static inline brdf_real brdf_fiber_lobe(struct brdf_fiber fiber, brdf_vec3 wo, brdf_vec3 wi)
{
    struct brdf_fiber_angle o = brdf_fiber_angle_of(fiber, brdf_fiber_inside(wo, fiber.eta));
    struct brdf_fiber_angle i = brdf_fiber_angle_of(fiber, brdf_fiber_inside(wi, fiber.eta));
    brdf_real cos2 = 0.5f * (1.0f + (o.cos * i.cos + o.sin * i.sin));
    return brdf_fiber_gauss(fiber.beta, o.psi + i.psi) / brdf_max(cos2, 1e-6f);
}

/*
 * The inclinations that get out of the surface, and the Gaussian around the cone's, cut off there.
 * Where less than 1 % of it is left, all inclinations count the same.
 */
struct brdf_fiber_cone {
    brdf_real low; /* [rad] */
    brdf_real high;
    brdf_real center;
    brdf_real erf_low;
    brdf_real mass; /* of the Gaussian in between [1] */
    brdf_mask even;
};

static inline struct brdf_fiber_cone brdf_fiber_cone_of(struct brdf_fiber fiber, brdf_vec3 wo)
{
    struct brdf_fiber_cone cone;
    brdf_real normal = brdf_atan2(fiber.frame.n.z, fiber.frame.s.z);
    brdf_real reach = brdf_asin(1.0f / fiber.eta);
    cone.low = brdf_max(normal - reach, -0.5f * BRDF_PI);
    cone.high = brdf_min(normal + reach, 0.5f * BRDF_PI);
    cone.center = -brdf_fiber_angle_of(fiber, brdf_fiber_inside(wo, fiber.eta)).psi;
    brdf_real scale = 0.707106781f / fiber.beta;
    cone.erf_low = brdf_erf((cone.low - cone.center) * scale);
    cone.mass = 0.5f * (brdf_erf((cone.high - cone.center) * scale) - cone.erf_low);
    cone.even = cone.mass < 0.01f;
    return cone;
}

/* Half the arc [rad] around the fibre of what has this inclination and gets out. */
static inline brdf_real brdf_fiber_arc(struct brdf_fiber fiber, brdf_real sine, brdf_real cosine)
{
    brdf_real above = sqrtf(brdf_fiber_critical2(fiber.eta)) - sine * fiber.frame.n.z;
    brdf_real across = brdf_max(cosine * fiber.frame.s.z, 1e-7f);
    return brdf_max(brdf_acos(brdf_clamp(above / across, -1.0f, 1.0f)), 1e-4f);
}

/* Density [1/sr] of the directions of brdf_fiber_sample, above the surface. */
static inline brdf_real brdf_fiber_pdf(struct brdf_fiber fiber, struct brdf_fiber_cone cone,
                                       brdf_vec3 wi)
{
    brdf_vec3 inside = brdf_fiber_inside(wi, fiber.eta);
    struct brdf_fiber_angle i = brdf_fiber_angle_of(fiber, inside);
    brdf_real gauss = brdf_fiber_gauss(fiber.beta, i.psi - cone.center);
    brdf_real density =
        brdf_pick(cone.even, 1.0f / (cone.high - cone.low), gauss / brdf_max(cone.mass, 1e-3f));
    density = density / (2.0f * brdf_fiber_arc(fiber, i.sin, i.cos) * brdf_max(i.cos, 1e-7f));
    /* Refraction: cos dw = eta^2 cos' dw'. */
    return density * wi.z / brdf_max(fiber.eta * fiber.eta * inside.z, 1e-37f);
}

/* A direction above the surface, z = 0 if it did not get there, for u, v in [0, 1). */
static inline brdf_vec3 brdf_fiber_sample(struct brdf_fiber fiber, struct brdf_fiber_cone cone,
                                          brdf_real u, brdf_real v)
{
    brdf_real x = brdf_erfinv(cone.erf_low + 2.0f * cone.mass * u);
    brdf_real psi = brdf_pick(cone.even, cone.low + (cone.high - cone.low) * u,
                              cone.center + 1.41421356f * fiber.beta * x);
    struct brdf_sincos turn = brdf_sincos(brdf_clamp(psi, cone.low, cone.high));
    brdf_real phi = (2.0f * v - 1.0f) * brdf_fiber_arc(fiber, turn.sin, brdf_max(turn.cos, 0.0f));
    struct brdf_sincos around = brdf_sincos(phi);
    brdf_vec3 w = brdf_vec3_make(turn.cos * around.cos, turn.cos * around.sin, turn.sin);
    return brdf_fiber_outside(brdf_to_world(fiber.frame, w), fiber.eta);
}

#endif
