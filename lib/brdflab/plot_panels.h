/*
 * plot_panels.h - the panels of a picture, a file each, and what they share.
 */
#ifndef BRDFLAB_PLOT_PANELS_H
#define BRDFLAB_PLOT_PANELS_H

#include "plot.h"
#include "plot_canvas.h"
#include "plot_scale.h"

/* What is the same for all materials of a picture, so that they compare. */
struct plot_job {
    const struct lab_plot_settings *settings;
    const struct lab_plot_material *materials;
    int count;
    int transmits;              /* one of them lets light through: room for the lower half */
    int anisotropic;            /* one of them is: dashed curves for the plane across */
    struct plot_scale slice;    /* of f */
    struct plot_scale lobe_log; /* of f cos, where the radius is logarithmic */
    struct plot_scale albedo;
};

/* Look at all materials. */
void plot_job_prepare(struct plot_job *job);

/* The section of one of the materials at one of the angles; across = 1 turns it by 90 degrees. */
struct lab_section plot_job_section(const struct plot_job *job, int material, int angle,
                                    int across);

/* Draw the panel of a material into a box. */
typedef brdf_status plot_panel_function(struct plot_canvas *canvas, struct plot_box box,
                                        const struct plot_job *job, int material,
                                        struct brdf_error *error);

plot_panel_function plot_panel_sphere;
plot_panel_function plot_panel_lobe;
plot_panel_function plot_panel_slice;
plot_panel_function plot_panel_albedo;
plot_panel_function plot_panel_image;

/* A box with an x axis below and a y axis to the left: lines at the ticks, and their labels. */
struct plot_axes {
    struct plot_box box;
    struct plot_scale x;
    struct plot_scale y;
    const char *x_label; /* at the right end of its axis */
    const char *y_label; /* above its axis */
    const char *x_unit;  /* after the numbers, such as a degree sign */
    const char *y_unit;
};

/* The axes within a cell, with room for their labels. */
struct plot_box plot_axes_room(struct plot_box cell);

void plot_axes_draw(struct plot_canvas *canvas, const struct plot_axes *axes);

/* Where (x, y) is. */
struct lab_point plot_axes_at(const struct plot_axes *axes, double x, double y);

/* Draw a curve, cut off at the edges of the box. */
void plot_axes_curve(struct plot_canvas *canvas, const struct plot_axes *axes,
                     const struct lab_curve *curve, double width, struct plot_color color,
                     double dash);

/* The fonts of ticks and notes, and of labels. */
struct plot_font plot_font_small(const struct plot_canvas *canvas);
struct plot_font plot_font_label(const struct plot_canvas *canvas);

#endif
