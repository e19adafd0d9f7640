/*
 * quad.h - four words that lie side by side in a table, gathered for a packet of lanes at once.
 *
 * A table of records is read a record a lane and then transposed: four loads of 16 bytes and two
 * shuffles for each vector of results cost a fraction of as many gathers of single words, and touch
 * a cache line once.
 */
#ifndef BRDF_QUAD_H
#define BRDF_QUAD_H

#include "real.h"

/* Words index, index + 1, index + 2, index + 3 of a table, in every lane. */
struct brdf_quad {
    brdf_real a;
    brdf_real b;
    brdf_real c;
    brdf_real d;
};

static inline struct brdf_quad brdf_quad_make(brdf_real a, brdf_real b, brdf_real c, brdf_real d)
{
    struct brdf_quad q;
    q.a = a;
    q.b = b;
    q.c = c;
    q.d = d;
    return q;
}

/* The same word by word. */
static inline struct brdf_quad brdf_quad_mix(struct brdf_quad p, struct brdf_quad q,
                                             struct brdf_quad t)
{
    return brdf_quad_make(brdf_mix(p.a, q.a, t.a), brdf_mix(p.b, q.b, t.b), brdf_mix(p.c, q.c, t.c),
                          brdf_mix(p.d, q.d, t.d));
}

#if BRDF_LANES == 1

static inline struct brdf_quad brdf_quad_transpose(struct brdf_quad q)
{
    return q;
}

static inline struct brdf_quad brdf_quad_spread(brdf_real t)
{
    return brdf_quad_make(t, t, t, t);
}

static inline struct brdf_quad brdf_gather_records(BRDF_GLOBAL const float *table, brdf_int index)
{
    return brdf_quad_make(table[index], table[index + 1], table[index + 2], table[index + 3]);
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
#define BRDF_REPEAT(t, k) BRDF_SHUFFLE(t, t, k, k, k, k)
#elif BRDF_LANES == 8
#define BRDF_BESIDE(F, k0, k1, k2, k3) (brdf_real)(F(k0), F(k1))
#define BRDF_ZIP_LOW(p, q) BRDF_SHUFFLE(p, q, 0, 8, 1, 9, 4, 12, 5, 13)
#define BRDF_ZIP_HIGH(p, q) BRDF_SHUFFLE(p, q, 2, 10, 3, 11, 6, 14, 7, 15)
#define BRDF_LOW_PAIRS(p, q) BRDF_SHUFFLE(p, q, 0, 1, 8, 9, 4, 5, 12, 13)
#define BRDF_HIGH_PAIRS(p, q) BRDF_SHUFFLE(p, q, 2, 3, 10, 11, 6, 7, 14, 15)
#define BRDF_REPEAT(t, k) BRDF_SHUFFLE(t, t, k, k, k, k, k + 4, k + 4, k + 4, k + 4)
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
#define BRDF_REPEAT(t, k)                                                                          \
    BRDF_SHUFFLE(t, t, k, k, k, k, k + 4, k + 4, k + 4, k + 4, k + 8, k + 8, k + 8, k + 8, k + 12, \
                 k + 12, k + 12, k + 12)
#endif

/* Transpose the 4 x 4 blocks of four vectors; its own inverse. */
static inline struct brdf_quad brdf_quad_transpose(struct brdf_quad q)
{
    brdf_real ab_low = BRDF_ZIP_LOW(q.a, q.b);
    brdf_real cd_low = BRDF_ZIP_LOW(q.c, q.d);
    brdf_real ab_high = BRDF_ZIP_HIGH(q.a, q.b);
    brdf_real cd_high = BRDF_ZIP_HIGH(q.c, q.d);
    return brdf_quad_make(BRDF_LOW_PAIRS(ab_low, cd_low), BRDF_HIGH_PAIRS(ab_low, cd_low),
                          BRDF_LOW_PAIRS(ab_high, cd_high), BRDF_HIGH_PAIRS(ab_high, cd_high));
}

/* Four floats anywhere. (PoCL makes two loads of vload4.) */
typedef float4 brdf_four_floats __attribute__((aligned(4)));

/* A number of each lane, beside the words of that lane's record. */
static inline struct brdf_quad brdf_quad_spread(brdf_real t)
{
    return brdf_quad_make(BRDF_REPEAT(t, 0), BRDF_REPEAT(t, 1), BRDF_REPEAT(t, 2),
                          BRDF_REPEAT(t, 3));
}

/*
 * The records at an index, not transposed yet: what is blended with numbers that are spread like
 * them needs to be transposed once only, after that. Of several records in a fixed distance move
 * `table`, not `index`, so that the lanes of the index are taken apart only once. An index is not
 * negative.
 */
static inline struct brdf_quad brdf_gather_records(BRDF_GLOBAL const float *table, brdf_int index)
{
#define BRDF_LANE(k) *(BRDF_GLOBAL const brdf_four_floats *)(table + as_uint(index.s##k))
    return brdf_quad_make(BRDF_BESIDE(BRDF_LANE, 0, 4, 8, c), BRDF_BESIDE(BRDF_LANE, 1, 5, 9, d),
                          BRDF_BESIDE(BRDF_LANE, 2, 6, a, e), BRDF_BESIDE(BRDF_LANE, 3, 7, b, f));
#undef BRDF_LANE
}

#endif

/* The four words at an index, in every lane. */
static inline struct brdf_quad brdf_gather_quad(BRDF_GLOBAL const float *table, brdf_int index)
{
    return brdf_quad_transpose(brdf_gather_records(table, index));
}

#endif
