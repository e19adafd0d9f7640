/*
 * fuzz_merl.c - any bytes as a MERL file. Whole ones are 35 MB: the input is the header and some
 * values, and where the header is one that is accepted, zeros make up the rest for some.
 */
#define _POSIX_C_SOURCE 200809L

#include <string.h>

#include <brdf/merl.h>

#include "fuzz_file.h"

static void demand(int truth)
{
    if (!truth) {
        abort();
    }
}

/* The length that the header asks for, if it is MERL's. */
static long whole_length(const uint8_t *bytes, size_t size)
{
    static const uint8_t header[12] = {90, 0, 0, 0, 90, 0, 0, 0, 180, 0, 0, 0};
    return size > 12 && memcmp(bytes, header, sizeof header) == 0 ? 34992012 : 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct brdf_merl_file file;
    struct brdf_error error = {BRDF_OK, ""};
    long whole = whole_length(bytes, size);
    const char *path = fuzz_file(bytes, size);
    if (whole && bytes[size - 1] % 16 == 0) {
        demand(truncate(path, whole) == 0);
    }
    enum brdf_merl_invalid invalid = (enum brdf_merl_invalid)(size % 3);
    brdf_status status = brdf_merl_read(path, invalid, &file, &error);
    demand(status == BRDF_OK || (error.status == status && strlen(error.message) > 10));
    if (status == BRDF_OK) {
        demand(file.bins == 90 * 90 * 180 && file.invalid < file.bins);
    }
    brdf_merl_free(&file);
    return 0;
}
