/*
 * dialect.h - one language out of two: C99, and OpenCL C 1.2 at 1, 4, 8 or 16 lanes.
 *
 * Every other shared header is ordinary C99 over the names below. This is the only file that asks
 * which compiler is reading, so it is the only place to look when a port goes wrong.
 *
 *   brdf_real   a value of the computation: float in C; float, float4, float8, float16 in OpenCL
 *   brdf_int    an integer of the same number of lanes
 *   brdf_uint   an unsigned integer of the same number of lanes
 *   brdf_mask   what a comparison yields: 0 is false; combine with &, | and !, never && or ||
 *   BRDF_COEFFICIENTS  a pointer into an array that is BRDF_CONSTANT
 *   BRDF_UNROLL before a loop of constant length whose counter chooses what is to live in registers
 *
 * Infix operators mean the same lane by lane in both languages. What C spells with a statement
 * (choose, convert, gather) has a function here. `float`, `int` and `unsigned` stay what they are:
 * one value for all lanes.
 *
 * Words that OpenCL C keeps for itself cannot be names: local, global, private, constant, kernel,
 * half.
 *
 * OpenCL: define BRDF_LANES (1, 4, 8 or 16; default 1) before the first include.
 */
#ifndef BRDF_DIALECT_H
#define BRDF_DIALECT_H

#ifdef __OPENCL_VERSION__

#pragma OPENCL FP_CONTRACT OFF

#ifndef BRDF_LANES
#define BRDF_LANES 1
#endif

#undef inline /* PoCL has one of its own */
/* A packet's values live in registers: a call would take them all through memory. */
#define inline __attribute__((always_inline)) inline

#define BRDF_GLOBAL __global
#define BRDF_UNROLL _Pragma("unroll")
#define BRDF_CONSTANT __constant
#define BRDF_COEFFICIENTS __constant float *

#if BRDF_LANES == 1
typedef float brdf_real;
typedef int brdf_int;
typedef uint brdf_uint;
#define BRDF_AS_REAL as_float
#define BRDF_AS_INT as_int
#define BRDF_AS_UINT as_uint
#define BRDF_TO_REAL convert_float
#define BRDF_TO_INT convert_int
#define BRDF_EACH_LANE(F) (F(0))
#elif BRDF_LANES == 4
typedef float4 brdf_real;
typedef int4 brdf_int;
typedef uint4 brdf_uint;
#define BRDF_AS_REAL as_float4
#define BRDF_AS_INT as_int4
#define BRDF_AS_UINT as_uint4
#define BRDF_TO_REAL convert_float4
#define BRDF_TO_INT convert_int4
#define BRDF_EACH_LANE(F) (F(0), F(1), F(2), F(3))
#elif BRDF_LANES == 8
typedef float8 brdf_real;
typedef int8 brdf_int;
typedef uint8 brdf_uint;
#define BRDF_AS_REAL as_float8
#define BRDF_AS_INT as_int8
#define BRDF_AS_UINT as_uint8
#define BRDF_TO_REAL convert_float8
#define BRDF_TO_INT convert_int8
#define BRDF_EACH_LANE(F) (F(0), F(1), F(2), F(3), F(4), F(5), F(6), F(7))
#elif BRDF_LANES == 16
typedef float16 brdf_real;
typedef int16 brdf_int;
typedef uint16 brdf_uint;
#define BRDF_AS_REAL as_float16
#define BRDF_AS_INT as_int16
#define BRDF_AS_UINT as_uint16
#define BRDF_TO_REAL convert_float16
#define BRDF_TO_INT convert_int16
#define BRDF_EACH_LANE(F)                                                                          \
    (F(0), F(1), F(2), F(3), F(4), F(5), F(6), F(7), F(8), F(9), F(a), F(b), F(c), F(d), F(e), F(f))
#else
#error "BRDF_LANES must be 1, 4, 8 or 16"
#endif
typedef brdf_int brdf_mask;

/* OpenCL adapts to C, so that nothing leaks into a client's C files. */
#define sqrtf(x) sqrt(x)
#define fabsf(x) fabs(x)
#define floorf(x) floor(x)

#else /* C99 */

#include <math.h>
#include <string.h>

#undef BRDF_LANES
#define BRDF_LANES 1
#define BRDF_GLOBAL
#define BRDF_UNROLL
#define BRDF_CONSTANT static const
#define BRDF_COEFFICIENTS const float *

typedef float brdf_real;
typedef int brdf_int;
typedef unsigned brdf_uint;
typedef brdf_int brdf_mask;

#endif

/* The same truth in every lane. (A vector mask is true by its top bit, so that 1 is not enough.) */
static inline brdf_mask brdf_mask_of(int truth)
{
    brdf_int lanes = truth;
    return lanes != 0;
}

/* pick: mask ? yes : no in every lane. Both arms are computed, so both must be finite. */
static inline brdf_real brdf_pick(brdf_mask mask, brdf_real yes, brdf_real no)
{
    return mask ? yes : no;
}

static inline brdf_int brdf_pick_int(brdf_mask mask, brdf_int yes, brdf_int no)
{
    return mask ? yes : no;
}

static inline brdf_uint brdf_pick_uint(brdf_mask mask, brdf_uint yes, brdf_uint no)
{
    return mask ? yes : no;
}

#ifdef __OPENCL_VERSION__

/* The bits of a float as an integer, and back. */
static inline brdf_int brdf_bits(brdf_real x)
{
    return BRDF_AS_INT(x);
}

static inline brdf_real brdf_from_bits(brdf_int bits)
{
    return BRDF_AS_REAL(bits);
}

static inline brdf_uint brdf_uint_of(brdf_int x)
{
    return BRDF_AS_UINT(x);
}

static inline brdf_int brdf_int_of(brdf_uint x)
{
    return BRDF_AS_INT(x);
}

/* Truncating conversion; |x| < 2^31 is the caller's promise. */
static inline brdf_int brdf_to_int(brdf_real x)
{
    return BRDF_TO_INT(x);
}

static inline brdf_real brdf_to_real(brdf_int x)
{
    return BRDF_TO_REAL(x);
}

/* table[index] in every lane. */
static inline brdf_real brdf_gather(BRDF_GLOBAL const float *table, brdf_int index)
{
#if BRDF_LANES == 1
    return table[index];
#else
#define BRDF_LANE(k) table[index.s##k]
    return (brdf_real)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

static inline brdf_int brdf_gather_int(BRDF_GLOBAL const int *table, brdf_int index)
{
#if BRDF_LANES == 1
    return table[index];
#else
#define BRDF_LANE(k) table[index.s##k]
    return (brdf_int)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

/* Is the mask true in some lane? One answer for all lanes: a branch on it is fine. By halves, for
   any() may become a branch for each lane. */
static inline int brdf_any(brdf_mask mask)
{
#if BRDF_LANES == 1
    return mask != 0;
#else
#if BRDF_LANES == 16
    int8 by8 = mask.lo | mask.hi;
    int4 by4 = by8.lo | by8.hi;
#elif BRDF_LANES == 8
    int4 by4 = mask.lo | mask.hi;
#else
    int4 by4 = mask;
#endif
    int2 by2 = by4.lo | by4.hi;
    return (by2.x | by2.y) != 0;
#endif
}

/* 0, 1, 2 ... : the number of each lane. */
static inline brdf_int brdf_lane_numbers(void)
{
#if BRDF_LANES == 1
    return 0;
#else
#define BRDF_LANE(k) 0x##k
    return (brdf_int)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

#else /* C99 */

static inline brdf_int brdf_bits(brdf_real x)
{
    brdf_int bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline brdf_real brdf_from_bits(brdf_int bits)
{
    brdf_real x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static inline brdf_uint brdf_uint_of(brdf_int x)
{
    return (brdf_uint)x;
}

static inline brdf_int brdf_int_of(brdf_uint x)
{
    brdf_int i;
    memcpy(&i, &x, sizeof i);
    return i;
}

static inline brdf_int brdf_to_int(brdf_real x)
{
    return (brdf_int)x;
}

static inline brdf_real brdf_to_real(brdf_int x)
{
    return (brdf_real)x;
}

static inline brdf_real brdf_gather(BRDF_GLOBAL const float *table, brdf_int index)
{
    return table[index];
}

static inline brdf_int brdf_gather_int(BRDF_GLOBAL const int *table, brdf_int index)
{
    return table[index];
}

static inline int brdf_any(brdf_mask mask)
{
    return mask != 0;
}

static inline brdf_int brdf_lane_numbers(void)
{
    return 0;
}

#endif

/*
 * The smaller and the larger of two, decided by one comparison, so that every compiler must agree:
 * where the comparison is false (equal zeros of different sign, a NaN) the first argument is kept.
 */
static inline brdf_real brdf_min(brdf_real a, brdf_real b)
{
    return brdf_pick(b < a, b, a);
}

static inline brdf_real brdf_max(brdf_real a, brdf_real b)
{
    return brdf_pick(b > a, b, a);
}

/* Within low and high, come what may: a NaN becomes low, so that an index made of it is one. */
static inline brdf_real brdf_clamp(brdf_real x, brdf_real low, brdf_real high)
{
    return brdf_min(high, brdf_max(low, x));
}

#endif
