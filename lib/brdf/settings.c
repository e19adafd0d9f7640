/* settings.c - settings put into a material, in any order and each only once. */
#include "draft.h"

#include <stdlib.h>
#include <string.h>

static brdf_status set_alias(const struct brdf_draft *d, const struct brdf_parameter_info *alias)
{
    char name[64];
    brdf_status status = brdf_draft_claim(d, alias, d->setting->name);
    for (int i = 0; !status && brdf_parameter_item(alias, i, name, sizeof name); ++i) {
        status = brdf_draft_set(d, brdf_parameter_find(d->model, name));
    }
    return status;
}

/* The parameter that opens the side below when it is above 0; NULL if the model has none. */
static const struct brdf_parameter_info *clarity_of(const struct brdf_draft *d)
{
    return brdf_parameter_find(d->model, "spec_trans");
}

int brdf_material_see_through(struct brdf_material *material, const struct brdf_model_info *model)
{
    const struct brdf_parameter_info *clarity = brdf_parameter_find(model, "spec_trans");
    int clear = !clarity || material->word[brdf_parameter_place(model, clarity)] > 0.0f;
    material->flags &= ~BRDF_TRANSMISSION;
    material->flags |= clear ? model->flags & BRDF_TRANSMISSION : 0u;
    return clear;
}

/* The one setting that every model has. */
static brdf_status set_twosided(struct brdf_draft *d)
{
    const char *text = d->setting->value;
    int yes = text ? strcmp(text, "true") == 0 : d->setting->number[0] == 1.0f;
    int no = text ? strcmp(text, "false") == 0 : d->setting->number[0] == 0.0f;
    if (d->twosided_set) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "twosided is set twice");
    }
    if (!yes && !no) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "twosided must be true or false");
    }
    if (yes && d->model->flags & BRDF_TRANSMISSION && !clarity_of(d)) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT,
                                 "%s has a side below of its own: leave out twosided",
                                 d->model->name);
    }
    d->twosided_set = 1;
    d->bsdf->material.flags |= yes ? BRDF_TWOSIDED : 0u;
    return BRDF_OK;
}

static brdf_status apply(struct brdf_draft *d)
{
    const char *name = d->setting->name;
    if (!name || (!d->setting->value && d->setting->numbers == 0)) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "a setting has no %s",
                                 name ? "value" : "name");
    }
    if (strcmp(name, "twosided") == 0) {
        return set_twosided(d);
    }
    const struct brdf_parameter_info *p = brdf_parameter_find(d->model, name);
    if (p) {
        return p->kind == BRDF_KIND_ALIAS ? set_alias(d, p) : brdf_draft_set(d, p);
    }
    char known[400] = "", hint[450];
    for (size_t i = 0; i < d->model->parameter_count; ++i) {
        brdf_draft_list(known, sizeof known, d->model->parameters[i].name);
    }
    brdf_draft_list(known, sizeof known, "twosided");
    const char *nearest = brdf_parameter_nearest(d->model, name);
    const char *const common[] = {"twosided"};
    brdf_draft_suggest(hint, sizeof hint, nearest ? nearest : brdf_name_nearest(name, common, 1),
                       known);
    return brdf_draft_refuse(d, BRDF_UNKNOWN_NAME, "%s has no parameter \"%.64s\"%s",
                             d->model->name, name, hint);
}

static void put_initial_values(struct brdf_draft *d)
{
    struct brdf_material *m = &d->bsdf->material;
    for (size_t i = 0; i < d->model->parameter_count; ++i) {
        const struct brdf_parameter_info *p = &d->model->parameters[i];
        int place = brdf_parameter_place(d->model, p);
        int words = p->kind == BRDF_KIND_REAL ? 1 : p->kind == BRDF_KIND_COLOR ? 3 : 0;
        for (int k = 0; k < words; ++k) {
            m->word[place + k] = p->initial;
        }
        if (p->kind == BRDF_KIND_CHOICE) {
            m->choices |= (unsigned)p->initial << (4 * place);
        }
    }
}

/* Nothing of a metal was set: its initial one. eta alone or k alone: no such material. */
static brdf_status complete_metal(const struct brdf_draft *d,
                                  const struct brdf_parameter_info *metal)
{
    const struct brdf_parameter_info *all = d->model->parameters;
    const char *eta = d->set_by[brdf_parameter_find(d->model, "eta") - all];
    const char *k = d->set_by[brdf_parameter_find(d->model, "k") - all];
    if (!eta && !k) {
        return brdf_draft_put_metal(d, brdf_metal_find(metal->initial_text), metal->name);
    }
    if (!eta || !k) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s is set without %s: set both, or %s",
                                 eta ? "eta" : "k", eta ? "k" : "eta", metal->name);
    }
    return BRDF_OK;
}

/* An opaque material may be mirrored and lets no light through, whatever its model could do; a
   clear one has a side below of its own. */
static brdf_status complete_clarity(const struct brdf_draft *d)
{
    struct brdf_material *m = &d->bsdf->material;
    const struct brdf_parameter_info *clarity = clarity_of(d);
    if (!clarity) {
        return BRDF_OK;
    }
    if (brdf_material_see_through(m, d->model) && m->flags & BRDF_TWOSIDED) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT,
                                 "%s with %s above 0 has a side below of its own: leave out"
                                 " twosided",
                                 d->model->name, clarity->name);
    }
    return BRDF_OK;
}

/* What can only be said once all settings are in. */
static brdf_status complete(struct brdf_draft *d)
{
    d->setting = NULL;
    brdf_status status = complete_clarity(d);
    for (size_t i = 0; !status && i < d->model->parameter_count; ++i) {
        const struct brdf_parameter_info *p = &d->model->parameters[i];
        if (p->kind == BRDF_KIND_METAL) {
            status = complete_metal(d, p);
        } else if (p->kind == BRDF_KIND_FILE && !d->set_by[i]) {
            status =
                brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s is missing: %s", p->name, p->meaning);
        }
    }
    char reason[300];
    if (!status &&
        brdf_choices_refused(d->model, d->bsdf->material.choices, reason, sizeof reason)) {
        status = brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s", reason);
    }
    return status;
}

brdf_status brdf_settings_apply(struct brdf_bsdf *bsdf, const struct brdf_model_info *model,
                                const struct brdf_setting *settings, size_t count,
                                const struct brdf_origin *origin, struct brdf_error *error)
{
    struct brdf_draft d = {bsdf, model, NULL, 0, NULL, NULL, 0, error};
    brdf_status status = BRDF_OK;
    d.description = origin ? origin->description : NULL;
    d.set_by = calloc(model->parameter_count + 1, sizeof *d.set_by);
    if (!d.set_by) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
        goto done;
    }
    bsdf->material.model = (unsigned)model->tag;
    bsdf->material.flags = model->flags;
    put_initial_values(&d);
    for (size_t i = 0; !status && i < count; ++i) {
        d.setting = &settings[i];
        d.place = origin ? origin->place[i] : 0;
        status = apply(&d);
    }
    if (!status) {
        status = complete(&d);
    }
done:
    free(d.set_by);
    return status;
}
