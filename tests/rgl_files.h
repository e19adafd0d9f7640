/*
 * rgl_files.h - materials to make RGL files of, and places for the files.
 */
#ifndef TEST_RGL_FILES_H
#define TEST_RGL_FILES_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <brdf/material.h>
#include <brdf/rgl.h>

#include "merl_bake.h"
#include "random_vectors.h"
#include "support_bsdf.h"
#include "support_place.h"

/* The bsdf at `data` in RGB; per wavelength its green, rising from 0 at 360 nm to 1 at 830 nm. */
static inline void rgl_test_values(const double wo[3], const double wi[3], int channels,
                                   const float *wavelengths, double *values, void *data)
{
    brdf_rgb f = brdf_eval(data, brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]),
                           brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]));
    const double rgb[3] = {(double)f.r, (double)f.g, (double)f.b};
    for (int i = 0; i < channels; ++i) {
        values[i] = wavelengths ? rgb[1] * ((double)wavelengths[i] - 360.0) / 470.0 : rgb[i];
    }
}

/* The smallest honest grid: a file of a few hundred bytes. */
static const struct brdf_rgl_grid rgl_test_tiny = {
    .thetas = 2, .normals = 4, .size = 2, .description = "tiny"};

/* A file's values of a material; ends the test if there are none. */
static inline struct brdf_rgl_file rgl_test_make(const char *description,
                                                 const struct brdf_rgl_grid *grid)
{
    struct brdf_rgl_file file;
    struct brdf_error error = {BRDF_OK, ""};
    struct brdf_bsdf *bsdf = bsdf_make(description);
    if (brdf_rgl_make(rgl_test_values, bsdf, grid, &file, &error)) {
        fail_msg("%s: %s", description, error.message);
    }
    brdf_bsdf_destroy(bsdf);
    return file;
}

/* The values as the model measured, through a file. */
static inline struct brdf_bsdf *rgl_test_load(const struct brdf_rgl_file *file)
{
    struct place place;
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(place_make(&place, "material.bsdf"), 0);
    struct brdf_setting setting = brdf_setting_text("filename", place.path);
    brdf_status status = brdf_rgl_write(place.path, file, &error);
    status = status ? status : brdf_bsdf_create_from("measured", &setting, 1, &bsdf, &error);
    place_remove(&place);
    if (status) {
        fail_msg("%s", error.message);
    }
    return bsdf;
}

#endif
