/*
 * random_vectors.h - what tests sample with: the same on every run.
 */
#ifndef TEST_RANDOM_VECTORS_H
#define TEST_RANDOM_VECTORS_H

#include <math.h>

#include "check_cases.h"

/* A point of the unit cube, uniform. */
static inline brdf_vec3 random_cube(struct brdfcl_random *random)
{
    float x = brdfcl_random_uniform(random);
    float y = brdfcl_random_uniform(random);
    return brdf_vec3_make(x, y, brdfcl_random_uniform(random));
}

/* A direction above the surface, uniform in solid angle. */
static inline brdf_vec3 random_above(struct brdfcl_random *random)
{
    brdf_vec3 w = brdfcl_random_direction(random);
    w.z = fabsf(w.z);
    return w;
}

#endif
