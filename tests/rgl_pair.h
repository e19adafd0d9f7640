/*
 * rgl_pair.h - two measured materials that tests look at from all sides, made once.
 */
#ifndef TEST_RGL_PAIR_H
#define TEST_RGL_PAIR_H

#include "rgl_files.h"

#define GLOSSY "roughconductor:material=Cu,alpha=0.2"
#define BRUSHED "roughconductor:material=Cu,alpha_u=0.15,alpha_v=0.4"

/* Files made once: isotropic, and anisotropic with a symmetry. */
struct rgl_pair {
    struct brdf_bsdf *glossy;
    struct brdf_bsdf *brushed;
};

static inline int rgl_pair_make(void **state)
{
    const struct brdf_rgl_grid anisotropic = {.phis = 7, .symmetry = 4, .thetas = 12};
    struct rgl_pair *m = calloc(1, sizeof *m);
    struct brdf_rgl_file glossy = rgl_test_make(GLOSSY, NULL);
    struct brdf_rgl_file brushed = rgl_test_make(BRUSHED, &anisotropic);
    m->glossy = rgl_test_load(&glossy);
    m->brushed = rgl_test_load(&brushed);
    brdf_rgl_free(&glossy);
    brdf_rgl_free(&brushed);
    *state = m;
    return 0;
}

static inline int rgl_pair_free(void **state)
{
    struct rgl_pair *m = *state;
    brdf_bsdf_destroy(m->glossy);
    brdf_bsdf_destroy(m->brushed);
    free(m);
    return 0;
}

#endif
