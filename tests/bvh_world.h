/*
 * bvh_world.h - a hierarchy as a renderer holds it, and rays through it.
 */
#ifndef TEST_BVH_WORLD_H
#define TEST_BVH_WORLD_H

#include "bvh.h"
#include "bvh_scenes.h"
#include "kernels/bvh.h"

/* Nodes and leaves as the device wants them, in one array. */
struct world {
    struct bvh bvh;
    struct pt_settings settings;
    float *words;
};

/* Fails the test if the hierarchy cannot be built. */
void world_make(const struct bvh_scene *scene, struct world *world);
void world_free(struct world *world);

/* From the RAY_WORDS of a scene's ray. */
struct pt_hit_record world_closest(const struct world *world, const float *ray);
int world_occluded(const struct world *world, const float *ray, float tmax);

/* Fails the test, naming the scene and the ray, unless all bits agree. */
void assert_same_hit(const char *name, size_t ray, struct pt_hit_record expected,
                     struct pt_hit_record got);

#endif
