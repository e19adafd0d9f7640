/*
 * derivatives.h - how a place moves in the world with its texture coordinates, as in Mitsuba 3.
 */
#ifndef PT_DERIVATIVES_H
#define PT_DERIVATIVES_H

#include "meeting.h"

struct pt_derivatives {
    brdf_vec3 du; /* of the place by u, world space */
    brdf_vec3 dv;
};

/* a x + b y */
static inline brdf_vec3 pt_combine(brdf_vec3 a, brdf_real x, brdf_vec3 b, brdf_real y)
{
    return brdf_add(brdf_scale(a, x), brdf_scale(b, y));
}

/* Of a triangle with texture coordinates of its own; any two where they do not span anything. */
static inline struct pt_derivatives pt_triangle_derivatives(struct pt_world w, struct pt_meeting m,
                                                            struct pt_derivatives plain)
{
    brdf_mask has = m.primitive.shading >= 0;
    BRDF_GLOBAL const float *words = w.scene + w.settings->shading;
    struct pt_row row = pt_load_row(words, brdf_pick_int(has, m.primitive.shading, 0) * PT_ROW);
    brdf_real du1 = row.q2.d - row.q2.b;
    brdf_real dv1 = row.q3.a - row.q2.c;
    brdf_real du2 = row.q3.b - row.q2.b;
    brdf_real dv2 = row.q3.c - row.q2.c;
    brdf_real determinant = du1 * dv2 - dv1 * du2;
    brdf_mask spans = (determinant > 0.0f) | (determinant < 0.0f);
    brdf_real inverse = 1.0f / brdf_pick(spans, determinant, 1.0f);
    struct pt_derivatives d;
    d.du = brdf_scale(pt_combine(m.primitive.e1, dv2, m.primitive.e2, -dv1), inverse);
    d.dv = brdf_scale(pt_combine(m.primitive.e1, -du2, m.primitive.e2, du1), inverse);
    d.du = brdf_vec3_pick(spans, d.du, m.at.frame.s);
    d.dv = brdf_vec3_pick(spans, d.dv, m.at.frame.t);
    d.du = brdf_vec3_pick(has, d.du, plain.du);
    d.dv = brdf_vec3_pick(has, d.dv, plain.dv);
    return d;
}

/* u goes once around the axis, v from one pole to the other; at the poles u does not move. */
static inline struct pt_derivatives pt_sphere_derivatives(struct pt_meeting m)
{
    brdf_real per_radius = 1.0f / brdf_max(m.primitive.radius, 1e-30f);
    brdf_vec3 e3 = brdf_scale(brdf_cross(m.primitive.e1, m.primitive.e2), per_radius);
    e3 = brdf_scale(e3, brdf_pick(m.primitive.mirrored > 0.0f, -1.0f, 1.0f));
    brdf_vec3 out = brdf_scale(brdf_sub(m.at.p, m.primitive.p), per_radius * per_radius);
    brdf_real x = brdf_dot(out, m.primitive.e1);
    brdf_real y = brdf_dot(out, m.primitive.e2);
    brdf_real z = brdf_dot(out, e3);
    brdf_real off_axis = sqrtf(x * x + y * y);
    brdf_mask pole = off_axis < 1e-8f;
    brdf_real inverse = 1.0f / brdf_pick(pole, 1.0f, off_axis);
    brdf_real cosine = brdf_pick(pole, 1.0f, x * inverse);
    brdf_real sine = y * inverse;
    struct pt_derivatives d;
    d.du = brdf_scale(pt_combine(m.primitive.e1, -y, m.primitive.e2, x), 2.0f * BRDF_PI);
    brdf_vec3 along = pt_combine(m.primitive.e1, z * cosine, m.primitive.e2, z * sine);
    d.dv = brdf_scale(brdf_sub(along, brdf_scale(e3, off_axis)), BRDF_PI);
    return d;
}

static inline struct pt_derivatives pt_derivatives_at(struct pt_world w, struct pt_meeting m)
{
    struct pt_derivatives d;
    /* A disk: u is the radius, v turns. */
    brdf_mask disk = m.primitive.kind == PT_DISK;
    brdf_real u = m.hit.b;
    brdf_real v = m.hit.c;
    brdf_real inverse = 1.0f / brdf_max(sqrtf(u * u + v * v), 1e-8f);
    brdf_vec3 radial = pt_combine(m.primitive.e1, u * inverse, m.primitive.e2, v * inverse);
    brdf_vec3 around =
        brdf_scale(pt_combine(m.primitive.e1, -v, m.primitive.e2, u), 2.0f * BRDF_PI);
    d.du = brdf_vec3_pick(disk, radial, m.primitive.e1);
    d.dv = brdf_vec3_pick(disk, around, m.primitive.e2);
    if (PT_HAS(w.settings, PT_HAS_SHADING)) {
        d = pt_triangle_derivatives(w, m, d);
    }
    if (PT_HAS(w.settings, PT_HAS_SPHERES)) {
        brdf_mask sphere = m.primitive.kind == PT_SPHERE;
        struct pt_derivatives on = pt_sphere_derivatives(m);
        d.du = brdf_vec3_pick(sphere, on.du, d.du);
        d.dv = brdf_vec3_pick(sphere, on.dv, d.dv);
    }
    return d;
}

#endif
