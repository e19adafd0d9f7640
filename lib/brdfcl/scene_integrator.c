/*
 * scene_integrator.c - <integrator>: path.
 */
#include "scene_loader.h"

#include <limits.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

brdf_status scene_integrator_read(struct scene_loader *loader, struct xml_node *node)
{
    static const char *const types[] = {"path"};
    struct brdfcl_scene *scene = loader->scene;
    int hide_emitters = 0;
    int block_size = 0;
    int samples_per_pass = 0;
    double timeout = 0.0;
    struct scene_slot slots[] = {
        {"max_depth", SLOT_INTEGER, &scene->max_depth, -1.0, INT_MAX, NULL},
        {"rr_depth", SLOT_INTEGER, &scene->rr_depth, 1.0, INT_MAX, NULL},
        {"hide_emitters", SLOT_BOOLEAN, &hide_emitters, 0.0, 0.0, NULL},
        {"block_size", SLOT_INTEGER, &block_size, 0.0, INT_MAX, NULL},
        {"samples_per_pass", SLOT_INTEGER, &samples_per_pass, 0.0, INT_MAX, NULL},
        {"timeout", SLOT_REAL, &timeout, -1.0, 1e9, NULL},
    };
    brdf_status status;
    if (strcmp(xml_attribute_get(node, "type"), types[0]) != 0) {
        return scene_fail_unknown(loader, node, "integrator", xml_attribute_get(node, "type"),
                                  types, COUNT(types));
    }
    status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    if (status) {
        return status;
    }
    if (hide_emitters) {
        return scene_fail(loader, slots[2].given, BRDF_UNSUPPORTED,
                          "hide_emitters = true is not supported");
    }
    return scene_slots_note(loader, slots + 3, COUNT(slots) - 3);
}
