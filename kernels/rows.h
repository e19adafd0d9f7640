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

/*
 * Within each group of four lanes: the lower (higher) lanes of two vectors by turns, and their
 * lower (higher) pairs side by side. Each is one instruction on x86 (unpcklps, unpckhps, unpcklpd,
 * unpckhpd). They are spelled as shuffles of whole vectors where the compiler has such a thing:
 * from single elements it builds the result of all of them together, element by element.
 */
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define PT_SHUFFLE(p, q, ...) __builtin_shufflevector(p, q, __VA_ARGS__)
#endif
#endif
#ifndef PT_SHUFFLE
#define PT_SHUFFLE(p, q, ...) shuffle2(p, q, (brdf_uint)(__VA_ARGS__))
#endif
#if BRDF_LANES == 4
#define PT_ZIP_LOW(p, q) PT_SHUFFLE(p, q, 0, 4, 1, 5)
#define PT_ZIP_HIGH(p, q) PT_SHUFFLE(p, q, 2, 6, 3, 7)
#define PT_LOW_PAIRS(p, q) PT_SHUFFLE(p, q, 0, 1, 4, 5)
#define PT_HIGH_PAIRS(p, q) PT_SHUFFLE(p, q, 2, 3, 6, 7)
#elif BRDF_LANES == 8
#define PT_ZIP_LOW(p, q) PT_SHUFFLE(p, q, 0, 8, 1, 9, 4, 12, 5, 13)
#define PT_ZIP_HIGH(p, q) PT_SHUFFLE(p, q, 2, 10, 3, 11, 6, 14, 7, 15)
#define PT_LOW_PAIRS(p, q) PT_SHUFFLE(p, q, 0, 1, 8, 9, 4, 5, 12, 13)
#define PT_HIGH_PAIRS(p, q) PT_SHUFFLE(p, q, 2, 3, 10, 11, 6, 7, 14, 15)
#elif BRDF_LANES == 16
#define PT_ZIP_LOW(p, q) PT_SHUFFLE(p, q, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29)
#define PT_ZIP_HIGH(p, q)                                                                          \
    PT_SHUFFLE(p, q, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31)
#define PT_LOW_PAIRS(p, q)                                                                         \
    PT_SHUFFLE(p, q, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29)
#define PT_HIGH_PAIRS(p, q)                                                                        \
    PT_SHUFFLE(p, q, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31)
#endif

/* Transpose the 4 x 4 blocks of four vectors; its own inverse. */
static inline struct pt_quad pt_quad_transpose(struct pt_quad q)
{
    brdf_real ab_low = PT_ZIP_LOW(q.a, q.b);
    brdf_real cd_low = PT_ZIP_LOW(q.c, q.d);
    brdf_real ab_high = PT_ZIP_HIGH(q.a, q.b);
    brdf_real cd_high = PT_ZIP_HIGH(q.c, q.d);
    return pt_quad_make(PT_LOW_PAIRS(ab_low, cd_low), PT_HIGH_PAIRS(ab_low, cd_low),
                        PT_LOW_PAIRS(ab_high, cd_high), PT_HIGH_PAIRS(ab_high, cd_high));
}

/*
 * words[index .. index + 3] in every lane; index is a multiple of 4 and not negative. Several quads
 * of one record: move `words`, not `index`, so that the lanes of the index are taken apart only
 * once.
 */
static inline struct pt_quad pt_load_quad(BRDF_GLOBAL const float *words, brdf_int index)
{
#define PT_AT(k) *(BRDF_GLOBAL const float4 *)(words + as_uint(index.s##k))
    struct pt_quad rows = pt_quad_make(PT_BESIDE(PT_AT, 0, 4, 8, c), PT_BESIDE(PT_AT, 1, 5, 9, d),
                                       PT_BESIDE(PT_AT, 2, 6, a, e), PT_BESIDE(PT_AT, 3, 7, b, f));
#undef PT_AT
    return pt_quad_transpose(rows);
}

/* words[index .. index + 3] = q in every lane, the lower lanes first. */
static inline void pt_store_quad(BRDF_GLOBAL float *words, brdf_int index, struct pt_quad q)
{
    struct pt_quad rows = pt_quad_transpose(q);
#define PT_PUT(k, row, part) *(BRDF_GLOBAL float4 *)(words + as_uint(index.s##k)) = rows.row part
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

/* The 16 words of a record in every lane. */
struct pt_row {
    struct pt_quad q0;
    struct pt_quad q1;
    struct pt_quad q2;
    struct pt_quad q3;
};

static inline struct pt_row pt_load_row(BRDF_GLOBAL const float *words, brdf_int index)
{
    struct pt_row row;
    row.q0 = pt_load_quad(words, index);
    row.q1 = pt_load_quad(words + 4, index);
    row.q2 = pt_load_quad(words + 8, index);
    row.q3 = pt_load_quad(words + 12, index);
    return row;
}

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
