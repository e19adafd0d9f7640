/*
 * pilot.h - random samples of a material, and cells of the sphere that follow them.
 */
#ifndef BRDFLAB_PILOT_H
#define BRDFLAB_PILOT_H

#include <brdf/material.h>

#include "brdfcl/check_random.h"
#include "sphere.h"

/* Three numbers for brdf_sample. */
brdf_vec3 lab_random_cube(struct brdfcl_random *random);

/*
 * Cut the sphere for so many samples from wo, to *sphere for the caller to destroy; NULL where
 * there are none but deltas. Some of them are of the lobes that are chosen rarely. Another seed,
 * other cells. BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_pilot_fly(const struct brdf_bsdf *bsdf, brdf_vec3 wo, int samples,
                          unsigned long long seed, struct lab_sphere **sphere,
                          struct brdf_error *error);

/* Let so many other samples watch for peaks (sphere.h). BRDF_OUT_OF_MEMORY. */
brdf_status lab_pilot_watch(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples,
                            unsigned long long seed, struct lab_sphere *sphere,
                            struct brdf_error *error);

#endif
