/*
 * bvh_leaf.h - one ray against a leaf of the hierarchy: up to 16 primitives of any kind, as lanes.
 *
 * A leaf is lines of 16 words: line k holds one word of each primitive.
 */
#ifndef PT_BVH_LEAF_H
#define PT_BVH_LEAF_H

#include "intersect.h"
#include "lanes.h"

enum pt_leaf_line {
    PT_LEAF_P = 0,       /* 3 lines: struct pt_plane, or the centre of a sphere */
    PT_LEAF_N = 3,       /* 3 lines; sphere: radius, 0, 0 */
    PT_LEAF_A = 6,       /* 3 lines */
    PT_LEAF_B = 9,       /* 3 lines */
    PT_LEAF_KIND = 12,   /* int: PT_TRIANGLE ... */
    PT_LEAF_NUMBER = 13, /* int: of the primitive; lanes without one have n = 0, which never hits */
    PT_LEAF_LINES = 14
};

/* What a leaf holds, in the two lowest bits of ~reference. */
#define PT_LEAF_SPHERES 1
#define PT_LEAF_KINDS 2 /* not only triangles */

struct pt_hit_record {
    float t; /* PT_MISS_T: nothing is met */
    float u;
    float v;
    int prim; /* number of the primitive, or -1 */
};

/* Where the ray meets the primitives of a chunk of a leaf. */
static inline struct pt_distance pt_leaf_test(BRDF_GLOBAL const float *chunk, struct pt_ray ray,
                                              int content)
{
#define PT_LEAF_LINE(line) pt_load_chunk(chunk + (line)*PT_WIDTH)
#define PT_LEAF_VECTOR(line)                                                                       \
    brdf_vec3_make(PT_LEAF_LINE(line), PT_LEAF_LINE(line + 1), PT_LEAF_LINE(line + 2))
    brdf_int kind = PT_TRIANGLE;
    if (content & PT_LEAF_KINDS) {
        kind = pt_load_chunk_int(chunk + PT_LEAF_KIND * PT_WIDTH);
    }
    struct pt_plane plane;
    plane.p = PT_LEAF_VECTOR(PT_LEAF_P);
    plane.n = PT_LEAF_VECTOR(PT_LEAF_N);
    plane.a = PT_LEAF_VECTOR(PT_LEAF_A);
    plane.b = PT_LEAF_VECTOR(PT_LEAF_B);
    struct pt_distance hit = pt_plane_distance(ray, plane, kind);
    if (content & PT_LEAF_SPHERES) {
        struct pt_distance round = pt_sphere_distance(ray, plane.p, plane.n.x);
        brdf_mask is_sphere = kind == PT_SPHERE;
        hit.t = brdf_pick(is_sphere, round.t, hit.t);
        hit.u = brdf_pick(is_sphere, round.u, hit.u);
        hit.v = brdf_pick(is_sphere, round.v, hit.v);
    }
    return hit;
#undef PT_LEAF_LINE
#undef PT_LEAF_VECTOR
}

/* Take over what is nearer in a leaf, or as near with a smaller number. */
static inline struct pt_hit_record pt_leaf_closest(BRDF_GLOBAL const float *leaf, struct pt_ray ray,
                                                   int content, struct pt_hit_record best)
{
    union pt_sixteen t;
    union pt_sixteen u;
    union pt_sixteen v;
    unsigned bits = 0u;
    for (int i = 0; i < PT_CHUNKS; ++i) {
        struct pt_distance hit = pt_leaf_test(leaf + i * BRDF_LANES, ray, content);
        t.chunk[i] = hit.t;
        u.chunk[i] = hit.u;
        v.chunk[i] = hit.v;
        bits |= pt_mask_bits((hit.t <= best.t) & (hit.t < PT_MISS_T)) << (i * BRDF_LANES);
    }
    for (; bits; bits &= bits - 1u) {
        int k = pt_lowest_bit(bits);
        int number = pt_int_bits(leaf[PT_LEAF_NUMBER * PT_WIDTH + k]);
        if (t.one[k] < best.t || (t.one[k] == best.t && number < best.prim)) {
            best.t = t.one[k];
            best.u = u.one[k];
            best.v = v.one[k];
            best.prim = number;
        }
    }
    return best;
}

static inline int pt_leaf_occluded(BRDF_GLOBAL const float *leaf, struct pt_ray ray, int content,
                                   float tmax)
{
    int hit = 0;
    for (int i = 0; i < PT_CHUNKS; ++i) {
        hit |= brdf_any(pt_leaf_test(leaf + i * BRDF_LANES, ray, content).t < tmax);
    }
    return hit;
}

#endif
