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

/* Diffuse, and a glossy reciprocal lobe about the normal: something of everything, in colour. */
static void painted(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    (void)data;
    double x = wo[0] + wi[0];
    double y = wo[1] + wi[1];
    double z = wo[2] + wi[2];
    double slope2 = (x * x + y * y) / (z * z);
    double grazing = 1.0 - sqrt(0.25 * (x * x + y * y + z * z)); /* 1 - cos(theta_d) */
    double shine = 0.8 * exp(-slope2 / 0.04) / (wo[2] + wi[2]) * (0.2 + 0.8 * grazing * grazing);
    rgb[0] = 0.10 + shine;
    rgb[1] = 0.05 + shine;
    rgb[2] = 0.02 + 0.7 * shine;
}

static brdf_status merl_write(const char *path, struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = brdf_merl_make(painted, NULL, &file, error);
    if (!status) {
        status = brdf_merl_write(path, &file, error);
        brdf_merl_free(&file);
    }
    return status;
}

/* Every format that a FILE parameter can be of, found by a word of the parameter's meaning. */
static const struct maker {
    const char *word;
    brdf_status (*write)(const char *path, struct brdf_error *error);
} makers[] = {
    {"MERL", merl_write},
};

static brdf_status measurement_write(const struct brdf_parameter_info *parameter, const char *path,
                                     struct brdf_error *error)
{
    for (size_t i = 0; i < sizeof makers / sizeof makers[0]; ++i) {
        if (strstr(parameter->meaning, makers[i].word)) {
            return makers[i].write(path, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED,
                     "no file can be made for the parameter %s (%s): describe the material with a "
                     "file of its own",
                     parameter->name, parameter->meaning);
}

/* The FILE parameter that the description leaves open; NULL if there is none. */
static const struct brdf_parameter_info *open_file(const char *description)
{
    char name[64] = "";
    snprintf(name, sizeof name, "%.*s", (int)strcspn(description, ":"), description);
    const struct brdf_model_info *model = brdf_model_find(name);
    for (size_t i = 0; model && i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        if (parameter->kind == BRDF_KIND_FILE && !strstr(description, parameter->name)) {
            return parameter;
        }
    }
    return NULL;
}

static brdf_status create_with_file(const char *description, const char *parameter,
                                    const char *path, struct brdf_bsdf **out,
                                    struct brdf_error *error)
{
    char text[2048];
    char mark = strchr(description, ':') ? ',' : ':';
    int length = snprintf(text, sizeof text, "%s%c%s=\"%s\"", description, mark, parameter, path);
    if (length < 0 || (size_t)length >= sizeof text) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "the description is too long: %s", description);
    }
    return brdf_bsdf_create(text, out, error);
}

brdf_status brdfcl_check_bsdf_create(const char *description, struct brdf_bsdf **out,
                                     struct brdf_error *error)
{
    *out = NULL;
    const struct brdf_parameter_info *parameter = open_file(description);
    if (!parameter) {
        return brdf_bsdf_create(description, out, error);
    }
    const char *base = getenv("TMPDIR");
    char directory[512];
    char path[600];
    snprintf(directory, sizeof directory, "%s/brdfcl-XXXXXX", base && *base ? base : "/tmp");
    if (!mkdtemp(directory)) {
        return brdf_fail(error, BRDF_IO, "%s: a temporary folder cannot be made there", directory);
    }
    snprintf(path, sizeof path, "%s/measurement", directory);
    brdf_status status = measurement_write(parameter, path, error);
    if (!status) {
        status = create_with_file(description, parameter->name, path, out, error);
    }
    unlink(path); /* it has been read, if it was ever written */
    rmdir(directory);
    return status;
}
