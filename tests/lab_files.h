/*
 * lab_files.h - baked tables as files and as bsdfs, for the tests of the laboratory.
 */
#ifndef TEST_LAB_FILES_H
#define TEST_LAB_FILES_H

#include <brdf/material.h>

#include "bake.h"
#include "merl_bake.h"
#include "support_place.h"

/* The table of a description; ends the test if there is none. */
static inline struct brdf_merl_file lab_test_bake(const char *description)
{
    struct brdf_merl_file file = {0};
    struct brdf_error error = {BRDF_OK, ""};
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = brdf_bsdf_create(description, &bsdf, &error);
    status = status ? status : lab_bake_merl(bsdf, &file, &error);
    if (status) {
        fail_msg("%s: %s", description, error.message);
    }
    brdf_bsdf_destroy(bsdf);
    return file;
}

/* A measurement through a file, as a bsdf: of one of the two, by its model and settings such as
   "interpolation=linear". */
static inline struct brdf_bsdf *lab_test_through(const struct brdf_merl_file *merl,
                                                 const struct brdf_rgl_file *rgl,
                                                 const char *settings)
{
    struct place place;
    char description[600];
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(place_make(&place, "measurement"), 0);
    snprintf(description, sizeof description, "%s:filename=\"%s\",%s", merl ? "merl" : "measured",
             place.path, settings);
    brdf_status status =
        merl ? brdf_merl_write(place.path, merl, &error) : brdf_rgl_write(place.path, rgl, &error);
    status = status ? status : brdf_bsdf_create(description, &bsdf, &error);
    place_remove(&place);
    if (status) {
        fail_msg("%s", error.message);
    }
    return bsdf;
}

static inline struct brdf_bsdf *lab_test_load(const struct brdf_merl_file *file,
                                              const char *settings)
{
    return lab_test_through(file, NULL, settings);
}

#endif
