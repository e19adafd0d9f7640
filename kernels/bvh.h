/*
 * bvh.h - one ray through a hierarchy of boxes, 16 wide: the children of a node and the primitives
 * of a leaf are the lanes, so that the same data serves every lane count.
 *
 * What it finds is, bit for bit, what a loop over all primitives finds: the smallest distance, and
 * of equal distances the smallest primitive number. For that a box must never be missed whose
 * primitive the ray hits, rounding included:
 *
 * A reported hit (intersect.h) is at a point o + t d of the ray that is off the true primitive by
 * no more than a few rounding errors of t, of |o - p| and of the primitive's size. The last is the
 * builder's to add to the box (lib/brdfcl/bvh.c). For the others, and for the rounding of the box
 * test itself, every box is widened by a distance that is PT_BVH_SLACK times what t can be at most,
 * which costs nothing: it goes into the origin that is subtracted from the planes. As the order of
 * visits does not matter then, it is chosen for speed alone.
 */
#ifndef PT_BVH_H
#define PT_BVH_H

#include "bvh_leaf.h"

/*
 * The node array starts with one line (16 words) about the whole, then come the nodes, then, as an
 * array of their own, the leaves. Line k of a record holds one word of each child or primitive.
 * A reference is the line at which a node begins, or ~(4 * line + PT_LEAF_...) for a leaf.
 */
enum pt_bvh_word {
    PT_BVH_CENTRE = 0, /* 3 words: of the box of everything */
    PT_BVH_HALF = 3    /* 3 words: half its extent */
};

enum pt_node_line {
    PT_NODE_LOWER = 0, /* 3 lines: x, y, z */
    PT_NODE_UPPER = 3, /* 3 lines */
    PT_NODE_CHILD = 6, /* int: a reference; lanes without a child have lower > upper */
    PT_NODE_LINES = 7
};

#define PT_BVH_DEPTH 20 /* levels of nodes at most; the builder keeps to it */
#define PT_BVH_STACK (PT_BVH_DEPTH * (PT_WIDTH - 1))
#define PT_BVH_NOWHERE (-2147483647 - 1) /* no reference: lines are fewer than 2^27 */
#define PT_BVH_SLACK 4.0e-6f    /* 67 units of rounding; the analysis above needs about 40 */
#define PT_BVH_ROUNDING 2.4e-7f /* of the widened origin itself: 4 units */
#define PT_BVH_STEEP 1.0e-18f   /* a smaller component of a direction is as good as 0 */

struct pt_bvh_ray {
    float ox, oy, oz;
    float dx, dy, dz; /* unit */
};

/* One axis of a ray as the box test wants it. */
struct pt_axis {
    float inverse; /* 1 / d */
    float near;    /* the origin that the near plane is measured from: o, moved to widen the box */
    float far;
    int near_line; /* line of the plane that is met first */
    int far_line;
};

static inline struct pt_axis pt_axis_make(float o, float d, float slack, int axis)
{
    struct pt_axis a;
    float widen = slack + PT_BVH_ROUNDING * (o < 0.0f ? -o : o);
    int down = d < 0.0f;
    int flat = d < PT_BVH_STEEP && d > -PT_BVH_STEEP;
    a.inverse = 1.0f / (flat ? (down ? -PT_BVH_STEEP : PT_BVH_STEEP) : d);
    a.near = down ? o - widen : o + widen;
    a.far = down ? o + widen : o - widen;
    a.near_line = (down ? PT_NODE_UPPER : PT_NODE_LOWER) + axis;
    a.far_line = (down ? PT_NODE_LOWER : PT_NODE_UPPER) + axis;
    return a;
}

/* How far |o - centre| + half an extent reaches along one axis. */
static inline float pt_bvh_reach(float o, float centre, float half_extent)
{
    float from = o - centre;
    return (from < 0.0f ? -from : from) + half_extent;
}

/* A ray on its way through the hierarchy. */
struct pt_walk {
    struct pt_axis x;
    struct pt_axis y;
    struct pt_axis z;
    struct pt_ray ray; /* in every lane */
    int top;
    int stack[PT_BVH_STACK];   /* references */
    float entry[PT_BVH_STACK]; /* the distances at which the ray enters them */
};

static inline void pt_walk_start(struct pt_walk *walk, BRDF_GLOBAL const float *nodes,
                                 struct pt_bvh_ray ray)
{
    BRDF_GLOBAL const float *centre = nodes + PT_BVH_CENTRE;
    BRDF_GLOBAL const float *extent = nodes + PT_BVH_HALF;
    float slack = PT_BVH_SLACK * (pt_bvh_reach(ray.ox, centre[0], extent[0]) +
                                  pt_bvh_reach(ray.oy, centre[1], extent[1]) +
                                  pt_bvh_reach(ray.oz, centre[2], extent[2]));
    walk->x = pt_axis_make(ray.ox, ray.dx, slack, 0);
    walk->y = pt_axis_make(ray.oy, ray.dy, slack, 1);
    walk->z = pt_axis_make(ray.oz, ray.dz, slack, 2);
    walk->ray.o = brdf_vec3_make(ray.ox, ray.oy, ray.oz);
    walk->ray.d = brdf_vec3_make(ray.dx, ray.dy, ray.dz);
    walk->top = 0;
}

static inline brdf_real pt_near_plane(BRDF_GLOBAL const float *node, struct pt_axis axis)
{
    return (pt_load_chunk(node + axis.near_line * PT_WIDTH) - axis.near) * axis.inverse;
}

static inline brdf_real pt_far_plane(BRDF_GLOBAL const float *node, struct pt_axis axis)
{
    return (pt_load_chunk(node + axis.far_line * PT_WIDTH) - axis.far) * axis.inverse;
}

/* Which children the ray enters before `far`, as bits, and at what distances. */
static inline unsigned pt_node_test(BRDF_GLOBAL const float *node, const struct pt_walk *walk,
                                    float far, union pt_sixteen *entry)
{
    unsigned bits = 0u;
    brdf_real zero = 0.0f;
    brdf_real limit = far;
    for (int i = 0; i < PT_CHUNKS; ++i) {
        BRDF_GLOBAL const float *chunk = node + i * BRDF_LANES;
        brdf_real first =
            brdf_max(brdf_max(zero, pt_near_plane(chunk, walk->x)),
                     brdf_max(pt_near_plane(chunk, walk->y), pt_near_plane(chunk, walk->z)));
        brdf_real last =
            brdf_min(brdf_min(limit, pt_far_plane(chunk, walk->x)),
                     brdf_min(pt_far_plane(chunk, walk->y), pt_far_plane(chunk, walk->z)));
        entry->chunk[i] = first;
        bits |= pt_mask_bits(first <= last) << (i * BRDF_LANES);
    }
    return bits;
}

/* The nearest of the children that were entered; the others go on the stack. */
static inline int pt_walk_down(struct pt_walk *walk, BRDF_GLOBAL const float *node, unsigned bits,
                               const union pt_sixteen *entry)
{
    BRDF_GLOBAL const float *child = node + PT_NODE_CHILD * PT_WIDTH;
    int k = pt_lowest_bit(bits);
    int nearest = pt_int_bits(child[k]);
    float distance = entry->one[k];
    for (bits &= bits - 1u; bits; bits &= bits - 1u) {
        k = pt_lowest_bit(bits);
        int other = pt_int_bits(child[k]);
        float other_distance = entry->one[k];
        int nearer = other_distance < distance;
        walk->stack[walk->top] = nearer ? nearest : other;
        walk->entry[walk->top] = nearer ? distance : other_distance;
        walk->top += 1;
        nearest = nearer ? other : nearest;
        distance = nearer ? other_distance : distance;
    }
    return nearest;
}

/* The last that was put on the stack and is entered before `far`; PT_BVH_NOWHERE if none is. */
static inline int pt_walk_on(struct pt_walk *walk, float far)
{
    int reference = PT_BVH_NOWHERE;
    while (walk->top > 0 && reference == PT_BVH_NOWHERE) {
        walk->top -= 1;
        if (walk->entry[walk->top] <= far) {
            reference = walk->stack[walk->top];
        }
    }
    return reference;
}

/* The first primitive along the ray, t > 0; the smallest number where several are equally near. */
PT_OWN_FRAME struct pt_hit_record pt_bvh_closest(BRDF_GLOBAL const struct pt_settings *settings,
                                                 BRDF_GLOBAL const float *scene,
                                                 struct pt_bvh_ray ray)
{
    BRDF_GLOBAL const float *nodes = scene + settings->nodes;
    BRDF_GLOBAL const float *leaves = scene + settings->leaves;
    struct pt_hit_record best = {PT_MISS_T, 0.0f, 0.0f, -1};
    struct pt_walk walk;
    pt_walk_start(&walk, nodes, ray);
    int at = settings->root;
    while (at != PT_BVH_NOWHERE) {
        unsigned bits = 0u;
        if (at < 0) {
            int leaf = ~at;
            best = pt_leaf_closest(leaves + (leaf >> 2) * PT_WIDTH, walk.ray, leaf & 3, best);
        } else {
            union pt_sixteen entry;
            BRDF_GLOBAL const float *node = nodes + at * PT_WIDTH;
            bits = pt_node_test(node, &walk, best.t, &entry);
            if (bits) {
                at = pt_walk_down(&walk, node, bits, &entry);
            }
        }
        if (!bits) {
            at = pt_walk_on(&walk, best.t);
        }
    }
    return best;
}

/* Is there a primitive at 0 < t < tmax? tmax is at most PT_MISS_T. */
PT_OWN_FRAME int pt_bvh_occluded(BRDF_GLOBAL const struct pt_settings *settings,
                                 BRDF_GLOBAL const float *scene, struct pt_bvh_ray ray, float tmax)
{
    BRDF_GLOBAL const float *nodes = scene + settings->nodes;
    BRDF_GLOBAL const float *leaves = scene + settings->leaves;
    int occluded = 0;
    struct pt_walk walk;
    pt_walk_start(&walk, nodes, ray);
    int at = settings->root;
    while (at != PT_BVH_NOWHERE && !occluded) {
        unsigned bits = 0u;
        if (at < 0) {
            int leaf = ~at;
            occluded = pt_leaf_occluded(leaves + (leaf >> 2) * PT_WIDTH, walk.ray, leaf & 3, tmax);
        } else {
            union pt_sixteen entry;
            BRDF_GLOBAL const float *node = nodes + at * PT_WIDTH;
            bits = pt_node_test(node, &walk, tmax, &entry);
            if (bits) {
                at = pt_walk_down(&walk, node, bits, &entry);
            }
        }
        if (!bits) {
            at = pt_walk_on(&walk, tmax);
        }
    }
    return occluded;
}

#endif
