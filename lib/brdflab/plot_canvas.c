/* plot_canvas.c - colours, lines and pixels. */
#include "plot_canvas.h"
#include "angle.h"

#include <math.h>
#include <stdint.h>

struct plot_box plot_box_within(struct plot_box box, double left, double top, double right,
                                double bottom)
{
    struct plot_box inner = {box.x + left, box.y + top, box.w - left - right, box.h - top - bottom};
    return inner;
}

const struct plot_theme *plot_theme(int dark)
{
    static const struct plot_theme light_theme = {{1.0, 1.0, 1.0, 1.0},
                                                  {0.11, 0.12, 0.14, 1.0},
                                                  {0.38, 0.40, 0.43, 1.0},
                                                  {0.60, 0.62, 0.65, 1.0},
                                                  {0.90, 0.91, 0.92, 1.0},
                                                  0.03,
                                                  0.78};
    static const struct plot_theme dark_theme = {{0.075, 0.082, 0.098, 1.0},
                                                 {0.95, 0.95, 0.96, 1.0},
                                                 {0.66, 0.68, 0.71, 1.0},
                                                 {0.42, 0.44, 0.48, 1.0},
                                                 {0.18, 0.19, 0.22, 1.0},
                                                 0.36,
                                                 0.94};
    return dark ? &dark_theme : &light_theme;
}

struct plot_color plot_color_of(const struct plot_theme *theme, int i, int count)
{
    static const unsigned char ramp[10][3] = {
        {13, 8, 135},   {70, 3, 159},   {114, 1, 168},  {156, 23, 158}, {189, 55, 134},
        {216, 87, 107}, {237, 121, 83}, {251, 159, 58}, {253, 202, 38}, {240, 249, 33}};
    double t = count > 1 ? (double)i / (count - 1) : 0.3;
    double place = 9.0 * (theme->first + (theme->last - theme->first) * t);
    int below = (int)fmin(8.0, floor(place));
    double above = place - below;
    double channel[3];
    for (int c = 0; c < 3; ++c) {
        channel[c] = (ramp[below][c] * (1.0 - above) + ramp[below + 1][c] * above) / 255.0;
    }
    struct plot_color color = {channel[0], channel[1], channel[2], 1.0};
    return color;
}

void plot_set_color(struct plot_canvas *canvas, struct plot_color color)
{
    cairo_set_source_rgba(canvas->cairo, color.r, color.g, color.b, color.a);
}

struct plot_color plot_faded(struct plot_color color, double alpha)
{
    color.a *= alpha;
    return color;
}

/* Draw what the path is, as a line. */
static void stroke(struct plot_canvas *canvas, double width, struct plot_color color, double dash)
{
    cairo_t *cairo = canvas->cairo;
    double dashes[2] = {dash, 0.8 * dash};
    cairo_set_dash(cairo, dashes, dash > 0.0 ? 2 : 0, 0.0);
    cairo_set_line_width(cairo, width);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    plot_set_color(canvas, color);
    cairo_stroke(cairo);
}

void plot_line(struct plot_canvas *canvas, struct lab_point from, struct lab_point to, double width,
               struct plot_color color, double dash)
{
    cairo_move_to(canvas->cairo, from.x, from.y);
    cairo_line_to(canvas->cairo, to.x, to.y);
    stroke(canvas, width, color, dash);
}

void plot_arrow(struct plot_canvas *canvas, struct lab_point from, struct lab_point to,
                double width, struct plot_color color)
{
    double along = atan2(to.y - from.y, to.x - from.x);
    double size = 4.0 + 1.5 * width;
    double spread = pi * 0.125;
    struct lab_point neck = {to.x - 0.8 * size * cos(along), to.y - 0.8 * size * sin(along)};
    plot_line(canvas, from, neck, width, color, 0.0);
    cairo_move_to(canvas->cairo, to.x, to.y);
    cairo_line_to(canvas->cairo, to.x - size * cos(along - spread),
                  to.y - size * sin(along - spread));
    cairo_line_to(canvas->cairo, to.x - size * cos(along + spread),
                  to.y - size * sin(along + spread));
    cairo_close_path(canvas->cairo);
    plot_set_color(canvas, color);
    cairo_fill(canvas->cairo);
}

void plot_curve(struct plot_canvas *canvas, const struct lab_curve *curve, double width,
                struct plot_color color, double dash, double fill)
{
    cairo_t *cairo = canvas->cairo;
    cairo_new_path(cairo);
    for (size_t i = 0; i < curve->count; ++i) {
        cairo_line_to(cairo, curve->point[i].x, curve->point[i].y);
    }
    if (fill > 0.0) {
        plot_set_color(canvas, plot_faded(color, fill));
        cairo_fill_preserve(cairo);
    }
    stroke(canvas, width, color, dash);
}

static uint32_t encoded(float linear)
{
    double x = linear > 0.0f ? fmin(1.0, (double)linear) : 0.0; /* also a NaN is 0 */
    double curve = x <= 0.0031308 ? 12.92 * x : 1.055 * pow(x, 1.0 / 2.4) - 0.055;
    return (uint32_t)(255.0 * curve + 0.5);
}

brdf_status plot_pixels(struct plot_canvas *canvas, struct plot_box box, const float *rgb,
                        int width, int height, struct brdf_error *error)
{
    cairo_surface_t *pixels = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    if (cairo_surface_status(pixels) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(pixels);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %d x %d pixels", width, height);
    }
    unsigned char *bytes = cairo_image_surface_get_data(pixels);
    int stride = cairo_image_surface_get_stride(pixels);
    for (int y = 0; y < height; ++y) {
        uint32_t *row = (uint32_t *)(void *)(bytes + (size_t)stride * (size_t)y);
        for (int x = 0; x < width; ++x) {
            const float *p = rgb + 3 * ((size_t)y * (size_t)width + (size_t)x);
            row[x] = encoded(p[0]) << 16 | encoded(p[1]) << 8 | encoded(p[2]);
        }
    }
    cairo_surface_mark_dirty(pixels);
    cairo_save(canvas->cairo);
    cairo_translate(canvas->cairo, box.x, box.y);
    cairo_scale(canvas->cairo, box.w / width, box.h / height);
    cairo_set_source_surface(canvas->cairo, pixels, 0.0, 0.0);
    cairo_pattern_set_filter(cairo_get_source(canvas->cairo), CAIRO_FILTER_BILINEAR);
    cairo_pattern_set_extend(cairo_get_source(canvas->cairo), CAIRO_EXTEND_PAD);
    cairo_rectangle(canvas->cairo, 0.0, 0.0, width, height);
    cairo_fill(canvas->cairo);
    cairo_restore(canvas->cairo);
    cairo_surface_destroy(pixels);
    return BRDF_OK;
}
