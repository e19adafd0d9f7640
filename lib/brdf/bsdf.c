/* bsdf.c - a bsdf made, evaluated one pair of directions at a time, and freed. */
#include "bsdf.h"

#include <stdlib.h>

#include "brdf/surface.h"

/* No such model: say so, with the name that was meant or all that there are. */
static brdf_status refuse_model(const char *name, struct brdf_error *error)
{
    const char *nearest = brdf_model_nearest(name);
    if (nearest) {
        return brdf_fail(error, BRDF_UNKNOWN_NAME,
                         "no model is called \"%.64s\"; did you mean \"%s\"?", name, nearest);
    }
    char known[600];
    size_t length = 0;
    known[0] = '\0';
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        for (const char *c = tag ? ", " : ""; *c && length + 1 < sizeof known; ++c) {
            known[length++] = *c;
        }
        for (const char *c = brdf_model_info(tag)->name; *c && length + 1 < sizeof known; ++c) {
            known[length++] = *c;
        }
        known[length] = '\0';
    }
    return brdf_fail(error, BRDF_UNKNOWN_NAME, "no model is called \"%.64s\"; known: %s", name,
                     known);
}

brdf_status brdf_bsdf_build(const char *model, const struct brdf_setting *settings, size_t count,
                            const struct brdf_origin *origin, int fixed, struct brdf_bsdf **out,
                            struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    struct brdf_bsdf *bsdf = NULL;
    const struct brdf_model_info *info = brdf_model_find(model);
    *out = NULL;
    if (!info) {
        status = refuse_model(model, error);
        goto done;
    }
    bsdf = calloc(1, sizeof *bsdf);
    if (!bsdf) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
        goto done;
    }
    status = brdf_settings_apply(bsdf, info, settings, count, origin, error);
    if (!status && bsdf->file[0]) {
        status =
            brdf_table_load(&bsdf->material, bsdf->file, &bsdf->table, &bsdf->table_words, error);
    }
    if (!status && info->flags & BRDF_COMPUTED) {
        status = brdf_table_compute(&bsdf->material, bsdf->varies, fixed, &bsdf->table,
                                    &bsdf->table_words, error);
    }
    if (!status) {
        bsdf->parameters =
            brdf_parameters_load(bsdf->material.model, bsdf->material.choices, bsdf->material.word);
        *out = bsdf;
        bsdf = NULL;
    }
done:
    brdf_bsdf_destroy(bsdf);
    return status;
}

brdf_status brdf_bsdf_create_from(const char *model, const struct brdf_setting *settings,
                                  size_t count, struct brdf_bsdf **out, struct brdf_error *error)
{
    return brdf_bsdf_build(model, settings, count, NULL, 0, out, error);
}

void brdf_bsdf_destroy(struct brdf_bsdf *bsdf)
{
    if (bsdf) {
        free(bsdf->table);
        for (int i = 0; i < BRDF_FILES; ++i) {
            free(bsdf->file[i]);
        }
        free(bsdf);
    }
}

brdf_rgb brdf_eval(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 wi)
{
    return brdf_surface_eval(bsdf->material.model, bsdf->material.flags, bsdf->parameters, wo, wi,
                             bsdf->table);
}

float brdf_pdf(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 wi)
{
    return brdf_surface_pdf(bsdf->material.model, bsdf->material.flags, bsdf->parameters, wo, wi,
                            bsdf->table);
}

struct brdf_sample brdf_sample(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 u)
{
    return brdf_surface_sample(bsdf->material.model, bsdf->material.flags, bsdf->parameters, wo, u,
                               bsdf->table);
}

const struct brdf_material *brdf_bsdf_material(const struct brdf_bsdf *bsdf)
{
    return &bsdf->material;
}

const float *brdf_bsdf_table(const struct brdf_bsdf *bsdf, size_t *words)
{
    *words = bsdf->table_words;
    return bsdf->table;
}
