/*
 * frame.h - the local shading frame: z is the normal, x the tangent that anisotropy refers to.
 */
#ifndef BRDF_FRAME_H
#define BRDF_FRAME_H

#include "vec.h"

struct brdf_frame {
    brdf_vec3 s; /* tangent, local x */
    brdf_vec3 t; /* bitangent, local y */
    brdf_vec3 n; /* normal, local z */
};
typedef struct brdf_frame brdf_frame;

/* Any frame around the unit normal n, continuous but for n.z = 0 [Duff et al. 2017, listing 3]. */
static inline brdf_frame brdf_frame_from_normal(brdf_vec3 n)
{
    brdf_frame frame;
    brdf_real sign = brdf_pick(n.z < 0.0f, -1.0f, 1.0f);
    brdf_real a = -1.0f / (sign + n.z);
    brdf_real b = n.x * n.y * a;
    frame.s = brdf_vec3_make(1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x);
    frame.t = brdf_vec3_make(b, sign + n.y * n.y * a, -n.y);
    frame.n = n;
    return frame;
}

/* The frame around n whose s lies along `tangent`; where that is parallel to n, any frame. */
static inline brdf_frame brdf_frame_from_tangent(brdf_vec3 n, brdf_vec3 tangent)
{
    brdf_frame any = brdf_frame_from_normal(n);
    brdf_vec3 s = brdf_sub(tangent, brdf_scale(n, brdf_dot(n, tangent)));
    brdf_real square = brdf_dot(s, s);
    brdf_mask valid = square > 1e-20f;
    brdf_real inverse = 1.0f / sqrtf(brdf_pick(valid, square, 1.0f));
    brdf_frame frame;
    frame.s = brdf_vec3_pick(valid, brdf_scale(s, inverse), any.s);
    frame.t = brdf_cross(n, frame.s);
    frame.n = n;
    return frame;
}

static inline brdf_vec3 brdf_to_local(brdf_frame frame, brdf_vec3 world)
{
    return brdf_vec3_make(brdf_dot(world, frame.s), brdf_dot(world, frame.t),
                          brdf_dot(world, frame.n));
}

static inline brdf_vec3 brdf_to_world(brdf_frame frame, brdf_vec3 w)
{
    return brdf_add(brdf_add(brdf_scale(frame.s, w.x), brdf_scale(frame.t, w.y)),
                    brdf_scale(frame.n, w.z));
}

#endif
