/*
 * rows.h - reading and writing records by index, a packet of lanes at a time.
 *
 * Paths, primitives and lights are records (an array of structs), not one array a field: a packet
 * whose lanes point anywhere touches one cache line a lane instead of one a lane and field, and the
 * transposition into lanes costs a few shuffles. The unit is the quad: four words on 16 bytes.
 */
#ifndef PT_ROWS_H
#define PT_ROWS_H

#include "brdf/vec.h"

/* Four words of a record in every lane. */
struct pt_quad {
    brdf_real a;
    brdf_real b;
    brdf_real c;
    brdf_real d;
};

static inline struct pt_quad pt_quad_make(brdf_real a, brdf_real b, brdf_real c, brdf_real d)
{
    struct pt_quad q;
    q.a = a;
    q.b = b;
    q.c = c;
    q.d = d;
    return q;
}

#if defined(__OPENCL_VERSION__) && BRDF_LANES > 1

/* The quads of lanes k, k + 4, k + 8, k + 12 side by side in one vector. */
#if BRDF_LANES == 4
#define PT_BESIDE(F, k0, k1, k2, k3) F(k0)
#elif BRDF_LANES == 8
#define PT_BESIDE(F, k0, k1, k2, k3) (brdf_real)(F(k0), F(k1))
#else
#define PT_BESIDE(F, k0, k1, k2, k3) (brdf_real)(F(k0), F(k1), F(k2), F(k3))
#endif

/* Within each group of four lanes: the even (odd) pairs, the even (odd) lanes of two vectors. */
#if BRDF_LANES == 4
#define PT_LOW_PAIRS(p, q) (brdf_real)(p.s01, q.s01)
#define PT_HIGH_PAIRS(p, q) (brdf_real)(p.s23, q.s23)
#define PT_EVEN(p, q) (brdf_real)(p.s0, q.s0, p.s2, q.s2)
#define PT_ODD(p, q) (brdf_real)(p.s1, q.s1, p.s3, q.s3)
#elif BRDF_LANES == 8
#define PT_LOW_PAIRS(p, q) (brdf_real)(p.s01, q.s01, p.s45, q.s45)
#define PT_HIGH_PAIRS(p, q) (brdf_real)(p.s23, q.s23, p.s67, q.s67)
#define PT_EVEN(p, q) (brdf_real)(p.s0, q.s0, p.s2, q.s2, p.s4, q.s4, p.s6, q.s6)
#define PT_ODD(p, q) (brdf_real)(p.s1, q.s1, p.s3, q.s3, p.s5, q.s5, p.s7, q.s7)
#else
#define PT_LOW_PAIRS(p, q) (brdf_real)(p.s01, q.s01, p.s45, q.s45, p.s89, q.s89, p.scd, q.scd)
#define PT_HIGH_PAIRS(p, q) (brdf_real)(p.s23, q.s23, p.s67, q.s67, p.sab, q.sab, p.sef, q.sef)
#define PT_EVEN(p, q)                                                                              \
    (brdf_real)(p.s0, q.s0, p.s2, q.s2, p.s4, q.s4, p.s6, q.s6, p.s8, q.s8, p.sa, q.sa, p.sc,      \
                q.sc, p.se, q.se)
#define PT_ODD(p, q)                                                                               \
    (brdf_real)(p.s1, q.s1, p.s3, q.s3, p.s5, q.s5, p.s7, q.s7, p.s9, q.s9, p.sb, q.sb, p.sd,      \
                q.sd, p.sf, q.sf)
#endif

/* Transpose the 4 x 4 blocks of four vectors; its own inverse. */
static inline struct pt_quad pt_quad_transpose(struct pt_quad q)
{
    brdf_real ac_low = PT_LOW_PAIRS(q.a, q.c);
    brdf_real ac_high = PT_HIGH_PAIRS(q.a, q.c);
    brdf_real bd_low = PT_LOW_PAIRS(q.b, q.d);
    brdf_real bd_high = PT_HIGH_PAIRS(q.b, q.d);
    return pt_quad_make(PT_EVEN(ac_low, bd_low), PT_ODD(ac_low, bd_low), PT_EVEN(ac_high, bd_high),
                        PT_ODD(ac_high, bd_high));
}

/* words[index .. index + 3] in every lane; index is a multiple of 4. */
static inline struct pt_quad pt_load_quad(BRDF_GLOBAL const float *words, brdf_int index)
{
#define PT_AT(k) *(BRDF_GLOBAL const float4 *)(words + index.s##k)
    struct pt_quad rows = pt_quad_make(PT_BESIDE(PT_AT, 0, 4, 8, c), PT_BESIDE(PT_AT, 1, 5, 9, d),
                                       PT_BESIDE(PT_AT, 2, 6, a, e), PT_BESIDE(PT_AT, 3, 7, b, f));
#undef PT_AT
    return pt_quad_transpose(rows);
}

/* words[index .. index + 3] = q in every lane, the lower lanes first. */
static inline void pt_store_quad(BRDF_GLOBAL float *words, brdf_int index, struct pt_quad q)
{
    struct pt_quad rows = pt_quad_transpose(q);
#define PT_PUT(k, row, part) *(BRDF_GLOBAL float4 *)(words + index.s##k) = rows.row part
#if BRDF_LANES == 4
    PT_PUT(0, a, );
    PT_PUT(1, b, );
    PT_PUT(2, c, );
    PT_PUT(3, d, );
#else
    PT_PUT(0, a, .s0123);
    PT_PUT(1, b, .s0123);
    PT_PUT(2, c, .s0123);
    PT_PUT(3, d, .s0123);
    PT_PUT(4, a, .s4567);
    PT_PUT(5, b, .s4567);
    PT_PUT(6, c, .s4567);
    PT_PUT(7, d, .s4567);
#endif
#if BRDF_LANES == 16
    PT_PUT(8, a, .s89ab);
    PT_PUT(9, b, .s89ab);
    PT_PUT(a, c, .s89ab);
    PT_PUT(b, d, .s89ab);
    PT_PUT(c, a, .scdef);
    PT_PUT(d, b, .scdef);
    PT_PUT(e, c, .scdef);
    PT_PUT(f, d, .scdef);
#endif
#undef PT_PUT
}

/* The integers at words[first ..], one a lane. */
static inline brdf_int pt_load_ints(BRDF_GLOBAL const int *words)
{
#if BRDF_LANES == 4
    return vload4(0, words);
#elif BRDF_LANES == 8
    return vload8(0, words);
#else
    return vload16(0, words);
#endif
}

static inline void pt_store_ints(BRDF_GLOBAL int *words, brdf_int values)
{
#if BRDF_LANES == 4
    vstore4(values, 0, words);
#elif BRDF_LANES == 8
    vstore8(values, 0, words);
#else
    vstore16(values, 0, words);
#endif
}

/* One lane of a vector by number, through memory: the number may change in a loop. */
union pt_lanes {
    brdf_int v;
    int lane[BRDF_LANES];
};

static inline union pt_lanes pt_lanes_of(brdf_int values)
{
    union pt_lanes lanes;
    lanes.v = values;
    return lanes;
}

#else /* one lane */

static inline struct pt_quad pt_load_quad(BRDF_GLOBAL const float *words, brdf_int index)
{
    return pt_quad_make(words[index], words[index + 1], words[index + 2], words[index + 3]);
}

static inline void pt_store_quad(BRDF_GLOBAL float *words, brdf_int index, struct pt_quad q)
{
    words[index] = q.a;
    words[index + 1] = q.b;
    words[index + 2] = q.c;
    words[index + 3] = q.d;
}

static inline brdf_int pt_load_ints(BRDF_GLOBAL const int *words)
{
    return words[0];
}

static inline void pt_store_ints(BRDF_GLOBAL int *words, brdf_int values)
{
    words[0] = values;
}

union pt_lanes {
    brdf_int v;
    int lane[1];
};

static inline union pt_lanes pt_lanes_of(brdf_int values)
{
    union pt_lanes lanes;
    lanes.v = values;
    return lanes;
}

#endif

/* The first three words of a quad as a vector or a colour, and back with a fourth. */
static inline brdf_vec3 pt_quad_vec3(struct pt_quad q)
{
    return brdf_vec3_make(q.a, q.b, q.c);
}

static inline brdf_rgb pt_quad_rgb(struct pt_quad q)
{
    return brdf_rgb_make(q.a, q.b, q.c);
}

static inline struct pt_quad pt_quad_of_vec3(brdf_vec3 v, brdf_real d)
{
    return pt_quad_make(v.x, v.y, v.z, d);
}

static inline struct pt_quad pt_quad_of_rgb(brdf_rgb c, brdf_real d)
{
    return pt_quad_make(c.r, c.g, c.b, d);
}

#endif
