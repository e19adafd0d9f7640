/*
 * exponential.h - exp, log and pow. math.h states the rules.
 */
#ifndef BRDF_EXPONENTIAL_H
#define BRDF_EXPONENTIAL_H

#include "real.h"

/*
 * exp(r) 2^n, for |r| <= 0.35 and a result that is neither subnormal nor above BRDF_LARGEST; n
 * comes as n + BRDF_ROUNDER.
 */
static inline brdf_real brdf_exp_scaled(brdf_real r, brdf_real rounded)
{
    brdf_real p = 1.38214696e-3f;
    p = p * r + 8.36866256e-3f;
    p = p * r + 4.16682549e-2f;
    p = p * r + 1.66665211e-1f;
    p = p * r + 4.99999940e-1f;
    p = p * (r * r) + r + 1.0f;
    /* Adding to the exponent instead of multiplying by 2^n, for 2^128 is not a float; the shift
       leaves nothing of `rounded` but n. */
    brdf_uint exponent = brdf_uint_of(brdf_bits(rounded)) << 23;
    return brdf_from_bits(brdf_int_of(brdf_uint_of(brdf_bits(p)) + exponent));
}

/*
 * e^x. 1 ulp. From 88.7228317 on the result stays at 3.40279858e+38; below -87.3365402, where it
 * would be subnormal, it is 0.
 */
static inline brdf_real brdf_exp(brdf_real x)
{
    brdf_real inside = brdf_clamp(x, -87.3365402f, 88.7228317f);
    brdf_real rounded = inside * 1.44269504f + BRDF_ROUNDER;
    brdf_real n = rounded - BRDF_ROUNDER;
    /* ln 2 in two pieces; the first has 10 bits, so that its product with n is exact. */
    brdf_real r = (inside - n * 0.693359375f) - n * -2.12194440e-4f;
    return brdf_pick(x < -87.3365402f, 0.0f, brdf_exp_scaled(r, rounded));
}

struct brdf_split {
    brdf_real mantissa; /* in [sqrt(1/2), sqrt(2)) */
    brdf_real exponent; /* a whole number */
};

/* x = mantissa 2^exponent; x below BRDF_SMALLEST (0, negative, subnormal) counts as that. */
static inline struct brdf_split brdf_split_exponent(brdf_real x)
{
    brdf_int root_half = 0x3f3504f3;
    brdf_int offset = brdf_bits(brdf_max(BRDF_SMALLEST, x)) - root_half;
    struct brdf_split result;
    result.exponent = brdf_to_real(offset >> 23);
    result.mantissa = brdf_from_bits((offset & 0x7fffff) + root_half);
    return result;
}

/*
 * The natural logarithm of x > 0. 1 ulp. Below the smallest normal number the result stays at its
 * logarithm, -87.3365479: finite, so that log(0) harms no sum. exp(y log(0)) is not 0: take
 * brdf_pow.
 */
static inline brdf_real brdf_log(brdf_real x)
{
    struct brdf_split split = brdf_split_exponent(x);
    brdf_real f = split.mantissa - 1.0f;
    brdf_real z = f * f;
    brdf_real p = 6.74925223e-2f;
    p = p * f - 1.16700925e-1f;
    p = p * f + 1.18835509e-1f;
    p = p * f - 1.24062344e-1f;
    p = p * f + 1.42203584e-1f;
    p = p * f - 1.66679889e-1f;
    p = p * f + 2.00020716e-1f;
    p = p * f - 2.50000089e-1f;
    p = p * f + 3.33333135e-1f;
    p = (f * z) * p - split.exponent * 2.12194440e-4f;
    p = f + (p - 0.5f * z);
    return p + split.exponent * 0.693359375f;
}

/* A number as an unevaluated sum of two floats. */
struct brdf_pair {
    brdf_real high;
    brdf_real low;
};

/* The leading 12 bits of x: products of two such are exact. */
static inline brdf_real brdf_leading(brdf_real x)
{
    return brdf_from_bits(brdf_bits(x) & ~0xfff);
}

/* a b exactly (Dekker 1971, A floating-point technique for extending the available precision). */
static inline struct brdf_pair brdf_product(brdf_real a, brdf_real b)
{
    brdf_real ah = brdf_leading(a);
    brdf_real bh = brdf_leading(b);
    brdf_real al = a - ah;
    brdf_real bl = b - bh;
    struct brdf_pair result;
    result.high = a * b;
    result.low = (((ah * bh - result.high) + ah * bl) + al * bh) + al * bl;
    return result;
}

/* log2 of x to 30 bits and more, by log2(m) = 2 / ln 2 atanh(s), s = (m - 1) / (m + 1). */
static inline struct brdf_pair brdf_log2_pair(brdf_real x)
{
    struct brdf_split split = brdf_split_exponent(x);
    brdf_real f = split.mantissa - 1.0f;
    brdf_real d = 2.0f + f;
    brdf_real d_low = f - (d - 2.0f);
    brdf_real inverse = 1.0f / d;
    brdf_real s = f * inverse;
    struct brdf_pair back = brdf_product(s, d);
    brdf_real s_low = (((f - back.high) - back.low) - s * d_low) * inverse;
    brdf_real z = s * s;
    brdf_real p = 3.36488426e-1f;
    p = p * z + 4.11927313e-1f;
    p = p * z + 5.77078819e-1f;
    p = p * z + 9.61796701e-1f;
    p = z * p;
    struct brdf_pair first = brdf_product(s, 2.88539004f);
    brdf_real tail = s_low * (2.88539004f + 3.0f * p) + s * 3.85192600e-8f;
    struct brdf_pair result;
    result.high = split.exponent + first.high;
    result.low = (first.high - (result.high - split.exponent)) + (s * p + (tail + first.low));
    return result;
}

/*
 * x^y for x >= 0 and any finite y. 4 ulp, whatever y. x below the smallest normal number counts as
 * 0, and 0^0 = 1. A result above BRDF_LARGEST is BRDF_LARGEST, as is 0^y for y < 0; one that would
 * be subnormal is 0.
 */
static inline brdf_real brdf_pow(brdf_real x, brdf_real y)
{
    struct brdf_pair log2 = brdf_log2_pair(x);
    /* Beyond 1e10 the nearest neighbours of 1 overflow already, and the product below must not. */
    brdf_real inside = brdf_clamp(y, -1e10f, 1e10f);
    struct brdf_pair power = brdf_product(inside, log2.high);
    brdf_real low = power.low + inside * log2.low;
    brdf_real total = power.high + low;
    brdf_mask over = total >= 128.0f;
    brdf_mask under = total < -126.0f;
    brdf_mask zero = x < BRDF_SMALLEST;
    brdf_real rounded = brdf_clamp(total, -127.0f, 128.0f) + BRDF_ROUNDER;
    brdf_real n = rounded - BRDF_ROUNDER;
    brdf_real r = brdf_pick(over | under, 0.0f, (power.high - n) + low);
    brdf_real result = brdf_exp_scaled(r * 0.693147181f, rounded);
    result = brdf_pick(under, 0.0f, brdf_pick(over, BRDF_LARGEST, result));
    brdf_real at_zero = brdf_pick(y > 0.0f, 0.0f, brdf_pick(y < 0.0f, BRDF_LARGEST, 1.0f));
    return brdf_pick(zero, at_zero, result);
}

#endif
