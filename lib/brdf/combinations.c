/* combinations.c - options of a model that do not go together. */
#include "brdf/info.h"
#include "brdf/model.h"

#include <stdio.h>
#include <string.h>

/* Two options of two choices, and why not. */
struct exclusion {
    int model;
    const char *choice;
    const char *option;
    const char *other_choice;
    const char *other_option;
    const char *reason;
};

static const struct exclusion exclusions[] = {
    {BRDF_MODEL_ROUGHCONDUCTOR, "masking", "rational", "distribution", "ggx",
     "the rational approximation is that of Beckmann's masking; for ggx take separable, which is "
     "exact"},
    {BRDF_MODEL_ROUGHCONDUCTOR, "masking", "correlated", "distribution", "blinn",
     "Smith's masking of it has no closed form; take rational, Beckmann's in its place, or "
     "vcavity"},
    {BRDF_MODEL_ROUGHCONDUCTOR, "masking", "separable", "distribution", "blinn",
     "Smith's masking of it has no closed form; take rational, Beckmann's in its place, or "
     "vcavity"},
    {BRDF_MODEL_ROUGHCONDUCTOR, "multiscatter", "kullaconty", "distribution", "blinn",
     "what it loses is known of beckmann and ggx; beckmann of the same alpha looks much the same"},
};

static int has_option(const struct brdf_model_info *model, unsigned choices, const char *name,
                      const char *wanted)
{
    const struct brdf_parameter_info *choice = brdf_parameter_find(model, name);
    char option[64];
    int shift = 4 * brdf_parameter_place(model, choice);
    return brdf_parameter_item(choice, (int)(choices >> shift & 15u), option, sizeof option) &&
           strcmp(option, wanted) == 0;
}

const char *brdf_choices_refused(const struct brdf_model_info *model, unsigned choices, char *text,
                                 size_t size)
{
    for (size_t i = 0; i < sizeof exclusions / sizeof exclusions[0]; ++i) {
        const struct exclusion *e = &exclusions[i];
        if (e->model == model->tag && has_option(model, choices, e->choice, e->option) &&
            has_option(model, choices, e->other_choice, e->other_option)) {
            snprintf(text, size, "%s=%s does not go with %s=%s: %s", e->choice, e->option,
                     e->other_choice, e->other_option, e->reason);
            return text;
        }
    }
    return NULL;
}
