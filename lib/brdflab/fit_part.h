/*
 * fit_part.h - one part of a fit: a model, all its settings, and which of them are searched.
 */
#ifndef BRDFLAB_FIT_PART_H
#define BRDFLAB_FIT_PART_H

#include <brdf/info.h>

#include "fit.h"

enum { FIT_SETTINGS = 40 };

struct fit_part {
    const struct brdf_model_info *model;
    struct brdf_setting settings[FIT_SETTINGS];
    char options[FIT_SETTINGS][32]; /* the texts of choices */
    int searched[FIT_SETTINGS];     /* 1: the fit is to find it */
    int tied_to[FIT_SETTINGS]; /* an earlier setting that an alias sets together with it, or -1 */
    int count;
    int eta; /* the settings of a metal's indices, where they are searched by reflectance; else -1
              */
    int k;
    int gray; /* 1: as one reflectance for all channels, and without k */
};

/* The part that the options' model stands for; of a diffuse part NULL is taken for the model. */
brdf_status fit_part_make(struct fit_part *part, const char *model,
                          const struct lab_fit_options *options, struct brdf_error *error);

/* The number of a setting; -1 if the model has none of the name. */
int fit_part_find(const struct fit_part *part, const char *name);

/* What a setting is about. */
const struct brdf_parameter_info *fit_part_info(const struct fit_part *part, int setting);

#endif
