/* tabulated.c - what the model merl does with a file, from a table in memory. */
#include "tabulated.h"

#include <stdlib.h>
#include <string.h>

#include "brdf/bsdf.h"
#include "brdf/merl_table.h"

/* The words that the model reads, of a table without invalid bins. */
static brdf_status words_make(struct brdf_bsdf *bsdf, const struct brdf_merl_file *file,
                              struct brdf_error *error)
{
    struct brdf_merl_file filled = {0};
    brdf_status status = brdf_merl_create(&filled, error);
    if (!status) {
        memcpy(filled.rgb, file->rgb, file->bins * 3 * sizeof *file->rgb);
        filled.invalid = file->invalid;
        status = brdf_merl_fill(&filled, error);
    }
    if (!status) {
        status = brdf_merl_table_build(&filled, &bsdf->table, &bsdf->table_words, error);
    }
    brdf_merl_free(&filled);
    return status;
}

brdf_status lab_bsdf_of_merl(const struct brdf_merl_file *file, struct brdf_bsdf **out,
                             struct brdf_error *error)
{
    struct brdf_setting name = brdf_setting_text("filename", "a table in memory");
    const struct brdf_model_info *model = brdf_model_info(BRDF_MODEL_MERL);
    struct brdf_bsdf *bsdf = calloc(1, sizeof *bsdf);
    *out = NULL;
    if (!bsdf) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    brdf_status status = brdf_settings_apply(bsdf, model, &name, 1, NULL, error);
    status = status ? status : words_make(bsdf, file, error);
    if (status) {
        brdf_bsdf_destroy(bsdf);
        return status;
    }
    bsdf->parameters =
        brdf_parameters_load(bsdf->material.model, bsdf->material.choices, bsdf->material.word);
    *out = bsdf;
    return BRDF_OK;
}
