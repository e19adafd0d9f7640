/* panel_lobe.c - lobes in the plane of incidence. */
#include <math.h>
#include <stdio.h>

#include "angle.h"
#include "plot_panels.h"
#include "polar.h"

struct lobe {
    const struct polar *polar;
    struct lab_section section;
};

static struct lab_point lobe_at(double theta, const void *data)
{
    const struct lobe *lobe = data;
    return polar_at(lobe->polar, theta, lab_section_lobe(&lobe->section, theta));
}

static brdf_status draw_curve(struct plot_canvas *canvas, const struct lobe *lobe,
                              struct plot_color color, int across, struct brdf_error *error)
{
    double seed[LAB_SECTION_SEEDS];
    int count = lab_section_seeds(&lobe->section, seed);
    double high = lab_section_high(lobe->polar->full);
    struct lab_curve curve;
    brdf_status status =
        lab_curve_trace(lobe_at, lobe, lab_section_low(), high, seed, count, 0.03, &curve, error);
    if (!status) {
        plot_curve(canvas, &curve, across ? 0.9 : 1.3, color, across ? 3.0 : 0.0,
                   across ? 0.0 : 0.09);
    }
    lab_curve_free(&curve);
    return status;
}

/* The light: an arrow that comes in over the rim. */
static void draw_light(struct plot_canvas *canvas, const struct lobe *lobe, struct plot_color color)
{
    struct lab_point from = polar_at_radius(lobe->polar, -lobe->section.incidence, 1.0);
    struct lab_point to = polar_at_radius(lobe->polar, -lobe->section.incidence, 0.86);
    plot_arrow(canvas, from, to, 1.0, color);
}

/* Where the last numbers of delta lobes were written, above and below the surface, so that the next
   goes beside it and not upon it. */
struct numbers {
    struct lab_point last[2];
};

/* How far from the rim arrows end [points]: the number has the rest. */
static const double number_room = 27.0;

static void draw_number(struct plot_canvas *canvas, const struct lobe *lobe,
                        const struct lab_delta *delta, struct plot_color color,
                        struct numbers *numbers)
{
    struct plot_font font = plot_font_small(canvas);
    font.color = color;
    char text[32];
    snprintf(text, sizeof text, delta->power < 0.0995 ? "%.1f %%" : "%.0f %%",
             100.0 * delta->power);
    struct lab_point *last = &numbers->last[delta->theta > pi / 2.0];
    double theta = delta->theta;
    double radius = 1.0 - (number_room - 4.0) / lobe->polar->radius;
    struct lab_point at = polar_at_radius(lobe->polar, theta, radius);
    while (hypot(0.5 * (at.x - last->x), at.y - last->y) < 10.0 && theta > delta->theta - 0.5) {
        theta -= 0.02; /* towards the horizon, where refracted angles grow sparse */
        at = polar_at_radius(lobe->polar, theta, radius);
    }
    *last = at;
    double drop = 3.0 - 5.0 * cos(theta);
    plot_text_haloed(canvas, at.x, at.y + drop, 0.5 - 0.5 * sin(theta), font, text);
}

static void draw_deltas(struct plot_canvas *canvas, const struct lobe *lobe,
                        struct plot_color color, struct numbers *numbers)
{
    struct lab_delta delta[LAB_SECTION_DELTAS];
    int count = lab_section_deltas(&lobe->section, delta);
    for (int i = 0; i < count; ++i) {
        struct lab_point head =
            polar_at_radius(lobe->polar, delta[i].theta, 1.0 - number_room / lobe->polar->radius);
        plot_arrow(canvas, lobe->polar->centre, head, 0.5 + 1.7 * sqrt(fmax(0.0, delta[i].power)),
                   color);
        draw_number(canvas, lobe, &delta[i], color, numbers);
    }
}

/* The largest f cos of all curves of a material. */
static double peak_of(const struct plot_job *job, int material)
{
    double peak = 0.0;
    double high = lab_section_high(job->transmits);
    int anisotropic = lab_anisotropic(job->materials[material].bsdf);
    for (int i = 0; i < job->settings->angles; ++i) {
        for (int across = 0; across <= anisotropic; ++across) {
            struct lab_section section = plot_job_section(job, material, i, across);
            peak = fmax(peak, lab_section_peak(&section, 1, lab_section_low(), high));
        }
    }
    return peak;
}

brdf_status plot_panel_lobe(struct plot_canvas *canvas, struct plot_box cell,
                            const struct plot_job *job, int material, struct brdf_error *error)
{
    const struct lab_plot_settings *settings = job->settings;
    double peak = peak_of(job, material);
    struct polar polar = polar_within(
        cell, job->transmits, settings->logarithmic ? job->lobe_log : plot_scale_linear(peak, 4));
    polar_draw(canvas, &polar, peak > 0.0, "f cos \xce\xb8_o [1/sr] \xe2\x86\x92");
    struct numbers numbers = {{{-100.0, 0.0}, {-100.0, 0.0}}};
    int anisotropic = lab_anisotropic(job->materials[material].bsdf);
    for (int i = 0; i < settings->angles; ++i) {
        struct plot_color color = plot_color_of(canvas->theme, i, settings->angles);
        for (int across = anisotropic; across >= 0; --across) {
            struct lobe lobe = {&polar, plot_job_section(job, material, i, across)};
            brdf_status status =
                peak > 0.0 ? draw_curve(canvas, &lobe, color, across, error) : BRDF_OK;
            if (status) {
                return status;
            }
            if (!across) {
                draw_light(canvas, &lobe, color);
                draw_deltas(canvas, &lobe, color, &numbers);
            }
        }
    }
    return BRDF_OK;
}
