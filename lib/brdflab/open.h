/*
 * open.h - a material as a person names it: the path of a measured file, or a description such
 * as roughconductor:material=Au,alpha=0.2.
 */
#ifndef BRDFLAB_OPEN_H
#define BRDFLAB_OPEN_H

#include <brdf/material.h>
#include <brdf/merl.h>

enum lab_format {
    LAB_FORMAT_NONE, /* a description, no file */
    LAB_FORMAT_MERL,
    LAB_FORMAT_RGL
};

/*
 * What a text names. A file is told from a description by being there, its format by its first
 * bytes; a file that is neither format counts as MERL, whose reader says what is wrong with it.
 * Errors: BRDF_IO (neither a file nor a model's name; a folder, a pipe; not readable).
 */
brdf_status lab_format_of(const char *text, enum lab_format *format, struct brdf_error *error);

/*
 * Open what the text names as a bsdf, *out for brdf_bsdf_destroy; `format` may be NULL. Of a MERL
 * file, bins without a measurement are filled, or 0 if not `fill` (a description says it itself, as
 * in merl:filename=gold.binary,fill=false). Errors: those of lab_format_of and brdf_bsdf_create.
 */
brdf_status lab_open_filled(const char *text, int fill, struct brdf_bsdf **out,
                            enum lab_format *format, struct brdf_error *error);

/* The same, filled. */
brdf_status lab_open(const char *text, struct brdf_bsdf **out, enum lab_format *format,
                     struct brdf_error *error);

/*
 * What the text names as a table on MERL's grid, for brdf_merl_free: a MERL file as it is, its
 * invalid bins kept (-1), anything else baked (bake.h). Errors: those of lab_open, brdf_merl_read
 * and lab_bake_merl.
 */
brdf_status lab_open_merl(const char *text, struct brdf_merl_file *file, enum lab_format *format,
                          struct brdf_error *error);

#endif
