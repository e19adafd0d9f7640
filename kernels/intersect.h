/*
 * intersect.h - where a ray meets a primitive.
 *
 * Rays and primitives both come as lane values. A packet of rays against one primitive passes the
 * primitive's values for all lanes alike; one ray against a leaf of primitives passes the ray's.
 * The arithmetic is the same, so both find the same bits.
 */
#ifndef PT_INTERSECT_H
#define PT_INTERSECT_H

#include "brdf/vec.h"
#include "scene.h"

#define PT_MISS_T 3.0e38f /* the hit distance of a ray that meets nothing */

struct pt_ray {
    brdf_vec3 o; /* origin */
    brdf_vec3 d; /* direction, unit */
};

/* A distance of PT_MISS_T or more means no hit; then u and v mean nothing. */
struct pt_distance {
    brdf_real t; /* along the ray, world units */
    brdf_real u; /* planar: the coordinates on it, to PT_EDGE; sphere: 0 */
    brdf_real v;
};

/*
 * A triangle, rectangle or disk made ready. x - p = u e1 + v e2 on its plane, and the dual vectors
 * a and b read the coordinates off: u = (x - p) . a, v = (x - p) . b [Baldwin and Weber 2016].
 *
 * Why not Moeller and Trumbore: for a ray that grazes the plane their u, v and t come from three
 * quotients of rounding errors, and may report a hit of something that the ray passes far away.
 * Here u and v belong to a point of the ray itself, so that the ray does pass the primitive to a
 * few units in the last place of t and size; the hierarchy (bvh.h) relies on it.
 */
struct pt_plane {
    brdf_vec3 p;
    brdf_vec3 n; /* normal, largest component 1; 0 where there is no area: then nothing hits it */
    brdf_vec3 a;
    brdf_vec3 b;
};

/* A triangle with |sin(e1, e2)| below about this has no area: its coordinates would be noise. */
#define PT_SLIVER 7.62939453e-6f /* 2^-17 */

/* u and v may be this far outside, so that rounding opens no crack along the edge of neighbours. */
#define PT_EDGE 3.81469727e-6f /* 2^-18 */

static inline brdf_real pt_largest_component(brdf_vec3 v)
{
    return brdf_max(fabsf(v.x), brdf_max(fabsf(v.y), fabsf(v.z)));
}

/*
 * e1 x e2, as the product of the two shortest sides of the triangle: they meet at its largest
 * angle, so that the plane of a needle is as exact as any other. (a x b would not do: nearly
 * parallel, they hold too few digits of it.)
 */
static inline brdf_vec3 pt_plane_product(brdf_vec3 e1, brdf_vec3 e2)
{
    brdf_vec3 e3 = brdf_sub(e2, e1);
    brdf_real square1 = brdf_dot(e1, e1);
    brdf_real square2 = brdf_dot(e2, e2);
    brdf_real square3 = brdf_dot(e3, e3);
    brdf_mask drop1 = (square1 > square2) & (square1 > square3);
    brdf_mask drop2 = (square2 >= square1) & (square2 > square3);
    return brdf_cross(brdf_vec3_pick(drop1, brdf_negate(e3), e1), brdf_vec3_pick(drop2, e3, e2));
}

/* Lengths of e1 and e2 from 1e-18 to 1e18, or 0. */
static inline struct pt_plane pt_plane_make(brdf_vec3 p, brdf_vec3 e1, brdf_vec3 e2)
{
    brdf_vec3 product = pt_plane_product(e1, e2);
    brdf_real size = pt_largest_component(product);
    brdf_mask solid = size > PT_SLIVER * pt_largest_component(e1) * pt_largest_component(e2);
    /* n is scaled before it is multiplied again: lengths to the fourth power would overflow. */
    brdf_real shrink = brdf_pick(solid, 1.0f / brdf_pick(solid, size, 1.0f), 0.0f);
    struct pt_plane plane;
    plane.p = p;
    plane.n = brdf_scale(product, shrink);
    brdf_real scale = 1.0f / brdf_pick(solid, brdf_dot(product, plane.n), 1.0f);
    plane.a = brdf_scale(brdf_cross(e2, plane.n), scale);
    plane.b = brdf_scale(brdf_cross(plane.n, e1), scale);
    return plane;
}

/* From both sides, at t > 0. */
static inline struct pt_distance pt_plane_distance(struct pt_ray ray, struct pt_plane plane,
                                                   brdf_int kind)
{
    brdf_vec3 from = brdf_sub(ray.o, plane.p);
    brdf_real slope = brdf_dot(ray.d, plane.n);
    brdf_mask facing = (slope > 0.0f) | (slope < 0.0f);
    brdf_real t = -brdf_dot(from, plane.n) / brdf_pick(facing, slope, 1.0f);
    brdf_vec3 at = brdf_add(from, brdf_scale(ray.d, t));
    brdf_real u = brdf_dot(at, plane.a);
    brdf_real v = brdf_dot(at, plane.b);
    brdf_real far = brdf_pick(kind == PT_TRIANGLE, u + v, brdf_max(u, v));
    brdf_mask inside = (u >= -PT_EDGE) & (v >= -PT_EDGE) & (far <= 1.0f + PT_EDGE);
    inside = brdf_pick_int(kind == PT_DISK, u * u + v * v <= 1.0f, inside);
    struct pt_distance hit;
    hit.t = brdf_pick(facing & inside & (t > 0.0f), t, PT_MISS_T);
    hit.u = u;
    hit.v = v;
    return hit;
}

/* The same for one that was not made ready; where it is met often, keep its pt_plane instead. */
static inline struct pt_distance pt_planar_distance(struct pt_ray ray, brdf_vec3 p, brdf_vec3 e1,
                                                    brdf_vec3 e2, brdf_int kind)
{
    return pt_plane_distance(ray, pt_plane_make(p, e1, e2), kind);
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
