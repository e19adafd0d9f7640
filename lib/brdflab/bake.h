/*
 * bake.h - a material tabulated into the layout of measured files.
 */
#ifndef BRDFLAB_BAKE_H
#define BRDFLAB_BAKE_H

#include <brdf/material.h>
#include <brdf/merl.h>
#include <brdf/rgl.h>

/*
 * Tabulate the reflection of a bsdf on MERL's grid: its value at the centre of each bin, which is
 * where looking up expects it; the mean of f(wo, wi) and f(wi, wo), which have one bin. For
 * brdf_merl_free. Errors: BRDF_UNSUPPORTED for what no such table can hold: a mirror direction, a
 * dependence on the azimuth of wo, light that goes through; BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_bake_merl(const struct brdf_bsdf *bsdf, struct brdf_merl_file *file,
                          struct brdf_error *error);

/*
 * Tabulate the reflection of a bsdf as an RGL file, for brdf_rgl_free. `grid` says how finely; a
 * zero in it stands for what is right for most: 25 polar angles; one azimuth and squares of 128 x
 * 128 if the material is isotropic, else steps of 11.25 degrees over as much of the turn as its
 * symmetry asks for, and squares of 64 x 64. Errors: as lab_bake_merl, but any azimuth will do;
 * those of brdf_rgl_make.
 */
brdf_status lab_bake_rgl(const struct brdf_bsdf *bsdf, const struct brdf_rgl_grid *grid,
                         struct brdf_rgl_file *file, struct brdf_error *error);

/*
 * How much f depends on the azimuth of wo: the largest difference between f of a pair of
 * directions and of the same pair turned about the normal, relative to the larger of the two; 0 for
 * an isotropic material, up to rounding.
 */
double lab_anisotropy(const struct brdf_bsdf *bsdf);

/*
 * How much of a turn tells all: 4 if f stays the same where x or y change their sign in both
 * directions, 2 if it does where both do, a half turn; else 1.
 */
int lab_symmetry(const struct brdf_bsdf *bsdf);

/* Can a draw from the bsdf be a delta lobe, a mirror direction? */
int lab_has_delta(const struct brdf_bsdf *bsdf);

#endif
