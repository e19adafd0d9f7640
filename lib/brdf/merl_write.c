/*
 * merl_write.c - write a MERL `.binary` file, whole or not at all.
 */
#define _POSIX_C_SOURCE 200809L

#include "merl_format.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void little_put(unsigned char *bytes, uint64_t word, int count)
{
    for (int i = 0; i < count; ++i) {
        bytes[i] = (unsigned char)(word >> (8 * i) & 0xffu);
    }
}

/* 0 if all went well; else errno tells what did not. */
static int header_put(FILE *stream, const struct brdf_merl_file *file)
{
    unsigned char header[BRDF_MERL_FILE_HEADER];
    little_put(header, (uint64_t)file->theta_h, 4);
    little_put(header + 4, (uint64_t)file->theta_d, 4);
    little_put(header + 8, (uint64_t)file->phi_d, 4);
    return fwrite(header, sizeof header, 1, stream) != 1;
}

static int values_put(FILE *stream, const struct brdf_merl_file *file)
{
    unsigned char line[8 * BRDF_MERL_FILE_PHI_D];
    size_t count = (size_t)file->phi_d;
    for (int channel = 0; channel < 3; ++channel) {
        for (size_t bin = 0; bin < file->bins; bin += count) {
            for (size_t i = 0; i < count; ++i) {
                double f = (double)file->rgb[3 * (bin + i) + (size_t)channel];
                double value = f < 0.0 ? -1.0 : f / brdf_merl_units[channel];
                uint64_t word;
                memcpy(&word, &value, sizeof word);
                little_put(line + 8 * i, word, 8);
            }
            if (fwrite(line, 8, count, stream) != count) {
                return 1;
            }
        }
    }
    return 0;
}

static brdf_status file_check(const char *path, const struct brdf_merl_file *file,
                              struct brdf_error *error)
{
    struct stat info;
    if (!path || !file || !file->rgb || file->theta_h != BRDF_MERL_FILE_THETA_H ||
        file->theta_d != BRDF_MERL_FILE_THETA_D || file->phi_d != BRDF_MERL_FILE_PHI_D ||
        file->bins != (size_t)file->theta_h * (size_t)file->theta_d * (size_t)file->phi_d) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_merl_write needs a path and a table of 90 x 90 x 180 bins");
    }
    for (size_t i = 0; i < file->bins * 3; ++i) {
        if (!isfinite(file->rgb[i])) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "%s: not written: bin %zu is not finite",
                             path, i / 3);
        }
    }
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode)) {
        return brdf_fail(error, BRDF_IO, "%s: not written: it exists and is not a regular file",
                         path);
    }
    return BRDF_OK;
}

brdf_status brdf_merl_write(const char *path, const struct brdf_merl_file *file,
                            struct brdf_error *error)
{
    FILE *stream = NULL;
    int descriptor = -1;
    brdf_status status = file_check(path, file, error);
    if (status != BRDF_OK) {
        return status;
    }
    size_t size = strlen(path) + 32;
    char *temporary = malloc(size);
    if (!temporary) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: no memory to write it", path);
    }
    snprintf(temporary, size, "%s.%ld.part", path, (long)getpid());
    descriptor = open(temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        status = brdf_fail(error, BRDF_IO, "%s: cannot be made: %s", temporary, strerror(errno));
        goto done;
    }
    stream = fdopen(descriptor, "wb");
    if (!stream) {
        close(descriptor);
    }
    int failed = !stream || header_put(stream, file) || values_put(stream, file);
    if (stream && fclose(stream) != 0) {
        failed = 1;
    }
    if (failed || rename(temporary, path) != 0) {
        status = brdf_fail(error, BRDF_IO, "%s: not written: %s", path, strerror(errno));
        unlink(temporary);
    }
done:
    free(temporary);
    return status;
}
