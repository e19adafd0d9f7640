/*
 * plot_file.h - a cairo surface whose bytes become a file, whole or not at all.
 */
#ifndef BRDFLAB_PLOT_FILE_H
#define BRDFLAB_PLOT_FILE_H

#include <cairo.h>

#include <brdf/status.h>
#include <brdfcl/atomic_file.h>

struct plot_file {
    const char *path;
    struct brdfcl_atomic_file file; /* from its first byte on */
    int is_open;
    int is_svg;
    void (*on_write)(void); /* called before the first byte; may be NULL */
    cairo_surface_t *surface;
    long long written; /* bytes */
    brdf_status status;
    struct brdf_error *error;
};

/* Is it to be an SVG, by its suffix? */
int plot_file_is_svg(const char *path);

/* Open a picture of so many points, `scale` pixels each for a PNG; ends with plot_file_close. The
   struct must stay where it is until then. Nothing is made on the disk before. */
brdf_status plot_file_open(struct plot_file *file, const char *path, double width, double height,
                           double scale, struct brdf_error *error);

/* Write what was drawn, where `status` is BRDF_OK, and put the file in its place; else drop it.
   Returns that status, or what went wrong now. */
brdf_status plot_file_close(struct plot_file *file, brdf_status status);

#endif
