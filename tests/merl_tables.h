/*
 * merl_tables.h - baked tables for the tests of the model merl.
 */
#ifndef TEST_MERL_TABLES_H
#define TEST_MERL_TABLES_H

#include <brdf/model/merl.h>

#include "merl_bake.h"
#include "merl_table.h"
#include "random_vectors.h"
#include "support_place.h"

/* A baked table and the function that it was baked from; the group's state. */
struct baked {
    float *gray; /* Lambert, albedo 0.5 */
    float *glossy;
    float *numbers; /* each bin holds its own indices */
};

static const double gray_albedo = 0.5;
static const double glossy_alpha = 0.3;
static const double incidences[] = {0.0, 30.0, 60.0, 80.0, 88.0}; /* degrees */
enum { INCIDENCES = sizeof incidences / sizeof incidences[0] };

static inline brdf_vec3 direction(double degrees)
{
    double theta = degrees * pi / 180.0;
    return brdf_vec3_make((float)(sin(theta) * 0.8), (float)(sin(theta) * 0.6), (float)cos(theta));
}

static inline struct brdf_merl material(int interpolation)
{
    struct brdf_merl p;
    p.interpolation = interpolation;
    p.scale = 1.0f;
    return p;
}

static inline double mean(brdf_rgb c)
{
    return ((double)c.r + (double)c.g + (double)c.b) / 3.0;
}

/* Through a file, as users do it: bake, write, load. */
static inline float *bake(brdf_merl_function *f, double parameter)
{
    struct brdf_merl_file file;
    float *table = NULL;
    size_t words = 0;
    struct place place;
    if (place_make(&place, "baked.binary") == 0 &&
        brdf_merl_make(f, &parameter, &file, NULL) == BRDF_OK) {
        if (brdf_merl_write(place.path, &file, NULL) == BRDF_OK) {
            brdf_merl_table_load(place.path, BRDF_MERL_INVALID_FILL, &table, &words, NULL);
        }
        brdf_merl_free(&file);
        place_remove(&place);
    }
    return words == BRDF_MERL_TABLE_WORDS ? table : NULL;
}

static inline int tables_make(void **state)
{
    struct baked *baked = calloc(1, sizeof *baked);
    struct brdf_merl_file file;
    size_t words;
    double nothing = 0.0;
    *state = baked;
    baked->gray = bake(test_lambert, gray_albedo);
    baked->glossy = bake(test_glossy, glossy_alpha);
    if (!baked->gray || !baked->glossy ||
        brdf_merl_make(test_lambert, &nothing, &file, NULL) != BRDF_OK) {
        return -1;
    }
    for (size_t bin = 0; bin < file.bins; ++bin) {
        file.rgb[3 * bin] = (float)(bin / (180 * 90));
        file.rgb[3 * bin + 1] = (float)(bin / 180 % 90);
        file.rgb[3 * bin + 2] = (float)(bin % 180);
    }
    brdf_status status = brdf_merl_table_build(&file, &baked->numbers, &words, NULL);
    brdf_merl_free(&file);
    return status;
}

static inline int tables_free(void **state)
{
    struct baked *baked = *state;
    free(baked->gray);
    free(baked->glossy);
    free(baked->numbers);
    free(baked);
    return 0;
}

#endif
