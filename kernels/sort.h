/*
 * sort.h - stage 3: the active paths, grouped into packets that met the same surface.
 *
 * reads: active queue, keys; writes: packets (their surface, their paths) and how many each variant
 * has. A counting sort by blocks: a work-item sorts PT_SORT_BLOCK entries on its own and claims
 * packets for them. The order of packets depends on who came first; no result does, as every path
 * is on its own until the film adds them in order.
 */
#ifndef PT_SORT_H
#define PT_SORT_H

#include "path.h"

#define PT_SORT_BLOCK 4096

/* Packets for `count` paths that met surface `key`: claimed, labelled, their idle lanes filled. The
   place of the first path. */
static inline int pt_open_packets(struct pt_world w, int key, int count)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int missed = key == settings->surface_count;
    int variant = missed ? settings->variant_count - 1 : pt_surface_at(w, key)->variant;
    int packets = (count + BRDF_LANES - 1) / BRDF_LANES;
    int first = w.queues[settings->variant_first + variant] +
                pt_claim(w.queues + PT_VARIANTS + variant, packets);
    for (int i = 0; i < packets; ++i) {
        w.queues[settings->packet_surface + first + i] = key;
    }
    BRDF_GLOBAL int *paths = w.queues + settings->packet_paths;
    for (int i = first * BRDF_LANES + count; i < (first + packets) * BRDF_LANES; ++i) {
        paths[i] = settings->pool;
    }
    return first * BRDF_LANES;
}

/* Does anything come of shading this surface at this depth? */
static inline int pt_worth_shading(struct pt_world w, int key, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    if (key == settings->surface_count) {
        return PT_HAS(settings, PT_HAS_CONSTANT | PT_HAS_MAP) != 0;
    }
    return depth + 1 < settings->max_depth || pt_surface_at(w, key)->emits;
}

static inline void pt_sort(struct pt_world w, int block, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int keys = settings->surface_count + 1;
    int begin = block * PT_SORT_BLOCK;
    int end = begin + PT_SORT_BLOCK;
    int count = w.queues[PT_ACTIVE + (depth & 1)];
    end = end < count ? end : count;
    BRDF_GLOBAL int *place = w.queues + settings->histograms + block * keys;
    BRDF_GLOBAL const int *key = w.queues + settings->keys;
    BRDF_GLOBAL const int *active = w.queues + settings->active[depth & 1];
    BRDF_GLOBAL int *paths = w.queues + settings->packet_paths;

    for (int k = 0; k < keys; ++k) {
        place[k] = 0;
    }
    for (int i = begin; i < end; ++i) {
        ++place[key[i]];
    }
    for (int k = 0; k < keys; ++k) {
        int worth = place[k] > 0 && pt_worth_shading(w, k, depth);
        place[k] = worth ? pt_open_packets(w, k, place[k]) : -1;
    }
    for (int i = begin; i < end; ++i) {
        int k = key[i];
        if (place[k] >= 0) {
            paths[place[k]] = active[i];
            ++place[k];
        }
    }
}

#endif
