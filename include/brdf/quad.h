/*
 * quad.h - four words that lie side by side in a table, gathered for a packet of lanes at once.
 *
 * A table of records is read a record a lane and then transposed: four loads of 16 bytes and two
 * shuffles for each vector of results cost a fraction of as many gathers of single words, and touch
 * a cache line once.
 */
#ifndef BRDF_QUAD_H
#define BRDF_QUAD_H

#include "dialect.h"

/* Words index, index + 1, index + 2, index + 3 of a table, in every lane. */
struct brdf_quad {
    brdf_real a;
    brdf_real b;
    brdf_real c;
    brdf_real d;
};

#if BRDF_LANES == 1

static inline struct brdf_quad brdf_gather_quad(BRDF_GLOBAL const float *table, brdf_int index)
{
    struct brdf_quad q;
    q.a = table[index];
    q.b = table[index + 1];
    q.c = table[index + 2];
    q.d = table[index + 3];
    return q;
}

#else

/*
 * The records of lanes k, k + 4, k + 8, k + 12 side by side in one vector; then, within each group
 * of four lanes, the lower (higher) lanes of two vectors by turns, and their lower (higher) pairs
 * side by side. Each of these is one instruction on x86 (unpcklps, unpckhps, unpcklpd, unpckhpd),
 * if it is spelled as a shuffle of whole vectors.
 */
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define BRDF_SHUFFLE(p, q, ...) __builtin_shufflevector(p, q, __VA_ARGS__)
#endif
#endif
#ifndef BRDF_SHUFFLE
#define BRDF_SHUFFLE(p, q, ...) shuffle2(p, q, (brdf_uint)(__VA_ARGS__))
#endif
#if BRDF_LANES == 4
#define BRDF_BESIDE(F, k0, k1, k2, k3) F(k0)
#define BRDF_ZIP_LOW(p, q) BRDF_SHUFFLE(p, q, 0, 4, 1, 5)
#define BRDF_ZIP_HIGH(p, q) BRDF_SHUFFLE(p, q, 2, 6, 3, 7)
#define BRDF_LOW_PAIRS(p, q) BRDF_SHUFFLE(p, q, 0, 1, 4, 5)
#define BRDF_HIGH_PAIRS(p, q) BRDF_SHUFFLE(p, q, 2, 3, 6, 7)
#elif BRDF_LANES == 8
#define BRDF_BESIDE(F, k0, k1, k2, k3) (brdf_real)(F(k0), F(k1))
#define BRDF_ZIP_LOW(p, q) BRDF_SHUFFLE(p, q, 0, 8, 1, 9, 4, 12, 5, 13)
#define BRDF_ZIP_HIGH(p, q) BRDF_SHUFFLE(p, q, 2, 10, 3, 11, 6, 14, 7, 15)
#define BRDF_LOW_PAIRS(p, q) BRDF_SHUFFLE(p, q, 0, 1, 8, 9, 4, 5, 12, 13)
#define BRDF_HIGH_PAIRS(p, q) BRDF_SHUFFLE(p, q, 2, 3, 10, 11, 6, 7, 14, 15)
#else
#define BRDF_BESIDE(F, k0, k1, k2, k3) (brdf_real)(F(k0), F(k1), F(k2), F(k3))
#define BRDF_ZIP_LOW(p, q)                                                                         \
    BRDF_SHUFFLE(p, q, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29)
#define BRDF_ZIP_HIGH(p, q)                                                                        \
    BRDF_SHUFFLE(p, q, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31)
#define BRDF_LOW_PAIRS(p, q)                                                                       \
    BRDF_SHUFFLE(p, q, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29)
#define BRDF_HIGH_PAIRS(p, q)                                                                      \
    BRDF_SHUFFLE(p, q, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31)
#endif

/* Four floats anywhere. (PoCL makes two loads of vload4.) */
typedef float4 brdf_four_floats __attribute__((aligned(4)));

static inline struct brdf_quad brdf_gather_quad(BRDF_GLOBAL const float *table, brdf_int index)
{
#define BRDF_LANE(k) *(BRDF_GLOBAL const brdf_four_floats *)(table + as_uint(index.s##k))
    brdf_real row0 = BRDF_BESIDE(BRDF_LANE, 0, 4, 8, c);
    brdf_real row1 = BRDF_BESIDE(BRDF_LANE, 1, 5, 9, d);
    brdf_real row2 = BRDF_BESIDE(BRDF_LANE, 2, 6, a, e);
    brdf_real row3 = BRDF_BESIDE(BRDF_LANE, 3, 7, b, f);
#undef BRDF_LANE
    brdf_real low01 = BRDF_ZIP_LOW(row0, row1);
    brdf_real low23 = BRDF_ZIP_LOW(row2, row3);
    brdf_real high01 = BRDF_ZIP_HIGH(row0, row1);
    brdf_real high23 = BRDF_ZIP_HIGH(row2, row3);
    struct brdf_quad q;
    q.a = BRDF_LOW_PAIRS(low01, low23);
    q.b = BRDF_HIGH_PAIRS(low01, low23);
    q.c = BRDF_LOW_PAIRS(high01, high23);
    q.d = BRDF_HIGH_PAIRS(high01, high23);
    return q;
}

#endif

#endif
