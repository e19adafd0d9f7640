/* polar.c - spokes every 30 degrees, rings at the ticks. */
#include "polar.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "angle.h"
#include "plot_panels.h"

struct polar polar_within(struct plot_box cell, int full, struct plot_scale scale)
{
    struct plot_box room = plot_box_within(cell, 26.0, 18.0, 26.0, full ? 18.0 : 30.0);
    struct polar polar;
    polar.radius = fmin(0.5 * room.w, full ? 0.5 * room.h : room.h);
    polar.centre.x = room.x + 0.5 * room.w;
    polar.centre.y = full ? room.y + 0.5 * room.h : room.y + room.h;
    polar.full = full;
    polar.scale = scale;
    return polar;
}

struct lab_point polar_at_radius(const struct polar *polar, double theta, double radius)
{
    struct lab_point point = {polar->centre.x + polar->radius * radius * sin(theta),
                              polar->centre.y - polar->radius * radius * cos(theta)};
    return point;
}

struct lab_point polar_at(const struct polar *polar, double theta, double value)
{
    return polar_at_radius(polar, theta, fmax(0.0, plot_scale_at(&polar->scale, value)));
}

static void draw_ring(struct plot_canvas *canvas, const struct polar *polar, double radius,
                      struct plot_color color, double width)
{
    cairo_new_path(canvas->cairo);
    cairo_arc(canvas->cairo, polar->centre.x, polar->centre.y, radius * polar->radius,
              polar->full ? 0.0 : pi, 2.0 * pi);
    cairo_set_dash(canvas->cairo, NULL, 0, 0.0);
    cairo_set_line_width(canvas->cairo, width);
    plot_set_color(canvas, color);
    cairo_stroke(canvas->cairo);
}

static void draw_spokes(struct plot_canvas *canvas, const struct polar *polar)
{
    int reach = polar->full ? 180 : 90;
    for (int degrees = -reach; degrees <= reach; degrees += 30) {
        if (degrees == -180) {
            continue;
        }
        double theta = degrees * pi / 180.0;
        struct lab_point rim = polar_at_radius(polar, theta, 1.0);
        plot_line(canvas, polar->centre, rim, 0.6, canvas->theme->grid, 0.0);
        char text[16];
        snprintf(text, sizeof text, "%d\xc2\xb0", abs(degrees));
        struct lab_point at = polar_at_radius(polar, theta, 1.0 + 6.0 / polar->radius);
        double drop = 2.9 + 2.9 * -cos(theta);
        plot_text(canvas, at.x, at.y + drop, 0.5 - 0.5 * sin(theta), plot_font_small(canvas), text);
    }
}

/* The numbers of the rings, under the surface's right half. */
static void draw_numbers(struct plot_canvas *canvas, const struct polar *polar, const char *label)
{
    double value;
    double baseline = polar->centre.y + 11.0;
    double free = -1e9; /* from where on there is room */
    for (int i = 0; plot_scale_tick(&polar->scale, i, &value); ++i) {
        char text[32];
        struct lab_point at = polar_at(polar, pi / 2.0, value);
        plot_scale_label(&polar->scale, value, text, sizeof text);
        double half = 0.5 * plot_text_width(canvas, plot_font_small(canvas), text);
        if (at.x - half > free) {
            plot_text_haloed(canvas, at.x, baseline, 0.5, plot_font_small(canvas), text);
            free = at.x + half + 4.0;
        }
    }
    double below = polar->full ? polar->centre.y + 22.0 : polar->centre.y + 24.0;
    plot_text_haloed(canvas, polar->centre.x + polar->radius, below, 1.0, plot_font_label(canvas),
                     label);
}

void polar_draw(struct plot_canvas *canvas, const struct polar *polar, int values,
                const char *label)
{
    draw_spokes(canvas, polar);
    double value;
    for (int i = 1; values && plot_scale_tick(&polar->scale, i, &value); ++i) {
        draw_ring(canvas, polar, plot_scale_at(&polar->scale, value), canvas->theme->grid, 0.6);
    }
    draw_ring(canvas, polar, 1.0, canvas->theme->grid, 0.9);
    struct lab_point left = {polar->centre.x - polar->radius, polar->centre.y};
    struct lab_point right = {polar->centre.x + polar->radius, polar->centre.y};
    plot_line(canvas, left, right, 0.9, canvas->theme->axis, 0.0);
    if (values) {
        draw_numbers(canvas, polar, label);
    }
}
