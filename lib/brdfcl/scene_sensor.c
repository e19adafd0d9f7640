/*
 * scene_sensor.c - <sensor>: a perspective camera, with its film and sampler.
 */
#define _POSIX_C_SOURCE 200809L
#include "angle.h"
#include "scene_loader.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))
#define SENSOR_SPP_MAX 16777216.0 /* 2^24 */

static const char *const sensor_axes[] = {"x", "y", "diagonal", "smaller", "larger"};

/* The field of view of a lens on film of 36 x 24 mm, along the diagonal [degrees]. */
static brdf_status sensor_focal_length(const struct scene_loader *loader,
                                       const struct xml_node *node, const char *text, float *fov)
{
    char copy[64];
    size_t length = strlen(text);
    double millimetres = 0.0;
    brdf_status status;
    if (length > 2 && length < sizeof copy && strcmp(text + length - 2, "mm") == 0) {
        length -= 2;
    }
    if (length >= sizeof copy) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not a length such as 50mm", text);
    }
    memcpy(copy, text, length);
    copy[length] = '\0';
    status = scene_value_number(loader, node, copy, &millimetres);
    if (status) {
        return status;
    }
    if (!(millimetres > 0.0)) {
        return scene_fail(loader, node, BRDF_OUT_OF_RANGE, "a focal length is more than 0");
    }
    *fov = (float)(2.0 * atan(sqrt(36.0 * 36.0 + 24.0 * 24.0) / (2.0 * millimetres)) * 180.0 / pi);
    return BRDF_OK;
}

static brdf_status sensor_place(const struct scene_loader *loader, const struct scene_slot *slot,
                                const double to_world[16])
{
    double scale = 0.0;
    if (!scene_matrix_is_uniform(to_world, &scale) || fabs(scale - 1.0) > 1e-3) {
        return scene_fail(loader, slot->given, BRDF_BAD_FILE,
                          "a camera can be turned, mirrored and moved, not scaled");
    }
    for (int i = 0; i < 16; ++i) {
        loader->scene->camera_to_world[i] = (float)to_world[i];
    }
    return BRDF_OK;
}

static brdf_status sensor_field(const struct scene_loader *loader, const struct scene_slot *fov,
                                const struct scene_slot *axis, const struct scene_slot *focal)
{
    struct brdfcl_scene *scene = loader->scene;
    const char *name = *(const char **)axis->value;
    brdf_status status;
    if (fov->given && focal->given) {
        return scene_fail(loader, focal->given, BRDF_BAD_FILE,
                          "fov and focal_length exclude each other");
    }
    if (!fov->given) {
        if (axis->given) {
            return scene_fail(loader, axis->given, BRDF_BAD_FILE, "fov_axis needs a fov");
        }
        scene->fov_axis = FOV_DIAGONAL;
        return sensor_focal_length(loader, focal->given, *(const char **)focal->value, &scene->fov);
    }
    status = scene_slot_check(loader, axis, sensor_axes, COUNT(sensor_axes));
    for (int i = 0; i < (int)COUNT(sensor_axes); ++i) {
        if (strcmp(sensor_axes[i], name) == 0) {
            scene->fov_axis = (enum scene_fov_axis)i;
        }
    }
    scene->fov = (float)*(double *)fov->value;
    return status;
}

/* The film and the sampler, at most one each. */
static brdf_status sensor_children(struct scene_loader *loader, struct xml_node *node)
{
    static const struct {
        const char *tag;
        brdf_status (*read)(struct scene_loader *, struct xml_node *);
    } parts[] = {{"film", scene_film_read}, {"sampler", scene_sampler_read}};
    for (size_t i = 0; i < COUNT(parts); ++i) {
        struct xml_node *child = NULL;
        struct xml_node *part = scene_object_next(loader, node, parts[i].tag, &child);
        brdf_status status = part ? parts[i].read(loader, part) : BRDF_OK;
        if (status) {
            return status;
        }
        if (part && scene_object_next(loader, node, parts[i].tag, &child)) {
            return scene_fail(loader, child, BRDF_BAD_FILE, "a sensor has only one %s",
                              parts[i].tag);
        }
    }
    return BRDF_OK;
}

brdf_status scene_sensor_read(struct scene_loader *loader, struct xml_node *node)
{
    static const char *const types[] = {"perspective"};
    const char *axis = "x";
    const char *focal_length = "50mm";
    double to_world[16];
    double fov = 0.0;
    double offset[2] = {0.0, 0.0};
    double unused = 0.0;
    struct scene_slot slots[] = {
        {"fov", SLOT_REAL, &fov, 1e-4, 179.99, NULL},
        {"fov_axis", SLOT_STRING, &axis, 0.0, 0.0, NULL},
        {"focal_length", SLOT_STRING, &focal_length, 0.0, 0.0, NULL},
        {"to_world", SLOT_TRANSFORM, to_world, 0.0, 0.0, NULL},
        {"principal_point_offset_x", SLOT_REAL, &offset[0], -1e3, 1e3, NULL},
        {"principal_point_offset_y", SLOT_REAL, &offset[1], -1e3, 1e3, NULL},
        {"near_clip", SLOT_REAL, &unused, (double)FLT_MIN, (double)FLT_MAX, NULL},
        {"far_clip", SLOT_REAL, &unused, (double)FLT_MIN, (double)FLT_MAX, NULL},
        {"focus_distance", SLOT_REAL, &unused, 0.0, (double)FLT_MAX, NULL},
        {"shutter_open", SLOT_REAL, &unused, -(double)FLT_MAX, (double)FLT_MAX, NULL},
        {"shutter_close", SLOT_REAL, &unused, -(double)FLT_MAX, (double)FLT_MAX, NULL},
    };
    brdf_status status;
    if (strcmp(xml_attribute_get(node, "type"), types[0]) != 0) {
        return scene_fail_unknown(loader, node, "sensor", xml_attribute_get(node, "type"), types,
                                  COUNT(types));
    }
    scene_matrix_identity(to_world);
    status = scene_slots_read(loader, node, slots, COUNT(slots), "film|sampler");
    if (!status) {
        status = sensor_field(loader, &slots[0], &slots[1], &slots[2]);
    }
    if (!status) {
        status = sensor_place(loader, &slots[3], to_world);
    }
    if (!status) {
        status = scene_slots_note(loader, slots + 6, COUNT(slots) - 6);
    }
    loader->scene->principal_offset[0] = (float)offset[0];
    loader->scene->principal_offset[1] = (float)offset[1];
    return status ? status : sensor_children(loader, node);
}

brdf_status scene_sampler_read(struct scene_loader *loader, struct xml_node *node)
{
    static const char *const types[] = {"independent", "ldsampler", "multijitter", "stratified",
                                        "orthogonal"};
    struct brdfcl_scene *scene = loader->scene;
    const char *type = xml_attribute_get(node, "type");
    int jitter = 0;
    int strength = 0;
    struct scene_slot slots[] = {
        {"sample_count", SLOT_INTEGER, &scene->spp, 1.0, SENSOR_SPP_MAX, NULL},
        {"seed", SLOT_INTEGER, &scene->seed, 0.0, INT_MAX, NULL},
        {"jitter", SLOT_BOOLEAN, &jitter, 0.0, 0.0, NULL},
        {"strength", SLOT_INTEGER, &strength, 1.0, INT_MAX, NULL},
    };
    /* Only those two are Mitsuba's for every sampler; jitter and strength are of some. */
    size_t count = strcmp(type, "orthogonal") == 0                  ? 4
                   : scene_list_has("multijitter|stratified", type) ? 3
                                                                    : 2;
    brdf_status status;
    if (!scene_list_has("independent|ldsampler|multijitter|stratified|orthogonal", type)) {
        return scene_fail_unknown(loader, node, "sampler", type, types, COUNT(types));
    }
    status = scene_slots_read(loader, node, slots, count, "");
    scene->sobol = strcmp(type, "independent") != 0;
    if (!status && scene->sobol) {
        status =
            scene_note(loader, node, "the sampler %s is done by Owen-scrambled Sobol points", type);
    }
    return status ? status : scene_slots_note(loader, slots + 2, count - 2);
}
