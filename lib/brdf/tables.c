/* tables.c - where a model's table comes from: a reader of its files, or a computation. */
#include "bsdf.h"

#include <stdlib.h>
#include <string.h>

#include "brdf/microfacet.h"
#include "brdf/round.h"
#include "brushed_table.h"
#include "glass_table.h"
#include "merl_table.h"
#include "rgl_table.h"

static int option_of(const struct brdf_model_info *model, const struct brdf_material *material,
                     const char *name)
{
    const struct brdf_parameter_info *p = brdf_parameter_find(model, name);
    return p ? (int)(material->choices >> 4 * brdf_parameter_place(model, p) & 15u) : 0;
}

static brdf_status merl_load(const struct brdf_material *material, const char *path, float **table,
                             size_t *words, struct brdf_error *error)
{
    int fill = option_of(brdf_model_info((int)material->model), material, "fill");
    return brdf_merl_table_load(path, fill ? BRDF_MERL_INVALID_FILL : BRDF_MERL_INVALID_ZERO, table,
                                words, error);
}

static brdf_status rgl_load(const struct brdf_material *material, const char *path, float **table,
                            size_t *words, struct brdf_error *error)
{
    (void)material; /* no option changes what is read */
    return brdf_rgl_table_load(path, table, words, error);
}

/* A tabulated model's measurement has a format of its own; this is the list of their readers. */
static const struct {
    int model;
    brdf_status (*load)(const struct brdf_material *material, const char *path, float **table,
                        size_t *words, struct brdf_error *error);
} readers[] = {
    {BRDF_MODEL_MERL, merl_load},
    {BRDF_MODEL_MEASUREDMIX, merl_load},
    {BRDF_MODEL_MEASURED, rgl_load},
};

int brdf_file_number(const struct brdf_model_info *model,
                     const struct brdf_parameter_info *parameter)
{
    int number = 0;
    for (const struct brdf_parameter_info *p = model->parameters; p != parameter; ++p) {
        number += p->kind == BRDF_KIND_FILE;
    }
    return number;
}

static brdf_status file_load(const struct brdf_material *material, const char *path, float **table,
                             size_t *words, struct brdf_error *error)
{
    for (size_t i = 0; i < sizeof readers / sizeof readers[0]; ++i) {
        if (readers[i].model == (int)material->model) {
            return readers[i].load(material, path, table, words, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED, "%s: no reader for its files",
                     brdf_model_info((int)material->model)->name);
}

/* Put the table of one more file behind those that are there. */
static brdf_status file_append(const struct brdf_material *material, const char *path,
                               float **table, size_t *words, struct brdf_error *error)
{
    float *more = NULL;
    size_t more_words = 0;
    brdf_status status = file_load(material, path, &more, &more_words, error);
    if (status) {
        return status;
    }
    if (!*table) { /* the first one, mostly the only one: no need to copy it */
        *table = more;
        *words = more_words;
        return BRDF_OK;
    }
    float *all = realloc(*table, (*words + more_words) * sizeof **table);
    if (all) {
        memcpy(all + *words, more, more_words * sizeof *more);
        *table = all;
        *words += more_words;
    }
    free(more);
    return all ? BRDF_OK : brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
}

brdf_status brdf_table_load(const struct brdf_material *material, char *const files[BRDF_FILES],
                            float **table, size_t *words, struct brdf_error *error)
{
    float *all = NULL;
    size_t count = 0;
    brdf_status status = BRDF_OK;
    for (int i = 0; i < BRDF_FILES && files[i] && !status; ++i) {
        status = file_append(material, files[i], &all, &count, error);
    }
    if (status) {
        free(all);
        return status;
    }
    *table = all;
    *words = count;
    return BRDF_OK;
}

static float value_of(const struct brdf_model_info *model, const struct brdf_material *material,
                      const char *name)
{
    const struct brdf_parameter_info *p = brdf_parameter_find(model, name);
    return material->word[brdf_parameter_place(model, p)];
}

static int varies(const struct brdf_model_info *model, unsigned words, const char *name)
{
    return (int)(words >> brdf_parameter_place(model, brdf_parameter_find(model, name)) & 1u);
}

/* What is DECIDED lies behind the choices. */
static void decide(const struct brdf_model_info *model, struct brdf_material *material, int yes)
{
    int place = 0;
    for (size_t i = 0; i < model->parameter_count; ++i) {
        place += model->parameters[i].kind == BRDF_KIND_CHOICE;
    }
    material->choices &= ~(15u << 4 * place);
    material->choices |= (unsigned)yes << 4 * place;
}

/* The one roughness that the table will be asked for. */
static double round_alpha(const struct facet_surface *surface)
{
    return (double)brdf_round_make(BRDF_ROUND_SMITH, (float)surface->alpha_u,
                                   (float)surface->alpha_v)
        .alpha;
}

/* Is the table to be for two roughnesses, which differ and are the same everywhere? */
static int is_brushed(const struct brdf_model_info *model, const struct facet_surface *surface,
                      unsigned words_that_vary)
{
    return surface->alpha_u != surface->alpha_v && !varies(model, words_that_vary, "alpha_u") &&
           !varies(model, words_that_vary, "alpha_v");
}

/* roughplastic has one with every option, the others for compensation. */
brdf_status brdf_table_compute(struct brdf_material *material, unsigned words_that_vary, int fixed,
                               float **table, size_t *words, struct brdf_error *error)
{
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    struct facet_surface surface = {option_of(model, material, "distribution"), 0, 0.0, 0.0, 0.0};
    int plastic = model->tag == BRDF_MODEL_ROUGHPLASTIC,
        metal = model->tag == BRDF_MODEL_ROUGHCONDUCTOR;
    if (!plastic && !option_of(model, material, "multiscatter")) {
        return BRDF_OK;
    }
    surface.masking = plastic ? BRDF_MASKING_SEPARABLE : option_of(model, material, "masking");
    surface.alpha_u = (double)value_of(model, material, plastic ? "alpha" : "alpha_u");
    surface.alpha_v = (double)value_of(model, material, plastic ? "alpha" : "alpha_v");
    if (!metal) {
        surface.eta =
            (double)(value_of(model, material, "int_ior") / value_of(model, material, "ext_ior"));
    }
    int brushed = !plastic && is_brushed(model, &surface, words_that_vary);
    if (!plastic) {
        decide(model, material, brushed);
    }
    if (metal) { /* what the others lose is a fit */
        return brushed ? brdf_brushed_table_make(&surface, table, words, error) : BRDF_OK;
    }
    if (brushed) {
        return brdf_brushed_glass_table_make(&surface, table, words, error);
    }
    surface.alpha_u = surface.alpha_v = fixed ? round_alpha(&surface) : 0.0;
    return brdf_glass_table_make(&surface, plastic, table, words, error);
}
