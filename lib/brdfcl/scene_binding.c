/*
 * scene_binding.c - a texture in place of a number: which words of a material it sets.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

/* Keep the list in the order of words. A parameter that is set twice is libbrdf's to refuse: each
   time it is among the settings. */
static void binding_insert(struct scene_bindings *bindings, const struct scene_binding *binding)
{
    size_t i = bindings->count < SCENE_BINDINGS_MAX ? bindings->count++ : bindings->count - 1;
    for (; i > 0 && bindings->list[i - 1].word > binding->word; --i) {
        bindings->list[i] = bindings->list[i - 1];
    }
    bindings->list[i] = *binding;
}

/* Numbers that the file gives are refused, as they are without a texture. Those of a picture are
   clamped, with a remark: it may well be white where a reflectance ends at 0.99. */
brdf_status scene_texture_check(const struct scene_loader *loader, const struct xml_node *node,
                                const struct pt_binding *binding, const char *name)
{
    const struct scene_texture *texture = &loader->scene->textures[binding->texture];
    double low = (double)binding->low;
    double high = (double)binding->high;
    float least = 0.0f;
    float most = 0.0f;
    scene_texture_range(texture, binding->output, &least, &most);
    if ((double)least >= low && (double)most <= high) {
        return BRDF_OK;
    }
    if (texture->record.kind == PT_TEXTURE_BITMAP) {
        return scene_note(loader, node,
                          "%s: the texture's values, %g to %g, are clamped to its range, %g to %g",
                          name, (double)least, (double)most, low, high);
    }
    return scene_fail(loader, node, BRDF_OUT_OF_RANGE,
                      "%s: the texture's values are %g to %g: expected %g to %g", name,
                      (double)least, (double)most, low, high);
}

/* The parameter that a texture may set, itself or through an alias; NULL if none. */
static const struct brdf_parameter_info *binding_target(const struct brdf_model_info *model,
                                                        const struct brdf_parameter_info *parameter,
                                                        int item)
{
    char name[64];
    if (parameter->kind == BRDF_KIND_ALIAS) {
        return brdf_parameter_item(parameter, item, name, sizeof name)
                   ? brdf_parameter_find(model, name)
                   : NULL;
    }
    return item == 0 && (parameter->kind == BRDF_KIND_REAL || parameter->kind == BRDF_KIND_COLOR)
               ? parameter
               : NULL;
}

static brdf_status binding_fail_name(const struct scene_loader *loader,
                                     const struct xml_node *child,
                                     const struct brdf_model_info *model, const char *name)
{
    const char *known[64];
    char what[96] = "parameter of ";
    size_t count = 0;
    for (size_t i = 0; i < model->parameter_count && count < 64; ++i) {
        if (binding_target(model, &model->parameters[i], 0)) {
            known[count++] = model->parameters[i].name;
        }
    }
    strncat(what, model->name, sizeof what - strlen(what) - 1);
    return scene_fail_unknown(loader, child, what, name, known, count);
}

/* All words that a parameter sets. */
static brdf_status binding_add(struct scene_loader *loader, struct xml_node *child,
                               const struct brdf_model_info *model,
                               const struct brdf_parameter_info *parameter,
                               struct scene_bindings *bindings)
{
    const struct brdf_parameter_info *target = binding_target(model, parameter, 0);
    struct scene_binding binding;
    brdf_status status;
    memset(&binding, 0, sizeof binding);
    status =
        scene_texture_read(loader, scene_reference_target(loader, child), &binding.record.texture);
    if (!status) {
        status = scene_texture_output(loader, child, binding.record.texture, parameter->name,
                                      &binding.record.output);
    }
    for (int item = 0; target && !status; ++item) {
        binding.word = brdf_parameter_place(model, target);
        binding.color = target->kind == BRDF_KIND_COLOR;
        binding.record.low = target->low;
        binding.record.high = target->high;
        if (item == 0) { /* those of an alias have one range */
            status = scene_texture_check(loader, child, &binding.record, parameter->name);
        }
        binding_insert(bindings, &binding);
        target = binding_target(model, parameter, item + 1);
    }
    return status;
}

brdf_status scene_binding_read(struct scene_loader *loader, struct xml_node *child,
                               const struct brdf_model_info *model, struct scene_bindings *bindings,
                               struct brdf_setting *stand_in)
{
    const char *name = xml_attribute_get(child, "name");
    const struct brdf_parameter_info *parameter = name ? brdf_parameter_find(model, name) : NULL;
    const struct brdf_parameter_info *target;
    if (!name) {
        return scene_fail(loader, child, BRDF_BAD_FILE,
                          "a texture needs a name: that of the parameter of %s that it sets",
                          model->name);
    }
    if (!parameter) {
        return binding_fail_name(loader, child, model, name);
    }
    target = binding_target(model, parameter, 0);
    if (!target) {
        return scene_fail(loader, child, BRDF_BAD_FILE,
                          "\"%s\" cannot be a <texture>: it is one for the whole surface", name);
    }
    *stand_in = brdf_setting_real(parameter->name, target->initial);
    stand_in->varies = 1;
    return binding_add(loader, child, model, parameter, bindings);
}

brdf_status scene_bindings_keep(struct scene_loader *loader, const struct xml_node *node,
                                const struct brdf_bsdf *bsdf, const struct scene_bindings *bindings)
{
    struct brdfcl_scene *scene = loader->scene;
    if (scene->binding_count + bindings->count > loader->binding_capacity) {
        size_t capacity = 2 * loader->binding_capacity + SCENE_BINDINGS_MAX;
        struct scene_binding *grown = realloc(scene->bindings, capacity * sizeof *grown);
        if (!grown) {
            return scene_fail_memory(loader, node);
        }
        scene->bindings = grown;
        loader->binding_capacity = capacity;
    }
    for (size_t i = 0; i < bindings->count; ++i) {
        struct scene_binding *binding = &scene->bindings[scene->binding_count++];
        *binding = bindings->list[i];
        binding->bsdf = bsdf;
    }
    return BRDF_OK;
}

const struct scene_binding *scene_bindings_of(const struct brdfcl_scene *scene,
                                              const struct brdf_bsdf *bsdf, size_t *count)
{
    size_t first = 0;
    *count = 0;
    while (first < scene->binding_count && scene->bindings[first].bsdf != bsdf) {
        ++first;
    }
    while (first + *count < scene->binding_count && scene->bindings[first + *count].bsdf == bsdf) {
        ++*count;
    }
    return scene->bindings + first;
}
