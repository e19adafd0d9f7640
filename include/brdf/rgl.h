/*
 * rgl.h - measured BRDFs in the RGL `.bsdf` format: read, make and write files.
 *
 * To render with one, give its path to the model: "measured:filename=paper_white_rgb.bsdf". This
 * header is for those who want the numbers. docs/rgl.md has the layout and its pitfalls.
 *
 * Format: Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
 * Rendering", 2018, in a tensor file: named arrays of numbers. Directions are given by theta and
 * phi [rad]; a grid over them, "by direction", has columns at theta = (pi / 2) x^2 and rows at
 * phi = pi (2 y - 1), x and y from 0 to 1 in equal steps, both ends included.
 */
#ifndef BRDF_RGL_H
#define BRDF_RGL_H

#include <stddef.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * A file's values in memory. brdf_rgl_read and brdf_rgl_make fill it, brdf_rgl_free ends it; all
 * that it points to is malloc'd and owned by the struct. Arrays are in C order, the last index
 * fastest, as their comments name them.
 */
struct brdf_rgl_file {
    char *description; /* in words; never NULL once filled */

    int phi_count;   /* azimuths of wo; 1 or 2: isotropic, the azimuth of the normal is then
                        relative to that of wo */
    int theta_count; /* polar angles of wo, >= 1 */
    float *phi_i;    /* [phi], ascending [rad] in [-pi, pi] */
    float *theta_i;  /* [theta], ascending [rad] in [0, pi / 2] */

    int ndf_rows; /* by direction of the normal; 2 equal rows where it is isotropic */
    int ndf_columns;
    float *ndf; /* [row][column], the distribution D of normals [1/sr] */

    int sigma_rows; /* by direction of wo */
    int sigma_columns;
    float *sigma; /* [row][column], the projected area of the microsurface, 1 at the normal */

    int vndf_rows; /* by direction of the normal */
    int vndf_columns;
    float *vndf; /* [phi][theta][row][column], density of visible normals over the square (x, y),
                    up to a factor for each wo */

    int size;         /* of the grids of luminance and colours, along both sides */
    float *luminance; /* [phi][theta][row][column], up to a factor for each wo: what samples
                         are drawn by before they become normals */

    int channels;       /* 3 for RGB, else wavelengths */
    float *wavelengths; /* [channel], ascending [nm]; NULL for RGB */
    float *values;      /* [phi][theta][channel][row][column]: f cos(theta_i) [1/sr] over
                           D / (4 sigma), in linear Rec. 709 or per wavelength */

    int jacobian; /* 0: values are f cos(theta_i) itself; 1 in all published files */
};

/*
 * Read a file. What it holds beyond these arrays is skipped. On failure `file` is left empty and
 * nothing is to be freed. Errors: BRDF_IO (missing, unreadable, not a regular file), BRDF_BAD_FILE
 * (not a tensor file, cut off, too long, an array that is missing or of the wrong type, rank or
 * size, or that lies outside of the file, a value that is not finite or is absurd: the sentence
 * names the byte), BRDF_OUT_OF_MEMORY, BRDF_BAD_ARGUMENT (a null pointer).
 */
BRDF_API brdf_status brdf_rgl_read(const char *path, struct brdf_rgl_file *file,
                                   struct brdf_error *error);

/*
 * Write a file, whole or not at all: under a temporary name beside it, then renamed. An existing
 * regular file is replaced. Errors: BRDF_IO (with the reason of the system), BRDF_BAD_ARGUMENT
 * (arrays or counts that brdf_rgl_read would refuse), BRDF_OUT_OF_MEMORY.
 */
BRDF_API brdf_status brdf_rgl_write(const char *path, const struct brdf_rgl_file *file,
                                    struct brdf_error *error);

/*
 * f(wo, wi) [1/sr] into `values`, one for each channel, for unit directions in the local frame,
 * both above the surface; wavelength is NULL for RGB, else `channels` of them [nm].
 */
typedef void brdf_rgl_function(const double wo[3], const double wi[3], int channels,
                               const float *wavelengths, double *values, void *data);

/* How finely to sample a function. A zero stands for what comes last in its comment. */
struct brdf_rgl_grid {
    int phis;                 /* azimuths of wo, 1: isotropic, else >= 3; 1 */
    int thetas;               /* polar angles of wo; 8 */
    int symmetry;             /* 1: azimuths over a whole turn, 2: half, 4: a quarter; 1 */
    int normals;              /* columns of ndf, sigma and vndf; 128, or 64 if anisotropic */
    int size;                 /* of luminance and values; 32 */
    int channels;             /* 3, or how many wavelengths; 3 */
    const float *wavelengths; /* ascending [nm], for a spectral file; NULL: RGB */
    const char *description;  /* "" */
};

/*
 * Make the values of a file from a function as the paper makes them from measurements: the
 * distribution of normals from retro-reflection (wi = wo) by power iterations [section 4.1], the
 * visible normals from that, then the function where the warp by these leads to. Deviations: the
 * distribution is the mean of that of retro-reflection and of what each view shows, or a narrow
 * lobe over a matte base would be lost at grazing angles; one normal in a hundred is spread evenly,
 * so that no direction is out of reach; grid points below the surface beside valid ones repeat
 * these; polar angles are denser towards grazing. No direction it asks for has a cosine below
 * 0.001. `grid` may be NULL. Errors: BRDF_BAD_ARGUMENT (a null pointer, a grid out of range, a
 * value that is not finite or above 1e9), BRDF_OUT_OF_MEMORY.
 */
BRDF_API brdf_status brdf_rgl_make(brdf_rgl_function *f, void *data,
                                   const struct brdf_rgl_grid *grid, struct brdf_rgl_file *file,
                                   struct brdf_error *error);

/*
 * Turn a spectral file into an RGB one, in place: linear Rec. 709 under illuminant D65, by the CIE
 * 1931 2-degree observer, linear between wavelengths and constant beyond them, so that a spectrum
 * of 1 becomes (1, 1, 1). An RGB file stays as it is. Errors: BRDF_BAD_ARGUMENT,
 * BRDF_OUT_OF_MEMORY.
 */
BRDF_API brdf_status brdf_rgl_to_rgb(struct brdf_rgl_file *file, struct brdf_error *error);

/* Free the values and empty the struct; an empty one may be given again. NULL is ignored. */
BRDF_API void brdf_rgl_free(struct brdf_rgl_file *file);

#ifdef __cplusplus
}
#endif

#endif
