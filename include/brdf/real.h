/*
 * real.h - constants, and what reads the bits of a number rather than its value.
 */
#ifndef BRDF_REAL_H
#define BRDF_REAL_H

#include "dialect.h"

#define BRDF_PI 3.14159265f
#define BRDF_TWO_PI 6.28318531f
#define BRDF_1_PI 0.318309886f
#define BRDF_TWO_OVER_PI 0.636619772f
#define BRDF_SQRT_PI 1.77245385f
#define BRDF_1_SQRT_PI 0.564189584f
#define BRDF_ONE_MINUS_ULP 0.99999994f  /* the largest float below 1 */
#define BRDF_LARGEST 3.40282347e+38f    /* the largest float */
#define BRDF_SMALLEST 1.17549435e-38f   /* the smallest positive float that is not subnormal */
#define BRDF_SIGN_BIT (-2147483647 - 1) /* of brdf_bits */

static inline brdf_real brdf_sqr(brdf_real x)
{
    return x * x;
}

/* a (1 - t) + b t */
static inline brdf_real brdf_mix(brdf_real a, brdf_real b, brdf_real t)
{
    return a * (1.0f - t) + b * t;
}

/*
 * x + BRDF_ROUNDER (1.5 2^23) leaves no room for a fraction: for |x| <= 2^22 it rounds x to the
 * nearest whole number, ties to even, and the low bits of the sum are those of that number.
 * Subtract it again for the number itself. OpenCL's floor and convert cost five times as much where
 * the processor's own are not used.
 */
#define BRDF_ROUNDER 12582912.0f

/* The nearest whole number, ties to even, for |x| <= 2^22. */
static inline brdf_real brdf_round(brdf_real x)
{
    return (x + BRDF_ROUNDER) - BRDF_ROUNDER;
}

/* The largest whole number that is not above x, for |x| <= 2^22. */
static inline brdf_real brdf_floor(brdf_real x)
{
    brdf_real n = brdf_round(x);
    return n - brdf_pick(n > x, 1.0f, 0.0f);
}

/* |magnitude| with the sign of x; a zero has a sign too. */
static inline brdf_real brdf_copysign(brdf_real magnitude, brdf_real x)
{
    return brdf_from_bits((brdf_bits(magnitude) & ~BRDF_SIGN_BIT) | (brdf_bits(x) & BRDF_SIGN_BIT));
}

#endif
