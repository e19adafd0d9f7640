/*
 * check_measurement.c - files for models that read a measurement, made from a formula.
 */
#define _POSIX_C_SOURCE 200809L
#include "check_cases.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <brdf/merl.h>
#include <brdf/rgl.h>

/*
 * Diffuse, and a glossy reciprocal lobe about the normal: something of everything, in colour. The
 * lobe's width depends on the number of the file, so that two are not alike.
 */
static void painted(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    double width2 = 0.04 * (1.0 + 3.0 * *(const int *)data);
    double x = wo[0] + wi[0];
    double y = wo[1] + wi[1];
    double z = wo[2] + wi[2];
    double slope2 = (x * x + y * y) / (z * z);
    double grazing = 1.0 - sqrt(0.25 * (x * x + y * y + z * z)); /* 1 - cos(theta_d) */
    double shine = 0.8 * exp(-slope2 / width2) / (wo[2] + wi[2]) * (0.2 + 0.8 * grazing * grazing);
    rgb[0] = 0.10 + shine;
    rgb[1] = 0.05 + shine;
    rgb[2] = 0.02 + 0.7 * shine;
}

static brdf_status merl_write(const char *path, int number, struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = brdf_merl_make(painted, &number, &file, error);
    if (!status) {
        status = brdf_merl_write(path, &file, error);
        brdf_merl_free(&file);
    }
    return status;
}

static void painted_channels(const double wo[3], const double wi[3], int channels,
                             const float *wavelengths, double *values, void *data)
{
    (void)channels; /* 3, for there are no wavelengths */
    (void)wavelengths;
    painted(wo, wi, values, data);
}

static brdf_status rgl_write(const char *path, int number, struct brdf_error *error)
{
    struct brdf_rgl_file file;
    const struct brdf_rgl_grid grid = {.description = "diffuse, and a glossy lobe"};
    brdf_status status = brdf_rgl_make(painted_channels, &number, &grid, &file, error);
    if (!status) {
        status = brdf_rgl_write(path, &file, error);
        brdf_rgl_free(&file);
    }
    return status;
}

/* Every format that a FILE parameter can be of, found by a word of the parameter's meaning. */
static const struct maker {
    const char *word;
    brdf_status (*write)(const char *path, int number, struct brdf_error *error);
} makers[] = {
    {"MERL", merl_write},
    {"RGL", rgl_write},
};

static brdf_status measurement_write(const struct brdf_parameter_info *parameter, const char *path,
                                     int number, struct brdf_error *error)
{
    for (size_t i = 0; i < sizeof makers / sizeof makers[0]; ++i) {
        if (strstr(parameter->meaning, makers[i].word)) {
            return makers[i].write(path, number, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED,
                     "no file can be made for the parameter %s (%s): describe the material with a "
                     "file of its own",
                     parameter->name, parameter->meaning);
}

/* A description that is completed with files in a temporary folder. */
struct completion {
    char text[2048];
    char folder[512];
    int files; /* FOLDER/0, FOLDER/1, ... */
};

static void file_path(const struct completion *completion, int number, char *path, size_t size)
{
    snprintf(path, size, "%s/%d", completion->folder, number);
}

/* Write one more file and name it in the description. */
static brdf_status file_add(struct completion *completion,
                            const struct brdf_parameter_info *parameter, struct brdf_error *error)
{
    char path[600];
    file_path(completion, completion->files, path, sizeof path);
    brdf_status status = measurement_write(parameter, path, completion->files, error);
    completion->files += status == BRDF_OK;
    size_t length = strlen(completion->text), room = sizeof completion->text - length;
    char mark = strchr(completion->text, ':') ? ',' : ':';
    int more =
        snprintf(completion->text + length, room, "%c%s=\"%s\"", mark, parameter->name, path);
    if (!status && (more < 0 || (size_t)more >= room)) {
        status = brdf_fail(error, BRDF_BAD_ARGUMENT, "the description is too long: %s",
                           completion->text);
    }
    return status;
}

/* Files for all FILE parameters that the description leaves open. */
static brdf_status files_add(struct completion *completion, const struct brdf_model_info *model,
                             struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < model->parameter_count && !status; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        if (parameter->kind == BRDF_KIND_FILE && !strstr(completion->text, parameter->name)) {
            status = file_add(completion, parameter, error);
        }
    }
    return status;
}

/* Options for which a table is computed, unless the description has chosen: all variants share it.
 */
static brdf_status computed_create(const char *description, struct brdf_bsdf **out,
                                   struct brdf_error *error)
{
    char text[2048];
    int length = snprintf(text, sizeof text, "%s%cmultiscatter=kullaconty", description,
                          strchr(description, ':') ? ',' : ':');
    int chosen = strstr(description, "multiscatter") != NULL;
    return brdf_bsdf_create(chosen || length >= (int)sizeof text ? description : text, out, error);
}

brdf_status brdfcl_check_bsdf_create(const char *description, struct brdf_bsdf **out,
                                     struct brdf_error *error)
{
    struct completion completion = {.files = 0};
    char name[64] = "", path[600];
    *out = NULL;
    snprintf(name, sizeof name, "%.*s", (int)strcspn(description, ":"), description);
    const struct brdf_model_info *model = brdf_model_find(name);
    if (model && model->flags & BRDF_COMPUTED) {
        return computed_create(description, out, error);
    }
    if (!model || !(model->flags & BRDF_TABULATED) ||
        strlen(description) >= sizeof completion.text) {
        return brdf_bsdf_create(description, out, error);
    }
    const char *base = getenv("TMPDIR");
    snprintf(completion.text, sizeof completion.text, "%s", description);
    snprintf(completion.folder, sizeof completion.folder, "%s/brdfcl-XXXXXX",
             base && *base ? base : "/tmp");
    if (!mkdtemp(completion.folder)) {
        return brdf_fail(error, BRDF_IO, "%s: a temporary folder cannot be made there",
                         completion.folder);
    }
    brdf_status status = files_add(&completion, model, error);
    if (!status) {
        status = brdf_bsdf_create(completion.text, out, error);
    }
    for (int i = 0; i < completion.files; ++i) { /* they have been read */
        file_path(&completion, i, path, sizeof path);
        unlink(path);
    }
    rmdir(completion.folder);
    return status;
}

brdf_status brdfcl_check_base_create(const struct brdf_model_info *model, int number,
                                     struct brdf_bsdf **out, struct brdf_error *error)
{
    char text[128];
    *out = NULL;
    if (number == 0) {
        return brdfcl_check_bsdf_create(model->name, out, error);
    }
    if (number > 1 || !(model->flags & BRDF_COMPUTED) || !brdf_parameter_find(model, "alpha_u")) {
        return BRDF_OK;
    }
    snprintf(text, sizeof text, "%s:multiscatter=kullaconty,alpha_u=0.05,alpha_v=0.5", model->name);
    return brdf_bsdf_create(text, out, error);
}

int brdfcl_check_base_serves(const struct brdf_model_info *model, int number,
                             const struct brdf_material *material)
{
    const struct brdf_parameter_info *p = brdf_parameter_find(model, "multiscatter");
    return number == 0 || !p ||
           (material->choices >> 4 * brdf_parameter_place(model, p) & 15u) > 0u;
}
