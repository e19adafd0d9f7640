/*
 * merl_write.c - write a MERL `.binary` file, whole or not at all.
 */
#include "merl_format.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "regular_file.h"

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
    return BRDF_OK;
}

brdf_status brdf_merl_write(const char *path, const struct brdf_merl_file *file,
                            struct brdf_error *error)
{
    struct brdf_new_file out;
    brdf_status status = file_check(path, file, error);
    if (status == BRDF_OK) {
        status = brdf_new_file_begin(&out, path, error);
    }
    if (status != BRDF_OK) {
        return status;
    }
    int failed = header_put(out.stream, file) || values_put(out.stream, file);
    return brdf_new_file_end(&out, failed, error);
}
