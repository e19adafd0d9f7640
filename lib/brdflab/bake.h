/*
 * bake.h - a material tabulated into the layout of measured files.
 */
#ifndef BRDFLAB_BAKE_H
#define BRDFLAB_BAKE_H

#include <brdf/material.h>
#include <brdf/merl.h>

/*
 * Tabulate the reflection of a bsdf on MERL's grid: its value at the centre of each bin, which is
 * where looking up expects it; the mean of f(wo, wi) and f(wi, wo), which have one bin. For
 * brdf_merl_free. Errors: BRDF_UNSUPPORTED for what no such table can hold: a mirror direction, a
 * dependence on the azimuth of wo, light that goes through; BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_bake_merl(const struct brdf_bsdf *bsdf, struct brdf_merl_file *file,
                          struct brdf_error *error);

/*
 * How much f depends on the azimuth of wo: the largest difference between f of a pair of
 * directions and of the same pair turned about the normal, relative to the larger of the two; 0 for
 * an isotropic material, up to rounding.
 */
double lab_anisotropy(const struct brdf_bsdf *bsdf);

/* Can a draw from the bsdf be a delta lobe, a mirror direction? */
int lab_has_delta(const struct brdf_bsdf *bsdf);

#endif
