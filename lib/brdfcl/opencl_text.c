/*
 * opencl_text.c - the text of a program: shared headers and kernels put together, cut to what its
 * materials use: models.h and choices.h are written for them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "embedded.h"
#include "opencl.h"

#include <brdf/model.h>
#include <brdf/source.h>

typedef char opencl_models_fit[(int)BRDF_MODEL_COUNT <= (int)OPENCL_MODELS ? 1 : -1];

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

/* What brdf/choices.h is in a program: the first lines, two constants for each model, the last. */
static const char *const choices_begin[] = {"#ifndef BRDF_CHOICES_H", "#define BRDF_CHOICES_H"};
static const char *const choices_end[] = {
    "#define BRDF_KNOWN(NAME, p) { unsigned known = BRDF_##NAME##_KNOWN; \\",
    "unsigned chosen = BRDF_##NAME##_CHOSEN; BRDF_##NAME##_PARAMETERS(BRDF_KNOW) }",
    "#endif",
    NULL,
};

enum { BEGIN = sizeof choices_begin / sizeof *choices_begin };

/* The two headers that are written for a program. */
struct cut {
    const char *models[BRDF_MODEL_COUNT + 1];
    const char *choices[sizeof choices_end / sizeof *choices_end + BEGIN + BRDF_MODEL_COUNT];
    char constants[BRDF_MODEL_COUNT][160];
};

static void cut_to(const struct opencl_materials *materials, struct cut *cut)
{
    size_t used = 0;
    memcpy(cut->choices, choices_begin, sizeof choices_begin);
    for (unsigned i = 0; i < BRDF_MODEL_COUNT; ++i) {
        if (materials->model[i].used) {
            snprintf(cut->constants[used], sizeof cut->constants[used],
                     "enum { BRDF_%s_KNOWN = (int)0x%xu, BRDF_%s_CHOSEN = (int)0x%xu };",
                     known[i].upper, materials->model[i].known, known[i].upper,
                     materials->model[i].chosen);
            cut->models[used] = known[i].include;
            cut->choices[BEGIN + used] = cut->constants[used];
            ++used;
        }
    }
    cut->models[used] = NULL;
    memcpy(cut->choices + BEGIN + used, choices_end, sizeof choices_end);
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
