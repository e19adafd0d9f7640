/*
 * trigonometry.h - sine, cosine and their inverses. math.h states the rules.
 */
#ifndef BRDF_TRIGONOMETRY_H
#define BRDF_TRIGONOMETRY_H

#include "real.h"

struct brdf_sincos {
    brdf_real sin;
    brdf_real cos;
};

/* From sine and cosine of the remainder to those of the angle, `quadrant` quarter turns further; of
   the quadrant only the low two bits count. */
static inline struct brdf_sincos brdf_sincos_turn(brdf_real sine, brdf_real cosine,
                                                  brdf_int quadrant)
{
    brdf_mask odd = (quadrant & 1) != 0;
    /* Bit 1 of the quadrant becomes the sign; unsigned, for C leaves the signed shift open. */
    brdf_uint flip_sin = (brdf_uint_of(quadrant) & 2u) << 30;
    brdf_uint flip_cos = (brdf_uint_of(quadrant + 1) & 2u) << 30;
    struct brdf_sincos result;
    result.sin = brdf_from_bits(brdf_bits(brdf_pick(odd, cosine, sine)) ^ brdf_int_of(flip_sin));
    result.cos = brdf_from_bits(brdf_bits(brdf_pick(odd, sine, cosine)) ^ brdf_int_of(flip_cos));
    return result;
}

/*
 * Sine and cosine of 2 pi u, for |u| <= 2^20. 2 ulp: the reduction is exact, multiples of a quarter
 * turn give exactly 0 and +-1. Prefer it to brdf_sincos wherever the angle is a fraction of a turn.
 */
static inline struct brdf_sincos brdf_sincos_2pi(brdf_real u)
{
    brdf_real quarters = 4.0f * u;
    brdf_real rounded = quarters + BRDF_ROUNDER;
    brdf_real r = quarters - (rounded - BRDF_ROUNDER);
    brdf_real z = r * r;
    /* sin(pi/2 r) and cos(pi/2 r) on [-1/2, 1/2]; pi/2 is 1.57079637 and what c0 adds. */
    brdf_real sine = -4.60011652e-3f;
    brdf_real cosine = 8.94473051e-4f;
    sine = sine * z + 7.96795711e-2f;
    sine = sine * z - 6.45963430e-1f;
    sine = sine * z - 4.88061893e-8f;
    sine = r * 1.57079637f + r * sine;
    cosine = cosine * z - 2.08555944e-2f;
    cosine = cosine * z + 2.53668547e-1f;
    cosine = cosine * z - 1.23370051f;
    cosine = cosine * z + 1.0f;
    return brdf_sincos_turn(sine, cosine, brdf_bits(rounded));
}

/*
 * Sine and cosine of x [rad], for |x| <= 8192; beyond, those of +-8192. 3 ulp.
 */
static inline struct brdf_sincos brdf_sincos(brdf_real x)
{
    brdf_real inside = brdf_clamp(x, -8192.0f, 8192.0f);
    brdf_real rounded = inside * BRDF_TWO_OVER_PI + BRDF_ROUNDER;
    brdf_real n = rounded - BRDF_ROUNDER;
    /* pi/2 in pieces of 11 bits: n has 13, so the products are exact and only the last one rounds
       (Cody and Waite 1980, Software Manual for the Elementary Functions). */
    brdf_real r = (((inside - n * 1.5703125f) - n * 4.83751297e-4f) - n * 7.54953362e-8f) -
                  n * 2.56334415e-12f;
    brdf_real z = r * r;
    brdf_real sine = -1.95182758e-4f;
    brdf_real cosine = 2.44323273e-5f;
    sine = sine * z + 8.33218917e-3f;
    sine = sine * z - 1.66666552e-1f;
    sine = r + r * (z * sine);
    cosine = cosine * z - 1.38873095e-3f;
    cosine = cosine * z + 4.16666456e-2f;
    cosine = cosine * (z * z) + (1.0f - 0.5f * z);
    return brdf_sincos_turn(sine, cosine, brdf_bits(rounded));
}

static inline brdf_real brdf_sin(brdf_real x)
{
    return brdf_sincos(x).sin;
}

static inline brdf_real brdf_cos(brdf_real x)
{
    return brdf_sincos(x).cos;
}

/* asin(s) for 0 <= s <= 1/2, with z = s^2. */
static inline brdf_real brdf_asin_core(brdf_real s, brdf_real z)
{
    brdf_real p = 4.21664044e-2f;
    p = p * z + 2.41807755e-2f;
    p = p * z + 4.54697721e-2f;
    p = p * z + 7.49530643e-2f;
    p = p * z + 1.66667521e-1f;
    return s + s * (z * p);
}

/*
 * Arc cosine [rad] in [0, pi]; x outside [-1, 1], which rounding makes of a dot product, counts as
 * the nearer bound. 2 ulp. Above 1/2 by acos(x) = 2 asin(sqrt((1 - x) / 2)).
 */
static inline brdf_real brdf_acos(brdf_real x)
{
    brdf_real a = brdf_min(1.0f, fabsf(x));
    brdf_mask outer = a > 0.5f;
    brdf_real z = brdf_pick(outer, 0.5f * (1.0f - a), a * a);
    brdf_real p = brdf_asin_core(brdf_pick(outer, sqrtf(z), a), z);
    brdf_real inner = 1.57079637f - (brdf_copysign(p, x) + 4.37113900e-8f);
    brdf_real near_one = 2.0f * p;
    brdf_real near_minus_one = 3.14159274f - (near_one + 8.74227800e-8f);
    return brdf_pick(outer, brdf_pick(x < 0.0f, near_minus_one, near_one), inner);
}

/* Arc sine [rad] in [-pi/2, pi/2]; x outside [-1, 1] counts as the nearer bound. 3 ulp. */
static inline brdf_real brdf_asin(brdf_real x)
{
    brdf_real a = brdf_min(1.0f, fabsf(x));
    brdf_mask outer = a > 0.5f;
    brdf_real z = brdf_pick(outer, 0.5f * (1.0f - a), a * a);
    brdf_real p = brdf_asin_core(brdf_pick(outer, sqrtf(z), a), z);
    return brdf_copysign(brdf_pick(outer, 1.57079637f - (2.0f * p + 4.37113900e-8f), p), x);
}

/*
 * The angle [rad] of the point (x, y), in [-pi, pi], with the sign of y; 0 at the origin. 2 ulp.
 * A point whose smaller coordinate is below 1.18e-38 of the larger counts as lying on that axis.
 */
static inline brdf_real brdf_atan2(brdf_real y, brdf_real x)
{
    brdf_real ax = fabsf(x);
    brdf_real ay = fabsf(y);
    brdf_mask steep = ay > ax;
    brdf_real large = brdf_pick(steep, ay, ax);
    brdf_real small = brdf_pick(steep, ax, ay);
    brdf_real t = small / brdf_pick(large > 0.0f, large, 1.0f);
    t = brdf_pick(t < BRDF_SMALLEST, 0.0f, t);
    brdf_real z = t * t;
    brdf_real p = -1.78281229e-3f;
    p = p * z + 1.08686602e-2f;
    p = p * z - 3.10969613e-2f;
    p = p * z + 5.78813814e-2f;
    p = p * z - 8.39930624e-2f;
    p = p * z + 1.09508805e-1f;
    p = p * z - 1.42640159e-1f;
    p = p * z + 1.99985296e-1f;
    p = p * z - 3.33332986e-1f;
    p = t + t * (z * p);
    p = brdf_pick(steep, 1.57079637f - (p + 4.37113900e-8f), p);
    p = brdf_pick(x < 0.0f, 3.14159274f - (p + 8.74227800e-8f), p);
    return brdf_copysign(p, y);
}

#endif
