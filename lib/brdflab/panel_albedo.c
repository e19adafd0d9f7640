/* panel_albedo.c - the share of a beam's power that leaves again, over the angle of incidence. */
#include <math.h>
#include <stdio.h>

#include "albedo.h"
#include "angle.h"
#include "plot_panels.h"

enum { STEPS = 90, SAMPLES = 16384 };

static double channel_of(enum lab_channel channel, const double rgb[3])
{
    return lab_channel_of(channel, brdf_rgb_make((float)rgb[0], (float)rgb[1], (float)rgb[2]));
}

/* Reflected, transmitted, and both, at each step. */
struct shares {
    struct lab_point point[3][STEPS + 1];
};

static void measure(const struct plot_job *job, int material, const struct plot_axes *axes,
                    struct shares *shares)
{
    enum lab_channel channel = job->settings->channel;
    for (int i = 0; i <= STEPS; ++i) {
        double theta = fmin(89.9, 90.0 * i / STEPS);
        struct lab_section section = {job->materials[material].bsdf, job->settings->azimuth,
                                      theta * degree, channel};
        struct lab_albedo albedo =
            lab_albedo_at(section.bsdf, lab_section_light(&section), SAMPLES);
        double r = channel_of(channel, albedo.reflection);
        double t = channel_of(channel, albedo.transmission);
        double y[3] = {r + t, r, t};
        for (int k = 0; k < 3; ++k) {
            shares->point[k][i] = plot_axes_at(axes, theta, y[k]);
        }
    }
}

/* How far a height is from what the curves do to the left, where the number is written. */
static double clearance(const struct shares *shares, int curves, double y)
{
    double least = 1e9;
    for (int k = 0; k < curves; ++k) {
        for (int i = 0; i <= STEPS / 2; ++i) {
            least = fmin(least, fabs(shares->point[k][i].y - y));
        }
    }
    return least;
}

/* What the surface does to diffuse light, written where no curve is. */
static void draw_average(struct plot_canvas *canvas, const struct plot_job *job, int material,
                         const struct plot_box *box, const struct shares *shares, int curves)
{
    enum lab_channel channel = job->settings->channel;
    struct lab_albedo albedo =
        lab_albedo_average(job->materials[material].bsdf, 0, 4 * (size_t)SAMPLES);
    char text[48];
    snprintf(text, sizeof text, "average %.3f",
             channel_of(channel, albedo.reflection) + channel_of(channel, albedo.transmission));
    double best = box->y + 0.125 * box->h;
    for (int i = 1; i < 8; i += 2) {
        double y = box->y + 0.125 * i * box->h;
        if (clearance(shares, curves, y) > clearance(shares, curves, best)) {
            best = y;
        }
    }
    plot_text(canvas, box->x + 6.0, best + 3.0, 0.0, plot_font_small(canvas), text);
}

brdf_status plot_panel_albedo(struct plot_canvas *canvas, struct plot_box cell,
                              const struct plot_job *job, int material, struct brdf_error *error)
{
    (void)error;
    struct plot_axes axes = {plot_axes_room(cell),
                             plot_scale_fixed(0.0, 90.0, 30.0),
                             job->albedo,
                             "\xce\xb8_i \xe2\x86\x92",
                             "\xe2\x86\x91 share of the power",
                             "\xc2\xb0",
                             ""};
    plot_axes_draw(canvas, &axes);
    struct shares shares;
    measure(job, material, &axes, &shares);
    static const char *const name[3] = {"", "reflected", "transmitted"};
    int parts = lab_transmits(job->materials[material].bsdf);
    draw_average(canvas, job, material, &axes.box, &shares, parts ? 3 : 1);
    for (int k = parts ? 2 : 0; k >= 0; --k) {
        struct lab_curve curve = {shares.point[k], STEPS + 1};
        struct plot_color color = k ? plot_color_of(canvas->theme, k, 3) : canvas->theme->ink;
        plot_axes_curve(canvas, &axes, &curve, k ? 1.2 : 1.8, color, 0.0);
        struct plot_font font = plot_font_small(canvas);
        font.color = color;
        struct lab_point at = shares.point[k][STEPS / 5];
        double lift = at.y > axes.box.y + axes.box.h - 12.0 || k == 1 ? -4.0 : 11.0;
        plot_text(canvas, at.x, at.y + lift, 0.0, font, name[k]);
    }
    return BRDF_OK;
}
