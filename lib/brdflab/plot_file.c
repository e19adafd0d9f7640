/* plot_file.c - PNG and SVG through cairo's streams. */
#define _POSIX_C_SOURCE 200809L

#include "plot_file.h"

#include <math.h>
#include <string.h>
#include <strings.h>

#include <cairo-svg.h>

#include "plot.h"

static int has_suffix(const char *path, const char *suffix)
{
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, suffix) == 0;
}

int plot_file_is_svg(const char *path)
{
    return has_suffix(path, ".svg");
}

brdf_status lab_plot_path_check(const char *path, struct brdf_error *error)
{
    if (!has_suffix(path, ".png") && !plot_file_is_svg(path)) {
        return brdf_fail(error, BRDF_UNSUPPORTED, "\"%s\": a plot is a .png or a .svg file", path);
    }
    return brdfcl_atomic_check(path, error);
}

static cairo_status_t write_bytes(void *closure, const unsigned char *bytes, unsigned length)
{
    struct plot_file *file = closure;
    if (!file->status && !file->is_open) {
        if (file->on_write) {
            file->on_write();
        }
        file->status = brdfcl_atomic_open(&file->file, file->path, file->error);
        file->is_open = !file->status;
    }
    if (!file->status) {
        file->status = brdfcl_atomic_write(&file->file, bytes, length, file->written, file->error);
        file->written += length;
    }
    return file->status ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static void make_surface(struct plot_file *file, double width, double height, double scale)
{
    if (file->is_svg) {
        file->surface = cairo_svg_surface_create_for_stream(write_bytes, file, width, height);
        return;
    }
    file->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, (int)lround(width * scale),
                                               (int)lround(height * scale));
    cairo_surface_set_device_scale(file->surface, scale, scale);
}

brdf_status plot_file_open(struct plot_file *file, const char *path, double width, double height,
                           double scale, struct brdf_error *error)
{
    memset(file, 0, sizeof *file);
    file->path = path;
    file->is_svg = plot_file_is_svg(path);
    file->error = error;
    file->status = lab_plot_path_check(path, error);
    if (file->status) {
        return file->status;
    }
    make_surface(file, width, height, scale);
    if (cairo_surface_status(file->surface) != CAIRO_STATUS_SUCCESS) {
        return plot_file_close(file, brdf_fail(error, BRDF_OUT_OF_MEMORY,
                                               "%s: no memory for a picture of %g x %g points",
                                               path, width, height));
    }
    return BRDF_OK;
}

brdf_status plot_file_close(struct plot_file *file, brdf_status status)
{
    cairo_status_t drawn = CAIRO_STATUS_SUCCESS;
    file->status = status; /* an error keeps an SVG from being written */
    if (!status && !file->is_svg) {
        drawn = cairo_surface_write_to_png_stream(file->surface, write_bytes, file);
    }
    cairo_surface_finish(file->surface); /* an SVG's bytes come now */
    if (drawn == CAIRO_STATUS_SUCCESS) {
        drawn = cairo_surface_status(file->surface);
    }
    if (!status) {
        status = file->status;
    }
    if (!status && drawn != CAIRO_STATUS_SUCCESS) {
        status =
            brdf_fail(file->error, BRDF_IO, "%s: %s", file->path, cairo_status_to_string(drawn));
    }
    cairo_surface_destroy(file->surface);
    file->surface = NULL;
    if (!status) {
        return brdfcl_atomic_commit(&file->file, file->error);
    }
    if (file->is_open) {
        brdfcl_atomic_discard(&file->file);
    }
    return status;
}
