/*
 * fit_picture.h - a fit beside what it was fitted to.
 */
#ifndef BRDFCL_FIT_PICTURE_H
#define BRDFCL_FIT_PICTURE_H

#include "brdflab/fit.h"

/*
 * Plot the target, called `name`, and the fit. A fit of several parts is baked into a MERL table
 * for it, so its roughness must be the same all around. BRDF_UNSUPPORTED, and the errors of
 * lab_plot_write and of files.
 */
brdf_status fit_picture_write(const char *path, const struct brdf_bsdf *target, const char *name,
                              const struct lab_fit_result *fit, struct brdf_error *error);

#endif
