/*
 * energy.h - does a material keep to the light that it gets, and is light by sampling light by
 * quadrature?
 */
#ifndef BRDFLAB_ENERGY_H
#define BRDFLAB_ENERGY_H

#include <brdf/material.h>

#include "finding.h"
#include "sphere.h"

struct lab_energy {
    double value;
    double error; /* what rare samples leave uncertain */
};

/*
 * The mean weight (of the three channels) of samples that are no deltas: what the integral of f
 * |cos| must be. Samples of weight up to 1 are many and even; `error` comes from the rare ones
 * above it (into a thinner medium).
 */
struct lab_energy lab_energy_sampled(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples);

/* The integral of f |cos| to *sum, in cells that follow the samples; from `finer` times as many
   samples where that is above 1. BRDF_OUT_OF_MEMORY. */
brdf_status lab_energy_integrated(const struct brdf_bsdf *bsdf, brdf_vec3 wo, int finer,
                                  struct lab_sphere_sum *sum, struct brdf_error *error);

/*
 * Light by sampling against light by quadrature: measured is their difference. LAB_NONE where there
 * is nothing but deltas, LAB_OPEN where the quadrature does not converge.
 */
brdf_status lab_try_albedo(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples,
                           struct lab_finding *finding, struct brdf_error *error);

/* The share of light that leaves again (albedo.h), largest channel; it should not exceed 1, which
   in a measured material is the data's matter: LAB_NOTE. */
struct lab_finding lab_try_energy(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples);

#endif
