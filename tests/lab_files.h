/*
 * lab_files.h - baked tables as files and as bsdfs, for the tests of the laboratory.
 */
#ifndef TEST_LAB_FILES_H
#define TEST_LAB_FILES_H

#include <brdf/material.h>

#include "bake.h"
#include "merl_bake.h"

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
    char *folder = test_folder_make();
    char path[4200], description[4400];
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_non_null(folder);
    snprintf(path, sizeof path, "%s/measurement", folder);
    snprintf(description, sizeof description, "%s:filename=\"%s\",%s", merl ? "merl" : "measured",
             path, settings);
    brdf_status status =
        merl ? brdf_merl_write(path, merl, &error) : brdf_rgl_write(path, rgl, &error);
    status = status ? status : brdf_bsdf_create(description, &bsdf, &error);
    unlink(path);
    rmdir(folder);
    free(folder);
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
