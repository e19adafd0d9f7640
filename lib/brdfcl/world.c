/*
 * world.c - from the scene in the host's memory to the arrays that the stages read.
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "world.h"

#include "kernels/extend.h"
#include "kernels/sort.h"

/* The primitives made ready for packets of rays. */
static brdf_status append_ready(const struct brdfcl_scene *scene, struct world *world,
                                struct world_words *words, struct brdf_error *error)
{
    size_t count = scene->primitives.count;
    brdf_status status = world_append(words, NULL, count * PT_ROW, &world->settings.ready, error);
    for (size_t i = 0; i < count && status == BRDF_OK; ++i) {
        const float *from = scene->primitives.words + i * PT_ROW;
        float *to = words->words + world->settings.ready + i * PT_ROW;
        struct pt_plane plane = pt_plane_make(pt_word_vec3(from + PT_P), pt_word_vec3(from + PT_E1),
                                              pt_word_vec3(from + PT_E2));
        if (pt_int_bits(from[PT_KIND]) == PT_SPHERE) {
            plane.n = brdf_vec3_make(from[PT_RADIUS], 0.0f, 0.0f);
        }
        const brdf_vec3 vectors[4] = {plane.p, plane.n, plane.a, plane.b};
        memcpy(to, vectors, sizeof vectors);
        to[PT_READY_KIND] = from[PT_KIND];
        to[PT_READY_SURFACE] = pt_float_of_bits(world_key(scene, pt_int_bits(from[PT_SURFACE])));
    }
    return status;
}

static brdf_status append_hierarchy(const struct brdfcl_scene *scene, struct world *world,
                                    struct world_words *words, struct brdf_error *error)
{
    struct bvh bvh;
    memset(&bvh, 0, sizeof bvh);
    brdf_status status = bvh_build(scene->primitives.words, scene->primitives.count, &bvh, error);
    if (status == BRDF_OK) {
        status = world_append(words, bvh.nodes, bvh.node_words, &world->settings.nodes, error);
    }
    if (status == BRDF_OK) {
        status = world_append(words, bvh.leaves, bvh.leaf_words, &world->settings.leaves, error);
    }
    world->settings.root = bvh.root;
    bvh_destroy(&bvh);
    return status;
}

static brdf_status append_geometry(const struct brdfcl_scene *scene, struct world *world,
                                   struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    size_t count = scene->primitives.count;
    settings->primitive_count = (int)count;
    for (size_t i = 0; i < count; ++i) {
        int kind = pt_int_bits(scene->primitives.words[i * PT_ROW + PT_KIND]);
        settings->features |= kind == PT_SPHERE ? PT_HAS_SPHERES : 0;
    }
    settings->features |= scene->shading.count > 0 ? PT_HAS_SHADING : 0;
    /* One row at least: idle lanes read the first. */
    size_t rows = count > 0 ? count : 1;
    brdf_status status = world_append(words, NULL, rows * PT_ROW, &settings->primitives, error);
    if (status == BRDF_OK && count > 0) {
        memcpy(words->words + settings->primitives, scene->primitives.words,
               count * PT_ROW * sizeof(float));
        for (size_t i = 0; i < count; ++i) {
            float *row = words->words + settings->primitives + i * PT_ROW;
            row[PT_SURFACE] = pt_float_of_bits(world_key(scene, pt_int_bits(row[PT_SURFACE])));
        }
    }
    if (status == BRDF_OK) {
        status = world_append(words, scene->shading.words, scene->shading.count * PT_ROW,
                              &settings->shading, error);
    }
    if (status == BRDF_OK && count > PT_PACKET_PRIMITIVES) {
        settings->features |= PT_HAS_BVH;
        return append_hierarchy(scene, world, words, error);
    }
    return status == BRDF_OK ? append_ready(scene, world, words, error) : status;
}

/* The packets that a variant can fill: full ones, and one begun by each block for each surface. */
static int variant_packets(const struct world *world, int variant, int lanes)
{
    return (world->settings.pool + lanes - 1) / lanes +
           world->sort_blocks * world->variants[variant].surfaces;
}

void world_variant_first(const struct world *world, int lanes, int first[PT_MAX_VARIANTS])
{
    int packets = 0;
    for (int v = 0; v < PT_MAX_VARIANTS; ++v) {
        first[v] = packets;
        packets += v < world->settings.variant_count ? variant_packets(world, v, lanes) : 0;
    }
}

/* Where the parts of the state array begin. */
static void plan_state(struct world *world, int lanes, int pool)
{
    struct pt_settings *settings = &world->settings;
    const int line = WORLD_LINE;
    int entries = pool + line;
    int blocks = (pool + PT_SORT_BLOCK - 1) / PT_SORT_BLOCK;
    world->sort_blocks = blocks;
    settings->pool = pool;
    settings->radiance = (pool + 1) * PT_PATH_WORDS;
    settings->shadows = settings->radiance + (pool + 4) * 4;
    settings->queues = settings->shadows + (pool + 1) * PT_SHADOW_WORDS;
    settings->active[0] = PT_COUNTERS;
    settings->active[1] = settings->active[0] + entries;
    settings->keys = settings->active[1] + entries;
    settings->variant_first = settings->keys + entries;
    settings->histograms = settings->variant_first + PT_MAX_VARIANTS;
    int packets = 0;
    for (int v = 0; v < settings->variant_count; ++v) {
        packets += variant_packets(world, v, lanes);
    }
    int histogram_words = blocks * (settings->surface_count + 1);
    settings->packet_surface = settings->histograms + histogram_words;
    settings->packet_paths = (settings->packet_surface + packets + line - 1) / line * line;
    world->state_words =
        (size_t)settings->queues + (size_t)settings->packet_paths + (size_t)packets * (size_t)lanes;
}

brdf_status world_create(const struct brdfcl_scene *scene, int lanes, int pool, struct world *world,
                         struct brdf_error *error)
{
    struct world_words words = {NULL, 0, 0};
    memset(world, 0, sizeof *world);
    struct pt_settings *settings = &world->settings;
    world_camera(scene, settings);
    settings->width = scene->width;
    settings->height = scene->height;
    settings->seed = scene->seed;
    settings->max_depth = scene->max_depth < 0 ? INT_MAX : scene->max_depth;
    settings->rr_depth = scene->rr_depth;
    settings->filter = scene->filter;
    settings->filter_radius = scene->filter_radius;
    settings->filter_sigma = scene->filter_sigma;
    settings->features = scene->sobol ? PT_HAS_SOBOL : 0;

    brdf_status status = append_geometry(scene, world, &words, error);
    if (status == BRDF_OK) {
        status = world_textures(scene, world, &words, error);
    }
    if (status == BRDF_OK) {
        status = world_surfaces(scene, world, &words, error);
    }
    if (status == BRDF_OK) {
        status = world_forks(scene, world, &words, error);
    }
    if (status == BRDF_OK) {
        status = world_environment(scene, world, &words, error);
    }
    if (status == BRDF_OK) {
        status = world_lights(scene, world, &words, error);
    }
    world->scene = words.words;
    world->scene_words = words.count;
    if (status == BRDF_OK) {
        plan_state(world, lanes, pool);
    } else {
        world_destroy(world);
    }
    return status;
}

void world_destroy(struct world *world)
{
    free(world->scene);
    free(world->own_tables);
    memset(world, 0, sizeof *world);
}
