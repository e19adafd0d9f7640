/*
 * bvh_world.c - a hierarchy as a renderer holds it, and rays through it.
 */
#define _POSIX_C_SOURCE 200809L
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "bvh_world.h"

void world_make(const struct bvh_scene *scene, struct world *world)
{
    struct brdf_error error;
    memset(world, 0, sizeof *world);
    if (bvh_build(scene->rows, scene->count, &world->bvh, &error) != BRDF_OK) {
        fail_msg("%s", error.message);
    }
    size_t node_bytes = world->bvh.node_words * sizeof(float);
    size_t leaf_bytes = world->bvh.leaf_words * sizeof(float);
    void *memory = NULL;
    assert_int_equal(posix_memalign(&memory, 64, node_bytes + leaf_bytes), 0);
    world->words = memory;
    memcpy(world->words, world->bvh.nodes, node_bytes);
    memcpy(world->words + world->bvh.node_words, world->bvh.leaves, leaf_bytes);
    world->settings.leaves = (int)world->bvh.node_words;
    world->settings.root = world->bvh.root;
}

void world_free(struct world *world)
{
    bvh_destroy(&world->bvh);
    free(world->words);
}

static struct pt_bvh_ray ray_of(const float *r)
{
    struct pt_bvh_ray ray = {r[0], r[1], r[2], r[3], r[4], r[5]};
    return ray;
}

struct pt_hit_record world_closest(const struct world *world, const float *ray)
{
    return pt_bvh_closest(&world->settings, world->words, ray_of(ray));
}

int world_occluded(const struct world *world, const float *ray, float tmax)
{
    return pt_bvh_occluded(&world->settings, world->words, ray_of(ray), tmax) != 0;
}

void assert_same_hit(const char *name, size_t ray, struct pt_hit_record expected,
                     struct pt_hit_record got)
{
    if (memcmp(&expected, &got, sizeof got) != 0) {
        fail_msg("%s, ray %zu: primitive %d at %.9g, but expected was %d at %.9g", name, ray,
                 got.prim, (double)got.t, expected.prim, (double)expected.t);
    }
}
