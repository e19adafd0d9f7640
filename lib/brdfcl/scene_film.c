/*
 * scene_film.c - <film>: hdrfilm and its reconstruction filter.
 */
#include "scene_loader.h"

#include <float.h>
#include <limits.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))
#define FILM_SIDE_MAX 65536.0

static brdf_status film_filter(struct scene_loader *loader, struct xml_node *node)
{
    static const char *const types[] = {"box", "tent", "gaussian"};
    static const int filters[] = {PT_FILTER_BOX, PT_FILTER_TENT, PT_FILTER_GAUSSIAN};
    struct brdfcl_scene *scene = loader->scene;
    const char *type = xml_attribute_get(node, "type");
    double width = strcmp(type, "tent") == 0 ? 1.0 : 0.5;
    struct scene_slot slots[] = {{"stddev", SLOT_REAL, &width, 1e-3, 16.0, NULL}};
    brdf_status status;
    size_t i = 0;
    while (i < COUNT(types) && strcmp(types[i], type) != 0) {
        ++i;
    }
    if (i == COUNT(types)) {
        return scene_fail_unknown(loader, node, "rfilter", type, types, COUNT(types));
    }
    if (filters[i] == PT_FILTER_TENT) {
        slots[0].name = "radius";
    }
    status = scene_slots_read(loader, node, slots, filters[i] == PT_FILTER_BOX ? 0 : 1, "");
    scene->filter = filters[i];
    scene->filter_sigma = (float)width;
    scene->filter_radius = (float)(filters[i] == PT_FILTER_GAUSSIAN ? 4.0 * width : width);
    return status;
}

/* What the file says of its own output: the command writes what its -o asks for. */
static brdf_status film_formats(const struct scene_loader *loader, const struct scene_slot *slots)
{
    static const char *const files[] = {"openexr", "exr", "rgbe", "pfm"};
    static const char *const pixels[] = {"rgb", "rgba", "luminance", "luminance_alpha",
                                         "xyz", "xyza"};
    static const char *const components[] = {"float16", "float32", "uint32"};
    const char *component = *(const char **)slots[2].value;
    brdf_status status = scene_slot_check(loader, &slots[0], files, COUNT(files));
    if (!status) {
        status = scene_slot_check(loader, &slots[1], pixels, COUNT(pixels));
    }
    if (!status) {
        status = scene_slot_check(loader, &slots[2], components, COUNT(components));
    }
    loader->scene->half = strcmp(component, "float16") == 0;
    if (!status && strcmp(component, "uint32") == 0) {
        status = scene_fail(loader, slots[2].given, BRDF_UNSUPPORTED,
                            "component_format uint32 is not written; use float16 or float32");
    }
    if (!status && !scene_list_has("openexr|exr", *(const char **)slots[0].value)) {
        status = scene_note(loader, slots[0].given, "files are OpenEXR or PNG, by their suffix");
    }
    if (!status && strcmp(*(const char **)slots[1].value, "rgb") != 0) {
        status = scene_note(loader, slots[1].given, "pixels are written as rgb");
    }
    return status;
}

brdf_status scene_film_read(struct scene_loader *loader, struct xml_node *node)
{
    static const char *const types[] = {"hdrfilm"};
    struct brdfcl_scene *scene = loader->scene;
    const char *file_format = "openexr";
    const char *pixel_format = "rgb";
    const char *component_format = "float16";
    int border = 0;
    struct scene_slot slots[] = {
        {"width", SLOT_INTEGER, &scene->width, 1.0, FILM_SIDE_MAX, NULL},
        {"height", SLOT_INTEGER, &scene->height, 1.0, FILM_SIDE_MAX, NULL},
        {"file_format", SLOT_STRING, &file_format, 0.0, 0.0, NULL},
        {"pixel_format", SLOT_STRING, &pixel_format, 0.0, 0.0, NULL},
        {"component_format", SLOT_STRING, &component_format, 0.0, 0.0, NULL},
        {"sample_border", SLOT_BOOLEAN, &border, 0.0, 0.0, NULL},
    };
    struct xml_node *child = NULL;
    struct xml_node *filter;
    brdf_status status;
    if (strcmp(xml_attribute_get(node, "type"), types[0]) != 0) {
        return scene_fail_unknown(loader, node, "film", xml_attribute_get(node, "type"), types,
                                  COUNT(types));
    }
    status = scene_slots_read(loader, node, slots, COUNT(slots), "rfilter");
    if (!status) {
        status = film_formats(loader, slots + 2);
    }
    if (!status) {
        status = scene_slots_note(loader, slots + 5, 1);
    }
    filter = scene_object_next(loader, node, "rfilter", &child);
    if (!status && filter) {
        status = film_filter(loader, filter);
    }
    if (!status && filter && scene_object_next(loader, node, "rfilter", &child)) {
        status = scene_fail(loader, child, BRDF_BAD_FILE, "a film has only one rfilter");
    }
    return status;
}
