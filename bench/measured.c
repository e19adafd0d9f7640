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

/* The material described, with one file for all those that it may have. */
static brdf_status create_measured(const struct brdf_model_info *model, const char *description,
                                   const char *path, struct brdf_bsdf **out,
                                   struct brdf_error *error)
{
    char whole[4096];
    size_t length = strlen(description);
    const char *between = strchr(description, ':') ? "," : ":";
    snprintf(whole, sizeof whole, "%s", description);
    for (size_t i = 0; i < model->parameter_count && length < sizeof whole; ++i) {
        if (model->parameters[i].kind == BRDF_KIND_FILE) {
            length += (size_t)snprintf(whole + length, sizeof whole - length, "%s%s=%s", between,
                                       model->parameters[i].name, path);
            between = ",";
        }
    }
    if (length >= sizeof whole) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "%s: too long a description", description);
    }
    return brdf_bsdf_create(whole, out, error);
}

static brdf_status create_copper(const struct brdf_model_info *model, const char *description,
                                 const struct format *format, struct brdf_bsdf **out,
                                 struct brdf_error *error)
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
        status = create_measured(model, description, path, out, error);
    }
    unlink(path);
    return status;
}

/* The model that is described, if it needs a file and none is named; else NULL. */
static const struct brdf_model_info *model_without_file(const char *description)
{
    char name[64];
    const struct brdf_model_info *model = NULL;
    size_t length = strcspn(description, ":");
    if (length < sizeof name && !strstr(description, "filename")) {
        memcpy(name, description, length);
        name[length] = '\0';
        model = brdf_model_find(name);
    }
    return model && (model->flags & BRDF_TABULATED) ? model : NULL;
}

brdf_status measured_bsdf_create(const char *description, struct brdf_bsdf **out,
                                 struct brdf_error *error)
{
    const struct brdf_model_info *model = model_without_file(description);
    *out = NULL;
    if (!model) {
        return lab_open(description, out, NULL, error);
    }
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; ++i) {
        if (strcmp(model->name, formats[i].model) == 0) {
            return create_copper(model, description, &formats[i], out, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED, "%s needs a file: name it as in \"%s:filename=FILE\"",
                     model->name, model->name);
}
