/*
 * fit_part.c - one part of a fit: a model, all its settings, and which of them are searched.
 */
#include <stdio.h>
#include <string.h>

#include <brdf/model.h>

#include "bake.h"
#include "fit_part.h"

/* Is `name` one of the names in a list? */
static int list_has(const char *list, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = list; at && *at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL) {
        if (strncmp(at, name, length) == 0 && (at[length] == ',' || at[length] == '\0')) {
            return 1;
        }
    }
    return 0;
}

/* Does the description, which is known to be valid, set a parameter by this very name? */
static int description_names(const char *description, const char *name)
{
    size_t length = strlen(name);
    int quoted = 0;
    for (const char *at = strchr(description, ':'); at && *at; ++at) {
        quoted ^= *at == '"';
        if ((*at == ':' || (*at == ',' && !quoted)) && strncmp(at + 1, name, length) == 0 &&
            at[1 + length] == '=') {
            return 1;
        }
    }
    return 0;
}

/* Does a parameter, an alias or a metal, stand for another one? */
static int stands_for(const struct brdf_parameter_info *parameter, const char *name)
{
    char item[64];
    int found =
        parameter->kind == BRDF_KIND_METAL && (strcmp(name, "eta") == 0 || strcmp(name, "k") == 0);
    for (int i = 0;
         parameter->kind == BRDF_KIND_ALIAS && brdf_parameter_item(parameter, i, item, sizeof item);
         ++i) {
        found |= strcmp(item, name) == 0;
    }
    return found;
}

/* Does the description set it, by its own name or another one? */
static int description_sets(const char *description, const struct brdf_model_info *model,
                            const char *name)
{
    int sets = description_names(description, name);
    for (size_t i = 0; i < model->parameter_count && !sets; ++i) {
        sets = stands_for(&model->parameters[i], name) &&
               description_names(description, model->parameters[i].name);
    }
    return sets;
}

/*
 * Held is what the description sets, and what nobody would search unless asked: the index outside,
 * since only its ratio to the one inside counts; and factors of the reflection of interfaces and
 * metals, whose indices set it already. (In cooktorrance the factor shares light between the lobe
 * and the diffuse part, and is searched: metal_find says what then becomes of the indices.)
 */
static int is_searched(const struct fit_part *part, const char *description, const char *free_names,
                       const char *name)
{
    const struct brdf_model_info *model = part->model;
    int is_physical = brdf_parameter_find(model, "int_ior") != NULL ||
                      (brdf_parameter_find(model, "eta") != NULL &&
                       brdf_parameter_find(model, "diffuse_reflectance") == NULL);
    if (list_has(free_names, name)) {
        return 1;
    }
    return !description_sets(description, model, name) && strncmp(name, "ext_", 4) != 0 &&
           !(is_physical && strncmp(name, "specular_", 9) == 0);
}

int fit_part_find(const struct fit_part *part, const char *name)
{
    for (int i = 0; i < part->count; ++i) {
        if (strcmp(part->settings[i].name, name) == 0) {
            return i;
        }
    }
    return -1;
}

const struct brdf_parameter_info *fit_part_info(const struct fit_part *part, int setting)
{
    return brdf_parameter_find(part->model, part->settings[setting].name);
}

/* The first setting that an alias sets together with this one, if it comes before it. */
static int tie_of(const struct fit_part *part, int setting)
{
    for (size_t i = 0; i < part->model->parameter_count; ++i) {
        const struct brdf_parameter_info *alias = &part->model->parameters[i];
        if (alias->kind != BRDF_KIND_ALIAS || !stands_for(alias, part->settings[setting].name)) {
            continue;
        }
        for (int other = 0; other < setting; ++other) {
            if (stands_for(alias, part->settings[other].name)) {
                return other;
            }
        }
    }
    return -1;
}

/* A setting with the value that the material has. */
static void setting_copy(struct fit_part *part, const struct brdf_material *material,
                         const struct brdf_parameter_info *parameter)
{
    int place = brdf_parameter_place(part->model, parameter);
    const float *word = material->word + place;
    struct brdf_setting *setting = &part->settings[part->count];
    char *option = part->options[part->count];
    switch (parameter->kind) {
    case BRDF_KIND_CHOICE:
        brdf_parameter_item(parameter, (int)(material->choices >> (4 * place) & 15u), option,
                            sizeof part->options[0]);
        *setting = brdf_setting_text(parameter->name, option);
        break;
    case BRDF_KIND_REAL:
        *setting = brdf_setting_real(parameter->name, word[0]);
        break;
    case BRDF_KIND_COLOR:
        *setting = brdf_setting_color(parameter->name, word[0], word[1], word[2]);
        break;
    default: /* what sets others has done so */
        return;
    }
    ++part->count;
}

static brdf_status check_free(const struct brdf_model_info *model, const char *names,
                              struct brdf_error *error)
{
    char name[64];
    for (const char *at = names; at && *at;) {
        size_t length = strcspn(at, ",");
        snprintf(name, sizeof name, "%.*s", (int)(length < 63 ? length : 63), at);
        const struct brdf_parameter_info *found = brdf_parameter_find(model, name);
        if (!found || (found->kind != BRDF_KIND_REAL && found->kind != BRDF_KIND_COLOR)) {
            const char *nearest = brdf_parameter_nearest(model, name);
            return brdf_fail(error, BRDF_UNKNOWN_NAME,
                             "%s has no number or colour \"%s\" to free%s%s%s", model->name, name,
                             nearest ? "; did you mean \"" : "", nearest ? nearest : "",
                             nearest ? "\"?" : "");
        }
        at += length + (at[length] == ',');
    }
    return BRDF_OK;
}

/*
 * A metal's indices are searched together. Where the weight of the same lobe is searched as well,
 * each channel would have three numbers for what it reflects; a measurement hardly tells more than
 * one, and how that rises towards grazing. So the weight has the colour then, and the indices are
 * those of a dielectric, the same for all channels, as in the published fits of Cook and Torrance's
 * model, unless some of the three are asked for by name.
 */
static void metal_find(struct fit_part *part, const char *free_names)
{
    static const char *const names[] = {"eta", "k", "specular_reflectance"};
    int setting[3], all = 1, freed = 0;
    for (int i = 0; i < 3; ++i) {
        setting[i] = fit_part_find(part, names[i]);
        all &= setting[i] >= 0 && part->searched[setting[i]];
        freed |= list_has(free_names, names[i]);
    }
    int both = setting[0] >= 0 && setting[1] >= 0 && part->searched[setting[0]] &&
               part->searched[setting[1]];
    part->eta = both ? setting[0] : -1;
    part->k = both ? setting[1] : -1;
    part->gray = all && !freed;
    if (part->gray) {
        part->settings[part->k] = brdf_setting_color("k", 0.0f, 0.0f, 0.0f);
        part->searched[part->k] = 0;
    }
}

static brdf_status part_fill(struct fit_part *part, const struct brdf_material *material,
                             const char *description, const struct lab_fit_options *options,
                             const char *free_names, struct brdf_error *error)
{
    brdf_status status = check_free(part->model, free_names, error);
    for (size_t i = 0; i < part->model->parameter_count && !status; ++i) {
        setting_copy(part, material, &part->model->parameters[i]);
    }
    for (int i = 0; i < part->count; ++i) {
        const char *name = part->settings[i].name;
        part->searched[i] = fit_part_info(part, i)->kind != BRDF_KIND_CHOICE &&
                            is_searched(part, description, free_names, name);
        part->tied_to[i] = options->anisotropic ? -1 : tie_of(part, i);
    }
    metal_find(part, free_names);
    return status;
}

brdf_status fit_part_make(struct fit_part *part, const char *model,
                          const struct lab_fit_options *options, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    const char *description = model ? model : "diffuse";
    brdf_status status = brdf_bsdf_create(description, &bsdf, error);
    memset(part, 0, sizeof *part);
    if (status) {
        return status;
    }
    const struct brdf_material *material = brdf_bsdf_material(bsdf);
    part->model = brdf_model_info((int)material->model);
    if (material->flags & BRDF_DELTA || lab_has_delta(bsdf)) {
        status = brdf_fail(error, BRDF_UNSUPPORTED,
                           "%s cannot be fitted: its mirror direction has no values to compare; "
                           "take another model, such as roughconductor, roughplastic or ward",
                           part->model->name);
    } else if (part->model->parameter_count > FIT_SETTINGS) {
        status = brdf_fail(error, BRDF_UNSUPPORTED, "%s cannot be fitted: it has %zu parameters",
                           part->model->name, part->model->parameter_count);
    } else {
        status =
            part_fill(part, material, description, options, model ? options->free : NULL, error);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}
