/* plot_axes.c - Cartesian axes: thin lines at the ticks, labels at the ends. */
#include <stdio.h>

#include "plot_panels.h"

struct plot_font plot_font_small(const struct plot_canvas *canvas)
{
    struct plot_font font = {8.5, PLOT_REGULAR, canvas->theme->text, 0};
    return font;
}

struct plot_font plot_font_label(const struct plot_canvas *canvas)
{
    struct plot_font font = {9.0, PLOT_REGULAR, canvas->theme->ink, 0};
    return font;
}

struct plot_box plot_axes_room(struct plot_box cell)
{
    return plot_box_within(cell, 34.0, 16.0, 12.0, 30.0);
}

struct lab_point plot_axes_at(const struct plot_axes *axes, double x, double y)
{
    struct lab_point point = {axes->box.x + axes->box.w * plot_scale_at(&axes->x, x),
                              axes->box.y + axes->box.h * (1.0 - plot_scale_at(&axes->y, y))};
    return point;
}

static void draw_x(struct plot_canvas *canvas, const struct plot_axes *axes)
{
    const struct plot_box *box = &axes->box;
    double bottom = box->y + box->h;
    double value;
    for (int i = 0; plot_scale_tick(&axes->x, i, &value); ++i) {
        char number[32], text[48];
        double x = plot_axes_at(axes, value, axes->y.low).x;
        struct lab_point top = {x, box->y}, end = {x, bottom};
        plot_line(canvas, top, end, 0.6, canvas->theme->grid, 0.0);
        plot_scale_label(&axes->x, value, number, sizeof number);
        snprintf(text, sizeof text, "%s%s", number, axes->x_unit);
        plot_text(canvas, x, bottom + 12.0, 0.5, plot_font_small(canvas), text);
    }
    plot_text(canvas, box->x + box->w, bottom + 24.0, 1.0, plot_font_label(canvas), axes->x_label);
}

static void draw_y(struct plot_canvas *canvas, const struct plot_axes *axes)
{
    const struct plot_box *box = &axes->box;
    double value;
    for (int i = 0; plot_scale_tick(&axes->y, i, &value); ++i) {
        char number[32], text[48];
        double y = plot_axes_at(axes, axes->x.low, value).y;
        struct lab_point left = {box->x, y}, right = {box->x + box->w, y};
        plot_line(canvas, left, right, 0.6, canvas->theme->grid, 0.0);
        plot_scale_label(&axes->y, value, number, sizeof number);
        snprintf(text, sizeof text, "%s%s", number, axes->y_unit);
        plot_text(canvas, box->x - 5.0, y + 2.9, 1.0, plot_font_small(canvas), text);
    }
    plot_text(canvas, box->x - 24.0, box->y - 8.0, 0.0, plot_font_label(canvas), axes->y_label);
}

void plot_axes_draw(struct plot_canvas *canvas, const struct plot_axes *axes)
{
    const struct plot_box *box = &axes->box;
    draw_x(canvas, axes);
    draw_y(canvas, axes);
    struct lab_point left = {box->x, box->y + box->h}, right = {box->x + box->w, left.y};
    plot_line(canvas, left, right, 0.9, canvas->theme->axis, 0.0);
}

void plot_axes_curve(struct plot_canvas *canvas, const struct plot_axes *axes,
                     const struct lab_curve *curve, double width, struct plot_color color,
                     double dash)
{
    const struct plot_box *box = &axes->box;
    cairo_save(canvas->cairo);
    cairo_rectangle(canvas->cairo, box->x, box->y - 1.0, box->w, box->h + 1.0);
    cairo_clip(canvas->cairo);
    plot_curve(canvas, curve, width, color, dash, 0.0);
    cairo_restore(canvas->cairo);
}
