/*
 * path.h - the state of the wavefront: paths, their queues, and what a stage sees.
 *
 * The pool holds the paths of one pass: `1 << sample_bits` samples of each of a run of pixels, path
 * number = pixel in the run << sample_bits | sample in the pass. A path keeps its number through
 * the pass; queues hold path numbers. The record after the last is scratch: idle lanes read and
 * write it, so that no stage needs a mask to load or store.
 *
 *   generate -> extend -> sort -> shade (one kernel a variant) -> connect -> (extend ...) -> film
 *
 * with "resolve" before sort where surfaces are composed of others.
 */
#ifndef PT_PATH_H
#define PT_PATH_H

#include "lanes.h"
#include "random.h"
#include "rows.h"
#include "scene.h"

/*
 * A path's record, F(word, name, meaning). Each group of four words is a quad that a stage loads or
 * stores as one.
 */
#define PT_PATH_STATE(F)                                                                           \
    F(0, ORIGIN, "x, y, z of the ray's origin, world space")                                       \
    F(3, PDF, "density [1/sr] of the last sampling; negative: no MIS (camera, delta)")             \
    F(4, DIRECTION, "x, y, z of the ray, unit")                                                    \
    F(7, ETA, "product of the relative refractive indices so far")                                 \
    F(8, THROUGHPUT, "r, g, b: what radiance found ahead is multiplied by")                        \
    F(11, UNUSED, "free")                                                                          \
    F(12, HIT_T, "distance to what extend found")                                                  \
    F(13, HIT_U, "first coordinate on it")                                                         \
    F(14, HIT_V, "second coordinate on it")                                                        \
    F(15, HIT_PRIMITIVE, "its number, as bits")

/* A shadow ray's record: what light arrives if nothing is in between. */
#define PT_SHADOW_STATE(F)                                                                         \
    F(0, ORIGIN, "x, y, z of the ray's origin")                                                    \
    F(3, LENGTH, "distance up to which it must be free")                                           \
    F(4, DIRECTION, "x, y, z, unit")                                                               \
    F(7, PATH, "number of the path, as bits")                                                      \
    F(8, RADIANCE, "r, g, b that the path gains")                                                  \
    F(11, UNUSED, "free")

enum pt_path_word {
#define PT_WORD(word, name, meaning) PT_PATH_##name = word,
    PT_PATH_STATE(PT_WORD)
#undef PT_WORD
        PT_PATH_WORDS = 16
};

enum pt_shadow_word {
#define PT_WORD(word, name, meaning) PT_SHADOW_##name = word,
    PT_SHADOW_STATE(PT_WORD)
#undef PT_WORD
        PT_SHADOW_WORDS = 16
};

/* Counters at the start of the queue array. */
enum pt_counter {
    PT_ACTIVE = 0,    /* and 1: paths in each of the two active queues */
    PT_SHADOWS = 2,   /* shadow rays waiting */
    PT_RAYS = 3,      /* rays traced since the render began, modulo 2^32 */
    PT_INVALID = 4,   /* samples that were not finite, likewise */
    PT_VARIANTS = 16, /* packets waiting for each variant; the last variant is "missed" */
    PT_MAX_VARIANTS = 240,
    PT_COUNTERS = 256
};

/* One pass over part of the image; by value, the same for every stage. */
struct pt_pass {
    int first_pixel;
    int first_sample;
    int sample_bits; /* log2 of the samples of a pixel in this pass */
    int path_count;  /* pixels in the pass << sample_bits */
};

/* All memory that stages use. */
struct pt_world {
    BRDF_GLOBAL const struct pt_settings *settings;
    BRDF_GLOBAL const float *scene;
    BRDF_GLOBAL const float *tables; /* measured BRDFs */
    BRDF_GLOBAL float *paths;        /* pool + 1 records of PT_PATH_WORDS */
    BRDF_GLOBAL float *radiance;     /* pool + 1 quads: r, g, b gathered so far, unused */
    BRDF_GLOBAL float *shadows;      /* pool + 1 records of PT_SHADOW_WORDS */
    BRDF_GLOBAL int *queues;
};

/* The parts of the state array, found through the settings. */
static inline struct pt_world pt_world_make(BRDF_GLOBAL const struct pt_settings *settings,
                                            BRDF_GLOBAL const float *scene,
                                            BRDF_GLOBAL const float *tables,
                                            BRDF_GLOBAL float *state)
{
    BRDF_GLOBAL void *queues = state + settings->queues;
    struct pt_world w;
    w.settings = settings;
    w.scene = scene;
    w.tables = tables;
    w.paths = state;
    w.radiance = state + settings->radiance;
    w.shadows = state + settings->shadows;
    w.queues = (BRDF_GLOBAL int *)queues;
    return w;
}

/* What a scene has: a constant where the kernels are compiled for it, so that tests fold away. */
#ifdef PT_FEATURES
#define PT_HAS(settings, feature) ((PT_FEATURES) & (feature))
#else
#define PT_HAS(settings, feature) ((settings)->features & (feature))
#endif

static inline BRDF_GLOBAL const struct pt_surface *pt_surface_at(struct pt_world w, int number)
{
    BRDF_GLOBAL const void *surfaces = w.scene + w.settings->surfaces;
    return (BRDF_GLOBAL const struct pt_surface *)surfaces + number;
}

/* Take `count` places of a counter; the first of them. Each renderer in C has its own counters. */
static inline int pt_claim(BRDF_GLOBAL int *counter, int count)
{
#ifdef __OPENCL_VERSION__
    return atomic_add((volatile BRDF_GLOBAL int *)counter, count);
#else
    int first = *counter;
    *counter = first + count;
    return first;
#endif
}

/* Before a pass: its paths are the first queue. */
static inline void pt_begin(struct pt_world w, struct pt_pass pass)
{
    w.queues[PT_ACTIVE] = pass.path_count;
}

/* Before a bounce: the next queue, the shadow rays and what waits for shading are empty. Done once,
   by whoever comes to extend first; the queue that is extended now stays as it is. */
static inline void pt_open_bounce(struct pt_world w, int depth)
{
    w.queues[PT_RAYS] += w.queues[PT_ACTIVE + (depth & 1)];
    w.queues[PT_ACTIVE + ((depth + 1) & 1)] = 0;
    w.queues[PT_SHADOWS] = 0;
    for (int v = 0; v < w.settings->variant_count; ++v) {
        w.queues[PT_VARIANTS + v] = 0;
    }
}

/* How many lanes of a mask are true. */
static inline int pt_count_lanes(brdf_mask mask)
{
    return pt_count_bits(pt_mask_bits(mask));
}

/*
 * The path numbers of packet `packet` of a queue of `count` entries; idle lanes get the scratch
 * path.
 */
static inline brdf_int pt_queue_paths(struct pt_world w, int queue, int packet, int count)
{
    brdf_int place = packet * BRDF_LANES + brdf_lane_numbers();
    brdf_int paths = pt_load_ints(w.queues + queue + packet * BRDF_LANES);
    return brdf_pick_int(place < count, paths, w.settings->pool);
}

static inline brdf_int pt_pixel_of(struct pt_pass pass, brdf_int path)
{
    return pass.first_pixel + (path >> pass.sample_bits);
}

static inline brdf_int pt_sample_of(struct pt_pass pass, brdf_int path)
{
    return pass.first_sample + (path & ((1 << pass.sample_bits) - 1));
}

/* The random number sets of a bounce; set 0 is the camera's. Of the first, a chooses the light, b
   the lobe, c decides roulette and d forks; the second places light and lobe. */
#define PT_SETS_PER_BOUNCE 2

static inline int pt_bounce_set(int depth)
{
    return 1 + PT_SETS_PER_BOUNCE * depth;
}

/* Four random numbers of each path, set `dimension`. */
static inline struct pt_random pt_path_random(struct pt_world w, struct pt_pass pass, brdf_int path,
                                              int dimension)
{
    return pt_random4(PT_HAS(w.settings, PT_HAS_SOBOL), w.settings->seed, pt_pixel_of(pass, path),
                      pt_sample_of(pass, path), dimension);
}

/* The path gains radiance. Each path is in one lane of one packet only, so nothing else adds now.
 */
static inline void pt_add_radiance(struct pt_world w, brdf_int path, brdf_rgb radiance)
{
    struct brdf_quad sum = brdf_gather_quad(w.radiance, path * 4);
    pt_store_quad(
        w.radiance, path * 4,
        brdf_quad_make(sum.a + radiance.r, sum.b + radiance.g, sum.c + radiance.b, sum.d));
}

/* MIS weight of a sample of density a against density b, power heuristic [Veach 1997, 9.2.4]. */
static inline brdf_real pt_mis(brdf_real a, brdf_real b)
{
    brdf_real ratio = b / brdf_max(a, 1e-30f);
    return 1.0f / (1.0f + ratio * ratio);
}

#endif
