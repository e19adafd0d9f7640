/*
 * scene.c - what a loaded scene tells, and what may be changed of it.
 */
#include "scene.h"

#include <stdlib.h>

#define SCENE_SIDE_MAX 65536
#define SCENE_SPP_MAX 16777216

void brdfcl_scene_destroy(struct brdfcl_scene *scene)
{
    if (!scene) {
        return;
    }
    for (size_t i = 0; i < scene->bsdf_count; ++i) {
        brdf_bsdf_destroy(scene->bsdfs[i]);
    }
    for (size_t i = 0; i < scene->note_count; ++i) {
        free(scene->notes[i]);
    }
    for (size_t i = 0; i < scene->texture_count; ++i) {
        free(scene->textures[i].codes);
        free(scene->textures[i].rgb);
    }
    brdfcl_image_destroy(&scene->environment.image);
    free(scene->textures);
    free(scene->bindings);
    free(scene->primitives.words);
    free(scene->shading.words);
    free(scene->surfaces);
    free(scene->forks);
    free(scene->bsdfs);
    free(scene->notes);
    free(scene->path);
    free(scene);
}

struct brdfcl_scene_info brdfcl_scene_get_info(const struct brdfcl_scene *scene)
{
    static const char *const filters[] = {"box", "tent", "gaussian"};
    struct brdfcl_scene_info info;
    info.width = scene->width;
    info.height = scene->height;
    info.spp = scene->spp;
    info.max_depth = scene->max_depth;
    info.rr_depth = scene->rr_depth;
    info.seed = scene->seed;
    info.half = scene->half;
    info.primitive_count = scene->primitives.count;
    info.surface_count = scene->surface_count;
    info.sampler = scene->sobol ? "sobol" : "independent";
    info.filter = filters[scene->filter];
    return info;
}

static brdf_status scene_check_range(const char *what, int value, int low, int high,
                                     struct brdf_error *error)
{
    if (value < low || value > high) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE, "%s = %d: expected %d to %d", what, value, low,
                         high);
    }
    return BRDF_OK;
}

brdf_status brdfcl_scene_set_size(struct brdfcl_scene *scene, int width, int height,
                                  struct brdf_error *error)
{
    brdf_status status = scene_check_range("width", width, 1, SCENE_SIDE_MAX, error);
    if (!status) {
        status = scene_check_range("height", height, 1, SCENE_SIDE_MAX, error);
    }
    if (!status) {
        scene->width = width;
        scene->height = height;
    }
    return status;
}

brdf_status brdfcl_scene_set_spp(struct brdfcl_scene *scene, int spp, struct brdf_error *error)
{
    brdf_status status = scene_check_range("samples a pixel", spp, 1, SCENE_SPP_MAX, error);
    if (!status) {
        scene->spp = spp;
    }
    return status;
}

brdf_status brdfcl_scene_set_depth(struct brdfcl_scene *scene, int max_depth,
                                   struct brdf_error *error)
{
    brdf_status status = scene_check_range("depth", max_depth, -1, 0x7fffffff, error);
    if (!status) {
        scene->max_depth = max_depth;
    }
    return status;
}

void brdfcl_scene_set_seed(struct brdfcl_scene *scene, int seed)
{
    scene->seed = seed;
}

const char *brdfcl_scene_note(const struct brdfcl_scene *scene, size_t index)
{
    return index < scene->note_count ? scene->notes[index] : NULL;
}
