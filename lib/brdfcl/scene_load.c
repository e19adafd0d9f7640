/*
 * scene_load.c - from a file to a scene: the passes over its tree, and what a scene is by default.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_loader.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* As Mitsuba 3 has it. */
static void scene_set_defaults(struct brdfcl_scene *scene)
{
    for (int i = 0; i < 4; ++i) {
        scene->camera_to_world[5 * i] = 1.0f;
    }
    for (int i = 0; i < 3; ++i) {
        scene->environment.to_world[4 * i] = 1.0f;
    }
    scene->width = 768;
    scene->height = 576;
    scene->filter = PT_FILTER_GAUSSIAN;
    scene->filter_sigma = 0.5f;
    scene->filter_radius = 2.0f;
    scene->half = 1;
    scene->spp = 4;
    scene->max_depth = -1;
    scene->rr_depth = 5;
}

/* The sensors: the first one is the picture. */
static brdf_status scene_read_sensor(struct scene_loader *loader, struct xml_node *root)
{
    struct xml_node *child = NULL;
    struct xml_node *sensor = scene_object_next(loader, root, "sensor", &child);
    brdf_status status;
    if (!sensor) {
        return scene_fail(loader, root, BRDF_BAD_FILE,
                          "the scene has no <sensor>: nothing says from where to look");
    }
    status = scene_sensor_read(loader, sensor);
    if (!status && scene_object_next(loader, root, "sensor", &child)) {
        status = scene_note(loader, child, "only the first sensor is rendered");
    }
    return status;
}

static brdf_status scene_read_integrator(struct scene_loader *loader, struct xml_node *root)
{
    struct xml_node *child = NULL;
    struct xml_node *integrator = scene_object_next(loader, root, "integrator", &child);
    brdf_status status;
    if (!integrator) {
        return scene_note(loader, root, "the scene has no <integrator>; it is rendered with path");
    }
    status = scene_integrator_read(loader, integrator);
    if (!status && scene_object_next(loader, root, "integrator", &child)) {
        status = scene_fail(loader, child, BRDF_BAD_FILE, "a scene has only one integrator");
    }
    return status;
}

/* Every bsdf and texture (used or not: a mistake in it is one), shape and emitter, in the file's
   order. */
static brdf_status scene_read_content(struct scene_loader *loader, struct xml_node *root)
{
    struct xml_node *child = NULL;
    struct xml_node *object;
    brdf_status status = BRDF_OK;
    while (!status && (object = scene_object_next(loader, root, NULL, &child)) != NULL) {
        int texture = 0;
        int reference;
        if (strcmp(object->tag, "bsdf") == 0) {
            status = scene_compose_read(loader, object, NULL, &reference);
        } else if (strcmp(object->tag, "texture") == 0) {
            status = scene_texture_read(loader, object, &texture);
        } else if (strcmp(object->tag, "shape") == 0) {
            status = scene_shape_read(loader, object);
        } else if (strcmp(object->tag, "emitter") == 0) {
            status = scene_emitter_read(loader, object);
        }
    }
    if (!status && loader->scene->primitives.count == 0) {
        status = scene_note(loader, root, "the scene has no shapes");
    }
    return status;
}

static brdf_status scene_read(struct scene_loader *loader, const struct brdfcl_define *defines,
                              size_t define_count)
{
    struct xml_node *root;
    brdf_status status = xml_document_read(loader->scene->path, &loader->document, loader->error);
    root = loader->document.root;
    if (!status) {
        status = scene_define_apply(loader, defines, define_count);
    }
    if (!status) {
        status = scene_grammar_check(loader);
    }
    if (!status) {
        status = scene_reference_resolve(loader);
    }
    if (!status) {
        status =
            scene_slots_read(loader, root, NULL, 0, "integrator|sensor|bsdf|texture|shape|emitter");
    }
    if (!status) {
        status = scene_read_integrator(loader, root);
    }
    if (!status) {
        status = scene_read_sensor(loader, root);
    }
    return status ? status : scene_read_content(loader, root);
}

brdf_status brdfcl_scene_load(const char *path, const struct brdfcl_define *defines,
                              size_t define_count, struct brdfcl_scene **out,
                              struct brdf_error *error)
{
    struct scene_loader loader;
    locale_t plain = (locale_t)0;
    locale_t before = (locale_t)0;
    brdf_status status;

    *out = NULL;
    memset(&loader, 0, sizeof loader);
    loader.error = error;
    loader.document.path = path;
    loader.scene = calloc(1, sizeof *loader.scene);
    if (!loader.scene) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
    }
    scene_set_defaults(loader.scene);
    loader.scene->path = strdup(path);
    /* Numbers have a point, whatever the language of the application. */
    plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (!loader.scene->path || !plain) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
        goto done;
    }
    before = uselocale(plain);
    status = scene_read(&loader, defines, define_count);
    uselocale(before);
done:
    if (plain) {
        freelocale(plain);
    }
    scene_reference_free(&loader);
    xml_document_free(&loader.document);
    if (status) {
        brdfcl_scene_destroy(loader.scene);
    } else {
        *out = loader.scene;
    }
    return status;
}
