/*
 * rgl_read.c - read an RGL `.bsdf` file: its counts against each other, then the numbers.
 */
#define _POSIX_C_SOURCE 200809L

#include "rgl_format.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "regular_file.h"
#include "tensor.h"

enum { CHUNK = 16384 }; /* values read at once: 64 KiB on the stack */

/* That `field` is there, with its dimension `number` (if not negative) in [low, high]. */
static brdf_status field_check(const struct brdf_tensor_file *source, enum brdf_rgl_field field,
                               int number, long long low, long long high, struct brdf_error *error)
{
    const struct brdf_tensor *tensor = &source->field[field];
    const char *name = brdf_rgl_field_kinds[field].name;
    if (!tensor->found) {
        return brdf_fail(error, BRDF_BAD_FILE, "%s: has no field \"%s\"", source->path, name);
    }
    long long size = number < 0 ? low : tensor->dimension[number];
    if (size < low || size > high) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: byte %lld: dimension %d of \"%s\" is %lld, but must be %lld%s%lld",
                         source->path, tensor->header, number, name, size, low,
                         low == high ? ", not " : " to ", low == high ? size : high);
    }
    return BRDF_OK;
}

/* Dimensions that are free, in this order, and those that are bound to an earlier one. */
static const struct rule {
    enum brdf_rgl_field field;
    int number;
    int least;                  /* 0: bound to the dimension of another field */
    enum brdf_rgl_field master; /* that one */
    int master_number;
} rules[] = {
    {BRDF_RGL_PHI_I, 0, 1, BRDF_RGL_PHI_I, 0},
    {BRDF_RGL_THETA_I, 0, 1, BRDF_RGL_THETA_I, 0},
    {BRDF_RGL_SIGMA, 0, 2, BRDF_RGL_SIGMA, 0},
    {BRDF_RGL_SIGMA, 1, 2, BRDF_RGL_SIGMA, 0},
    {BRDF_RGL_NDF, 0, 2, BRDF_RGL_NDF, 0},
    {BRDF_RGL_NDF, 1, 2, BRDF_RGL_NDF, 0},
    {BRDF_RGL_VNDF, 0, 0, BRDF_RGL_PHI_I, 0},
    {BRDF_RGL_VNDF, 1, 0, BRDF_RGL_THETA_I, 0},
    {BRDF_RGL_VNDF, 2, 2, BRDF_RGL_VNDF, 0},
    {BRDF_RGL_VNDF, 3, 2, BRDF_RGL_VNDF, 0},
    {BRDF_RGL_LUMINANCE, 0, 0, BRDF_RGL_PHI_I, 0},
    {BRDF_RGL_LUMINANCE, 1, 0, BRDF_RGL_THETA_I, 0},
    {BRDF_RGL_LUMINANCE, 2, 2, BRDF_RGL_LUMINANCE, 0},
    {BRDF_RGL_LUMINANCE, 3, 0, BRDF_RGL_LUMINANCE, 2},
    {BRDF_RGL_JACOBIAN, 0, 0, BRDF_RGL_JACOBIAN, -1},
};

static brdf_status rule_check(const struct brdf_tensor_file *source, const struct rule *rule,
                              struct brdf_error *error)
{
    long long low = rule->least;
    long long high = BRDF_RGL_SIDE_MAX;
    if (!rule->least) {
        low = rule->master_number < 0 ? 1
                                      : source->field[rule->master].dimension[rule->master_number];
        high = low;
    }
    return field_check(source, rule->field, rule->number, low, high, error);
}

static brdf_status colors_check(const struct brdf_tensor_file *source, struct brdf_error *error)
{
    const struct brdf_tensor *luminance = &source->field[BRDF_RGL_LUMINANCE];
    int spectral = source->field[BRDF_RGL_WAVELENGTHS].found;
    enum brdf_rgl_field colors = spectral ? BRDF_RGL_SPECTRA : BRDF_RGL_RGB;
    brdf_status status = BRDF_OK;
    long long channels = 3;
    if (spectral) {
        status = field_check(source, BRDF_RGL_WAVELENGTHS, 0, 1, BRDF_RGL_SIDE_MAX, error);
        channels = source->field[BRDF_RGL_WAVELENGTHS].dimension[0];
    }
    long long wanted[5] = {luminance->dimension[0], luminance->dimension[1], channels,
                           luminance->dimension[2], luminance->dimension[3]};
    for (int i = 0; i < 5 && !status; ++i) {
        status = field_check(source, colors, i, wanted[i], wanted[i], error);
    }
    return status;
}

/* All dimensions against each other, and the counts that follow. */
static brdf_status source_counts(const struct brdf_tensor_file *source, struct brdf_rgl_file *file,
                                 struct brdf_error *error)
{
    const struct brdf_tensor *field = source->field;
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; ++i) {
        brdf_status status = rule_check(source, &rules[i], error);
        if (status) {
            return status;
        }
    }
    brdf_status status = colors_check(source, error);
    if (status) {
        return status;
    }
    file->phi_count = (int)field[BRDF_RGL_PHI_I].dimension[0];
    file->theta_count = (int)field[BRDF_RGL_THETA_I].dimension[0];
    file->sigma_rows = (int)field[BRDF_RGL_SIGMA].dimension[0];
    file->sigma_columns = (int)field[BRDF_RGL_SIGMA].dimension[1];
    file->ndf_rows = (int)field[BRDF_RGL_NDF].dimension[0];
    file->ndf_columns = (int)field[BRDF_RGL_NDF].dimension[1];
    file->vndf_rows = (int)field[BRDF_RGL_VNDF].dimension[2];
    file->vndf_columns = (int)field[BRDF_RGL_VNDF].dimension[3];
    file->size = (int)field[BRDF_RGL_LUMINANCE].dimension[2];
    file->channels =
        field[BRDF_RGL_WAVELENGTHS].found ? (int)field[BRDF_RGL_WAVELENGTHS].dimension[0] : 3;
    return BRDF_OK;
}

static brdf_status source_seek(struct brdf_tensor_file *source, long long at,
                               struct brdf_error *error)
{
    if (fseeko(source->stream, (off_t)at, SEEK_SET) != 0) {
        return brdf_fail(error, BRDF_IO, "%s: byte %lld: cannot be read: %s", source->path, at,
                         strerror(errno));
    }
    source->at = at;
    return BRDF_OK;
}

/* The floats of one field. */
static brdf_status source_floats(struct brdf_tensor_file *source, enum brdf_rgl_field field,
                                 float *values, struct brdf_error *error)
{
    unsigned char bytes[4 * CHUNK];
    const struct brdf_tensor *tensor = &source->field[field];
    double previous = -HUGE_VAL;
    brdf_status status = source_seek(source, tensor->data, error);
    for (long long first = 0; first < tensor->elements && !status; first += CHUNK) {
        int count = tensor->elements - first < CHUNK ? (int)(tensor->elements - first) : CHUNK;
        long long at = source->at;
        status = brdf_tensor_take(source, bytes, 4 * count, error);
        for (int i = 0; i < count && !status; ++i) {
            uint32_t word = (uint32_t)brdf_little(bytes + 4 * i, 4);
            float value;
            memcpy(&value, &word, sizeof value);
            const char *fault = brdf_rgl_value_fault(field, (double)value, previous);
            if (fault) {
                status = brdf_fail(error, BRDF_BAD_FILE, "%s: byte %lld: value %lld of \"%s\" %s",
                                   source->path, at + 4LL * i, first + i,
                                   brdf_rgl_field_kinds[field].name, fault);
            }
            previous = (double)value;
            values[first + i] = value;
        }
    }
    return status;
}

/* Description and Jacobian: what is not an array of floats. */
static brdf_status source_bytes(struct brdf_tensor_file *source, struct brdf_rgl_file *file,
                                struct brdf_error *error)
{
    const struct brdf_tensor *text = &source->field[BRDF_RGL_DESCRIPTION];
    size_t length = text->found && text->elements < 65536 ? (size_t)text->elements : 0;
    unsigned char jacobian = 0;
    file->description = calloc(length + 1, 1);
    if (!file->description) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: no memory for its description",
                         source->path);
    }
    brdf_status status = source_seek(source, text->data, error);
    status = status ? status : brdf_tensor_take(source, file->description, (int)length, error);
    status = status ? status : source_seek(source, source->field[BRDF_RGL_JACOBIAN].data, error);
    status = status ? status : brdf_tensor_take(source, &jacobian, 1, error);
    file->jacobian = jacobian != 0;
    return status;
}

static brdf_status source_values(struct brdf_tensor_file *source, struct brdf_rgl_file *file,
                                 struct brdf_error *error)
{
    int spectral = source->field[BRDF_RGL_WAVELENGTHS].found;
    brdf_status status = brdf_rgl_reserve(file, spectral, error);
    status = status ? status : source_bytes(source, file, error);
    for (int k = 0; k < BRDF_RGL_FIELDS && !status; ++k) {
        enum brdf_rgl_field field = (enum brdf_rgl_field)k;
        float **array = brdf_rgl_array(file, field);
        int ours = field != (spectral ? BRDF_RGL_RGB : BRDF_RGL_SPECTRA);
        if (array && *array && ours) {
            status = source_floats(source, field, *array, error);
        }
    }
    return status;
}

brdf_status brdf_rgl_read(const char *path, struct brdf_rgl_file *file, struct brdf_error *error)
{
    struct brdf_tensor_file source;
    if (!file || !path) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "brdf_rgl_read needs a path and a file to fill");
    }
    memset(file, 0, sizeof *file);
    memset(&source, 0, sizeof source);
    source.path = path;
    brdf_status status = brdf_regular_file_open(path, &source.stream, &source.size, error);
    if (status) {
        return status;
    }
    status = brdf_tensor_header(&source, error);
    status = status ? status : source_counts(&source, file, error);
    status = status ? status : source_values(&source, file, error);
    fclose(source.stream);
    if (status) {
        brdf_rgl_free(file);
    }
    return status;
}
