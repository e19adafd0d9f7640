/*
 * dialect.h - one language out of two: C99, and OpenCL C 1.2 at 1, 4, 8, 16 or 32 lanes.
 *
 * Every other shared header is ordinary C99 over the names below. This file and the one of the two
 * that it includes are the only ones that ask which compiler is reading, so they are the only place
 * to look when a port goes wrong.
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
 * OpenCL: define BRDF_LANES (1, 4, 8, 16 or 32; default 1) before the first include. 32 are more
 * than OpenCL has types for and need a compiler of the family of clang, as PoCL's is; they are two
 * vectors of the widest processors, whose instructions fill the gaps in each other's chains.
 */
#ifndef BRDF_DIALECT_H
#define BRDF_DIALECT_H

#ifdef __OPENCL_VERSION__
#include "dialect_opencl.h"
#else
#include "dialect_c.h"
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

/* Is the mask true in some lane? One answer for all lanes: a branch on it is fine. */
static inline int brdf_any(brdf_mask mask)
{
    return brdf_or_lanes(mask) != 0;
}

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
