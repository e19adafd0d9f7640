/*
 * measured.h - what the commands that write measured files have in common.
 */
#ifndef BRDFCL_MEASURED_H
#define BRDFCL_MEASURED_H

#include <brdf/merl.h>
#include <brdf/rgl.h>

#include "brdflab/open.h"

/*
 * The format of a file to write: what --format said (LAB_FORMAT_NONE: nothing), else by the name's
 * end, .binary or .bsdf. Returns an exit status, or OPTIONS_GO_ON.
 */
int measured_format(const char *path, int wanted, enum lab_format *format);

/*
 * lab_open_merl for commands that work on MERL's grid; prints how much baking changed what was no
 * MERL file.
 */
brdf_status measured_open(const char *text, struct brdf_merl_file *file, enum lab_format *format,
                          struct brdf_error *error);

/* Can a file be written there? Asked before the work is done. BRDF_IO. */
brdf_status measured_check(const char *path, struct brdf_error *error);

/* Write a table, or copy a file to `path`, whole or not at all, whatever signal arrives. */
brdf_status measured_write(const char *path, const struct brdf_merl_file *file,
                           struct brdf_error *error);
brdf_status measured_write_rgl(const char *path, const struct brdf_rgl_file *file,
                               struct brdf_error *error);
brdf_status measured_copy(const char *from, const char *path, struct brdf_error *error);

/* The exit status of a command whose work ended so: a signal that had to wait is obeyed now. */
int measured_exit(brdf_status status, const struct brdf_error *error);

#endif
