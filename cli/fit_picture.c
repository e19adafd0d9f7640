/* fit_picture.c - a fit beside what it was fitted to. */
#define _POSIX_C_SOURCE 200809L
#include "fit_picture.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <brdf/merl.h>

#include "brdflab/bake.h"
#include "brdflab/plot.h"

#include "stop.h"

/* f of the blend, for one pair of directions. */
static void blend(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    const struct lab_fit_result *fit = data;
    brdf_vec3 o = brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]);
    brdf_vec3 i = brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]);
    rgb[0] = rgb[1] = rgb[2] = 0.0;
    for (int k = 0; k < fit->part_count; ++k) {
        brdf_rgb f = brdf_eval(fit->parts[k], o, i);
        rgb[0] += fit->weights[k] * (double)f.r;
        rgb[1] += fit->weights[k] * (double)f.g;
        rgb[2] += fit->weights[k] * (double)f.b;
    }
}

/* The blend as one bsdf, by way of a file that is gone at once. */
static brdf_status bake(const struct lab_fit_result *fit, struct brdf_bsdf **bsdf,
                        struct brdf_error *error)
{
    const char *folder = getenv("TMPDIR");
    char path[4096];
    struct brdf_merl_file table;
    struct lab_fit_result copy = *fit;
    for (int k = 0; k < fit->part_count; ++k) {
        if (lab_anisotropy(fit->parts[k]) > 1e-3) {
            return brdf_fail(error, BRDF_UNSUPPORTED,
                             "no picture of a blend whose parts are anisotropic");
        }
    }
    brdf_status status = brdf_merl_make(blend, &copy, &table, error);
    if (status) {
        return status;
    }
    stop_wait(); /* until the file is gone */
    snprintf(path, sizeof path, "%s/brdfcl-fit-XXXXXX", folder && *folder ? folder : "/tmp");
    int file = mkstemp(path);
    if (file < 0) {
        status = brdf_fail(error, BRDF_IO, "%s: %s", path, strerror(errno));
    } else {
        close(file);
        status = brdf_merl_write(path, &table, error);
        if (!status) {
            struct brdf_setting setting = brdf_setting_text("filename", path);
            status = brdf_bsdf_create_from("merl", &setting, 1, bsdf, error);
        }
        unlink(path);
    }
    stop_resume();
    brdf_merl_free(&table);
    return status;
}

brdf_status fit_picture_write(const char *path, const struct brdf_bsdf *target, const char *name,
                              const struct lab_fit_result *fit, struct brdf_error *error)
{
    struct lab_plot_settings settings = lab_plot_settings_initial();
    struct brdf_bsdf *baked = NULL;
    char caption[2048], title[128];
    brdf_status status = fit->part_count > 1 ? bake(fit, &baked, error) : BRDF_OK;
    if (status) {
        return status;
    }
    if (baked) {
        snprintf(caption, sizeof caption, "blend of %d parts", fit->part_count);
    } else {
        brdf_bsdf_describe(fit->parts[0], caption, sizeof caption);
    }
    snprintf(title, sizeof title, "Fit with an error of %.4g", fit->error);
    settings.title = title;
    settings.on_write = stop_wait;
    struct lab_plot_material materials[2] = {{target, name},
                                             {baked ? baked : fit->parts[0], caption}};
    status = lab_plot_write(path, materials, 2, &settings, error);
    brdf_bsdf_destroy(baked);
    return status;
}
