/*
 * world_surfaces.c - surfaces with their materials, and the variants: surfaces of equal model,
 * flags, choices and textured parameters are shaded by one kernel.
 */
#include <stdlib.h>
#include <string.h>

#include "world.h"

/* The variant like this one, added if it is new; -1 if there are too many. */
static int find_variant(struct world *world, const struct world_variant *wanted)
{
    int count = world->settings.variant_count;
    for (int v = 0; v < count; ++v) {
        struct world_variant *variant = &world->variants[v];
        if (variant->model == wanted->model && variant->flags == wanted->flags &&
            variant->choices == wanted->choices && variant->textured == wanted->textured &&
            variant->colors == wanted->colors && variant->tilt == wanted->tilt &&
            variant->through == wanted->through) {
            variant->surfaces += 1;
            return v;
        }
    }
    if (count == PT_MAX_VARIANTS - 1) { /* one is kept for "missed" */
        return -1;
    }
    world->variants[count] = *wanted;
    world->settings.variant_count = count + 1;
    return count;
}

static unsigned table_of(const struct brdfcl_scene *scene, const struct brdf_bsdf *bsdf,
                         const unsigned *table_of_bsdf)
{
    for (size_t i = 0; i < scene->bsdf_count; ++i) {
        if (scene->bsdfs[i] == bsdf) {
            return table_of_bsdf[i];
        }
    }
    return 0u;
}

static brdf_status put_surface(const struct brdfcl_scene *scene, struct world *world,
                               struct world_words *words, size_t number,
                               const unsigned *table_of_bsdf, struct brdf_error *error)
{
    const struct scene_surface *from = &scene->surfaces[number];
    struct pt_surface surface;
    memset(&surface, 0, sizeof surface);
    surface.emits = from->emits;
    memcpy(surface.radiance, from->radiance, sizeof surface.radiance);
    struct world_variant variant;
    memset(&variant, 0, sizeof variant);
    variant.surfaces = 1;
    variant.through = !from->bsdf;
    brdf_status status = BRDF_OK;
    if (from->bsdf) {
        surface.material = *brdf_bsdf_material(from->bsdf);
        surface.material.table += table_of(scene, from->bsdf, table_of_bsdf);
        variant.model = surface.material.model;
        variant.flags = surface.material.flags;
        variant.choices = surface.material.choices;
        variant.tilt = from->tilt.how;
        surface.tilt_texture = from->tilt.texture;
        surface.tilt_scale = from->tilt.scale;
        status = world_bindings(scene, from->bsdf, words, &surface.bindings, &variant.textured,
                                &variant.colors, error);
    }
    if (status != BRDF_OK) {
        return status;
    }
    surface.variant = find_variant(world, &variant);
    if (surface.variant < 0) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "more than %d different kinds of material in one scene",
                         PT_MAX_VARIANTS - 1);
    }
    size_t surface_words = sizeof surface / sizeof(float);
    memcpy(words->words + world->settings.surfaces + number * surface_words, &surface,
           sizeof surface);
    return BRDF_OK;
}

brdf_status world_surfaces(const struct brdfcl_scene *scene, struct world *world,
                           struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    size_t surface_words = sizeof(struct pt_surface) / sizeof(float);
    unsigned *table_of_bsdf = calloc(scene->bsdf_count + 1, sizeof *table_of_bsdf);
    brdf_status status = table_of_bsdf ? world_tables(scene, world, table_of_bsdf, error)
                                       : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    settings->surface_count = (int)scene->surface_count;
    if (status == BRDF_OK) {
        status = world_append(words, NULL, scene->surface_count * surface_words,
                              &settings->surfaces, error);
    }
    for (size_t i = 0; i < scene->surface_count && status == BRDF_OK; ++i) {
        status = put_surface(scene, world, words, i, table_of_bsdf, error);
    }
    /* The last variant is for paths that met nothing. */
    world->variants[settings->variant_count].surfaces = 1;
    settings->variant_count += 1;
    free(table_of_bsdf);
    return status;
}
