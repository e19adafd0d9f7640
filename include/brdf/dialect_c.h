/*
 * dialect_c.h - the dialect (dialect.h) as C99: a lane is a float.
 */
#ifndef BRDF_DIALECT_C_H
#define BRDF_DIALECT_C_H

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

static inline int brdf_or_lanes(brdf_int x)
{
    return x;
}

static inline brdf_int brdf_lane_numbers(void)
{
    return 0;
}

#endif
