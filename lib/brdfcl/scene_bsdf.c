/*
 * scene_bsdf.c - <bsdf>: any model of libbrdf by its name. What is composed of them is read by
 * scene_compose.c.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/model.h>

#define BSDF_SETTINGS_MAX 32
#define BSDF_MODELS_MAX 128

/* What is given to libbrdf; the paths of files are owned. */
struct bsdf_draft {
    struct brdf_setting settings[BSDF_SETTINGS_MAX];
    char *paths[BSDF_SETTINGS_MAX];
    size_t count;
    struct scene_bindings bindings; /* the parameters that textures set */
};

static brdf_status bsdf_fail_model(const struct scene_loader *loader, const struct xml_node *node,
                                   const char *type)
{
    const char *known[BSDF_MODELS_MAX] = {"twosided", "blendbsdf", "mask", "normalmap", "bumpmap"};
    size_t count = 5;
    for (int tag = 0; tag < brdf_model_count() && count < BSDF_MODELS_MAX; ++tag) {
        known[count++] = brdf_model_info(tag)->name;
    }
    return scene_fail_unknown(loader, node, "bsdf", type, known, count);
}

static brdf_status bsdf_fail_parameter(const struct scene_loader *loader,
                                       const struct xml_node *node,
                                       const struct brdf_model_info *model, const char *name)
{
    const char *known[BSDF_SETTINGS_MAX] = {"twosided"};
    size_t count = 1;
    char what[96] = "parameter of ";
    for (size_t i = 0; i < model->parameter_count && count < BSDF_SETTINGS_MAX; ++i) {
        known[count++] = model->parameters[i].name;
    }
    strncat(what, model->name, sizeof what - strlen(what) - 1);
    return scene_fail_unknown(loader, node, what, name, known, count);
}

/* Room for one more setting. */
static brdf_status bsdf_claim(const struct scene_loader *loader, const struct xml_node *node,
                              struct bsdf_draft *draft, struct brdf_setting **setting)
{
    if (draft->count == BSDF_SETTINGS_MAX) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "more than %d parameters",
                          BSDF_SETTINGS_MAX);
    }
    *setting = &draft->settings[draft->count];
    return BRDF_OK;
}

/* Here and not only in libbrdf, so that the message has the line of the parameter. */
static brdf_status bsdf_check_range(const struct scene_loader *loader, const struct xml_node *node,
                                    const struct brdf_parameter_info *limits, const char *name,
                                    const double *numbers, int count)
{
    char text[400];
    for (int i = 0; i < count; ++i) {
        if (brdf_value_refused(limits, name, (float)numbers[i], text, sizeof text)) {
            return scene_fail(loader, node, BRDF_OUT_OF_RANGE, "%s", text);
        }
    }
    return BRDF_OK;
}

/* Whose limits hold for numbers: of an alias, those of the first that it sets; NULL if none. */
static const struct brdf_parameter_info *bsdf_limits(const struct brdf_model_info *model,
                                                     const struct brdf_parameter_info *parameter)
{
    char item[64];
    if (parameter->kind == BRDF_KIND_ALIAS &&
        brdf_parameter_item(parameter, 0, item, sizeof item)) {
        parameter = brdf_parameter_find(model, item);
    }
    return parameter->kind == BRDF_KIND_REAL || parameter->kind == BRDF_KIND_COLOR ? parameter
                                                                                   : NULL;
}

/* A number or a colour as a setting. */
static brdf_status bsdf_read_numbers(const struct scene_loader *loader, const struct xml_node *node,
                                     const struct brdf_model_info *model,
                                     const struct brdf_parameter_info *parameter,
                                     struct brdf_setting *setting)
{
    const char *text = xml_attribute_get(node, "value");
    const struct brdf_parameter_info *limits = bsdf_limits(model, parameter);
    int is_rgb = strcmp(node->tag, "rgb") == 0;
    double numbers[3] = {0.0, 0.0, 0.0};
    brdf_status status;
    if (!limits) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not a <%s>; expected <string>",
                          parameter->name, node->tag);
    }
    if (is_rgb && parameter->kind != BRDF_KIND_COLOR) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not an <rgb>; expected <float>",
                          parameter->name);
    }
    status = is_rgb ? scene_value_color(loader, node, numbers)
                    : scene_value_number(loader, node, text, numbers);
    if (!status) {
        status = bsdf_check_range(loader, node, limits, parameter->name, numbers, is_rgb ? 3 : 1);
    }
    if (is_rgb) {
        *setting = brdf_setting_color(parameter->name, (float)numbers[0], (float)numbers[1],
                                      (float)numbers[2]);
    } else {
        *setting = brdf_setting_real(parameter->name, (float)numbers[0]);
    }
    return status;
}

static brdf_status bsdf_read_text(const struct scene_loader *loader, const struct xml_node *node,
                                  const struct brdf_parameter_info *parameter,
                                  struct bsdf_draft *draft)
{
    const char *text = xml_attribute_get(node, "value");
    if (parameter->kind == BRDF_KIND_COLOR) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not a <string>; expected <rgb>",
                          parameter->name);
    }
    if (parameter->kind == BRDF_KIND_FILE) {
        draft->paths[draft->count] = scene_value_path(loader, text);
        text = draft->paths[draft->count];
        if (!text) {
            return scene_fail_memory(loader, node);
        }
    }
    draft->settings[draft->count] = brdf_setting_text(parameter->name, text);
    return BRDF_OK;
}

static brdf_status bsdf_read_setting(const struct scene_loader *loader, const struct xml_node *node,
                                     const struct brdf_model_info *model, struct bsdf_draft *draft)
{
    const char *name = xml_attribute_get(node, "name");
    const struct brdf_parameter_info *parameter = brdf_parameter_find(model, name);
    struct brdf_setting *setting = NULL;
    brdf_status status = bsdf_claim(loader, node, draft, &setting);
    if (status) {
        return status;
    }
    if (!parameter && strcmp(name, "twosided") != 0) {
        return bsdf_fail_parameter(loader, node, model, name);
    }
    if (!parameter) {
        *setting = brdf_setting_text(name, xml_attribute_get(node, "value"));
        status = BRDF_OK;
    } else if (scene_list_has("float|integer|rgb|spectrum", node->tag)) {
        status = bsdf_read_numbers(loader, node, model, parameter, setting);
    } else if (strcmp(node->tag, "string") == 0 ||
               (strcmp(node->tag, "boolean") == 0 && parameter->kind == BRDF_KIND_CHOICE)) {
        status = bsdf_read_text(loader, node, parameter, draft);
    } else {
        status =
            scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" cannot be a <%s>", name, node->tag);
    }
    ++draft->count;
    return status;
}

static brdf_status bsdf_read_texture(struct scene_loader *loader, struct xml_node *child,
                                     const struct brdf_model_info *model, struct bsdf_draft *draft)
{
    struct brdf_setting *setting = NULL;
    brdf_status status = bsdf_claim(loader, child, draft, &setting);
    if (!status) {
        status = scene_binding_read(loader, child, model, &draft->bindings, setting);
        ++draft->count;
    }
    return status;
}

static brdf_status bsdf_make(struct scene_loader *loader, const struct xml_node *node,
                             const char *model, const struct bsdf_draft *draft,
                             struct brdf_bsdf **bsdf)
{
    struct brdf_error inner;
    brdf_status status;
    memset(&inner, 0, sizeof inner);
    status = brdf_bsdf_create_from(model, draft->settings, draft->count, bsdf, &inner);
    if (status) {
        inner.status = status;
        return scene_fail_inner(loader, node, &inner);
    }
    return scene_bsdf_keep(loader, node, &draft->bindings, bsdf);
}

/* One model. `outer` is the "twosided" around it, or NULL. */
static brdf_status bsdf_read_model(struct scene_loader *loader, struct xml_node *node,
                                   const struct xml_node *outer, struct brdf_bsdf **bsdf)
{
    const char *type = xml_attribute_get(node, "type");
    const struct brdf_model_info *model = brdf_model_find(type);
    struct bsdf_draft draft;
    brdf_status status = BRDF_OK;
    memset(&draft, 0, sizeof draft);
    if (!model) {
        return bsdf_fail_model(loader, node, type);
    }
    if (outer) {
        draft.settings[draft.count++] = brdf_setting_text("twosided", "true");
    }
    for (struct xml_node *child = node->child; child && !status; child = child->next) {
        enum xml_class kind = scene_grammar_class(child);
        if (kind == XML_PROPERTY) {
            status = bsdf_read_setting(loader, child, model, &draft);
        } else if (kind != XML_OTHER &&
                   strcmp(scene_reference_target(loader, child)->tag, "texture") == 0) {
            status = bsdf_read_texture(loader, child, model, &draft);
        } else if (kind != XML_OTHER) {
            status = scene_fail(loader, child, BRDF_UNSUPPORTED,
                                "a %s holds only numbers, names and textures", type);
        }
    }
    if (!status) {
        draft.count = scene_mitsuba_assume(type, draft.settings, draft.count, BSDF_SETTINGS_MAX);
        status = bsdf_make(loader, outer ? outer : node, type, &draft, bsdf);
    }
    for (size_t i = 0; i < BSDF_SETTINGS_MAX; ++i) {
        free(draft.paths[i]);
    }
    return status;
}

brdf_status scene_bsdf_read(struct scene_loader *loader, struct xml_node *node,
                            const struct xml_node *twosided, struct brdf_bsdf **bsdf)
{
    void **product = twosided ? &node->twosided_product : &node->product;
    brdf_status status = BRDF_OK;
    if (!*product) {
        struct brdf_bsdf *made = NULL;
        status = bsdf_read_model(loader, node, twosided, &made);
        *product = made;
    }
    *bsdf = *product;
    return status;
}

brdf_status scene_bsdf_default(struct scene_loader *loader, const struct xml_node *node, int emits,
                               struct brdf_bsdf **bsdf)
{
    struct bsdf_draft draft;
    memset(&draft, 0, sizeof draft);
    draft.settings[draft.count++] = brdf_setting_real("reflectance", emits ? 0.0f : 0.5f);
    return bsdf_make(loader, node, "diffuse", &draft, bsdf);
}
