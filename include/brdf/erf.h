/*
 * erf.h - the error function and its inverse. math.h states the rules.
 */
#ifndef BRDF_ERF_H
#define BRDF_ERF_H

#include "exponential.h"

/*
 * erf(x). 3 ulp. Near 0 an odd polynomial; from 1.25 on 1 - p^8, where p(x) fits erfc^(1/8), which
 * is flat enough for a short polynomial and needs no exp.
 */
static inline brdf_real brdf_erf(brdf_real x)
{
    brdf_real a = brdf_min(3.92f, fabsf(x));
    brdf_real z = a * a;
    brdf_real core = -7.42356588e-6f;
    brdf_real tail = 1.72205910e-4f;
    core = core * z + 1.03166960e-4f;
    core = core * z - 8.32405349e-4f;
    core = core * z + 5.20749157e-3f;
    core = core * z - 2.68594977e-2f;
    core = core * z + 1.12836584e-1f;
    core = core * z - 3.76126289e-1f;
    core = core * z + 1.28379166e-1f;
    core = a + a * core;
    tail = tail * a - 2.71684676e-3f;
    tail = tail * a + 1.40419202e-2f;
    tail = tail * a - 1.40116261e-2f;
    tail = tail * a - 5.79814501e-2f;
    tail = tail * a - 1.47419021e-1f;
    tail = tail * a + 1.00149667f;
    tail = brdf_sqr(brdf_sqr(brdf_sqr(tail)));
    return brdf_copysign(brdf_pick(a < 1.25f, core, 1.0f - tail), x);
}

/*
 * The inverse of erf for |x| < 1; +-1 and beyond count as +-BRDF_ONE_MINUS_ULP, so the result stays
 * within +-3.84. 4 ulp. After Giles 2012, Approximating the erfinv function: with
 * w = -log(1 - x^2), x times a polynomial in w, or far out in sqrt(w); the coefficients are ours.
 */
static inline brdf_real brdf_erfinv(brdf_real x)
{
    brdf_real inside = brdf_clamp(x, -BRDF_ONE_MINUS_ULP, BRDF_ONE_MINUS_ULP);
    brdf_real w = -brdf_log((1.0f - inside) * (1.0f + inside));
    brdf_mask central = w < 4.8f;
    brdf_real v = brdf_pick(central, w - 2.5f, sqrtf(brdf_max(0.0f, w)) - 3.0f);
    brdf_real p = brdf_pick(central, 3.56033247e-8f, -2.39160043e-4f);
    p = p * v + brdf_pick(central, 3.60172066e-7f, 1.35546114e-4f);
    p = p * v + brdf_pick(central, -3.59043656e-6f, 1.39278790e-3f);
    p = p * v + brdf_pick(central, -4.53769826e-6f, -3.70688434e-3f);
    p = p * v + brdf_pick(central, 2.18751578e-4f, 5.72286127e-3f);
    p = p * v + brdf_pick(central, -1.25337159e-3f, -7.61361467e-3f);
    p = p * v + brdf_pick(central, -4.17779014e-3f, 9.44137946e-3f);
    p = p * v + brdf_pick(central, 2.46640533e-1f, 1.00167358f);
    p = p * v + brdf_pick(central, 1.50140941f, 2.83297682f);
    return p * inside;
}

#endif
