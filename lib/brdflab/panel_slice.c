/* panel_slice.c - f over the angle at which light leaves, logarithmic. */
#include <math.h>

#include "angle.h"
#include "plot_panels.h"

struct slice {
    const struct plot_axes *axes;
    struct lab_section section;
};

static struct lab_point slice_at(double theta, const void *data)
{
    const struct slice *slice = data;
    const struct plot_axes *axes = slice->axes;
    double f = lab_section_f(&slice->section, theta);
    /* Far below the axis is below it: finite, so that the clipped line falls straight. */
    return plot_axes_at(axes, theta / degree, fmax(f, axes->y.low * 1e-2));
}

static brdf_status draw_curve(struct plot_canvas *canvas, const struct slice *slice, double high,
                              struct plot_color color, double dash, struct brdf_error *error)
{
    double seed[LAB_SECTION_SEEDS];
    int count = lab_section_seeds(&slice->section, seed);
    struct lab_curve curve;
    brdf_status status =
        lab_curve_trace(slice_at, slice, lab_section_low(), high, seed, count, 0.05, &curve, error);
    if (!status) {
        plot_axes_curve(canvas, slice->axes, &curve, 1.3, color, dash);
    }
    lab_curve_free(&curve);
    return status;
}

/* Delta lobes have no f: a mark above the axis where they are. */
static void draw_deltas(struct plot_canvas *canvas, const struct slice *slice,
                        struct plot_color color)
{
    struct lab_delta delta[LAB_SECTION_DELTAS];
    int count = lab_section_deltas(&slice->section, delta);
    for (int i = 0; i < count; ++i) {
        struct lab_point foot =
            plot_axes_at(slice->axes, delta[i].theta / degree, slice->axes->y.low);
        struct lab_point head = {foot.x, slice->axes->box.y + 4.0};
        plot_arrow(canvas, foot, head, 1.3, color);
    }
}

brdf_status plot_panel_slice(struct plot_canvas *canvas, struct plot_box cell,
                             const struct plot_job *job, int material, struct brdf_error *error)
{
    const struct lab_plot_settings *settings = job->settings;
    double high = lab_section_high(job->transmits);
    struct plot_axes axes = {plot_axes_room(cell),
                             plot_scale_fixed(-90.0, high / degree, job->transmits ? 90.0 : 30.0),
                             job->slice,
                             "\xce\xb8_o \xe2\x86\x92",
                             "\xe2\x86\x91 f [1/sr]",
                             "\xc2\xb0",
                             ""};
    plot_axes_draw(canvas, &axes);
    int anisotropic = lab_anisotropic(job->materials[material].bsdf);
    for (int i = 0; i < settings->angles; ++i) {
        struct plot_color color = plot_color_of(canvas->theme, i, settings->angles);
        for (int across = 0; across <= anisotropic; ++across) {
            struct slice slice = {&axes, plot_job_section(job, material, i, across)};
            brdf_status status = draw_curve(canvas, &slice, high, color, across ? 3.0 : 0.0, error);
            if (status) {
                return status;
            }
            if (!across) {
                draw_deltas(canvas, &slice, color);
            }
        }
    }
    return BRDF_OK;
}
