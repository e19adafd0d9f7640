/*
 * values.h - what every value of a material must be: finite, non-negative, reciprocal, consistent
 * with the others and with the flags of its model.
 *
 * Directions and random numbers are those of brdfcl/check_cases.h, half of the time at some limit:
 * grazing, equal, opposite, along an axis, u = 0 and just below 1. The same seed gives the same.
 */
#ifndef BRDFLAB_VALUES_H
#define BRDFLAB_VALUES_H

#include <brdf/material.h>

#include "finding.h"

/* Can light come from below the surface: is there something to see? */
int lab_seen_from_below(const struct brdf_bsdf *bsdf);

/*
 * f, density and sample of `calls` inputs: finite, non-negative, unit directions, and black on the
 * sides that the flags exclude. Measured: how many inputs are at fault. The worst case is the
 * first.
 */
struct lab_finding lab_try_finite(const struct brdf_bsdf *bsdf, size_t calls,
                                  unsigned long long seed);

/*
 * f(wo, wi) eta^2 = f(wi, wo), eta being the index of wi's side over that of wo's [Veach 1997,
 * 5.2]. Measured: the largest relative difference, up to 1e-4. LAB_NONE where the model does not
 * announce it.
 */
struct lab_finding lab_try_reciprocal(const struct brdf_bsdf *bsdf, size_t calls,
                                      unsigned long long seed);

/*
 * The weight of a sample is f |cos| / pdf and its density is pdf, as the other two functions have
 * them. Measured: the largest relative difference, up to 1e-3; weights below 1e-6 count as 1e-6.
 */
struct lab_finding lab_try_weight(const struct brdf_bsdf *bsdf, size_t calls,
                                  unsigned long long seed);

/*
 * f does not change when both directions turn by 90 degrees. Measured: the largest relative
 * difference, up to 1e-4. LAB_NONE where the model announces that it does.
 */
struct lab_finding lab_try_isotropic(const struct brdf_bsdf *bsdf, size_t calls,
                                     unsigned long long seed);

#endif
