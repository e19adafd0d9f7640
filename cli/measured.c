/* measured.c - measured files as results. */
#define _POSIX_C_SOURCE 200809L
#include "measured.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "brdfcl/atomic_file.h"
#include "brdflab/bake.h"
#include "brdflab/complete.h"
#include "brdflab/copy.h"
#include "brdflab/tabulated.h"
#include "commands.h"
#include "difference.h"
#include "say.h"
#include "stop.h"

static int ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), wanted = strlen(end);
    return length > wanted && strcmp(text + length - wanted, end) == 0;
}

static int is_same_file(const char *a, const char *b)
{
    struct stat of_a, of_b;
    return stat(a, &of_a) == 0 && stat(b, &of_b) == 0 && of_a.st_dev == of_b.st_dev &&
           of_a.st_ino == of_b.st_ino;
}

int measured_out_set(struct measured_out *out, const char *path, const char *const *in,
                     size_t count)
{
    out->path = path;
    if (out->format == LAB_FORMAT_NONE) {
        out->format = ends_with(path, ".binary") ? LAB_FORMAT_MERL
                      : ends_with(path, ".bsdf") ? LAB_FORMAT_RGL
                                                 : LAB_FORMAT_NONE;
    }
    if (out->format == LAB_FORMAT_NONE) {
        return say_usage("\"%s\" has no suffix that tells its format: .binary is MERL's, .bsdf "
                         "RGL's; --format merl or rgl says it too",
                         path);
    }
    for (size_t i = 0; i < count && !out->force; ++i) {
        if (is_same_file(path, in[i])) {
            return say_usage("\"%s\" is read and written: what was measured would be lost; give "
                             "another name, or --force",
                             path);
        }
    }
    return OPTIONS_GO_ON;
}

brdf_status measured_open(const char *text, int fill, struct brdf_merl_file *file,
                          enum lab_format *format, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    struct lab_difference difference;
    brdf_status status = lab_open_merl(text, file, format, error);
    if (status || *format == LAB_FORMAT_MERL) {
        return status || fill ? status : lab_complete_merl(file, 0, error);
    }
    status = lab_open(text, &bsdf, NULL, error);
    status = status ? status : lab_compare_merl(bsdf, file, &difference, error);
    if (!status) {
        printf("%s: onto MERL's grid\n", text);
        difference_print(&difference);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}

brdf_status measured_check(const struct measured_out *out, struct brdf_error *error)
{
    return brdfcl_atomic_check(out->path, error);
}

brdf_status measured_write_merl(const struct measured_out *out, const struct brdf_merl_file *file,
                                struct brdf_error *error)
{
    stop_wait();
    brdf_status status = brdf_merl_write(out->path, file, error);
    stop_resume();
    return status;
}

brdf_status measured_write_rgl(const struct measured_out *out, const struct brdf_bsdf *bsdf,
                               struct brdf_error *error)
{
    struct brdf_rgl_file file;
    brdf_status status = lab_bake_rgl(bsdf, &out->grid, &file, error);
    if (status) {
        return status;
    }
    stop_wait();
    status = brdf_rgl_write(out->path, &file, error);
    stop_resume();
    brdf_rgl_free(&file);
    return status;
}

brdf_status measured_copy(const struct measured_out *out, const char *from,
                          struct brdf_error *error)
{
    stop_wait();
    brdf_status status = lab_copy_file(from, out->path, error);
    stop_resume();
    return status;
}

brdf_status measured_write(const struct measured_out *out, const struct brdf_merl_file *file,
                           struct brdf_error *error)
{
    struct brdf_bsdf *table = NULL, *written = NULL;
    if (out->format == LAB_FORMAT_MERL) {
        return measured_write_merl(out, file, error);
    }
    brdf_status status = lab_bsdf_of_merl(file, &table, error);
    status = status ? status : measured_write_rgl(out, table, error);
    status = status ? status : lab_open(out->path, &written, NULL, error);
    if (!status) {
        struct lab_difference difference = lab_compare(table, written);
        printf("%s: from MERL's grid into RGL's\n", out->path);
        difference_print(&difference);
    }
    brdf_bsdf_destroy(written);
    brdf_bsdf_destroy(table);
    return status;
}

int measured_exit(brdf_status status, const struct brdf_error *error)
{
    if (status) {
        return say_error(error);
    }
    return stop_signal() ? 128 + stop_signal() : EXIT_DONE;
}
