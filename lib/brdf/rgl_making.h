/*
 * rgl_making.h - a file that is being made from a function (internal to rgl_make.c, rgl_views.c
 * and rgl_values.c).
 */
#ifndef BRDF_RGL_MAKING_H
#define BRDF_RGL_MAKING_H

#include "rgl_format.h"

/* The least cosine at which a function is asked: at the horizon itself many have no value. */
#define BRDF_RGL_COSINE_LEAST 1e-3

/* What is being made. */
struct brdf_rgl_making {
    brdf_rgl_function *f;
    void *data;
    struct brdf_rgl_grid grid; /* without zeros */
    struct brdf_rgl_file *file;
    double *values; /* of one pair of directions, a channel each */
    struct brdf_error *error;
};

/* f into making->values; both directions a little further up where they need it. */
brdf_status brdf_rgl_ask(struct brdf_rgl_making *m, const double from[3], const double to[3]);

/* Blend a distribution that retro-reflection shows with what all views show. */
struct brdf_rgl_normals;
brdf_status brdf_rgl_views_blend(struct brdf_rgl_making *m, struct brdf_rgl_normals *normals);

/* Visible normals, values and luminance of all views, once the file has its D and sigma. */
brdf_status brdf_rgl_values_make(struct brdf_rgl_making *m);

#endif
