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
    struct pt_arrival a = pt_arrive(w, packet);
    if (depth + 1 >= w.settings->max_depth) {
        return;
    }
    brdf_rgb throughput = a.m.throughput;
    if (depth + 1 >= w.settings->rr_depth) {
        struct pt_random choose = pt_path_random(w, pass, a.path, pt_bounce_set(depth));
        throughput = brdf_rgb_scale(throughput, pt_roulette(throughput, a.m.eta, choose.c));
    }
    brdf_int record = a.path * PT_PATH_WORDS;
    brdf_vec3 beyond = pt_leave(a.m.at, a.m.ray.d);
    pt_store_quad(w.paths + PT_PATH_ORIGIN, record, pt_quad_of_vec3(beyond, -1.0f));
    pt_store_quad(w.paths + PT_PATH_THROUGHPUT, record, pt_quad_of_rgb(throughput, 0.0f));
    pt_continue(w, a.path, a.used & (brdf_rgb_largest(throughput) > 0.0f), depth);
}

#endif
