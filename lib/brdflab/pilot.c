/*
 * pilot.c - cells of the sphere that follow the samples of a material.
 */
#include "pilot.h"

#include <stdlib.h>

#include <brdf/math.h>

#include "brdfcl/check_random.h"

/* z chooses among lobes. One that a thousandth of the samples, or fewer, come from needs its cells
   too: usually it is the first or the last. */
static float choice_of(int i, float z)
{
    switch (i % 16) {
    case 0:
        return 1e-3f * z;
    case 8:
        return brdf_min(1.0f - 1e-3f * z, BRDF_ONE_MINUS_ULP);
    default:
        return z;
    }
}

brdf_vec3 lab_random_cube(struct brdfcl_random *random)
{
    float x = brdfcl_random_uniform(random);
    float y = brdfcl_random_uniform(random);
    return brdf_vec3_make(x, y, brdfcl_random_uniform(random));
}

brdf_status lab_pilot_fly(const struct brdf_bsdf *bsdf, brdf_vec3 wo, int samples,
                          unsigned long long seed, struct lab_sphere **sphere,
                          struct brdf_error *error)
{
    struct brdfcl_random random = {seed};
    brdf_vec3 *pilot = calloc((size_t)samples, sizeof *pilot);
    size_t count = 0;
    for (int i = 0; i < samples && pilot; ++i) {
        brdf_vec3 u = lab_random_cube(&random);
        u.z = choice_of(i, u.z);
        struct brdf_sample s = brdf_sample(bsdf, wo, u);
        if (s.pdf > 0.0f && !s.delta) {
            pilot[count++] = s.wi;
        }
    }
    *sphere = count ? lab_sphere_create(pilot, count) : NULL;
    free(pilot);
    if (!pilot || (count && !*sphere)) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the cells of a test");
    }
    return BRDF_OK;
}
