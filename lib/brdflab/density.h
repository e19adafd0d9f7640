/*
 * density.h - do the samples of a material have the density that pdf announces?
 *
 * The sphere is cut into cells that follow a pilot of the samples themselves (sphere.h), so that
 * narrow lobes are resolved as well as wide ones; pdf is integrated over each cell by adaptive
 * quadrature, and Pearson's test compares with other samples. Where the quadrature does not
 * converge, or depends on the cells (some ridges tens of thousands of times longer than wide),
 * nothing can be told, and the verdict says so.
 */
#ifndef BRDFLAB_DENSITY_H
#define BRDFLAB_DENSITY_H

#include <stddef.h>

#include <brdf/material.h>

#include "finding.h"

/* The directions that materials are tested from: 0, 30, 60, 80, 88 degrees from the normal, and
   100, 135, 180, which are from inside. */
enum { LAB_VIEWS = 8 };
extern const double lab_view_angle[LAB_VIEWS];
brdf_vec3 lab_view_direction(int number);

/* How many of them, the first ones, show something of a material with these flags. */
int lab_view_count(unsigned flags);

struct lab_density {
    struct lab_finding mass; /* |integral of pdf - chance of a sample|, up to 2e-3 */
    struct lab_finding chi2; /* p of Pearson's test, at least the limit given */
    double departure;        /* chi2 beyond its degrees of freedom, its expectation */
};

/*
 * Test one view with so many samples. Both findings are LAB_NONE where there is nothing but deltas,
 * or nothing at all. BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_try_density(const struct brdf_bsdf *bsdf, int view, size_t samples,
                            unsigned long long seed, double limit, struct lab_density *result,
                            struct brdf_error *error);

#endif
