/*
 * merl_read.c - read a MERL `.binary` file: first everything that can be wrong, then the numbers.
 */
#include "merl_format.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "regular_file.h"

/* An open file, and what its header says of it. */
struct source {
    FILE *stream;
    const char *path;
    long long size;
    const struct brdf_merl_layout *layout;
    int turns;         /* 1: phi_d covers half a turn; 2: a whole turn, to be folded */
    double apart, sum; /* of values that met in folding: of |f - f'| and f + f' */
};

enum { CHUNK = 8192 }; /* values read at once: 64 KiB on the stack */

void brdf_merl_free(struct brdf_merl_file *file)
{
    if (file) {
        free(file->rgb);
        memset(file, 0, sizeof *file);
    }
}

brdf_status brdf_merl_reserve(struct brdf_merl_file *file, const struct brdf_merl_layout *layout,
                              struct brdf_error *error)
{
    file->theta_h = layout->theta_h;
    file->theta_d = layout->theta_d;
    file->phi_d = layout->phi_d;
    file->bins = (size_t)file->theta_h * (size_t)file->theta_d * (size_t)file->phi_d;
    file->invalid = 0;
    file->rgb = malloc(file->bins * 3 * sizeof(float));
    if (!file->rgb) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for the %zu bins of a MERL table",
                         file->bins);
    }
    return BRDF_OK;
}

/* The header and the size that it implies, before anything is allocated. */
static brdf_status source_check(struct source *source, struct brdf_error *error)
{
    static const unsigned char xz[6] = {0xfd, '7', 'z', 'X', 'Z', 0};
    unsigned char header[BRDF_MERL_FILE_HEADER] = {0};
    if (source->size < BRDF_MERL_FILE_HEADER) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: %lld bytes are too short for a MERL header of %d bytes", source->path,
                         source->size, BRDF_MERL_FILE_HEADER);
    }
    if (fread(header, 1, sizeof header, source->stream) != sizeof header) {
        return brdf_fail(error, BRDF_IO, "%s: byte 0: cannot be read: %s", source->path,
                         strerror(errno));
    }
    if (memcmp(header, xz, sizeof xz) == 0) {
        return brdf_fail(error, BRDF_BAD_FILE, "%s: is compressed; unpack it with \"xz -dk\" first",
                         source->path);
    }
    const struct brdf_merl_layout *layout = source->layout;
    int32_t bins[3];
    for (int i = 0; i < 3; ++i) {
        uint32_t word = brdf_little32(header + 4 * i);
        memcpy(&bins[i], &word, sizeof word);
    }
    if (bins[0] != layout->theta_h || bins[1] != layout->theta_d ||
        (bins[2] != layout->phi_d && bins[2] != 2 * layout->phi_d)) {
        return brdf_fail(error, BRDF_BAD_FILE,
                         "%s: byte 0: the header says %ld x %ld x %ld bins; a MERL file has "
                         "%d x %d x %d (or %d)",
                         source->path, (long)bins[0], (long)bins[1], (long)bins[2], layout->theta_h,
                         layout->theta_d, layout->phi_d, 2 * layout->phi_d);
    }
    source->turns = (int)bins[2] / layout->phi_d;
    long long expected = BRDF_MERL_FILE_HEADER + 8LL * 3 * bins[0] * bins[1] * bins[2];
    if (source->size != expected) {
        return brdf_fail(
            error, BRDF_BAD_FILE,
            "%s: expected %lld bytes (%ld x %ld x %ld bins), found %lld: the file is %s",
            source->path, expected, (long)bins[0], (long)bins[1], (long)bins[2], source->size,
            source->size < expected ? "cut off" : "too long");
    }
    return BRDF_OK;
}

/*
 * Put one value of the file in its place. In a file of a whole turn the second half turn meets the
 * first: two valid values are averaged, one valid value wins over an invalid one.
 */
static void value_store(struct source *source, float *slot, double value, int second)
{
    float f = value < 0.0 ? -1.0f : (float)value;
    if (!second || *slot < 0.0f) {
        *slot = f;
    } else if (f >= 0.0f) {
        source->apart += fabs((double)*slot - (double)f);
        source->sum += (double)*slot + (double)f;
        *slot = 0.5f * *slot + 0.5f * f;
    }
}

/* `count` values of one channel, the first of them being number `first` of its plane. */
static brdf_status chunk_store(struct source *source, struct brdf_merl_file *file, int channel,
                               size_t first, const unsigned char *bytes, size_t count,
                               struct brdf_error *error)
{
    size_t half_turn = (size_t)file->phi_d;
    size_t line = half_turn * (size_t)source->turns;
    size_t row = first / line;
    size_t phi = first % line;
    for (size_t i = 0; i < count; ++i) {
        uint64_t word = brdf_little64(bytes + 8 * i);
        double value;
        memcpy(&value, &word, sizeof value);
        value *= brdf_merl_units[channel];
        if (!(fabs(value) <= 3.4e38)) {
            long long at =
                BRDF_MERL_FILE_HEADER +
                8LL * (long long)((size_t)channel * line * (file->bins / half_turn) + first + i);
            return brdf_fail(error, BRDF_BAD_FILE, "%s: byte %lld: the value is %s", source->path,
                             at, value == value ? "infinite or too large" : "not a number");
        }
        size_t bin = row * half_turn + phi % half_turn;
        value_store(source, &file->rgb[3 * bin + (size_t)channel], value, phi >= half_turn);
        if (++phi == line) {
            phi = 0;
            ++row;
        }
    }
    return BRDF_OK;
}

static brdf_status source_values(struct source *source, struct brdf_merl_file *file,
                                 struct brdf_error *error)
{
    unsigned char bytes[8 * CHUNK];
    size_t plane = file->bins * (size_t)source->turns;
    for (int channel = 0; channel < 3; ++channel) {
        for (size_t first = 0; first < plane; first += CHUNK) {
            size_t count = plane - first < CHUNK ? plane - first : CHUNK;
            if (fread(bytes, 8, count, source->stream) != count) {
                return brdf_fail(error, BRDF_IO, "%s: byte %lld: cannot be read: %s", source->path,
                                 (long long)ftell(source->stream),
                                 ferror(source->stream) ? strerror(errno) : "the file has shrunk");
            }
            brdf_status status = chunk_store(source, file, channel, first, bytes, count, error);
            if (status != BRDF_OK) {
                return status;
            }
        }
    }
    return BRDF_OK;
}

/* A bin is invalid as a whole if any of its channels is: mark it in all, and count. */
static void bins_mark(struct brdf_merl_file *file)
{
    for (size_t bin = 0; bin < file->bins; ++bin) {
        float *f = file->rgb + 3 * bin;
        if (f[0] < 0.0f || f[1] < 0.0f || f[2] < 0.0f) {
            f[0] = f[1] = f[2] = -1.0f;
            ++file->invalid;
        }
    }
}

brdf_status brdf_merl_read(const char *path, enum brdf_merl_invalid invalid,
                           struct brdf_merl_file *file, struct brdf_error *error)
{
    if (!file || !path || invalid < BRDF_MERL_INVALID_FILL || invalid > BRDF_MERL_INVALID_KEEP) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_merl_read needs a path, a file to fill and one of "
                         "BRDF_MERL_INVALID_...");
    }
    return brdf_merl_read_layout(path, &brdf_merl_layout, invalid, file, error);
}

brdf_status brdf_merl_read_layout(const char *path, const struct brdf_merl_layout *layout,
                                  enum brdf_merl_invalid invalid, struct brdf_merl_file *file,
                                  struct brdf_error *error)
{
    struct source source = {.path = path, .layout = layout, .turns = 1};
    memset(file, 0, sizeof *file);
    brdf_status status = brdf_regular_file_open(path, &source.stream, &source.size, error);
    if (status != BRDF_OK) {
        return status;
    }
    status = source_check(&source, error);
    if (status != BRDF_OK) {
        goto done;
    }
    status = brdf_merl_reserve(file, layout, error);
    if (status != BRDF_OK) {
        goto done;
    }
    status = source_values(&source, file, error);
    if (status != BRDF_OK) {
        goto done;
    }
    bins_mark(file);
    file->folded = source.turns == 2;
    file->folding = source.sum > 0.0 ? 2.0 * source.apart / source.sum : 0.0;
    if (file->invalid == file->bins) {
        status = brdf_fail(error, BRDF_BAD_FILE,
                           "%s: no bin is valid: every one has a negative value", path);
        goto done;
    }
    brdf_merl_replace(file, invalid);
done:
    fclose(source.stream);
    if (status != BRDF_OK) {
        brdf_merl_free(file);
    }
    return status;
}
