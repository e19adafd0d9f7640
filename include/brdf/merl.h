/*
 * merl.h - measured isotropic BRDFs in the MERL `.binary` format: read, make and write files.
 *
 * To render with one, give its path to the model: "merl:filename=gold.binary". This header is for
 * those who want the numbers. docs/merl.md has the layout and its pitfalls.
 *
 * Format: Matusik, Pfister, Brand, McMillan, "A Data-Driven Reflectance Model", 2003. Three
 * little-endian 32-bit integers (90, 90, 180 bins of theta_h, theta_d, phi_d), then planes of
 * little-endian doubles for R, G and B, each in units of 1/1500, 1.15/1500, 1.66/1500 1/sr.
 */
#ifndef BRDF_MERL_H
#define BRDF_MERL_H

#include <stddef.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A file's values in memory. brdf_merl_read and brdf_merl_make fill it, brdf_merl_free ends it. */
struct brdf_merl_file {
    int theta_h;    /* bins of the half angle, 90; bin k begins at (pi / 2) (k / 90)^2 rad */
    int theta_d;    /* bins of the difference angle, 90, one degree each */
    int phi_d;      /* bins of the difference azimuth, 180, one degree each, from 0 to pi */
    float *rgb;     /* [theta_h][theta_d][phi_d][3], f in 1/sr; owned by the struct, malloc'd */
    size_t bins;    /* theta_h theta_d phi_d */
    size_t invalid; /* bins without a measurement; invalid / bins is their fraction */
    int folded;     /* 1: the file had a whole turn of phi_d, 360 bins, and was folded; else 0 */
    double folding; /* how unlike the values were that met then: mean difference over mean; or 0 */
};

/* What becomes of bins without a measurement (a negative value in any channel). */
enum brdf_merl_invalid {
    BRDF_MERL_INVALID_FILL, /* from valid bins of the same theta_d and phi_d: docs/merl.md */
    BRDF_MERL_INVALID_ZERO, /* 0 in all channels */
    BRDF_MERL_INVALID_KEEP  /* -1 in all channels */
};

/*
 * Read a file. A file with 360 bins of phi_d (a full turn, as some data sets have) is folded:
 * opposite azimuths are the same by reciprocity, and are averaged. On failure `file` is left empty
 * and nothing is to be freed. Errors: BRDF_IO (missing, unreadable, not a regular file),
 * BRDF_BAD_FILE (another header, shorter or longer than the header says, a value that is not
 * finite, no valid bin at all), BRDF_OUT_OF_MEMORY, BRDF_BAD_ARGUMENT (a null pointer or an unknown
 * `invalid`).
 */
BRDF_API brdf_status brdf_merl_read(const char *path, enum brdf_merl_invalid invalid,
                                    struct brdf_merl_file *file, struct brdf_error *error);

/* f(wo, wi) in 1/sr into rgb, for unit directions in the local frame, both above the surface. */
typedef void brdf_merl_function(const double wo[3], const double wi[3], double rgb[3], void *data);

/*
 * Make the values of a file from a function: f at the centre of each bin. Bins whose centre has a
 * direction below the surface hold -1, as in measured files, and are counted as invalid.
 * Errors: BRDF_OUT_OF_MEMORY, BRDF_BAD_ARGUMENT.
 */
BRDF_API brdf_status brdf_merl_make(brdf_merl_function *f, void *data, struct brdf_merl_file *file,
                                    struct brdf_error *error);

/*
 * Give a file its sizes and its memory, every bin invalid (-1), to be filled in by the caller, who
 * keeps `invalid` true. Errors: BRDF_OUT_OF_MEMORY, BRDF_BAD_ARGUMENT.
 */
BRDF_API brdf_status brdf_merl_create(struct brdf_merl_file *file, struct brdf_error *error);

/*
 * Fill the invalid bins of a file as brdf_merl_read does with BRDF_MERL_INVALID_FILL; `invalid`
 * keeps the count of what was not measured. Errors: BRDF_BAD_ARGUMENT (no bin is valid).
 */
BRDF_API brdf_status brdf_merl_fill(struct brdf_merl_file *file, struct brdf_error *error);

/*
 * The directions [1] at the half and difference angles [rad] of Rusinkiewicz 1998, section 3: half
 * way between wo and wi is h at (theta_h, phi_h), and around it wi lies at (theta_d, phi_d).
 * Returns 1 if both are above the surface, else 0.
 */
BRDF_API int brdf_merl_directions_at(double theta_h, double phi_h, double theta_d, double phi_d,
                                     double wo[3], double wi[3]);

/*
 * The directions [1] at the centre of a bin, wo and wi unit, h in the half plane of +x. Returns 1
 * if both are above the surface, else 0.
 */
BRDF_API int brdf_merl_directions(int theta_h, int theta_d, int phi_d, double wo[3], double wi[3]);

/*
 * Write a file, whole or not at all: under a temporary name beside it, then renamed. Negative
 * values are written as -1 (invalid). An existing regular file is replaced. Errors: BRDF_IO (with
 * the reason of the system), BRDF_BAD_ARGUMENT (sizes that are not MERL's, a value that is not
 * finite), BRDF_OUT_OF_MEMORY.
 */
BRDF_API brdf_status brdf_merl_write(const char *path, const struct brdf_merl_file *file,
                                     struct brdf_error *error);

/* Free the values and empty the struct; an empty one may be given again. NULL is ignored. */
BRDF_API void brdf_merl_free(struct brdf_merl_file *file);

#ifdef __cplusplus
}
#endif

#endif
