/*
 * through.h - stage 4 where a mask lets a path through: it goes on as if nothing had been there.
 *
 * It counts as a bounce, as in Mitsuba 3's path integrator: against the limit of depth, and in that
 * next-event estimation, whose shadow rays masks stop, could not have found what is met beyond.
 */
#ifndef PT_THROUGH_H
#define PT_THROUGH_H

#include "shade.h"

static inline void pt_shade_through(struct pt_world w, struct pt_pass pass, int packet, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    BRDF_GLOBAL const struct pt_surface *surface =
        pt_surface_at(w, w.queues[settings->packet_surface + packet]);
    brdf_int path = pt_load_ints(w.queues + settings->packet_paths + packet * BRDF_LANES);
    brdf_int record = path * PT_PATH_WORDS;
    struct pt_quad origin = pt_load_quad(w.paths + PT_PATH_ORIGIN, record);
    struct pt_quad direction = pt_load_quad(w.paths + PT_PATH_DIRECTION, record);
    struct pt_quad hit = pt_load_quad(w.paths + PT_PATH_HIT_T, record);
    brdf_rgb throughput = pt_quad_rgb(pt_load_quad(w.paths + PT_PATH_THROUGHPUT, record));
    brdf_mask used = path < settings->pool;

    struct pt_ray ray;
    ray.o = pt_quad_vec3(origin);
    ray.d = pt_quad_vec3(direction);
    struct pt_primitive primitive = pt_load_primitive(w, brdf_pick_int(used, brdf_bits(hit.d), 0));
    struct pt_interaction at = pt_interact(w, primitive, ray, hit);
    if (surface->emits) {
        pt_shade_emission(w, surface, path, primitive, at, ray, hit, throughput, origin.d);
    }
    if (depth + 1 >= settings->max_depth) {
        return;
    }
    if (depth + 1 >= settings->rr_depth) {
        struct pt_random choose = pt_path_random(w, pass, path, pt_bounce_set(depth));
        throughput = brdf_rgb_scale(throughput, pt_roulette(throughput, direction.d, choose.c));
    }
    pt_store_quad(w.paths + PT_PATH_ORIGIN, record, pt_quad_of_vec3(pt_leave(at, ray.d), -1.0f));
    pt_store_quad(w.paths + PT_PATH_THROUGHPUT, record, pt_quad_of_rgb(throughput, 0.0f));
    pt_continue(w, path, used & (brdf_rgb_largest(throughput) > 0.0f), depth);
}

#endif
