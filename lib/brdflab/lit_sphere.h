/*
 * lit_sphere.h - a sphere of a material in the light of studio.h.
 *
 * The view is orthographic, from +z, with y up; the tangent that anisotropy refers to runs around
 * the y axis. Light that enters the sphere leaves it elsewhere, so that glass looks like glass.
 * Each pixel is an integral over samples of the material and of the lamps, weighted by the balance
 * heuristic [Veach 1997].
 */
#ifndef BRDFLAB_LIT_SPHERE_H
#define BRDFLAB_LIT_SPHERE_H

#include <brdf/material.h>

/*
 * Fill size * size pixels, rows from the top, with linear Rec. 709 between 0 and 1: radiance, whose
 * part above 0.6 is rolled off. The sphere fills the picture; just outside of it the colour of its
 * edge goes on, to be cut off as smoothly as one likes, and beyond that is black. The same call
 * gives the same bits. BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_lit_sphere(const struct brdf_bsdf *bsdf, int size, float *rgb,
                           struct brdf_error *error);

#endif
