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
    brdf_mask used = path < settings->pool;
    struct pt_meeting m = pt_meet(w, path, used);
    if (surface->emits) {
        pt_shade_emission(w, surface, path, m);
    }
    if (depth + 1 >= settings->max_depth) {
        return;
    }
    brdf_rgb throughput = m.throughput;
    if (depth + 1 >= settings->rr_depth) {
        struct pt_random choose = pt_path_random(w, pass, path, pt_bounce_set(depth));
        throughput = brdf_rgb_scale(throughput, pt_roulette(throughput, m.eta, choose.c));
    }
    brdf_int record = path * PT_PATH_WORDS;
    brdf_vec3 beyond = pt_leave(m.at, m.ray.d);
    pt_store_quad(w.paths + PT_PATH_ORIGIN, record, pt_quad_of_vec3(beyond, -1.0f));
    pt_store_quad(w.paths + PT_PATH_THROUGHPUT, record, pt_quad_of_rgb(throughput, 0.0f));
    pt_continue(w, path, used & (brdf_rgb_largest(throughput) > 0.0f), depth);
}

#endif
