/*
 * tilt.h - normal maps and bump maps: the shading frame turned as a texture says.
 *
 * As in Mitsuba 3.9. The tilted normal is found relative to the shading frame; where it would turn
 * away from the viewer it is mirrored about the untilted one; directions that lie above one of the
 * two planes and below the other gain nothing; and light is dimmed towards the untilted horizon, as
 * the facets that a tilted normal stands for shadow each other [Estevez, Lecocq and Stellmack 2019,
 * "A microfacet-based shadowing function to solve the bump terminator problem", Ray Tracing Gems].
 */
#ifndef PT_TILT_H
#define PT_TILT_H

#include "derivatives.h"
#include "texture_gradient.h"

struct pt_tilt {
    brdf_frame frame; /* to shade in */
    brdf_vec3 up;     /* the normal that it was tilted from, on the viewer's side if two-sided */
    brdf_real alpha2; /* roughness of the facets, squared; 0: they do not shadow */
};

/* The square of the tangent of the angle to the normal. */
static inline brdf_real pt_tangent2(brdf_real cosine)
{
    brdf_real square = brdf_max(cosine * cosine, 1e-12f);
    return brdf_max(1.0f - square, 0.0f) / square;
}

/* The normal in the shading frame, from its components as colours: 0 to 1 stands for -1 to 1. */
static inline brdf_vec3 pt_tilt_normal(struct pt_world w,
                                       BRDF_GLOBAL const struct pt_surface *surface,
                                       struct pt_interaction at)
{
    brdf_rgb color = pt_texture_eval(w, surface->tilt_texture, at);
    return brdf_vec3_make(2.0f * color.r - 1.0f, 2.0f * color.g - 1.0f, 2.0f * color.b - 1.0f);
}

/* The normal in the shading frame, from a height above the surface: its derivatives move along. The
   change of the surface's own normal is left out, as the height is small. */
static inline brdf_vec3
pt_tilt_bump(struct pt_world w, BRDF_GLOBAL const struct pt_surface *surface, struct pt_meeting m)
{
    struct pt_gradient slope = pt_texture_gradient(w, surface->tilt_texture, m.at);
    struct pt_derivatives d = pt_derivatives_at(w, m);
    brdf_vec3 n = m.at.frame.n;
    brdf_real rise_u = surface->tilt_scale * slope.u - brdf_dot(n, d.du);
    brdf_real rise_v = surface->tilt_scale * slope.v - brdf_dot(n, d.dv);
    brdf_vec3 bumped =
        brdf_cross(brdf_add(d.du, brdf_scale(n, rise_u)), brdf_add(d.dv, brdf_scale(n, rise_v)));
    brdf_real side = brdf_pick(brdf_dot(m.at.ng, bumped) < 0.0f, -1.0f, 1.0f);
    return brdf_to_local(m.at.frame, brdf_scale(bumped, side));
}

/* Unit; upright where there is nothing to make it of. */
static inline brdf_vec3 pt_tilt_unit(brdf_vec3 n)
{
    brdf_real square = brdf_dot(n, n);
    brdf_mask valid = square > 1e-24f;
    brdf_real inverse = 1.0f / sqrtf(brdf_pick(valid, square, 1.0f));
    return brdf_vec3_pick(valid, brdf_scale(n, inverse), brdf_vec3_make(0.0f, 0.0f, 1.0f));
}

static inline struct pt_tilt pt_tilt_at(struct pt_world w, unsigned how,
                                        BRDF_GLOBAL const struct pt_surface *surface,
                                        struct pt_meeting m)
{
    brdf_vec3 n =
        how & PT_TILT_BUMP ? pt_tilt_bump(w, surface, m) : pt_tilt_normal(w, surface, m.at);
    n = pt_tilt_unit(n);
    brdf_frame base = m.at.frame;
    brdf_vec3 wo = brdf_to_local(base, brdf_negate(m.ray.d));
    if (how & PT_TILT_TWOSIDED) {
        brdf_real side = brdf_pick(wo.z < 0.0f, -1.0f, 1.0f);
        base.n = brdf_scale(base.n, side);
        wo.z = wo.z * side;
    }
    if (how & PT_TILT_FACE) {
        brdf_mask away = wo.z * brdf_dot(wo, n) <= 0.0f;
        n.x = brdf_pick(away, -n.x, n.x);
        n.y = brdf_pick(away, -n.y, n.y);
    }
    brdf_frame turned = brdf_frame_from_tangent(n, brdf_vec3_make(1.0f, 0.0f, 0.0f));
    struct pt_tilt tilt;
    tilt.frame.s = brdf_to_world(base, turned.s);
    tilt.frame.t = brdf_to_world(base, turned.t);
    tilt.frame.n = brdf_to_world(base, turned.n);
    tilt.up = base.n;
    tilt.alpha2 = how & PT_TILT_SHADOW ? brdf_min(0.125f * pt_tangent2(n.z), 1.0f) : 0.0f;
    return tilt;
}

static inline struct pt_tilt pt_tilt_none(struct pt_interaction at)
{
    struct pt_tilt tilt;
    tilt.frame = at.frame;
    tilt.up = at.frame.n;
    tilt.alpha2 = 0.0f;
    return tilt;
}

/* What f and weights are multiplied by, for wi in the world and in the tilted frame. */
static inline brdf_real pt_tilt_factor(struct pt_tilt tilt, brdf_vec3 wi, brdf_vec3 wi_local)
{
    brdf_real cosine = brdf_dot(tilt.up, wi);
    brdf_real shadow = 2.0f / (1.0f + sqrtf(1.0f + tilt.alpha2 * pt_tangent2(cosine)));
    return brdf_pick(cosine * wi_local.z > 0.0f, shadow, 0.0f);
}

#endif
