/* tables.c - the table of a model that has files: readers of their formats. */
#include "bsdf.h"

#include <stdlib.h>
#include <string.h>

#include "merl_table.h"
#include "rgl_table.h"

static brdf_status merl_load(const struct brdf_material *material, const char *path, float **table,
                             size_t *words, struct brdf_error *error)
{
    int fill = brdf_option_of(material, "fill");
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
