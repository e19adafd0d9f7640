/*
 * scene_emitter.c - <emitter>: area on shapes; constant and envmap around the scene.
 */
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static const char *const emitter_types[] = {"area", "constant", "envmap"};

static brdf_status emitter_fail_type(const struct scene_loader *loader, const struct xml_node *node)
{
    return scene_fail_unknown(loader, node, "emitter", xml_attribute_get(node, "type"),
                              emitter_types, COUNT(emitter_types));
}

brdf_status scene_emitter_area(const struct scene_loader *loader, struct xml_node *node,
                               double radiance[3])
{
    struct scene_slot slots[] = {{"radiance", SLOT_RADIANCE, radiance, 0.0, 0.0, NULL}};
    for (int i = 0; i < 3; ++i) {
        radiance[i] = 1.0;
    }
    if (!scene_list_has("area|constant|envmap", xml_attribute_get(node, "type"))) {
        return emitter_fail_type(loader, node);
    }
    if (strcmp(xml_attribute_get(node, "type"), "area") != 0) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "a shape emits by type \"area\", not \"%s\"",
                          xml_attribute_get(node, "type"));
    }
    return scene_slots_read(loader, node, slots, COUNT(slots), "");
}

static brdf_status emitter_constant(struct scene_loader *loader, struct xml_node *node)
{
    double radiance[3] = {1.0, 1.0, 1.0};
    struct scene_slot slots[] = {{"radiance", SLOT_RADIANCE, radiance, 0.0, 0.0, NULL}};
    brdf_status status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    loader->scene->environment.kind = ENVIRONMENT_CONSTANT;
    for (int i = 0; i < 3; ++i) {
        loader->scene->environment.radiance[i] = (float)radiance[i];
    }
    return status;
}

/* Scale the picture; what is no light (negative, NaN, infinite) is refused, with its pixel. */
static brdf_status emitter_scale(const struct scene_loader *loader, const struct xml_node *node,
                                 const char *path, double scale)
{
    struct brdfcl_image *image = &loader->scene->environment.image;
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    if (image->width < 2 || image->height < 3) {
        return scene_fail(loader, node, BRDF_BAD_FILE,
                          "%s: %d x %d pixels; an environment has at least 2 x 3", path,
                          image->width, image->height);
    }
    for (size_t i = 0; i < count; ++i) {
        float value = image->rgb[i] * (float)scale;
        if (!(value >= 0.0f && value <= FLT_MAX)) {
            size_t pixel = i / 3;
            return scene_fail(loader, node, BRDF_BAD_FILE,
                              "%s: pixel (%d, %d) has a channel of %g; light is finite and not "
                              "negative",
                              path, (int)(pixel % (size_t)image->width),
                              (int)(pixel / (size_t)image->width), (double)image->rgb[i]);
        }
        image->rgb[i] = value;
    }
    return BRDF_OK;
}

static brdf_status emitter_image(const struct scene_loader *loader, const struct xml_node *node,
                                 const char *filename, double scale)
{
    struct brdf_error inner;
    char *path = scene_value_path(loader, filename);
    brdf_status status;
    if (!path) {
        return scene_fail_memory(loader, node);
    }
    memset(&inner, 0, sizeof inner);
    status = brdfcl_image_read(&loader->scene->environment.image, path, &inner);
    if (status) {
        inner.status = status;
        status = scene_fail_inner(loader, node, &inner);
    } else {
        status = emitter_scale(loader, node, path, scale);
    }
    free(path);
    return status;
}

static brdf_status emitter_envmap(struct scene_loader *loader, struct xml_node *node)
{
    struct scene_environment *environment = &loader->scene->environment;
    const char *filename = NULL;
    double scale = 1.0;
    double unit = 0.0;
    double to_world[16];
    int compensation = 0;
    struct scene_slot slots[] = {
        {"filename", SLOT_STRING, &filename, 0.0, 0.0, NULL},
        {"scale", SLOT_REAL, &scale, 0.0, (double)FLT_MAX, NULL},
        {"to_world", SLOT_TRANSFORM, to_world, 0.0, 0.0, NULL},
        {"mis_compensation", SLOT_BOOLEAN, &compensation, 0.0, 0.0, NULL},
    };
    brdf_status status;
    scene_matrix_identity(to_world);
    status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    if (status) {
        return status;
    }
    if (!filename) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "an envmap needs a filename");
    }
    if (!scene_matrix_is_uniform(to_world, &unit) || fabs(unit - 1.0) > 1e-4) {
        return scene_fail(loader, slots[2].given, BRDF_UNSUPPORTED,
                          "an environment can be turned and mirrored, not scaled");
    }
    if (compensation) {
        status =
            scene_note(loader, slots[3].given,
                       "mis_compensation is not done; the picture is the same, with other noise");
    }
    environment->kind = ENVIRONMENT_MAP;
    for (int i = 0; i < 9; ++i) {
        environment->to_world[i] = (float)(to_world[4 * (i / 3) + i % 3] / unit);
    }
    return status ? status : emitter_image(loader, slots[0].given, filename, scale);
}

brdf_status scene_emitter_read(struct scene_loader *loader, struct xml_node *node)
{
    const char *type = xml_attribute_get(node, "type");
    if (!scene_list_has("area|constant|envmap", type)) {
        return emitter_fail_type(loader, node);
    }
    if (strcmp(type, "area") == 0) {
        if (xml_attribute_get(node, "id")) {
            return BRDF_OK; /* for shapes to refer to */
        }
        return scene_fail(loader, node, BRDF_BAD_FILE, "an area emitter stands in a <shape>");
    }
    if (loader->scene->environment.kind != ENVIRONMENT_NONE) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "a scene has only one environment");
    }
    return strcmp(type, "constant") == 0 ? emitter_constant(loader, node)
                                         : emitter_envmap(loader, node);
}
