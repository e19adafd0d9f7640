/*
 * world.h - a scene laid out for the stages: settings, the scene array, the plan of the state
 * array.
 */
#ifndef BRDFCL_LIB_WORLD_H
#define BRDFCL_LIB_WORLD_H

#include "bvh.h"
#include "scene.h"
#include "world_words.h"

#include "kernels/path.h"

/* One shading kernel: what is constant in it. The last variant of a world is "missed". */
struct world_variant {
    unsigned model;
    unsigned flags;
    unsigned choices;
    unsigned textured; /* kernels/texture.h */
    unsigned colors;
    unsigned tilt; /* enum pt_tilt_how */
    int through;   /* no model: paths go on as if nothing were there */
    int surfaces;  /* how many surfaces are shaded by it */
};

struct world {
    struct pt_settings settings;
    float *scene; /* aligned to 64 bytes */
    size_t scene_words;
    const float *tables;
    size_t table_words;
    float *own_tables; /* tables, where they had to be put side by side */
    struct world_variant variants[PT_MAX_VARIANTS];
    size_t state_words; /* of the state array of one renderer */
    int sort_blocks;
};

/*
 * Lay out a scene for renderers of `lanes` lanes and `pool` paths in flight (a multiple of 16).
 * Refers to the scene's measured tables, which must outlive the world.
 */
brdf_status world_create(const struct brdfcl_scene *scene, int lanes, int pool, struct world *world,
                         struct brdf_error *error);
void world_destroy(struct world *world);

/* The first packet of each variant, to be written to the queue array at settings.variant_first. */
void world_variant_first(const struct world *world, int lanes, int first[PT_MAX_VARIANTS]);

/* The parts, each in a file of its own; they fill in their settings. */
void world_camera(const struct brdfcl_scene *scene, struct pt_settings *settings);
brdf_status world_textures(const struct brdfcl_scene *scene, struct world *world,
                           struct world_words *words, struct brdf_error *error);
/* The tables of all bsdfs; table_of_bsdf has the first word of each bsdf's. */
brdf_status world_tables(const struct brdfcl_scene *scene, struct world *world,
                         unsigned *table_of_bsdf, struct brdf_error *error);
brdf_status world_surfaces(const struct brdfcl_scene *scene, struct world *world,
                           struct world_words *words, struct brdf_error *error);
brdf_status world_lights(const struct brdfcl_scene *scene, struct world *world,
                         struct world_words *words, struct brdf_error *error);
brdf_status world_environment(const struct brdfcl_scene *scene, struct world *world,
                              struct world_words *words, struct brdf_error *error);

/* The bindings of a bsdf: their first word, which of the material's words they set, and which of
   those begin a colour. */
brdf_status world_bindings(const struct brdfcl_scene *scene, const struct brdf_bsdf *bsdf,
                           struct world_words *words, int *first, unsigned *textured,
                           unsigned *colors, struct brdf_error *error);
/* What a primitive's reference (struct scene_fork) is on the device: surfaces, "missed", forks. */
int world_key(const struct brdfcl_scene *scene, int reference);

/* The forks of a scene, as they are. */
brdf_status world_forks(const struct brdfcl_scene *scene, struct world *world,
                        struct world_words *words, struct brdf_error *error);

#endif
