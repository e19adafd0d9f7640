/* measured.c - a material for every model, also for those that need a measurement. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <brdf/info.h>
#include <brdf/merl.h>
#include <brdf/rgl.h>

#include "arrays.h"
#include "brdflab/open.h"

static void copper(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    brdf_rgb f = brdf_eval(data, brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]),
                           brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]));
    rgb[0] = (double)f.r;
    rgb[1] = (double)f.g;
    rgb[2] = (double)f.b;
}

static void copper_channels(const double wo[3], const double wi[3], int channels,
                            const float *wavelengths, double *values, void *data)
{
    (void)channels; /* 3, for there are no wavelengths */
    (void)wavelengths;
    copper(wo, wi, values, data);
}

static brdf_status write_merl(const char *path, struct brdf_bsdf *bsdf, struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = brdf_merl_make(copper, bsdf, &file, error);
    if (!status) {
        status = brdf_merl_write(path, &file, error);
        brdf_merl_free(&file);
    }
    return status;
}

static brdf_status write_rgl(const char *path, struct brdf_bsdf *bsdf, struct brdf_error *error)
{
    struct brdf_rgl_file file;
    brdf_status status = brdf_rgl_make(copper_channels, bsdf, NULL, &file, error);
    if (!status) {
        status = brdf_rgl_write(path, &file, error);
        brdf_rgl_free(&file);
    }
    return status;
}

/* How a measurement of rough copper is written in the format of each model's files. */
static const struct format {
    const char *model;
    brdf_status (*write)(const char *path, struct brdf_bsdf *bsdf, struct brdf_error *error);
} formats[] = {
    {"merl", write_merl},
    {"measuredmix", write_merl},
    {"measured", write_rgl},
};

/* A material of the model, with one file for all those that it may have. */
static brdf_status create_measured(const struct brdf_model_info *model, const char *path,
                                   struct brdf_bsdf **out, struct brdf_error *error)
{
    struct brdf_setting settings[4];
    size_t count = 0;
    for (size_t i = 0; i < model->parameter_count && count < 4; ++i) {
        if (model->parameters[i].kind == BRDF_KIND_FILE) {
            settings[count++] = brdf_setting_text(model->parameters[i].name, path);
        }
    }
    return brdf_bsdf_create_from(model->name, settings, count, out, error);
}

static brdf_status create_copper(const struct brdf_model_info *model, const struct format *format,
                                 struct brdf_bsdf **out, struct brdf_error *error)
{
    const char *folder = getenv("TMPDIR");
    char path[1024];
    int length =
        snprintf(path, sizeof path, "%s/brdfcl-bench.XXXXXX", folder && *folder ? folder : "/tmp");
    int fd = length < (int)sizeof path ? mkstemp(path) : -1;
    if (fd < 0) {
        return brdf_fail(error, BRDF_IO, "%s: no temporary file can be made", path);
    }
    close(fd);
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = brdf_bsdf_create("roughconductor:material=Cu,alpha=0.2", &bsdf, error);
    if (!status) {
        status = format->write(path, bsdf, error);
    }
    brdf_bsdf_destroy(bsdf);
    if (!status) {
        status = create_measured(model, path, out, error);
    }
    unlink(path);
    return status;
}

brdf_status measured_bsdf_create(const char *description, struct brdf_bsdf **out,
                                 struct brdf_error *error)
{
    const struct brdf_model_info *model = brdf_model_find(description);
    *out = NULL;
    if (!model || !(model->flags & BRDF_TABULATED)) {
        return lab_open(description, out, NULL, error);
    }
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; ++i) {
        if (strcmp(model->name, formats[i].model) == 0) {
            return create_copper(model, &formats[i], out, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED, "%s needs a file: name it as in \"%s:filename=FILE\"",
                     model->name, model->name);
}
