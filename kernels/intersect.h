/*
 * intersect.h - where a ray meets a primitive.
 *
 * Rays and primitives both come as lane values. A packet of rays against one primitive passes the
 * primitive's values for all lanes alike; one ray against a leaf of primitives passes the ray's.
 * The arithmetic is the same, so both find the same bits.
 */
#ifndef PT_INTERSECT_H
#define PT_INTERSECT_H

#include "scene.h"

#define PT_MISS_T 3.0e38f /* the hit distance of a ray that meets nothing */

struct pt_ray {
    brdf_vec3 o; /* origin */
    brdf_vec3 d; /* direction, unit */
};

/* A distance of PT_MISS_T or more means no hit; then u and v are finite but mean nothing. */
struct pt_distance {
    brdf_real t; /* along the ray, world units */
    brdf_real u; /* planar: the coordinates on it; sphere: 0 */
    brdf_real v;
};

/* A triangle, rectangle or disk [Moeller and Trumbore 1997], both sides, at t > 0. */
static inline struct pt_distance pt_planar_distance(struct pt_ray ray, brdf_vec3 p, brdf_vec3 e1,
                                                    brdf_vec3 e2, brdf_int kind)
{
    brdf_vec3 across = brdf_cross(ray.d, e2);
    brdf_real determinant = brdf_dot(e1, across);
    brdf_mask facing = (determinant > 0.0f) | (determinant < 0.0f);
    brdf_real inverse = 1.0f / brdf_pick(facing, determinant, 1.0f);
    brdf_vec3 from = brdf_sub(ray.o, p);
    brdf_real u = brdf_dot(from, across) * inverse;
    brdf_vec3 along = brdf_cross(from, e1);
    brdf_real v = brdf_dot(ray.d, along) * inverse;
    brdf_real t = brdf_dot(e2, along) * inverse;
    brdf_real far = brdf_pick(kind == PT_TRIANGLE, u + v, brdf_max(u, v));
    brdf_mask inside = (brdf_min(u, v) >= 0.0f) & (far <= 1.0f);
    inside = brdf_pick_int(kind == PT_DISK, u * u + v * v <= 1.0f, inside);
    struct pt_distance hit;
    hit.t = brdf_pick(facing & inside & (t > 0.0f), t, PT_MISS_T);
    hit.u = u;
    hit.v = v;
    return hit;
}

/*
 * A sphere, from outside or inside, at t > 0. The discriminant is taken from the vector between the
 * centre and the nearest point of the ray, which keeps its digits for far and small spheres [Haines
 * et al., Ray Tracing Gems 2019, chapter 7].
 */
static inline struct pt_distance pt_sphere_distance(struct pt_ray ray, brdf_vec3 centre,
                                                    brdf_real radius)
{
    brdf_vec3 to = brdf_sub(centre, ray.o);
    brdf_real b = brdf_dot(to, ray.d);
    brdf_vec3 nearest = brdf_sub(to, brdf_scale(ray.d, b));
    brdf_real discriminant = radius * radius - brdf_dot(nearest, nearest);
    brdf_real root = sqrtf(brdf_max(discriminant, 0.0f));
    brdf_real c = brdf_dot(to, to) - radius * radius;
    /* The root of larger size first; the other from the product of roots, without cancellation. */
    brdf_real q = b + brdf_pick(b < 0.0f, -root, root);
    brdf_real other = c / brdf_pick(q == 0.0f, 1.0f, q);
    brdf_real t0 = brdf_min(q, other);
    brdf_real t1 = brdf_max(q, other);
    brdf_real t = brdf_pick(t0 > 0.0f, t0, t1);
    struct pt_distance hit;
    hit.t = brdf_pick((discriminant > 0.0f) & (t > 0.0f), t, PT_MISS_T);
    hit.u = 0.0f;
    hit.v = 0.0f;
    return hit;
}

#endif
