/* tables.c - which reader makes the table of which tabulated model. */
#include "bsdf.h"

#include "merl_table.h"

/* A tabulated model's measurement has a format of its own; this is the list of their readers. */
static const struct {
    int model;
    brdf_status (*load)(const char *path, float **table, size_t *words, struct brdf_error *error);
} readers[] = {
    {BRDF_MODEL_MERL, brdf_merl_table_load},
};

brdf_status brdf_table_load(const struct brdf_model_info *model, const char *path, float **table,
                            size_t *words, struct brdf_error *error)
{
    for (size_t i = 0; i < sizeof readers / sizeof readers[0]; ++i) {
        if (readers[i].model == model->tag) {
            return readers[i].load(path, table, words, error);
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED, "%s: no reader for its files", model->name);
}
