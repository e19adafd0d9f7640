/*
 * fuzz_merl.c - any bytes as a MERL file. Whole ones are 35 MB, which a fuzzer cannot turn over
 * often: the reader reads tables of 4 x 3 x 5 bins here, by the same code, and the same bytes once
 * more as a file of the true size, which they are too short for.
 */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <string.h>

#include <brdf/merl.h>

#include "fuzz_file.h"
#include "merl_format.h"

static const struct brdf_merl_layout small = {4, 3, 5};

static void demand(int truth)
{
    if (!truth) {
        abort();
    }
}

/* A table that was accepted: numbers, and what is invalid is so in all channels. */
static void inspect(const struct brdf_merl_file *file, enum brdf_merl_invalid invalid)
{
    size_t negative = 0;
    demand(file->bins == 4 * 3 * 5 && file->invalid < file->bins);
    demand(isfinite(file->folding) && file->folding >= 0.0 && file->folding <= 2.0);
    for (size_t bin = 0; bin < file->bins; ++bin) {
        const float *f = file->rgb + 3 * bin;
        demand(isfinite(f[0]) && isfinite(f[1]) && isfinite(f[2]));
        demand((f[0] < 0.0f) == (f[1] < 0.0f) && (f[0] < 0.0f) == (f[2] < 0.0f));
        negative += f[0] < 0.0f;
    }
    demand(negative == (invalid == BRDF_MERL_INVALID_KEEP ? file->invalid : 0));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct brdf_merl_file file;
    struct brdf_error error = {BRDF_OK, ""};
    const char *path = fuzz_file(bytes, size);
    /* By the last byte and not by the length: lengths that are accepted are few. */
    enum brdf_merl_invalid invalid = (enum brdf_merl_invalid)(size > 12 ? bytes[size - 1] % 3 : 0);
    brdf_status status = brdf_merl_read_layout(path, &small, invalid, &file, &error);
    demand(status == BRDF_OK || (error.status == status && strlen(error.message) > 10));
    if (status == BRDF_OK) {
        inspect(&file, invalid);
    }
    brdf_merl_free(&file);
    demand(brdf_merl_read(path, invalid, &file, &error) == BRDF_BAD_FILE && !file.rgb);
    return 0;
}
