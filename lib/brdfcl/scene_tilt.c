/*
 * scene_tilt.c - what "normalmap" and "bumpmap" say besides the bsdf inside, and textures that are
 * parameters of a composition.
 */
#include "scene_loader.h"

#include <float.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

brdf_status scene_texture_child(struct scene_loader *loader, const struct xml_node *node,
                                const char *name, const struct xml_node **given, int *number)
{
    struct xml_node *cursor = NULL;
    struct xml_node *texture;
    brdf_status status = BRDF_OK;
    *given = NULL;
    while (!status && (texture = scene_object_next(loader, node, "texture", &cursor)) != NULL) {
        const char *called = xml_attribute_get(cursor, "name");
        if (*given) {
            return scene_fail(loader, cursor, BRDF_BAD_FILE, "a %s holds one texture",
                              xml_attribute_get(node, "type"));
        }
        if (name && !called) {
            return scene_fail(loader, cursor, BRDF_BAD_FILE,
                              "the texture needs a name: that of what it sets, \"%s\"", name);
        }
        if (name && strcmp(called, name) != 0) {
            return scene_fail_unknown(loader, cursor, "textured parameter", called, &name, 1);
        }
        *given = cursor;
        status = scene_texture_read(loader, texture, number);
    }
    return status;
}

/* A normal map holds numbers, not colours, and a bump map is differentiated. */
static brdf_status tilt_check(const struct scene_loader *loader, const struct xml_node *given,
                              const struct scene_texture *texture, unsigned how)
{
    int bitmap = texture->record.kind == PT_TEXTURE_BITMAP;
    if (how & PT_TILT_BUMP && !bitmap) {
        return scene_fail(loader, given, BRDF_UNSUPPORTED,
                          "a bump map must be a bitmap: its slope is asked for");
    }
    if (how & PT_TILT_BUMP && texture->record.nearest) {
        return scene_note(loader, given,
                          "the bump map is flat: its filter_type is nearest, which has no slope");
    }
    if (how & PT_TILT_NORMAL && bitmap && texture->codes && !texture->raw) {
        return scene_note(loader, given,
                          "the normal map is read as sRGB colours; say raw = true if it is not");
    }
    return BRDF_OK;
}

brdf_status scene_tilt_read(struct scene_loader *loader, struct xml_node *node,
                            struct scene_tilt *tilt)
{
    double scale = 1.0;
    int face = 1;
    int shadow = 1;
    int bump = strcmp(xml_attribute_get(node, "type"), "bumpmap") == 0;
    const struct xml_node *given = NULL;
    struct scene_slot slots[] = {
        {"flip_invalid_normals", SLOT_BOOLEAN, &face, 0.0, 0.0, NULL},
        {"use_shadowing_function", SLOT_BOOLEAN, &shadow, 0.0, 0.0, NULL},
        {"scale", SLOT_REAL, &scale, (double)-FLT_MAX, (double)FLT_MAX, NULL},
    };
    brdf_status status =
        scene_slots_read(loader, node, slots, bump ? COUNT(slots) : 2, "bsdf|texture");
    memset(tilt, 0, sizeof *tilt);
    if (!status) {
        status =
            scene_texture_child(loader, node, bump ? NULL : "normalmap", &given, &tilt->texture);
    }
    if (!status && !given) {
        status = scene_fail(loader, node, BRDF_BAD_FILE, "a %s needs a <texture%s>",
                            bump ? "bumpmap" : "normalmap", bump ? "" : " name=\"normalmap\"");
    }
    tilt->how = bump ? PT_TILT_BUMP : PT_TILT_NORMAL;
    if (!status) {
        status = tilt_check(loader, given, &loader->scene->textures[tilt->texture], tilt->how);
    }
    tilt->how |= face ? PT_TILT_FACE : 0u;
    tilt->how |= shadow ? PT_TILT_SHADOW : 0u;
    tilt->scale = bump ? (float)scale : 0.0f;
    return status;
}
