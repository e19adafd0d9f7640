/*
 * plot_canvas.h - what panels draw with: colours, lines and text over cairo, in points.
 *
 * Texts are UTF-8 with two marks: "_x" lowers one letter (theta_i), "^{...}" raises what is in the
 * braces. Everything is set in the system's sans-serif, without hinting, so that PNG and SVG have
 * the same layout.
 */
#ifndef BRDFLAB_PLOT_CANVAS_H
#define BRDFLAB_PLOT_CANVAS_H

#include <cairo.h>

#include "curve.h"

struct plot_color {
    double r, g, b, a; /* sRGB, 0 to 1 */
};

struct plot_theme {
    struct plot_color paper; /* the ground */
    struct plot_color ink;   /* titles */
    struct plot_color text;  /* ticks and notes */
    struct plot_color axis;
    struct plot_color grid;
    double first, last; /* the part of the ramp of colours that is seen well on the paper */
};

struct plot_canvas {
    cairo_t *cairo;
    const struct plot_theme *theme;
    double scale; /* pixels for each point, for what is drawn pixel by pixel */
};

struct plot_box {
    double x, y, w, h; /* points; y goes down */
};

/* What is left of a box within margins. */
struct plot_box plot_box_within(struct plot_box box, double left, double top, double right,
                                double bottom);

const struct plot_theme *plot_theme(int dark);

/* The colour of curve i of `count`: ordered, from dark to light, told apart by the colour-blind
   [the ramp is matplotlib's plasma; Smith and van der Walt 2015]. */
struct plot_color plot_color_of(const struct plot_theme *theme, int i, int count);

void plot_set_color(struct plot_canvas *canvas, struct plot_color color);
struct plot_color plot_faded(struct plot_color color, double alpha);

/* A straight line; `dash` is the length of dashes, 0 for none. */
void plot_line(struct plot_canvas *canvas, struct lab_point from, struct lab_point to, double width,
               struct plot_color color, double dash);

/* A line with a head at its end. */
void plot_arrow(struct plot_canvas *canvas, struct lab_point from, struct lab_point to,
                double width, struct plot_color color);

/* The line through the points of a curve; closed and filled with some of the colour where `fill`
   is more than 0. */
void plot_curve(struct plot_canvas *canvas, const struct lab_curve *curve, double width,
                struct plot_color color, double dash, double fill);

enum plot_weight { PLOT_REGULAR, PLOT_BOLD };

struct plot_font {
    double size; /* points */
    enum plot_weight weight;
    struct plot_color color;
    int literal; /* the text has no marks: "_" and "^{" are letters, as in what people type */
};

/* The width of a text. */
double plot_text_width(struct plot_canvas *canvas, struct plot_font font, const char *text);

/* A text on the line y; `align` is how much of its width lies left of x: 0, 0.5, 1. */
void plot_text(struct plot_canvas *canvas, double x, double y, double align, struct plot_font font,
               const char *text);

/* The same on a ground of the paper's colour, to be read above lines. */
void plot_text_haloed(struct plot_canvas *canvas, double x, double y, double align,
                      struct plot_font font, const char *text);

/* Pixels, linear Rec. 709 in rows from the top, fitted into a box as they are: 0 to 1 becomes sRGB.
   BRDF_OUT_OF_MEMORY. */
brdf_status plot_pixels(struct plot_canvas *canvas, struct plot_box box, const float *rgb,
                        int width, int height, struct brdf_error *error);

#endif
