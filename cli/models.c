/* models.c - brdfcl models: what there is, and what each model can be told. */
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/material.h>
#include <brdf/substance.h>

#include "brdflab/bake.h"
#include "commands.h"
#include "options.h"
#include "say.h"

/* Has a model that is not perfectly smooth a part that is, as it is initially? */
static int has_delta_part(const struct brdf_model_info *model)
{
    struct brdf_bsdf *bsdf = NULL;
    int has = !(model->flags & BRDF_DELTA) &&
              brdf_bsdf_create(model->name, &bsdf, NULL) == BRDF_OK && lab_has_delta(bsdf);
    brdf_bsdf_destroy(bsdf);
    return has;
}

/* What a model is, in words. */
static const char *flags_text(const struct brdf_model_info *model, char *text, size_t size)
{
    static const struct word {
        unsigned flag;
        const char *text;
    } words[] = {
        {BRDF_REFLECTION, "reflects"}, {BRDF_TRANSMISSION, "transmits"},
        {BRDF_DELTA, "delta"},         {BRDF_ANISOTROPIC, "anisotropic"},
        {BRDF_TABULATED, "measured"},  {BRDF_RECIPROCAL, "reciprocal"},
    };
    snprintf(text, size, "%s", has_delta_part(model) ? "partly delta" : "");
    for (size_t i = 0; i < sizeof words / sizeof words[0]; ++i) {
        if (model->flags & words[i].flag) {
            size_t used = strlen(text);
            snprintf(text + used, size - used, "%s%s", used ? ", " : "", words[i].text);
        }
    }
    return text;
}

/* "; also called a, b", or "". */
static const char *aliases_text(const struct brdf_model_info *model, char *text, size_t size)
{
    const char *alias;
    text[0] = '\0';
    for (int i = 0; (alias = brdf_model_alias(model, i)) != NULL; ++i) {
        size_t used = strlen(text);
        snprintf(text + used, size - used, "%s%s", used ? ", " : "; also called ", alias);
    }
    return text;
}

static void list_models(void)
{
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *model = brdf_model_info(tag);
        char flags[128], aliases[128];
        printf("%-16s %s\n", model->name, model->summary);
        printf("%-16s %s; %s%s\n", "", flags_text(model, flags, sizeof flags), model->reference,
               aliases_text(model, aliases, sizeof aliases));
    }
}

/* The metal that sets a parameter of the model from the beginning; NULL if none does. */
static const char *metal_of(const struct brdf_model_info *model, const char *name)
{
    for (size_t i = 0; i < model->parameter_count; ++i) {
        if (model->parameters[i].kind == BRDF_KIND_METAL) {
            return strcmp(name, "eta") == 0 || strcmp(name, "k") == 0
                       ? model->parameters[i].initial_text
                       : NULL;
        }
    }
    return NULL;
}

/* What values a parameter takes, and what it is without being set. */
static void show_values(const struct brdf_model_info *model,
                        const struct brdf_parameter_info *parameter)
{
    const char *metal = metal_of(model, parameter->name);
    char item[64] = "";
    switch (parameter->kind) {
    case BRDF_KIND_CHOICE:
        brdf_parameter_item(parameter, (int)parameter->initial, item, sizeof item);
        printf("one of %s; initially %s", parameter->unit, item);
        break;
    case BRDF_KIND_REAL:
    case BRDF_KIND_COLOR:
        printf("from %g to %g", (double)parameter->low, (double)parameter->high);
        if (strcmp(parameter->unit, "ior") == 0) {
            printf(", or a dielectric by name");
        } else if (strcmp(parameter->unit, "1") != 0) {
            printf(" [%s]", parameter->unit);
        }
        if (metal) {
            printf("; initially that of %s", metal);
        } else {
            printf("; initially %g", (double)parameter->initial);
        }
        break;
    case BRDF_KIND_ALIAS:
        printf("sets %s", parameter->unit);
        break;
    case BRDF_KIND_METAL:
        printf("a metal by name; sets eta and k");
        if (parameter->initial_text) {
            printf("; initially %s", parameter->initial_text);
        }
        break;
    default:
        printf("a path; must be given");
        break;
    }
}

/* The names that a parameter may have instead of a number. */
static void show_substances(const struct brdf_model_info *model)
{
    int metals = 0, dielectrics = 0;
    for (size_t i = 0; i < model->parameter_count; ++i) {
        metals |= model->parameters[i].kind == BRDF_KIND_METAL;
        dielectrics |= model->parameters[i].kind == BRDF_KIND_REAL &&
                       strcmp(model->parameters[i].unit, "ior") == 0;
    }
    const struct brdf_metal *metal;
    for (int i = 0; metals && (metal = brdf_metal_at(i)) != NULL; ++i) {
        printf("%s%s", i ? " " : "\nmetals: ", metal->name);
    }
    const struct brdf_dielectric_substance *substance;
    for (int i = 0; dielectrics && (substance = brdf_dielectric_at(i)) != NULL; ++i) {
        printf("%s%s %g", i ? ", " : "\ndielectrics: ", substance->name, (double)substance->ior);
    }
    if (metals || dielectrics) {
        printf("\n");
    }
}

static void show_model(const struct brdf_model_info *model)
{
    char flags[128], aliases[128];
    printf("%s: %s\n", model->name, model->summary);
    printf("%s%s\n", flags_text(model, flags, sizeof flags),
           aliases_text(model, aliases, sizeof aliases));
    printf("reference: %s\n", model->reference);
    for (size_t i = 0; i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        printf("\n  %-24s %s: %s\n", parameter->name, brdf_kind_name(parameter->kind),
               parameter->meaning);
        printf("  %-24s ", "");
        show_values(model, parameter);
        printf("\n");
    }
    printf("\n  %-24s flag: the side below the surface looks like the side above\n", "twosided");
    show_substances(model);
}

int command_models(int argc, char **argv)
{
    const struct usage usage = {
        "models", "[NAME]", "List the models, or all that one of them can be told.", NULL, 0, 0, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (arguments.count == 0) {
        list_models();
        return EXIT_DONE;
    }
    const struct brdf_model_info *model = brdf_model_find(arguments.item[0]);
    if (!model) {
        say("unknown model \"%s\"%s; \"brdfcl models\" lists them", arguments.item[0],
            say_nearest(brdf_model_nearest(arguments.item[0])).text);
        return EXIT_FAILED;
    }
    show_model(model);
    return EXIT_DONE;
}
