/*
 * support_matte.h - albedos of wide, isotropic models, by quadrature over plain grids.
 *
 * For models without narrow lobes this is exact to six digits and quick; support_energy.h is for
 * the others.
 */
#ifndef SUPPORT_MATTE_H
#define SUPPORT_MATTE_H

#include "support_energy.h"

/* The albedo (green channel) for light from the cosine mu, on a grid of count x 2 count twice. */
double matte_albedo(const struct brdf_bsdf *bsdf, double mu, int count);
double matte_albedo_by_sampling(const struct brdf_bsdf *bsdf, double mu);

/* 1, and a printed line, where `found` is not `known` within the tolerance; else 0. */
int matte_expect(const char *what, double mu, double found, double known, double tolerance);

/* The albedo at all five cosines, by quadrature and by sampling; the number of failures. */
int matte_expect_albedos(const char *description, const double known[ENERGY_COSINES],
                         double tolerance);

#endif
