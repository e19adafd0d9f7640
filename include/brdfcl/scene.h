/*
 * scene.h - scenes: Mitsuba 3 XML files in, something to render out.
 */
#ifndef BRDFCL_SCENE_H
#define BRDFCL_SCENE_H

#include <stddef.h>

#include <brdf/status.h>
#include <brdfcl/api.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scene with its meshes, materials and environment; immutable once loaded but for the setters. */
struct brdfcl_scene;

/* What a user may override; 0 or negative = as the scene file says. */
struct brdfcl_scene_info {
    int width;     /* pixels, 1 to 65536 */
    int height;    /* pixels, 1 to 65536 */
    int spp;       /* samples a pixel, 1 to 2^24 */
    int max_depth; /* path segments at most, -1 = unlimited */
    int rr_depth;  /* Russian roulette from this depth on */
    int seed;
    int half; /* the scene asks for 16-bit EXR */
    size_t primitive_count;
    size_t surface_count;
    const char *sampler; /* "independent" or "sobol" */
    const char *filter;  /* "box", "tent" or "gaussian" */
};

/* -D name=value: replaces $name in the file; the pair's strings are only read during the call. */
struct brdfcl_define {
    const char *name;
    const char *value;
};

/*
 * Read a scene. Errors name file and line (and column where known) and what was expected, with the
 * nearest known name; nothing that the file says is ignored silently.
 */
BRDFCL_API brdf_status brdfcl_scene_load(const char *path, const struct brdfcl_define *defines,
                                         size_t define_count, struct brdfcl_scene **scene,
                                         struct brdf_error *error);

/* NULL is fine. */
BRDFCL_API void brdfcl_scene_destroy(struct brdfcl_scene *scene);

BRDFCL_API struct brdfcl_scene_info brdfcl_scene_get_info(const struct brdfcl_scene *scene);

/* Replace sizes and counts; refused with the range where out of it. The field of view is kept
   horizontally or vertically as the file's fov_axis says. */
BRDFCL_API brdf_status brdfcl_scene_set_size(struct brdfcl_scene *scene, int width, int height,
                                             struct brdf_error *error);
BRDFCL_API brdf_status brdfcl_scene_set_spp(struct brdfcl_scene *scene, int spp,
                                            struct brdf_error *error);
BRDFCL_API brdf_status brdfcl_scene_set_depth(struct brdfcl_scene *scene, int max_depth,
                                              struct brdf_error *error);
BRDFCL_API void brdfcl_scene_set_seed(struct brdfcl_scene *scene, int seed);

/* Remarks of loading (a sampler that was mapped, triangles dropped); NULL past the last. */
BRDFCL_API const char *brdfcl_scene_note(const struct brdfcl_scene *scene, size_t index);

#ifdef __cplusplus
}
#endif

#endif
