/*
 * math.h - constants and elementary functions, one text for every compiler.
 *
 * The platforms' sin, exp and pow differ in the last bits, and so would every image. These do not:
 * they use only + - * /, sqrtf, floorf, comparisons and integers, in a fixed order, without
 * contraction. They are branch-free, finite for every argument in the stated domain, and ignore
 * subnormal numbers (below 1.18e-38), which some devices do not have.
 *
 * Error bounds are in units in the last place (ulp) against a double-precision reference; the tests
 * hold the functions to them. The polynomials are minimax fits made for this file.
 */
#ifndef BRDF_MATH_H
#define BRDF_MATH_H

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

/* |magnitude| with the sign of x; a zero has a sign too. */
static inline brdf_real brdf_copysign(brdf_real magnitude, brdf_real x)
{
    return brdf_from_bits((brdf_bits(magnitude) & ~BRDF_SIGN_BIT) | (brdf_bits(x) & BRDF_SIGN_BIT));
}

#include "trigonometry.h"
#include "exponential.h"
#include "erf.h"

#endif
