/*
 * resolve.h - between extend and sort: paths that met a composed surface decide for one part of it.
 *
 * reads: active queue, keys; writes: keys, which are those of surfaces only.
 *
 * A blend's light is the weighted sum of its parts' light, so that a path that goes on to one part,
 * with the part's weight as its probability, gains the same in expectation; a mask is a blend with
 * nothing. Shading then knows no composition: packets hold one surface as ever, each with its own
 * kernel, and what a kernel returns as density is that of the part, for its light and its next ray
 * alike.
 */
#ifndef PT_RESOLVE_H
#define PT_RESOLVE_H

#include "texture.h"
#include "meeting.h"

static inline BRDF_GLOBAL const struct pt_fork *pt_fork_at(struct pt_world w, int number)
{
    BRDF_GLOBAL const void *forks = w.scene + w.settings->forks;
    return (BRDF_GLOBAL const struct pt_fork *)forks + number;
}

/* The probability of the second way, in each lane. */
static inline brdf_real pt_fork_weight(struct pt_world w, BRDF_GLOBAL const struct pt_fork *fork,
                                       struct pt_meeting m)
{
    if (PT_HAS(w.settings, PT_HAS_PLACED_FORKS)) {
        if (PT_HAS(w.settings, PT_HAS_TEXTURES) && fork->kind == PT_FORK_TEXTURE) {
            brdf_rgb value = pt_texture_eval(w, fork->texture, m.at);
            return brdf_clamp(brdf_rgb_luminance(value), 0.0f, 1.0f);
        }
        if (fork->kind == PT_FORK_SIDE) {
            return brdf_pick(brdf_dot(m.at.frame.n, m.ray.d) > 0.0f, 1.0f, 0.0f);
        }
    }
    return fork->weight;
}

/*
 * One number decides all forks on the way: what is left of it after a decision is again uniform.
 * Forks are gone through from the last to the first, as each comes after those it leads to; which
 * lanes stand at it is all that differs between lanes.
 */
static inline void pt_resolve(struct pt_world w, struct pt_pass pass, int packet, int depth)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int active = depth & 1;
    int first_fork = settings->surface_count + 1;
    BRDF_GLOBAL int *keys = w.queues + settings->keys + packet * BRDF_LANES;
    brdf_int key = pt_load_ints(keys);
    if (pt_count_lanes(key >= first_fork) == 0) {
        return;
    }
    brdf_int path =
        pt_queue_paths(w, settings->active[active], packet, w.queues[PT_ACTIVE + active]);
    struct pt_meeting m = pt_meet(w, path, (path < settings->pool) & (key >= first_fork));
    brdf_real u = pt_path_random(w, pass, path, pt_bounce_set(depth)).d;
    for (int i = settings->fork_count - 1; i >= 0; --i) {
        brdf_mask here = key == first_fork + i;
        if (pt_count_lanes(here) == 0) {
            continue;
        }
        BRDF_GLOBAL const struct pt_fork *fork = pt_fork_at(w, i);
        brdf_real weight = pt_fork_weight(w, fork, m);
        brdf_mask second = u < weight;
        brdf_real from = brdf_pick(second, 0.0f, weight);
        brdf_real share = brdf_pick(second, weight, 1.0f - weight);
        brdf_real rest = brdf_min((u - from) / brdf_max(share, 1e-30f), BRDF_ONE_MINUS_ULP);
        u = brdf_pick(here, rest, u);
        key = brdf_pick_int(here, brdf_pick_int(second, fork->second, fork->first), key);
    }
    pt_store_ints(keys, key);
}

#endif
