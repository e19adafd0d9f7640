/* measured.c - measured files as results. */
#include "measured.h"

#include <stdio.h>
#include <string.h>

#include "brdfcl/atomic_file.h"
#include "brdflab/compare.h"
#include "brdflab/copy.h"
#include "commands.h"
#include "options.h"
#include "say.h"
#include "stop.h"

static int ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), wanted = strlen(end);
    return length > wanted && strcmp(text + length - wanted, end) == 0;
}

int measured_format(const char *path, int wanted, enum lab_format *format)
{
    *format = (enum lab_format)wanted;
    if (wanted == LAB_FORMAT_NONE && ends_with(path, ".binary")) {
        *format = LAB_FORMAT_MERL;
    } else if (wanted == LAB_FORMAT_NONE && ends_with(path, ".bsdf")) {
        *format = LAB_FORMAT_RGL;
    }
    if (*format == LAB_FORMAT_NONE) {
        return say_usage(
            "\"%s\" has no suffix that tells its format: .binary is MERL's, .bsdf RGL's", path);
    }
    return OPTIONS_GO_ON;
}

brdf_status measured_open(const char *text, struct brdf_merl_file *file, enum lab_format *format,
                          struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    struct lab_difference difference;
    brdf_status status = lab_open_merl(text, file, format, error);
    if (status || *format == LAB_FORMAT_MERL) {
        return status;
    }
    status = lab_open(text, &bsdf, NULL, error);
    status = status ? status : lab_compare_merl(bsdf, file, &difference, error);
    if (!status) {
        printf("%s: baked onto MERL's grid, which changed it by rms %.3g  mean %.3g  albedo %.2g\n",
               text, difference.rms, difference.mean, difference.albedo);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}

brdf_status measured_check(const char *path, struct brdf_error *error)
{
    return brdfcl_atomic_check(path, error);
}

brdf_status measured_write(const char *path, const struct brdf_merl_file *file,
                           struct brdf_error *error)
{
    stop_wait();
    brdf_status status = brdf_merl_write(path, file, error);
    stop_resume();
    return status;
}

brdf_status measured_write_rgl(const char *path, const struct brdf_rgl_file *file,
                               struct brdf_error *error)
{
    stop_wait();
    brdf_status status = brdf_rgl_write(path, file, error);
    stop_resume();
    return status;
}

brdf_status measured_copy(const char *from, const char *path, struct brdf_error *error)
{
    stop_wait();
    brdf_status status = lab_copy_file(from, path, error);
    stop_resume();
    return status;
}

int measured_exit(brdf_status status, const struct brdf_error *error)
{
    if (status) {
        return say_error(error);
    }
    return stop_signal() ? 128 + stop_signal() : EXIT_DONE;
}
