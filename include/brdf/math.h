/*
 * math.h - elementary functions, one text for every compiler.
 *
 * The platforms' sin, exp and pow differ in the last bits, and so would every image. These do not:
 * they use only + - * /, sqrtf, comparisons and integers, in a fixed order, without
 * contraction. They are branch-free, and finite for every argument in the stated domain. A
 * device without subnormal numbers agrees as long as arguments are 0 or above 1e-30 in magnitude.
 *
 * "n ulp" bounds the error in units in the last place of the float nearest to the exact result, as
 * measured against a double-precision reference; tests/test_math.c holds each function to it. All
 * polynomials are minimax fits made for this library.
 */
#ifndef BRDF_MATH_H
#define BRDF_MATH_H

#include "real.h"
#include "trigonometry.h"
#include "exponential.h"
#include "erf.h"

#endif
