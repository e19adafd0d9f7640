/*
 * scene_surface.c - surfaces, each once: the fewer there are, the fuller the packets of the
 * renderer.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

static int surface_find(const struct brdfcl_scene *scene, const struct scene_surface *wanted)
{
    for (size_t i = 0; i < scene->surface_count; ++i) {
        const struct scene_surface *surface = &scene->surfaces[i];
        if (surface->bsdf == wanted->bsdf && surface->emits == wanted->emits &&
            memcmp(&surface->tilt, &wanted->tilt, sizeof wanted->tilt) == 0 &&
            memcmp(surface->radiance, wanted->radiance, sizeof wanted->radiance) == 0) {
            return (int)i;
        }
    }
    return -1;
}

brdf_status scene_surface_add(struct scene_loader *loader, const struct xml_node *node,
                              struct brdf_bsdf *bsdf, const struct scene_tilt *tilt,
                              const double radiance[3], int *surface)
{
    struct brdfcl_scene *scene = loader->scene;
    struct scene_surface wanted;
    memset(&wanted, 0, sizeof wanted);
    wanted.bsdf = bsdf;
    if (tilt) {
        wanted.tilt = *tilt;
    }
    for (int i = 0; i < 3; ++i) {
        wanted.radiance[i] = (float)radiance[i] + 0.0f; /* no -0, which would look different */
        wanted.emits |= wanted.radiance[i] > 0.0f;
    }
    *surface = surface_find(scene, &wanted);
    if (*surface >= 0) {
        return BRDF_OK;
    }
    if (scene->surface_count == loader->surface_capacity) {
        size_t capacity = 2 * loader->surface_capacity + 8;
        struct scene_surface *surfaces =
            realloc(scene->surfaces, capacity * sizeof *scene->surfaces);
        if (!surfaces) {
            return scene_fail_memory(loader, node);
        }
        scene->surfaces = surfaces;
        loader->surface_capacity = capacity;
    }
    *surface = (int)scene->surface_count;
    scene->surfaces[scene->surface_count++] = wanted;
    return BRDF_OK;
}
