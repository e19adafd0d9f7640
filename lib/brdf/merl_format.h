/*
 * merl_format.h - what reader and writer of MERL files agree on (internal).
 */
#ifndef BRDF_MERL_FORMAT_H
#define BRDF_MERL_FORMAT_H

#include <stdint.h>

#include "brdf/merl.h"

enum {
    BRDF_MERL_FILE_THETA_H = 90,
    BRDF_MERL_FILE_THETA_D = 90,
    BRDF_MERL_FILE_PHI_D = 180,
    BRDF_MERL_FILE_HEADER = 12 /* bytes */
};

/* The unit of each channel's numbers in the file [1/sr]; the constants of MERL's own reader. */
static const double brdf_merl_units[3] = {1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

/* Bins of a table. There is one layout; small ones let a fuzzer reach all of the reader. */
struct brdf_merl_layout {
    int theta_h;
    int theta_d;
    int phi_d; /* of half a turn, at most BRDF_MERL_FILE_PHI_D; a file may have twice as many */
};

static const struct brdf_merl_layout brdf_merl_layout = {
    BRDF_MERL_FILE_THETA_H, BRDF_MERL_FILE_THETA_D, BRDF_MERL_FILE_PHI_D};

/* brdf_merl_read for files of any layout; all of them are valid pointers. */
brdf_status brdf_merl_read_layout(const char *path, const struct brdf_merl_layout *layout,
                                  enum brdf_merl_invalid invalid, struct brdf_merl_file *file,
                                  struct brdf_error *error);

/* Give the file its sizes and its memory, not yet set. */
brdf_status brdf_merl_reserve(struct brdf_merl_file *file, const struct brdf_merl_layout *layout,
                              struct brdf_error *error);

/* Replace invalid (negative) bins; BRDF_MERL_INVALID_FILL needs at least one valid bin. */
void brdf_merl_replace(struct brdf_merl_file *file, enum brdf_merl_invalid invalid);

/* Little-endian numbers in memory, whatever the machine. */
static inline uint32_t brdf_little32(const unsigned char *b)
{
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

static inline uint64_t brdf_little64(const unsigned char *b)
{
    return (uint64_t)brdf_little32(b) | (uint64_t)brdf_little32(b + 4) << 32;
}

#endif
