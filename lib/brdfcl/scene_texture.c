/*
 * scene_texture.c - <texture>: bitmap and checkerboard; scene_woodgrain.c reads the third kind.
 */
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "image_formats.h"

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* The 2 x 3 part of a transform that moves (u, v). */
static void texture_put_uv(struct pt_texture *record, const double to_uv[16])
{
    for (int i = 0; i < 2; ++i) {
        record->to_uv[3 * i] = (float)to_uv[4 * i];
        record->to_uv[3 * i + 1] = (float)to_uv[4 * i + 1];
        record->to_uv[3 * i + 2] = (float)to_uv[4 * i + 3];
    }
}

static void texture_widen(struct scene_texture *texture, float value)
{
    texture->least = value < texture->least ? value : texture->least;
    texture->most = value > texture->most ? value : texture->most;
}

/* The number of 8 bits that a float came from; the table grows. */
static unsigned texture_code(const float table[256], float value)
{
    unsigned low = 0;
    for (unsigned step = 128; step > 0; step /= 2) {
        low += table[low + step] <= value ? step : 0;
    }
    return low;
}

/* Take the pixels over; those of 8 bits are kept as such, a word each instead of four. */
static brdf_status texture_take(const struct scene_loader *loader, const struct xml_node *node,
                                struct brdfcl_image *image, int bits, struct scene_texture *texture)
{
    size_t texels = (size_t)image->width * (size_t)image->height;
    float table[256];
    texture->record.width = image->width;
    texture->record.height = image->height;
    if (bits != 8) {
        texture->rgb = image->rgb;
        image->rgb = NULL;
        return BRDF_OK;
    }
    texture->codes = malloc(texels * sizeof *texture->codes);
    if (!texture->codes) {
        return scene_fail_memory(loader, node);
    }
    brdfcl_image_codes(texture->raw, table);
    for (size_t i = 0; i < texels; ++i) {
        const float *rgb = image->rgb + 3 * i;
        texture->codes[i] = texture_code(table, rgb[0]) | texture_code(table, rgb[1]) << 8 |
                            texture_code(table, rgb[2]) << 16;
    }
    return BRDF_OK;
}

static brdf_status texture_check_pixels(const struct scene_loader *loader,
                                        const struct xml_node *node, const char *path,
                                        const struct brdfcl_image *image,
                                        struct scene_texture *texture)
{
    size_t count = (size_t)image->width * (size_t)image->height * 3;
    for (size_t i = 0; i < count; ++i) {
        float value = image->rgb[i];
        if (!(fabsf(value) <= FLT_MAX)) {
            size_t pixel = i / 3;
            return scene_fail(loader, node, BRDF_BAD_FILE,
                              "%s: pixel (%d, %d) has a channel that is not a finite number", path,
                              (int)(pixel % (size_t)image->width),
                              (int)(pixel / (size_t)image->width));
        }
        texture_widen(texture, value);
    }
    return BRDF_OK;
}

static brdf_status texture_load(const struct scene_loader *loader, const struct xml_node *node,
                                const char *filename, struct scene_texture *texture)
{
    struct brdfcl_image image = {0, 0, NULL};
    struct brdf_error inner;
    int bits = 0;
    char *path = scene_value_path(loader, filename);
    brdf_status status;
    if (!path) {
        return scene_fail_memory(loader, node);
    }
    memset(&inner, 0, sizeof inner);
    status = brdfcl_image_read_numbers(&image, path, texture->raw, &bits, &inner);
    if (status) {
        inner.status = status;
        status = scene_fail_inner(loader, node, &inner);
    } else {
        status = texture_check_pixels(loader, node, path, &image, texture);
    }
    if (!status) {
        status = texture_take(loader, node, &image, bits, texture);
    }
    brdfcl_image_destroy(&image);
    free(path);
    return status;
}

static brdf_status texture_bitmap(struct scene_loader *loader, struct xml_node *node,
                                  struct scene_texture *texture)
{
    static const char *const filters[] = {"bilinear", "nearest"};
    static const char *const wraps[] = {"repeat", "mirror", "clamp"}; /* enum pt_texture_wrap */
    const char *filename = NULL;
    const char *filter = filters[0];
    const char *wrap = wraps[0];
    const char *format = NULL;
    int accel = 0;
    double to_uv[16];
    struct scene_slot slots[] = {
        {"filename", SLOT_STRING, &filename, 0.0, 0.0, NULL},
        {"filter_type", SLOT_STRING, &filter, 0.0, 0.0, NULL},
        {"wrap_mode", SLOT_STRING, &wrap, 0.0, 0.0, NULL},
        {"raw", SLOT_BOOLEAN, &texture->raw, 0.0, 0.0, NULL},
        {"to_uv", SLOT_TRANSFORM, to_uv, 0.0, 0.0, NULL},
        {"format", SLOT_STRING, &format, 0.0, 0.0, NULL}, /* how Mitsuba keeps the texels */
        {"accel", SLOT_BOOLEAN, &accel, 0.0, 0.0, NULL},
    };
    brdf_status status;
    scene_matrix_identity(to_uv);
    status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    if (!status && (!filename || !*filename)) {
        status = scene_fail(loader, node, BRDF_BAD_FILE, "a bitmap needs a filename");
    }
    if (!status) {
        status = scene_slot_check(loader, &slots[1], filters, COUNT(filters));
    }
    if (!status) {
        status = scene_slot_check(loader, &slots[2], wraps, COUNT(wraps));
    }
    if (!status) {
        status = scene_slots_note(loader, slots + 5, 2);
    }
    if (status) {
        return status;
    }
    texture->record.kind = PT_TEXTURE_BITMAP;
    texture->record.nearest = strcmp(filter, "nearest") == 0;
    while (strcmp(wraps[texture->record.wrap], wrap) != 0) {
        ++texture->record.wrap;
    }
    texture_put_uv(&texture->record, to_uv);
    return texture_load(loader, slots[0].given, filename, texture);
}

static brdf_status texture_checkerboard(struct scene_loader *loader, struct xml_node *node,
                                        struct scene_texture *texture)
{
    double color0[3] = {0.4, 0.4, 0.4};
    double color1[3] = {0.2, 0.2, 0.2};
    double to_uv[16];
    struct scene_slot slots[] = {
        {"color0", SLOT_COLOR, color0, 0.0, 0.0, NULL},
        {"color1", SLOT_COLOR, color1, 0.0, 0.0, NULL},
        {"to_uv", SLOT_TRANSFORM, to_uv, 0.0, 0.0, NULL},
    };
    brdf_status status;
    scene_matrix_identity(to_uv);
    status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    texture->record.kind = PT_TEXTURE_CHECKERBOARD;
    texture_put_uv(&texture->record, to_uv);
    for (int i = 0; i < 3; ++i) {
        texture->record.color0[i] = (float)color0[i];
        texture->record.color1[i] = (float)color1[i];
        texture_widen(texture, texture->record.color0[i]);
        texture_widen(texture, texture->record.color1[i]);
    }
    return status;
}

/* Put a texture at the end of the scene's; on failure it is freed. */
static brdf_status texture_keep(struct scene_loader *loader, const struct xml_node *node,
                                const struct scene_texture *texture, int *number)
{
    struct brdfcl_scene *scene = loader->scene;
    if (scene->texture_count == loader->texture_capacity) {
        size_t capacity = 2 * loader->texture_capacity + 8;
        struct scene_texture *grown = realloc(scene->textures, capacity * sizeof *grown);
        if (!grown) {
            return scene_fail_memory(loader, node);
        }
        scene->textures = grown;
        loader->texture_capacity = capacity;
    }
    *number = (int)scene->texture_count;
    scene->textures[scene->texture_count++] = *texture;
    return BRDF_OK;
}

static brdf_status texture_make(struct scene_loader *loader, struct xml_node *node, int *number)
{
    static const char *const types[] = {"bitmap", "checkerboard", "woodgrain"};
    const char *type = xml_attribute_get(node, "type");
    struct scene_texture texture;
    brdf_status status;
    memset(&texture, 0, sizeof texture);
    texture.least = FLT_MAX;
    texture.most = -FLT_MAX;
    if (strcmp(type, "bitmap") == 0) {
        status = texture_bitmap(loader, node, &texture);
    } else if (strcmp(type, "checkerboard") == 0) {
        status = texture_checkerboard(loader, node, &texture);
    } else if (strcmp(type, "woodgrain") == 0) {
        status = scene_woodgrain_read(loader, node, &texture);
    } else {
        return scene_fail_unknown(loader, node, "texture", type, types, COUNT(types));
    }
    if (!status) {
        status = texture_keep(loader, node, &texture, number);
    }
    if (status) {
        free(texture.codes);
        free(texture.rgb);
    }
    return status;
}

brdf_status scene_texture_read(struct scene_loader *loader, struct xml_node *node, int *number)
{
    int *made = node->product;
    brdf_status status;
    if (made) {
        *number = *made;
        return BRDF_OK;
    }
    status = texture_make(loader, node, number);
    if (!status) {
        made = xml_allocate(&loader->document, sizeof *made);
        if (!made) {
            return scene_fail_memory(loader, node);
        }
        *made = *number;
        node->product = made;
    }
    return status;
}
