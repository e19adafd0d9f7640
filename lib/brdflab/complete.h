/*
 * complete.h - bins that were not measured, given a value for good.
 */
#ifndef BRDFLAB_COMPLETE_H
#define BRDFLAB_COMPLETE_H

#include <brdf/merl.h>

/*
 * Give every invalid bin whose directions are above the surface a value: the one that
 * brdf_merl_fill finds, or 0 if not `fill`. The others stay invalid, which says that nobody asked.
 * Errors: BRDF_BAD_ARGUMENT (no bin is valid), BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_complete_merl(struct brdf_merl_file *file, int fill, struct brdf_error *error);

/*
 * What the text names as a table (open.h), its unmeasured bins filled so; for brdf_merl_free.
 * Errors: those of lab_open_merl and lab_complete_merl; then nothing is to be freed.
 */
brdf_status lab_complete_open(const char *text, struct brdf_merl_file *file,
                              struct brdf_error *error);

#endif
