/*
 * tabulated.h - a table in memory as a material.
 */
#ifndef BRDFLAB_TABULATED_H
#define BRDFLAB_TABULATED_H

#include <brdf/material.h>
#include <brdf/merl.h>

/*
 * The material that the model merl would be if the table were a file, *out for brdf_bsdf_destroy.
 * Bins that are invalid are filled; the table itself stays as it is. Errors: those of
 * brdf_merl_fill, BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_bsdf_of_merl(const struct brdf_merl_file *file, struct brdf_bsdf **out,
                             struct brdf_error *error);

#endif
