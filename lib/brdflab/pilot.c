/*
 * pilot.c - cells of the sphere that follow the samples of a material.
 */
#include "pilot.h"

#include <stdlib.h>

#include <brdf/math.h>

#include "brdfcl/check_random.h"

/* z chooses among lobes. One that a thousandth of the samples, or fewer, come from needs its cells
   too: usually it is the first or the last. */
static float choice_of(size_t i, float z)
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

/* Draw so many; *count of them, no deltas, are in the array that is the caller's. NULL out of
   memory. */
static brdf_vec3 *draw(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples,
                       unsigned long long seed, size_t *count)
{
    struct brdfcl_random random = {seed};
    brdf_vec3 *pilot = calloc(samples + 1, sizeof *pilot);
    *count = 0;
    for (size_t i = 0; i < samples && pilot; ++i) {
        brdf_vec3 u = lab_random_cube(&random);
        u.z = choice_of(i, u.z);
        struct brdf_sample s = brdf_sample(bsdf, wo, u);
        if (s.pdf > 0.0f && !s.delta) {
            pilot[(*count)++] = s.wi;
        }
    }
    return pilot;
}

static brdf_status fail(struct brdf_error *error)
{
    return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the cells of a test");
}

brdf_status lab_pilot_fly(const struct brdf_bsdf *bsdf, brdf_vec3 wo, int samples,
                          unsigned long long seed, struct lab_sphere **sphere,
                          struct brdf_error *error)
{
    size_t count;
    brdf_vec3 *pilot = draw(bsdf, wo, (size_t)samples, seed, &count);
    *sphere = count ? lab_sphere_create(pilot, count) : NULL;
    int done = pilot && (!count || *sphere);
    free(pilot);
    return done ? BRDF_OK : fail(error);
}

brdf_status lab_pilot_watch(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples,
                            unsigned long long seed, struct lab_sphere *sphere,
                            struct brdf_error *error)
{
    size_t count;
    brdf_vec3 *watch = draw(bsdf, wo, samples, seed, &count);
    int done = watch && lab_sphere_watch(sphere, watch, count);
    free(watch);
    return done ? BRDF_OK : fail(error);
}
