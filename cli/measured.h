/*
 * measured.h - what the commands that read and write measured files have in common.
 */
#ifndef BRDFCL_MEASURED_H
#define BRDFCL_MEASURED_H

#include <brdf/merl.h>
#include <brdf/rgl.h>

#include "brdflab/open.h"
#include "options.h"

/* clang-format off */
/* --no-fill, of every command that opens measured files; `to` is an int that begins as 1. */
#define MEASURED_NO_FILL(to)                                                                       \
    {"no-fill", 0, OPTION_OFF, to, NULL, 0, 0,                                                     \
     "of MERL files: 0 where nothing was measured, not what is near"}
/* clang-format on */

/* The file that a command writes. Begin with all zero. */
struct measured_out {
    const char *path;
    int format; /* enum lab_format; LAB_FORMAT_NONE: by the suffix */
    int force;  /* over a file that is read, too */
    struct brdf_rgl_grid grid;
};

/* The options of such a file. */
/* clang-format off */
#define MEASURED_OUT_OPTIONS(out)                                                                  \
    {"format", 0, OPTION_CHOICE, &(out).format, "by-name|merl|rgl", 0, 0,                          \
     "of OUT; by its suffix, .binary or .bsdf, if not given"},                                     \
    {"thetas", 0, OPTION_INT, &(out).grid.thetas, "N", 2, 256,                                     \
     "RGL: polar angles of the viewer; 25 if not given"},                                          \
    {"size", 0, OPTION_INT, &(out).grid.size, "N", 2, 1024,                                        \
     "RGL: nodes along the sides of a view's square; 128, 64 if anisotropic"},                     \
    {"force", 0, OPTION_ON, &(out).force, NULL, 0, 0, "OUT may be a file that is read"}
/* clang-format on */

/*
 * Take `path` as the file to write, and tell its format. `in` are the `count` materials that are
 * read. Usage errors: a suffix that says nothing; one of `in` that is the very same file, without
 * --force, for measurements cannot be made again. Returns an exit status, or OPTIONS_GO_ON.
 */
int measured_out_set(struct measured_out *out, const char *path, const char *const *in,
                     size_t count);

/*
 * lab_open_merl for commands that work on MERL's grid; prints how much baking changed what was no
 * MERL file. Without `fill`, what was not measured above the surface is 0, else marked as invalid.
 */
brdf_status measured_open(const char *text, int fill, struct brdf_merl_file *file,
                          enum lab_format *format, struct brdf_error *error);

/* Can the file be written there? Asked before the work is done. BRDF_IO. */
brdf_status measured_check(const struct measured_out *out, struct brdf_error *error);

/* Write whole or not at all, whatever signal arrives: a table in MERL's layout, a material as RGL,
   the bytes of another file. */
brdf_status measured_write_merl(const struct measured_out *out, const struct brdf_merl_file *file,
                                struct brdf_error *error);
brdf_status measured_write_rgl(const struct measured_out *out, const struct brdf_bsdf *bsdf,
                               struct brdf_error *error);
brdf_status measured_copy(const struct measured_out *out, const char *from,
                          struct brdf_error *error);

/* Write a table in the format of `out`; prints how much that of RGL changed it. */
brdf_status measured_write(const struct measured_out *out, const struct brdf_merl_file *file,
                           struct brdf_error *error);

/* The exit status of a command whose work ended so: a signal that had to wait is obeyed now. */
int measured_exit(brdf_status status, const struct brdf_error *error);

#endif
