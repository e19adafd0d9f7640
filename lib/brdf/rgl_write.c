/*
 * rgl_write.c - write an RGL `.bsdf` file, whole or not at all.
 */
#include "rgl_format.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "regular_file.h"
#include "tensor.h"

enum { ALIGNMENT = 8, HEADER_MAX = 1024, CHUNK = 4096 };

/* What is to be written of one field. */
struct part {
    int wanted;
    int rank;
    size_t dimension[BRDF_TENSOR_RANK_MAX];
    size_t bytes;
    size_t place;
};

struct plan {
    struct part part[BRDF_RGL_FIELDS];
    unsigned char header[HEADER_MAX];
    size_t header_bytes;
};

static void little_put(struct plan *plan, unsigned long long word, int count)
{
    for (int i = 0; i < count; ++i) {
        plan->header[plan->header_bytes++] = (unsigned char)(word >> (8 * i) & 0xffu);
    }
}

static size_t aligned(size_t place)
{
    return (place + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

static void shapes_plan(struct plan *plan, const struct brdf_rgl_file *file)
{
    size_t phi = (size_t)file->phi_count;
    size_t theta = (size_t)file->theta_count;
    size_t size = (size_t)file->size;
    size_t channels = (size_t)file->channels;
    const size_t dimensions[BRDF_RGL_FIELDS][BRDF_TENSOR_RANK_MAX] = {
        {strlen(file->description)},
        {phi},
        {theta},
        {(size_t)file->sigma_rows, (size_t)file->sigma_columns},
        {(size_t)file->ndf_rows, (size_t)file->ndf_columns},
        {phi, theta, (size_t)file->vndf_rows, (size_t)file->vndf_columns},
        {phi, theta, size, size},
        {phi, theta, channels, size, size},
        {channels},
        {phi, theta, channels, size, size},
        {1},
    };
    int spectral = file->wavelengths != NULL;
    for (int k = 0; k < BRDF_RGL_FIELDS; ++k) {
        struct part *part = &plan->part[k];
        part->wanted = k == BRDF_RGL_RGB                                    ? !spectral
                       : k == BRDF_RGL_SPECTRA || k == BRDF_RGL_WAVELENGTHS ? spectral
                                                                            : 1;
        part->rank = brdf_rgl_field_kinds[k].rank;
        part->bytes = brdf_rgl_field_kinds[k].type == BRDF_TENSOR_FLOAT32 ? sizeof(float) : 1;
        for (int i = 0; i < part->rank; ++i) {
            part->dimension[i] = dimensions[k][i];
            part->bytes *= dimensions[k][i];
        }
    }
}

/* The header; the first pass finds its length, the second the places of the data behind it. */
static void header_plan(struct plan *plan)
{
    for (int pass = 0; pass < 2; ++pass) {
        size_t place = aligned(plan->header_bytes);
        plan->header_bytes = BRDF_TENSOR_MAGIC;
        memcpy(plan->header, brdf_tensor_magic, BRDF_TENSOR_MAGIC);
        little_put(plan, 1, 2); /* version 1.0 */
        size_t count_at = plan->header_bytes;
        unsigned fields = 0;
        little_put(plan, 0, 4);
        for (int k = 0; k < BRDF_RGL_FIELDS; ++k) {
            struct part *part = &plan->part[k];
            const struct brdf_rgl_field_kind *kind = &brdf_rgl_field_kinds[k];
            if (!part->wanted) {
                continue;
            }
            size_t length = strlen(kind->name);
            little_put(plan, length, 2);
            memcpy(plan->header + plan->header_bytes, kind->name, length);
            plan->header_bytes += length;
            little_put(plan, (unsigned)kind->rank, 2);
            little_put(plan, (unsigned)kind->type, 1);
            little_put(plan, place, 8);
            for (int i = 0; i < part->rank; ++i) {
                little_put(plan, part->dimension[i], 8);
            }
            part->place = place;
            place = aligned(place + part->bytes);
            ++fields;
        }
        plan->header[count_at] = (unsigned char)fields;
    }
}

/* Zeros up to `place`; 0 if all went well, else errno tells what did not. */
static int pad(FILE *stream, size_t *at, size_t place)
{
    static const unsigned char zeros[ALIGNMENT];
    size_t count = place - *at;
    *at = place;
    return fwrite(zeros, 1, count, stream) != count;
}

static int floats_put(FILE *stream, const float *values, size_t count)
{
    unsigned char bytes[4 * CHUNK];
    for (size_t first = 0; first < count; first += CHUNK) {
        size_t here = count - first < CHUNK ? count - first : CHUNK;
        for (size_t i = 0; i < here; ++i) {
            uint32_t word;
            memcpy(&word, &values[first + i], sizeof word);
            for (int k = 0; k < 4; ++k) {
                bytes[4 * i + (size_t)k] = (unsigned char)(word >> (8 * k) & 0xffu);
            }
        }
        if (fwrite(bytes, 4, here, stream) != here) {
            return 1;
        }
    }
    return 0;
}

static int data_put(FILE *stream, const struct plan *plan, struct brdf_rgl_file *file)
{
    size_t at = plan->header_bytes;
    const unsigned char jacobian = (unsigned char)(file->jacobian != 0);
    int failed = fwrite(plan->header, 1, at, stream) != at;
    for (int k = 0; k < BRDF_RGL_FIELDS && !failed; ++k) {
        const struct part *part = &plan->part[k];
        if (!part->wanted) {
            continue;
        }
        float **array = brdf_rgl_array(file, (enum brdf_rgl_field)k);
        const void *bytes = k == BRDF_RGL_JACOBIAN ? (const void *)&jacobian : file->description;
        failed = pad(stream, &at, part->place);
        if (!failed) {
            failed = array ? floats_put(stream, *array, part->bytes / sizeof(float))
                           : fwrite(bytes, 1, part->bytes, stream) != part->bytes;
        }
        at += part->bytes;
    }
    return failed;
}

static brdf_status counts_check(const char *path, const struct brdf_rgl_file *file,
                                struct brdf_error *error)
{
    const int counts[][2] = {{file->phi_count, 1},  {file->theta_count, 1},
                             {file->ndf_rows, 2},   {file->ndf_columns, 2},
                             {file->sigma_rows, 2}, {file->sigma_columns, 2},
                             {file->vndf_rows, 2},  {file->vndf_columns, 2},
                             {file->size, 2},       {file->channels, file->wavelengths ? 1 : 3}};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i) {
        if (counts[i][0] < counts[i][1] || counts[i][0] > BRDF_RGL_SIDE_MAX) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT,
                             "%s: not written: a count of %d is not in [%d, %d]", path,
                             counts[i][0], counts[i][1], BRDF_RGL_SIDE_MAX);
        }
    }
    if (!file->wavelengths && file->channels != 3) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "%s: not written: %d channels without wavelengths; RGB has 3", path,
                         file->channels);
    }
    return BRDF_OK;
}

static brdf_status values_check(const char *path, struct brdf_rgl_file *file,
                                struct brdf_error *error)
{
    for (int k = 0; k < BRDF_RGL_FIELDS; ++k) {
        enum brdf_rgl_field field = (enum brdf_rgl_field)k;
        float **array = brdf_rgl_array(file, field);
        size_t count = brdf_rgl_elements(file, field);
        double previous = -HUGE_VAL;
        if (!array || (field == BRDF_RGL_WAVELENGTHS && !*array)) {
            continue;
        }
        if (!*array) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "%s: not written: it has no %s", path,
                             brdf_rgl_field_kinds[k].name);
        }
        for (size_t i = 0; i < count; ++i) {
            const char *fault = brdf_rgl_value_fault(field, (double)(*array)[i], previous);
            if (fault) {
                return brdf_fail(error, BRDF_BAD_ARGUMENT,
                                 "%s: not written: value %zu of \"%s\" %s", path, i,
                                 brdf_rgl_field_kinds[k].name, fault);
            }
            previous = (double)(*array)[i];
        }
    }
    return BRDF_OK;
}

brdf_status brdf_rgl_write(const char *path, const struct brdf_rgl_file *file,
                           struct brdf_error *error)
{
    struct brdf_new_file out;
    struct plan plan;
    if (!path || !file || !file->description || strlen(file->description) > 65535) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_rgl_write needs a path and a file with a description of at most "
                         "65535 bytes");
    }
    struct brdf_rgl_file view = *file; /* the same arrays; only read */
    brdf_status status = counts_check(path, file, error);
    status = status ? status : values_check(path, &view, error);
    status = status ? status : brdf_new_file_begin(&out, path, error);
    if (status) {
        return status;
    }
    memset(&plan, 0, sizeof plan);
    shapes_plan(&plan, file);
    header_plan(&plan);
    return brdf_new_file_end(&out, data_put(out.stream, &plan, &view), error);
}
