/*
 * opencl_text.c - the text of a program: shared headers and kernels put together, with a list of
 * models that is cut to those it needs.
 */
#include <stdio.h>
#include <stdlib.h>

#include "embedded.h"
#include "opencl.h"

#include <brdf/model.h>
#include <brdf/source.h>

/* The list of models has a bit for each in opencl_models. */
typedef char opencl_models_fit[BRDF_MODEL_COUNT <= 64 ? 1 : -1];

static const struct {
    const char *tag;
    const char *include; /* its line in models.h */
} known[BRDF_MODEL_COUNT] = {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    {"BRDF_MODEL_" #NAME, "#include \"model/" #name ".h\""},
#include <brdf/models.h>
#undef BRDF_MODEL
};

const char *opencl_model_tag(unsigned model)
{
    return known[model].tag;
}

brdf_status opencl_expand(opencl_models models, const char *text, const char *text_name, char **out,
                          struct brdf_error *error)
{
    size_t count = 0;
    while (brdfcl_embedded_files[count].name) {
        ++count;
    }
    struct brdf_source_file *files = malloc((count + 2) * sizeof *files);
    if (!files) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the text of %s", text_name);
    }
    const char *lines[BRDF_MODEL_COUNT + 1];
    size_t used = 0;
    for (unsigned model = 0; model < BRDF_MODEL_COUNT; ++model) {
        if (models & OPENCL_MODEL(model)) {
            lines[used++] = known[model].include;
        }
    }
    lines[used] = NULL;
    files[0].name = "brdf/models.h";
    files[0].lines = lines;
    for (size_t i = 0; i <= count; ++i) {
        files[i + 1] = brdfcl_embedded_files[i];
    }
    brdf_status status = brdf_source_expand(text, text_name, files, out, error);
    free(files);
    return status;
}
