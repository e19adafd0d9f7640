/*
 * support_energy.h - how much light a material reflects: by sampling, by quadrature, and as known.
 */
#ifndef SUPPORT_ENERGY_H
#define SUPPORT_ENERGY_H

#include <brdf/material.h>

#include "energy.h"

enum { ENERGY_COSINES = 5 };

/* The cosines of wo that known albedos are for: 0.1, 0.25, 0.5, 0.75, 1. */
extern const double energy_cosines[ENERGY_COSINES];

struct energy_known {
    const char *description;
    double albedo[ENERGY_COSINES]; /* mean of the channels, at the cosines above */
    double tolerance;
    double tolerance_grazing; /* of the first cosine */
};

/* A direction by its cosine with the normal and its azimuth [rad]. */
brdf_vec3 energy_direction(double cosine, double phi);

/* The mean weight of samples, and the integral of f |cos| (brdflab/energy.h). */
struct lab_energy energy_by_sampling(const struct brdf_bsdf *bsdf, brdf_vec3 wo);
struct lab_sphere_sum energy_by_quadrature(const struct brdf_bsdf *bsdf, brdf_vec3 wo);

/* The mean weight of `count` samples without radiance's 1 / eta^2; eta is the index on the far side
 * over that on the near one. */
double energy_of_both_sides(const struct brdf_bsdf *bsdf, brdf_vec3 wo, double eta, size_t count);

/* How far that is from 1 for light from an angle with the normal on a side (1 above, -1 below) and
 * an azimuth [rad]; `name` of what is further than `at_most` is printed. */
double energy_missing(const struct brdf_bsdf *bsdf, const char *name, double degrees, double side,
                      double azimuth, double eta, size_t count, double at_most);

/* Rows against both; what differs is printed. Returns the number of failures. */
int energy_check_known(const struct energy_known *rows, size_t count);

#endif
