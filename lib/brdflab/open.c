/* open.c - files told from descriptions, and one format from another. */
#define _POSIX_C_SOURCE 200809L

#include "open.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <brdf/info.h>

#include "bake.h"

/* Does the text begin with the name of a model? */
static int is_description(const char *text)
{
    char name[64];
    size_t length = strcspn(text, ":");
    snprintf(name, sizeof name, "%.*s", (int)(length < 60 ? length : 60), text);
    return brdf_model_find(name) != NULL;
}

static brdf_status refuse(const char *text, int reason, struct brdf_error *error)
{
    char name[64];
    size_t length = strcspn(text, ":");
    snprintf(name, sizeof name, "%.*s", (int)(length < 60 ? length : 60), text);
    const char *nearest = brdf_model_nearest(name);
    if (!*text) {
        return brdf_fail(error, BRDF_UNKNOWN_NAME,
                         "the name of a material is empty: expected a measured file (.binary, "
                         ".bsdf) or a material such as roughconductor:material=Au,alpha=0.2");
    }
    if (reason == ENOENT && nearest) {
        return brdf_fail(error, BRDF_UNKNOWN_NAME,
                         "%s: there is no such file, and no model is called \"%s\"; did you mean "
                         "\"%s\"?",
                         text, name, nearest);
    }
    if (reason == ENOENT && !strpbrk(name, "./")) {
        return brdf_fail(
            error, BRDF_UNKNOWN_NAME,
            "%s: there is no such file, and no model is called \"%s\"; \"brdfcl models\" "
            "lists them",
            text, name);
    }
    return brdf_fail(error, BRDF_IO,
                     "%s: cannot be opened: %s; expected a measured file (.binary, .bsdf) or a "
                     "material such as roughconductor:material=Au,alpha=0.2",
                     text, strerror(reason));
}

brdf_status lab_format_of(const char *text, enum lab_format *format, struct brdf_error *error)
{
    static const char rgl[12] = "tensor_file";
    struct stat info;
    char begin[sizeof rgl] = "";
    *format = LAB_FORMAT_NONE;
    /* First: `wood` is the model also where there is a folder of that name; ./wood is not. */
    if (is_description(text)) {
        return BRDF_OK;
    }
    if (stat(text, &info) != 0) {
        return refuse(text, errno, error);
    }
    if (!S_ISREG(info.st_mode)) {
        return brdf_fail(error, BRDF_IO, "%s: is not a regular file but %s", text,
                         S_ISDIR(info.st_mode) ? "a folder" : "a pipe, socket or device");
    }
    FILE *stream = fopen(text, "rb");
    if (!stream) {
        return refuse(text, errno, error);
    }
    size_t count = fread(begin, 1, sizeof begin, stream);
    fclose(stream);
    int is_rgl = count == sizeof begin && memcmp(begin, rgl, sizeof rgl) == 0;
    *format = is_rgl ? LAB_FORMAT_RGL : LAB_FORMAT_MERL;
    return BRDF_OK;
}

brdf_status lab_open(const char *text, struct brdf_bsdf **out, enum lab_format *format,
                     struct brdf_error *error)
{
    return lab_open_filled(text, 1, out, format, error);
}

brdf_status lab_open_filled(const char *text, int fill, struct brdf_bsdf **out,
                            enum lab_format *format, struct brdf_error *error)
{
    enum lab_format found;
    *out = NULL;
    brdf_status status = lab_format_of(text, &found, error);
    if (status) {
        return status;
    }
    if (format) {
        *format = found;
    }
    if (found == LAB_FORMAT_NONE) {
        return brdf_bsdf_create(text, out, error);
    }
    const struct brdf_setting settings[2] = {brdf_setting_text("filename", text),
                                             brdf_setting_text("fill", fill ? "true" : "false")};
    return found == LAB_FORMAT_RGL ? brdf_bsdf_create_from("measured", settings, 1, out, error)
                                   : brdf_bsdf_create_from("merl", settings, 2, out, error);
}

brdf_status lab_open_merl(const char *text, struct brdf_merl_file *file, enum lab_format *format,
                          struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error reason = {BRDF_OK, ""};
    memset(file, 0, sizeof *file);
    brdf_status status = lab_format_of(text, format, error);
    if (status == BRDF_OK && *format == LAB_FORMAT_MERL) {
        return brdf_merl_read(text, BRDF_MERL_INVALID_KEEP, file, error);
    }
    if (status == BRDF_OK) {
        status = lab_open(text, &bsdf, NULL, error);
    }
    if (status == BRDF_OK) {
        status = lab_bake_merl(bsdf, file, &reason);
    }
    if (reason.status) { /* which one of several materials it was */
        status = brdf_fail(error, reason.status, "%s: %s", text, reason.message);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}
