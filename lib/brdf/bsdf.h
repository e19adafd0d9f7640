/*
 * bsdf.h - what a bsdf is made of (internal).
 */
#ifndef BRDF_BSDF_H
#define BRDF_BSDF_H

#include <stddef.h>

#include "brdf/info.h"
#include "brdf/material.h"
#include "brdf/model.h"

enum { BRDF_FILES = 2 }; /* the most parameters of kind FILE that a model has */

struct brdf_bsdf {
    struct brdf_material material;
    brdf_parameters parameters; /* the material's, unpacked */
    float *table;               /* NULL if the model has none; owned */
    size_t table_words;
    char *file[BRDF_FILES]; /* where the table came from, for descriptions; owned */
    unsigned varies;        /* a bit for each word of the material that will have other values */
};

/* Where settings were written, so that an error can say it: `place` has a byte, from 0, for each.
 */
struct brdf_origin {
    const char *description;
    const size_t *place;
};

/*
 * brdf_bsdf_create_from, with the origin of the settings or NULL. `fixed`: never to be evaluated
 * with other parameters than its own, so that less of a table need be computed.
 */
brdf_status brdf_bsdf_build(const char *model, const struct brdf_setting *settings, size_t count,
                            const struct brdf_origin *origin, int fixed, struct brdf_bsdf **out,
                            struct brdf_error *error);

/*
 * Put the settings into a bsdf that is all zeros, initial values first: material and file, but not
 * yet the table. settings.c
 */
brdf_status brdf_settings_apply(struct brdf_bsdf *bsdf, const struct brdf_model_info *model,
                                const struct brdf_setting *settings, size_t count,
                                const struct brdf_origin *origin, struct brdf_error *error);

/* Whether light passes, as the model and the parameters say, into the material's flags. settings.c
 */
int brdf_material_see_through(struct brdf_material *material, const struct brdf_model_info *model);

/* Which of the model's files a parameter of kind FILE names, from 0. tables.c */
int brdf_file_number(const struct brdf_model_info *model,
                     const struct brdf_parameter_info *parameter);

/*
 * Read the tables of a tabulated model's files, one behind the other in the order of its list;
 * *table is to be freed with free(). tables.c
 */
brdf_status brdf_table_load(const struct brdf_material *material, char *const files[BRDF_FILES],
                            float **table, size_t *words, struct brdf_error *error);

/* The number of what was chosen for a parameter of kind CHOICE; 0 if the model has none of that
   name. computed.c */
int brdf_option_of(const struct brdf_material *material, const char *name);

/*
 * The table that the material's options need, computed; left alone where they need none. Puts in
 * what is DECIDED (parameters.h). `varies` and `fixed` as above. computed.c
 */
brdf_status brdf_table_compute(struct brdf_material *material, unsigned varies, int fixed,
                               float **table, size_t *words, struct brdf_error *error);

#endif
