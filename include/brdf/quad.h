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
 * The records of lanes k, k + 4, k + 8, ... side by side in one vector; then, within each group
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

/* The same four places in every group of four lanes. */
#define BRDF_GROUP(g, i, j, k, l) (i) + 4 * (g), (j) + 4 * (g), (k) + 4 * (g), (l) + 4 * (g)
#if BRDF_LANES == 4
#define BRDF_GROUPS(i, j, k, l) BRDF_GROUP(0, i, j, k, l)
#define BRDF_BESIDE(F, k0, k1, k2, k3, k4, k5, k6, k7) F(k0)
#elif BRDF_LANES == 8
#define BRDF_GROUPS(i, j, k, l) BRDF_GROUP(0, i, j, k, l), BRDF_GROUP(1, i, j, k, l)
#define BRDF_BESIDE(F, k0, k1, k2, k3, k4, k5, k6, k7) (brdf_real)(F(k0), F(k1))
#elif BRDF_LANES == 16
#define BRDF_GROUPS(i, j, k, l)                                                                    \
    BRDF_GROUP(0, i, j, k, l), BRDF_GROUP(1, i, j, k, l), BRDF_GROUP(2, i, j, k, l),               \
        BRDF_GROUP(3, i, j, k, l)
#define BRDF_BESIDE(F, k0, k1, k2, k3, k4, k5, k6, k7) (brdf_real)(F(k0), F(k1), F(k2), F(k3))
#else
#define BRDF_GROUPS(i, j, k, l)                                                                    \
    BRDF_GROUP(0, i, j, k, l), BRDF_GROUP(1, i, j, k, l), BRDF_GROUP(2, i, j, k, l),               \
        BRDF_GROUP(3, i, j, k, l), BRDF_GROUP(4, i, j, k, l), BRDF_GROUP(5, i, j, k, l),           \
        BRDF_GROUP(6, i, j, k, l), BRDF_GROUP(7, i, j, k, l)
#define BRDF_BESIDE(F, k0, k1, k2, k3, k4, k5, k6, k7)                                             \
    (brdf_real)(F(k0), F(k1), F(k2), F(k3), F(k4), F(k5), F(k6), F(k7))
#endif
#define BRDF_ZIP_LOW(p, q) BRDF_SHUFFLE(p, q, BRDF_GROUPS(0, BRDF_LANES, 1, BRDF_LANES + 1))
#define BRDF_ZIP_HIGH(p, q) BRDF_SHUFFLE(p, q, BRDF_GROUPS(2, BRDF_LANES + 2, 3, BRDF_LANES + 3))
#define BRDF_LOW_PAIRS(p, q) BRDF_SHUFFLE(p, q, BRDF_GROUPS(0, 1, BRDF_LANES, BRDF_LANES + 1))
#define BRDF_HIGH_PAIRS(p, q) BRDF_SHUFFLE(p, q, BRDF_GROUPS(2, 3, BRDF_LANES + 2, BRDF_LANES + 3))
#define BRDF_REPEAT(t, k) BRDF_SHUFFLE(t, t, BRDF_GROUPS(k, k, k, k))

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
#define BRDF_LANE(k)                                                                               \
    *(BRDF_GLOBAL const brdf_four_floats *)(table + as_uint(BRDF_LANE_OF(index, k)))
    return brdf_quad_make(BRDF_BESIDE(BRDF_LANE, 0, 4, 8, c, g, k, o, s),
                          BRDF_BESIDE(BRDF_LANE, 1, 5, 9, d, h, l, p, t),
                          BRDF_BESIDE(BRDF_LANE, 2, 6, a, e, i, m, q, u),
                          BRDF_BESIDE(BRDF_LANE, 3, 7, b, f, j, n, r, v));
#undef BRDF_LANE
}

#endif

/* The four words at an index, in every lane. */
static inline struct brdf_quad brdf_gather_quad(BRDF_GLOBAL const float *table, brdf_int index)
{
    return brdf_quad_transpose(brdf_gather_records(table, index));
}

#endif
