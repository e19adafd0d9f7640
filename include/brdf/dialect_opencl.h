/*
 * dialect_opencl.h - the dialect (dialect.h) as OpenCL C 1.2: a packet of lanes is a vector.
 */
#ifndef BRDF_DIALECT_OPENCL_H
#define BRDF_DIALECT_OPENCL_H

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
#elif BRDF_LANES == 32
#include "dialect_wide.h"
#else
#error "BRDF_LANES must be 1, 4, 8, 16 or 32"
#endif
typedef brdf_int brdf_mask;

#if BRDF_LANES <= 16
/* A lane by its hexadecimal digit. */
#define BRDF_LANE_NUMBER(k) 0x##k
#define BRDF_LANE_OF(vector, k) (vector).s##k
/* OpenCL adapts to C, so that nothing leaks into a client's C files. */
#define sqrtf(x) sqrt(x)
#define fabsf(x) fabs(x)
#define floorf(x) floor(x)
#endif

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
#define BRDF_LANE(k) table[BRDF_LANE_OF(index, k)]
    return (brdf_real)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

static inline brdf_int brdf_gather_int(BRDF_GLOBAL const int *table, brdf_int index)
{
#if BRDF_LANES == 1
    return table[index];
#else
#define BRDF_LANE(k) table[BRDF_LANE_OF(index, k)]
    return (brdf_int)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

/* All lanes or'ed into one value, by halves: any() may become a branch for each lane. */
static inline int brdf_or_lanes(brdf_int x)
{
#if BRDF_LANES == 1
    return x;
#else
#if BRDF_LANES == 32
    int16 by16 = x.lo | x.hi;
    int8 by8 = by16.lo | by16.hi;
    int4 by4 = by8.lo | by8.hi;
#elif BRDF_LANES == 16
    int8 by8 = x.lo | x.hi;
    int4 by4 = by8.lo | by8.hi;
#elif BRDF_LANES == 8
    int4 by4 = x.lo | x.hi;
#else
    int4 by4 = x;
#endif
    int2 by2 = by4.lo | by4.hi;
    return by2.x | by2.y;
#endif
}

/* 0, 1, 2 ... : the number of each lane. */
static inline brdf_int brdf_lane_numbers(void)
{
#if BRDF_LANES == 1
    return 0;
#else
#define BRDF_LANE(k) BRDF_LANE_NUMBER(k)
    return (brdf_int)BRDF_EACH_LANE(BRDF_LANE);
#undef BRDF_LANE
#endif
}

#endif
