/*
 * extend.h - stage 2: each active path's ray finds the nearest primitive.
 *
 * reads: active queue, rays; writes: hits and, a place of the queue, the surface met (key):
 * surface_count for a miss.
 *
 * Two ways to the same bits. Few primitives: a packet of rays goes through all of them. Many: one
 * ray goes through the hierarchy, whose boxes and leaves fill the lanes (bvh.h).
 */
#ifndef PT_EXTEND_H
#define PT_EXTEND_H

#include "bvh.h"
#include "intersect.h"
#include "path.h"

/* Up to this many primitives a packet tests them all; chosen by measurement. */
#define PT_PACKET_PRIMITIVES 32

static inline brdf_vec3 pt_word_vec3(BRDF_GLOBAL const float *words)
{
    return brdf_vec3_make(words[0], words[1], words[2]);
}

/* The distance of a packet of rays to one primitive, from its row made ready. */
static inline struct pt_distance pt_ready_distance(BRDF_GLOBAL const float *ready,
                                                   struct pt_ray ray)
{
    int kind = pt_int_bits(ready[PT_READY_KIND]);
    struct pt_plane plane;
    plane.p = pt_word_vec3(ready + PT_READY_P);
    if (kind == PT_SPHERE) {
        return pt_sphere_distance(ray, plane.p, ready[PT_READY_N]);
    }
    plane.n = pt_word_vec3(ready + PT_READY_N);
    plane.a = pt_word_vec3(ready + PT_READY_A);
    plane.b = pt_word_vec3(ready + PT_READY_B);
    return pt_plane_distance(ray, plane, kind);
}

/* A packet of rays against every primitive; ties go to the lower number. */
static inline void pt_extend_packet(struct pt_world w, int packet, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int queue = settings->active[depth & 1];
    brdf_int path = pt_queue_paths(w, queue, packet, w.queues[PT_ACTIVE + (depth & 1)]);
    brdf_int record = path * PT_PATH_WORDS;
    struct pt_ray ray;
    ray.o = pt_quad_vec3(brdf_gather_quad(w.paths + PT_PATH_ORIGIN, record));
    ray.d = pt_quad_vec3(brdf_gather_quad(w.paths + PT_PATH_DIRECTION, record));

    brdf_real t = PT_MISS_T;
    brdf_real u = 0.0f;
    brdf_real v = 0.0f;
    brdf_int nearest = -1;
    brdf_int key = settings->surface_count;
    BRDF_GLOBAL const float *ready = w.scene + settings->ready;
    for (int i = 0; i < settings->primitive_count; ++i) {
        struct pt_distance hit = pt_ready_distance(ready, ray);
        brdf_mask nearer = hit.t < t;
        t = brdf_pick(nearer, hit.t, t);
        u = brdf_pick(nearer, hit.u, u);
        v = brdf_pick(nearer, hit.v, v);
        nearest = brdf_pick_int(nearer, i, nearest);
        key = brdf_pick_int(nearer, pt_int_bits(ready[PT_READY_SURFACE]), key);
        ready += PT_ROW;
    }
    pt_store_quad(w.paths + PT_PATH_HIT_T, record,
                  brdf_quad_make(t, u, v, brdf_from_bits(nearest)));
    pt_store_ints(w.queues + settings->keys + packet * BRDF_LANES, key);
}

/* The ray at the start of a path's or a shadow ray's record. */
static inline struct pt_bvh_ray pt_ray_of(BRDF_GLOBAL const float *record)
{
    struct pt_bvh_ray ray;
    ray.ox = record[PT_PATH_ORIGIN];
    ray.oy = record[PT_PATH_ORIGIN + 1];
    ray.oz = record[PT_PATH_ORIGIN + 2];
    ray.dx = record[PT_PATH_DIRECTION];
    ray.dy = record[PT_PATH_DIRECTION + 1];
    ray.dz = record[PT_PATH_DIRECTION + 2];
    return ray;
}

/* One ray, the queue's entry `place`, through the hierarchy. */
static inline void pt_extend_ray(struct pt_world w, int place, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int path = w.queues[settings->active[depth & 1] + place];
    BRDF_GLOBAL float *record = w.paths + path * PT_PATH_WORDS;
    struct pt_hit_record hit = pt_bvh_closest(settings, w.scene, pt_ray_of(record));
    record[PT_PATH_HIT_T] = hit.t;
    record[PT_PATH_HIT_U] = hit.u;
    record[PT_PATH_HIT_V] = hit.v;
    record[PT_PATH_HIT_PRIMITIVE] = pt_float_of_bits(hit.prim);
    int key = settings->surface_count;
    if (hit.prim >= 0) {
        key = pt_int_bits(w.scene[settings->primitives + hit.prim * PT_ROW + PT_SURFACE]);
    }
    w.queues[settings->keys + place] = key;
}

#endif
