/* panel_sphere.c - the lit sphere, cut out along its edge. */
#include <math.h>
#include <stdlib.h>

#include "angle.h"
#include "lit_sphere.h"
#include "plot_panels.h"

brdf_status plot_panel_sphere(struct plot_canvas *canvas, struct plot_box cell,
                              const struct plot_job *job, int material, struct brdf_error *error)
{
    struct plot_box room = plot_box_within(cell, 14.0, 8.0, 14.0, 14.0);
    double side = fmin(room.w, room.h);
    struct plot_box box = {room.x + 0.5 * (room.w - side), room.y + 0.5 * (room.h - side), side,
                           side};
    int size = (int)ceil(side * canvas->scale);
    float *rgb = malloc(3 * (size_t)size * (size_t)size * sizeof *rgb);
    if (!rgb) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %d x %d pixels", size, size);
    }
    brdf_status status = lab_lit_sphere(job->materials[material].bsdf, size, rgb, error);
    cairo_save(canvas->cairo);
    cairo_arc(canvas->cairo, box.x + 0.5 * side, box.y + 0.5 * side, 0.5 * side, 0.0, 2.0 * pi);
    cairo_clip(canvas->cairo);
    if (!status) {
        status = plot_pixels(canvas, box, rgb, size, size, error);
    }
    cairo_restore(canvas->cairo);
    free(rgb);
    return status;
}
