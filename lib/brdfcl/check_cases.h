/*
 * check_cases.h - what the models are checked with: materials, directions, random numbers.
 *
 * Everything comes from info.h, so that a new model is checked without a word here. Directions and
 * numbers are chosen to hurt: beside ordinary ones there are grazing, coincident, opposite and
 * normal directions, and uniform numbers of 0 and just below 1.
 */
#ifndef BRDFCL_CHECK_CASES_H
#define BRDFCL_CHECK_CASES_H

#include <brdf/info.h>
#include <brdf/material.h>
#include <brdf/stored.h>

#include "check_random.h"

struct brdfcl_check_input {
    brdf_vec3 wo;
    brdf_vec3 wi;
    brdf_vec3 u;
};

/* A unit vector, uniform on the sphere. */
brdf_vec3 brdfcl_random_direction(struct brdfcl_random *random);

/* Two directions and three uniform numbers, half of the time at some limit. */
struct brdfcl_check_input brdfcl_check_input_make(struct brdfcl_random *random);

/*
 * A variant is what a kernel is compiled for: the options that are chosen, and whether mirrored.
 * There are as many as there are combinations of options, without those that do not go together
 * (info.h), and at least two where mirroring is possible. Of more than 16, a selection: every two
 * options of two choices that go together are met in some variant; so are both with and without
 * mirroring. check_choices.c
 */
int brdfcl_check_variant_count(const struct brdf_model_info *model);

/* Turn a material of the model into a variant of it, 0 <= variant < count. */
void brdfcl_check_material_vary(struct brdf_material *material, const struct brdf_model_info *model,
                                int variant);

/* Give it other parameters, every one anywhere in its range, limits included; same variant. */
void brdfcl_check_material_change(struct brdf_material *material,
                                  const struct brdf_model_info *model,
                                  struct brdfcl_random *random);

/* The material as a description (material.h), but for a FILE, cut to `size` bytes. */
void brdfcl_check_material_describe(const struct brdf_material *material,
                                    const struct brdf_model_info *model, char *text, size_t size);

/*
 * As brdf_bsdf_create, but a model that reads a measurement gets one made for it in a temporary
 * file, unless the description names its own, and one that computes a table has options that need
 * it, unless the description chooses. Fails also where no maker is known for the
 * measurement.
 */
brdf_status brdfcl_check_bsdf_create(const char *description, struct brdf_bsdf **out,
                                     struct brdf_error *error);

/*
 * The materials of the model whose tables its variants are checked with, from 0: the initial one,
 * and one for which libbrdf decides otherwise (DECIDED in brdf/parameters.h). *out is NULL where
 * there are no more of them.
 */
brdf_status brdfcl_check_base_create(const struct brdf_model_info *model, int number,
                                     struct brdf_bsdf **out, struct brdf_error *error);

/* Does the variant of a material have what needs the base's table? Always, of base 0. */
int brdfcl_check_base_serves(const struct brdf_model_info *model, int number,
                             const struct brdf_material *material);

#endif
