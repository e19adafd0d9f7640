/*
 * scene_bsdf_keep.c - the bsdfs of a scene, each once: the fewer there are, the fuller the packets
 * of the renderer.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

#include <brdf/model.h>

/* The scene's bsdf that has the same bits and no textures, if there is one. */
static struct brdf_bsdf *bsdf_find(const struct brdfcl_scene *scene, const struct brdf_bsdf *wanted)
{
    size_t words = 0;
    const float *table = brdf_bsdf_table(wanted, &words);
    for (size_t i = 0; i < scene->bsdf_count; ++i) {
        size_t other_words = 0;
        size_t bindings = 0;
        const float *other = brdf_bsdf_table(scene->bsdfs[i], &other_words);
        scene_bindings_of(scene, scene->bsdfs[i], &bindings);
        if (bindings == 0 &&
            memcmp(brdf_bsdf_material(scene->bsdfs[i]), brdf_bsdf_material(wanted),
                   sizeof(struct brdf_material)) == 0 &&
            words == other_words &&
            (words == 0 || memcmp(table, other, words * sizeof *table) == 0)) {
            return scene->bsdfs[i];
        }
    }
    return NULL;
}

brdf_status scene_bsdf_keep(struct scene_loader *loader, const struct xml_node *node,
                            const struct scene_bindings *bindings, struct brdf_bsdf **bsdf)
{
    struct brdfcl_scene *scene = loader->scene;
    struct brdf_bsdf *same = bindings->count > 0 ? NULL : bsdf_find(scene, *bsdf);
    if (same) {
        brdf_bsdf_destroy(*bsdf);
        *bsdf = same;
        return BRDF_OK;
    }
    if (scene->bsdf_count == loader->bsdf_capacity) {
        size_t capacity = 2 * loader->bsdf_capacity + 8;
        struct brdf_bsdf **bsdfs = realloc(scene->bsdfs, capacity * sizeof *scene->bsdfs);
        if (!bsdfs) {
            brdf_bsdf_destroy(*bsdf);
            return scene_fail_memory(loader, node);
        }
        scene->bsdfs = bsdfs;
        loader->bsdf_capacity = capacity;
    }
    scene->bsdfs[scene->bsdf_count++] = *bsdf;
    return scene_bindings_keep(loader, node, *bsdf, bindings);
}
