/* panel_image.c - f over the half and the difference angle, as an image. */
#include <math.h>
#include <stdlib.h>

#include <brdf/merl.h>
#include <brdf/model.h>

#include "angle.h"
#include "plot_panels.h"

/* f where phi_d = -90 degrees: wo and wi lie theta_d to either side of h, across the plane that h
   is tilted in, and so are above the surface at every pair of angles. */
static brdf_rgb value_at(const struct brdf_bsdf *bsdf, double theta_h, double theta_d,
                         double azimuth)
{
    double wo[3], wi[3];
    brdf_merl_directions_at(theta_h, azimuth, theta_d, -0.5 * pi, wo, wi);
    return brdf_eval(bsdf, brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]),
                     brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]));
}

/* pi f, darkened by its luminance: white that scatters evenly becomes one half. */
static void tone_map(brdf_rgb f, float rgb[3])
{
    double bright = pi * (double)brdf_rgb_luminance(f);
    double factor = pi / (1.0 + bright);
    rgb[0] = (float)(factor * (double)f.r);
    rgb[1] = (float)(factor * (double)f.g);
    rgb[2] = (float)(factor * (double)f.b);
}

brdf_status plot_panel_image(struct plot_canvas *canvas, struct plot_box cell,
                             const struct plot_job *job, int material, struct brdf_error *error)
{
    struct plot_box box = plot_axes_room(cell);
    struct plot_axes axes = {box,
                             plot_scale_fixed(0.0, 90.0, 30.0),
                             plot_scale_fixed(0.0, 90.0, 30.0),
                             "\xce\xb8_h \xe2\x86\x92",
                             "\xe2\x86\x91 \xce\xb8_d",
                             "\xc2\xb0",
                             "\xc2\xb0"};
    const struct brdf_bsdf *bsdf = job->materials[material].bsdf;
    plot_axes_draw(canvas, &axes);
    if (brdf_bsdf_material(bsdf)->flags & BRDF_DELTA) {
        plot_text(canvas, box.x + 0.5 * box.w, box.y + 0.5 * box.h, 0.5, plot_font_small(canvas),
                  "delta lobes have no f");
        return BRDF_OK;
    }
    int width = (int)ceil(box.w * canvas->scale);
    int height = (int)ceil(box.h * canvas->scale);
    float *rgb = malloc(3 * (size_t)width * (size_t)height * sizeof *rgb);
    if (!rgb) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %d x %d pixels", width, height);
    }
    for (int y = 0; y < height; ++y) {
        double theta_d = 0.5 * pi * (1.0 - (y + 0.5) / height);
        for (int x = 0; x < width; ++x) {
            double theta_h = 0.5 * pi * (x + 0.5) / width;
            tone_map(value_at(bsdf, theta_h, theta_d, job->settings->azimuth),
                     rgb + 3 * ((size_t)y * (size_t)width + (size_t)x));
        }
    }
    brdf_status status = plot_pixels(canvas, box, rgb, width, height, error);
    free(rgb);
    return status;
}
