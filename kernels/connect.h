/*
 * connect.h - stage 5: shadow rays. What next-event estimation found arrives if the way is free.
 *
 * reads: shadow rays; writes: the radiance of their paths.
 */
#ifndef PT_CONNECT_H
#define PT_CONNECT_H

#include "extend.h"

/* A packet of shadow rays against every primitive. */
static inline void pt_connect_packet(struct pt_world w, int packet)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    brdf_int place = packet * BRDF_LANES + brdf_lane_numbers();
    brdf_mask used = place < w.queues[PT_SHADOWS];
    brdf_int record = brdf_pick_int(used, place, settings->pool) * PT_SHADOW_WORDS;
    struct brdf_quad origin = brdf_gather_quad(w.shadows + PT_SHADOW_ORIGIN, record);
    struct brdf_quad direction = brdf_gather_quad(w.shadows + PT_SHADOW_DIRECTION, record);
    struct pt_ray ray;
    ray.o = pt_quad_vec3(origin);
    ray.d = pt_quad_vec3(direction);
    brdf_real nearest = PT_MISS_T;
    BRDF_GLOBAL const float *ready = w.scene + settings->ready;
    for (int i = 0; i < settings->primitive_count; ++i) {
        nearest = brdf_min(nearest, pt_ready_distance(ready, ray).t);
        ready += PT_ROW;
    }
    struct brdf_quad radiance = brdf_gather_quad(w.shadows + PT_SHADOW_RADIANCE, record);
    brdf_mask arrives = used & (nearest >= origin.d);
    brdf_int path = brdf_pick_int(arrives, brdf_bits(direction.d), settings->pool);
    pt_add_radiance(w, path, pt_quad_rgb(radiance));
}

/* Shadow ray `place` through the hierarchy. */
static inline void pt_connect_ray(struct pt_world w, int place)
{
    BRDF_GLOBAL const float *record = w.shadows + place * PT_SHADOW_WORDS;
    int blocked = pt_bvh_occluded(w.settings, w.scene, pt_ray_of(record), record[PT_SHADOW_LENGTH]);
    if (!blocked) {
        BRDF_GLOBAL float *sum = w.radiance + pt_int_bits(record[PT_SHADOW_PATH]) * 4;
        sum[0] += record[PT_SHADOW_RADIANCE];
        sum[1] += record[PT_SHADOW_RADIANCE + 1];
        sum[2] += record[PT_SHADOW_RADIANCE + 2];
    }
}

#endif
