/*
 * opencl_text.c - the text of a program: shared headers and kernels put together, cut to what its
 * materials use: models.h and choices.h are written for them.
 */
#include <stdio.h>
#include <stdlib.h>

#include "embedded.h"
#include "opencl.h"

#include <brdf/model.h>
#include <brdf/source.h>

static const struct {
    const char *tag;
    const char *upper;   /* its name in constants, "DIFFUSE" */
    const char *include; /* its line in models.h */
} known[BRDF_MODEL_COUNT] = {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    {"BRDF_MODEL_" #NAME, #NAME, "#include \"model/" #name ".h\""},
#include <brdf/models.h>
#undef BRDF_MODEL
};

const char *opencl_model_tag(unsigned model)
{
    return known[model].tag;
}

void opencl_materials_add(struct opencl_materials *materials, unsigned model, unsigned choices)
{
    unsigned known = materials->model[model].used ? materials->model[model].known : ~0u;
    for (int bit = 0; bit < 32 && materials->model[model].used; bit += 4) {
        if ((choices ^ materials->model[model].chosen) >> bit & 15u) {
            known &= ~(15u << bit);
        }
    }
    materials->model[model].used = 1;
    materials->model[model].known = known;
    materials->model[model].chosen = choices;
}

/* The two headers that are written for a program: brdf/models.h and brdf/choices.h. */
struct cut {
    const char *models[BRDF_MODEL_COUNT + 1];
    const char *choices[BRDF_MODEL_COUNT + 3];
    char constants[BRDF_MODEL_COUNT][160];
};

static void cut_to(const struct opencl_materials *materials, struct cut *cut)
{
    size_t used = 0;
    for (unsigned i = 0; i < BRDF_MODEL_COUNT; ++i) {
        if (materials->model[i].used) {
            snprintf(cut->constants[used], sizeof cut->constants[used],
                     "BRDF_%s_KNOWN = (int)0x%xu, BRDF_%s_CHOSEN = (int)0x%xu,", known[i].upper,
                     materials->model[i].known, known[i].upper, materials->model[i].chosen);
            cut->models[used] = known[i].include;
            cut->choices[1 + used] = cut->constants[used];
            ++used;
        }
    }
    cut->models[used] = NULL;
    cut->choices[0] = used ? "enum brdf_model_choices {" : "";
    cut->choices[1 + used] = used ? "};" : "";
    cut->choices[2 + used] = NULL;
}

brdf_status opencl_expand(const struct opencl_materials *materials, const char *text,
                          const char *text_name, char **out, struct brdf_error *error)
{
    enum { CUT = 2 };
    size_t count = 0;
    while (brdfcl_embedded_files[count].name) {
        ++count;
    }
    struct brdf_source_file *files = malloc((CUT + count + 1) * sizeof *files);
    if (!files) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the text of %s", text_name);
    }
    struct cut cut;
    cut_to(materials, &cut);
    files[0].name = "brdf/models.h";
    files[0].lines = cut.models;
    files[1].name = "brdf/choices.h";
    files[1].lines = cut.choices;
    for (size_t i = 0; i <= count; ++i) {
        files[CUT + i] = brdfcl_embedded_files[i];
    }
    brdf_status status = brdf_source_expand(text, text_name, files, out, error);
    free(files);
    return status;
}
