/*
 * cases.c - the cases of every model.
 */
#include "cases.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "brdfcl/check_cases.h"
#include "density.h"

/* Cases beside the initial parameters and the random ones. */
static const char *const more_cases[] = {
    "diffuse:reflectance=1",
    "phong:exponent=1,specular_reflectance=0.5,diffuse_reflectance=0",
    "phong:exponent=1000,specular_reflectance=1,diffuse_reflectance=0",
    "blinnphong:normalisation=energy,exponent=1000,specular_reflectance=1,diffuse_reflectance=0",
    "blinnphong:normalisation=distribution,exponent=0,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=balanced,alpha=0.5,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=ward-duer,alpha_u=0.05,alpha_v=0.6,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=ward,alpha_u=0.3,alpha_v=0.01,specular_reflectance=1,diffuse_reflectance=0",
    "ashikhminshirley:specular_reflectance=1,exponent_u=10,exponent_v=1000",
    "torrancesparrow:distribution=blinn,exponent=5",
    "torrancesparrow:distribution=beckmann,alpha=0.5",
    "torrancesparrow:distribution=beckmann,alpha=0.01",
    "cooktorrance:alpha=0.3,eta=1.5,k=0,diffuse_reflectance=0.6",
    "roughconductor:distribution=ggx,alpha=0.5",
    "roughconductor:distribution=ggx,alpha=0.01",
    "roughconductor:distribution=ggx,alpha_u=0.05,alpha_v=0.6",
    "roughconductor:distribution=beckmann,alpha=0.5",
    "roughconductor:distribution=beckmann,alpha=0.01",
    "roughconductor:distribution=beckmann,alpha_u=0.6,alpha_v=0.05",
    "principled:metallic=0.3,roughness=0.2,anisotropic=0.8,clearcoat=1,sheen=1,flatness=0.5",
    "principled:spec_trans=0.7,roughness=0.4,eta=1.5,clearcoat=0.5,clearcoat_gloss=0.5,coat=burley",
    "wood:fiber_axis=0.9/0.4/0.7,beta=0.05,fiber_reflectance=1,diffuse_reflectance=0.1",
    "wood:eta=1,fiber_reflectance=1,diffuse_reflectance=0",
    "roughconductor:distribution=ggx,alpha=0.7,multiscatter=kullaconty",
    "roughconductor:distribution=ggx,alpha_u=0.05,alpha_v=0.8,multiscatter=kullaconty",
    "roughdielectric:distribution=beckmann,alpha_u=0.6,alpha_v=0.1,multiscatter=kullaconty",
    "dielectric:int_ior=1.33,ext_ior=1",
    "dielectric:int_ior=1,ext_ior=2.4",
};

enum { RANDOM_CASES = 8 }; /* of each model, at least */

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static int is_of(const char *description, const struct brdf_model_info *model)
{
    size_t length = strlen(model->name);
    return !strncmp(description, model->name, length) &&
           (description[length] == ':' || !description[length]);
}

static size_t random_count(const struct brdf_model_info *model)
{
    size_t variants = (size_t)brdfcl_check_variant_count(model);
    return variants * ((RANDOM_CASES + variants - 1) / variants);
}

size_t lab_cases_count(const struct brdf_model_info *model)
{
    size_t count = 1 + random_count(model);
    for (size_t i = 0; i < COUNT(more_cases); ++i) {
        count += (size_t)is_of(more_cases[i], model);
    }
    return count;
}

/* Those described in words are not mirrored. */
static size_t comparisons_of(const struct brdf_model_info *model)
{
    if (model->flags & BRDF_DELTA) {
        return 0;
    }
    struct brdf_material material = {.flags = model->flags};
    size_t random = random_count(model);
    int variants = brdfcl_check_variant_count(model);
    size_t views = (lab_cases_count(model) - random) * (size_t)lab_view_count(model->flags);
    for (size_t i = 0; i < random; ++i) {
        brdfcl_check_material_vary(&material, model, (int)i % variants);
        views += (size_t)lab_view_count(material.flags);
    }
    return views;
}

size_t lab_suite_comparisons(void)
{
    size_t count = 0;
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        count += comparisons_of(brdf_model_info(tag));
    }
    return count;
}

static brdf_status add_described(struct lab_cases *cases, const char *description,
                                 struct brdf_error *error)
{
    struct lab_case *one = &cases->items[cases->count];
    struct brdf_bsdf *bsdf;
    brdf_status status = brdfcl_check_bsdf_create(description, &bsdf, error);
    if (status) {
        return status;
    }
    one->bsdf = *bsdf;
    one->is_made = 1;
    free(bsdf); /* its table lives on in the case */
    snprintf(one->text, sizeof one->text, "%s", description);
    ++cases->count;
    return BRDF_OK;
}

/* Random parameters; a table that files fill is that of the first case. */
static brdf_status add_random(struct lab_cases *cases, int variant, struct brdfcl_random *random,
                              struct brdf_error *error)
{
    struct lab_case *one = &cases->items[cases->count++];
    one->bsdf = cases->items[0].bsdf;
    one->is_made = 0;
    struct brdf_material *material = &one->bsdf.material;
    brdfcl_check_material_vary(material, cases->model, variant);
    brdfcl_check_material_change(material, cases->model, random);
    brdf_material_see_through(material, cases->model);
    one->bsdf.parameters = brdf_parameters_load(material->model, material->choices, material->word);
    brdfcl_check_material_describe(material, cases->model, one->text, sizeof one->text);
    if (!(cases->model->flags & BRDF_COMPUTED)) {
        return BRDF_OK;
    }
    one->is_made = 1;
    one->bsdf.table = NULL;
    one->bsdf.table_words = 0;
    brdf_status status =
        brdf_table_compute(material, 0u, 1, &one->bsdf.table, &one->bsdf.table_words, error);
    one->bsdf.parameters = brdf_parameters_load(material->model, material->choices, material->word);
    return status;
}

brdf_status lab_cases_create(const struct brdf_model_info *model, struct lab_cases *cases,
                             struct brdf_error *error)
{
    memset(cases, 0, sizeof *cases);
    cases->model = model;
    cases->items = calloc(lab_cases_count(model), sizeof *cases->items);
    if (!cases->items) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the cases of %s",
                         model->name);
    }
    brdf_status status = add_described(cases, model->name, error);
    for (size_t i = 0; i < COUNT(more_cases) && !status; ++i) {
        if (is_of(more_cases[i], model)) {
            status = add_described(cases, more_cases[i], error);
        }
    }
    struct brdfcl_random random = {7};
    int variants = brdfcl_check_variant_count(model);
    for (size_t i = 0; i < random_count(model) && !status; ++i) {
        status = add_random(cases, (int)i % variants, &random, error);
    }
    if (status) {
        lab_cases_destroy(cases);
    }
    return status;
}

void lab_cases_destroy(struct lab_cases *cases)
{
    for (size_t i = 0; i < cases->count; ++i) {
        if (cases->items[i].is_made) {
            free(cases->items[i].bsdf.table);
            for (int k = 0; k < BRDF_FILES; ++k) {
                free(cases->items[i].bsdf.file[k]);
            }
        }
    }
    free(cases->items);
    memset(cases, 0, sizeof *cases);
}
