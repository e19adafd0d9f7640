/*
 * rgl_normals.h - normals out of retro-reflection (internal).
 */
#ifndef BRDF_RGL_NORMALS_H
#define BRDF_RGL_NORMALS_H

#include "brdf/status.h"

/* Two grids by direction (rgl.h), [row][column]; the arrays belong to the caller. */
struct brdf_rgl_normals {
    int rows; /* of an isotropic distribution all rows are the same */
    int columns;
    int isotropic;
    double *d;     /* [1/sr] */
    double *sigma; /* 1 at the normal */
};

/* The direction of a node of such a grid. */
void brdf_rgl_direction(int row, int rows, int column, int columns, double w[3]);

/*
 * Fill d and sigma from what is sent back, f(w, w) cos(theta) at every node up to a factor, not
 * negative and not all 0. The area of d seen from the normal is 1. Errors: BRDF_OUT_OF_MEMORY.
 */
brdf_status brdf_rgl_normals_find(struct brdf_rgl_normals *normals, const double *back,
                                  struct brdf_error *error);

/* The projected area that some distribution on the same grid has, seen from the normal. */
double brdf_rgl_normals_area(const struct brdf_rgl_normals *normals, const double *d);

/* Spread some of the normals evenly, so that d is 0 nowhere, and find sigma of what d is then.
   Errors: BRDF_OUT_OF_MEMORY. */
brdf_status brdf_rgl_normals_end(struct brdf_rgl_normals *normals, struct brdf_error *error);

#endif
