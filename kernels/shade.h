/*
 * shade.h - stage 4: what happens where a path met a surface, or nothing.
 *
 * reads: a packet of paths that met the same surface, with their hits; writes: the radiance found
 * there, a shadow ray for next-event estimation, and the path's next ray (active queue).
 *
 * The model, its flags and its choices are constants of each specialised kernel, so that the
 * dispatch in brdf/model.h folds away.
 */
#ifndef PT_SHADE_H
#define PT_SHADE_H

#include "brdf/surface.h"
#include "light.h"
#include "texture.h"
#include "tilt.h"

/* What the kernels of a variant have in common; constants there. */
struct pt_variant {
    unsigned model;
    unsigned flags;
    unsigned choices;
    int number;
    unsigned textured; /* texture.h: bit i is set where a texture sets word i of the material */
    unsigned colors;   /* and bit i here where it sets the two words behind, too */
    unsigned tilt;     /* PT_TILT_... */
};

/* Append the paths of the lanes in the mask to the queue of the next bounce. */
static inline void pt_continue(struct pt_world w, brdf_int path, brdf_mask alive, int depth)
{
    int next = (depth + 1) & 1;
    union pt_lanes alive_lanes = pt_lanes_of(alive);
    union pt_lanes path_lanes = pt_lanes_of(path);
    int count = pt_count_lanes(alive);
    int place = pt_claim(w.queues + PT_ACTIVE + next, count);
    BRDF_GLOBAL int *queue = w.queues + w.settings->active[next];
    if (count == BRDF_LANES) {
        pt_store_ints(queue + place, path);
        return;
    }
    for (int k = 0; k < BRDF_LANES; ++k) {
        if (alive_lanes.lane[k]) {
            queue[place] = path_lanes.lane[k];
            ++place;
        }
    }
}

/* Shadow rays end a little before the light, which must not shadow itself. */
#define PT_SHADOW_SHORTER 0.9995f

struct pt_shadow_ray {
    struct pt_ray ray;
    brdf_real length; /* up to which the way must be free */
};

/*
 * From where a ray leaves the surface to the very point of the light that was chosen. The direction
 * as seen from the surface's point would not do: of a light near the surface, or at the rim of a
 * sphere, it meets from there another point, before the end.
 */
static inline struct pt_shadow_ray pt_shadow_ray_make(struct pt_interaction at,
                                                      struct pt_light_sample light)
{
    struct pt_shadow_ray shadow;
    brdf_mask near = light.length < PT_MISS_T;
    shadow.ray.o = pt_leave(at, light.wi);
    brdf_vec3 moved = brdf_sub(shadow.ray.o, at.p);
    brdf_vec3 to = brdf_sub(brdf_scale(light.wi, brdf_pick(near, light.length, 1.0f)), moved);
    brdf_real length = sqrtf(brdf_max(brdf_dot(to, to), 1e-30f));
    shadow.ray.d = brdf_vec3_pick(near, brdf_scale(to, 1.0f / length), light.wi);
    shadow.length = brdf_pick(near, length * PT_SHADOW_SHORTER, PT_MISS_T);
    return shadow;
}

/* Append a shadow ray for each lane in the mask. */
static inline void pt_ask_shadow(struct pt_world w, brdf_int path, brdf_mask asks,
                                 struct pt_shadow_ray shadow, brdf_rgb radiance)
{
    int count = pt_count_lanes(asks);
    if (count == 0) {
        return;
    }
    int place = pt_claim(w.queues + PT_SHADOWS, count);
    union pt_lanes places = pt_lanes_of(place + brdf_lane_numbers());
    if (count < BRDF_LANES) {
        union pt_lanes ask_lanes = pt_lanes_of(asks);
        for (int k = 0; k < BRDF_LANES; ++k) {
            int asking = ask_lanes.lane[k] != 0;
            places.lane[k] = asking ? place : w.settings->pool;
            place += asking;
        }
    }
    brdf_int record = places.v * PT_SHADOW_WORDS;
    pt_store_quad(w.shadows + PT_SHADOW_ORIGIN, record,
                  pt_quad_of_vec3(shadow.ray.o, shadow.length));
    pt_store_quad(w.shadows + PT_SHADOW_DIRECTION, record,
                  pt_quad_of_vec3(shadow.ray.d, brdf_from_bits(path)));
    pt_store_quad(w.shadows + PT_SHADOW_RADIANCE, record, pt_quad_of_rgb(radiance, 0.0f));
}

/* The radiance that the surface emits itself towards the ray, weighted against next-event
   estimation, which might have found it as well. */
static inline void pt_shade_emission(struct pt_world w,
                                     BRDF_GLOBAL const struct pt_surface *surface, brdf_int path,
                                     struct pt_meeting m)
{
    brdf_rgb emitted =
        brdf_rgb_make(surface->radiance[0], surface->radiance[1], surface->radiance[2]);
    brdf_real light_pdf = pt_light_density(w.settings, m.primitive, m.ray, m.hit.a);
    brdf_real weight = brdf_pick(m.pdf < 0.0f, 1.0f, pt_mis(m.pdf, light_pdf));
    weight = brdf_pick(brdf_dot(m.at.ng, m.ray.d) < 0.0f, weight, 0.0f);
    pt_add_radiance(w, path, brdf_rgb_scale(brdf_rgb_mul(m.throughput, emitted), weight));
}

/* Paths that met nothing gain what comes from the environment, and end. */
static inline void pt_shade_missed(struct pt_world w, int packet)
{
    brdf_int path = pt_load_ints(w.queues + w.settings->packet_paths + packet * BRDF_LANES);
    brdf_int record = path * PT_PATH_WORDS;
    struct brdf_quad origin = brdf_gather_quad(w.paths + PT_PATH_ORIGIN, record);
    struct brdf_quad direction = brdf_gather_quad(w.paths + PT_PATH_DIRECTION, record);
    struct brdf_quad throughput = brdf_gather_quad(w.paths + PT_PATH_THROUGHPUT, record);
    brdf_real light_pdf;
    brdf_rgb radiance = pt_environment_radiance(w, pt_quad_vec3(direction), &light_pdf);
    brdf_real weight = brdf_pick(origin.d < 0.0f, 1.0f, pt_mis(origin.d, light_pdf));
    pt_add_radiance(w, path,
                    brdf_rgb_scale(brdf_rgb_mul(pt_quad_rgb(throughput), radiance), weight));
}

/* Russian roulette: the factor of the throughput, 0 where the path ends. As in Mitsuba 3. */
static inline brdf_real pt_roulette(brdf_rgb throughput, brdf_real eta, brdf_real u)
{
    brdf_real survive = brdf_min(brdf_rgb_largest(throughput) * eta * eta, 0.95f);
    return brdf_pick(u < survive, 1.0f / brdf_max(survive, 1e-6f), 0.0f);
}

/* A packet of paths where they met one surface. */
struct pt_arrival {
    BRDF_GLOBAL const struct pt_surface *surface;
    brdf_int path;
    brdf_mask used; /* the lanes that hold a path */
    struct pt_meeting m;
};

/* What every surface begins with: the paths gain what it emits itself. */
static inline struct pt_arrival pt_arrive(struct pt_world w, int packet)
{
    struct pt_arrival a;
    a.surface = pt_surface_at(w, w.queues[w.settings->packet_surface + packet]);
    a.path = pt_load_ints(w.queues + w.settings->packet_paths + packet * BRDF_LANES);
    a.used = a.path < w.settings->pool;
    a.m = pt_meet(w, a.path, a.used);
    if (a.surface->emits) {
        pt_shade_emission(w, a.surface, a.path, a.m);
    }
    return a;
}

/* What scatters light there: the material's own values, and the frame that it stands in. */
struct pt_scatterer {
    brdf_parameters p;
    BRDF_GLOBAL const float *table;
    struct pt_tilt tilt;
    struct pt_interaction at; /* in the tilted frame */
    brdf_vec3 wo;             /* in that frame, too */
};

static inline struct pt_scatterer pt_scatterer_at(struct pt_world w, struct pt_variant variant,
                                                  struct pt_arrival a)
{
    struct pt_scatterer b;
    brdf_vec3 back = brdf_negate(a.m.ray.d);
    b.tilt = variant.tilt ? pt_tilt_at(w, variant.tilt, a.surface, a.m) : pt_tilt_none(a.m.at);
    b.at = a.m.at;
    b.at.frame = b.tilt.frame;
    b.wo = brdf_to_local(b.at.frame, back);
    b.p = brdf_parameters_load(variant.model, variant.choices, a.surface->material.word);
    if (variant.textured) {
        b.p = pt_textured_parameters(w, variant.model, variant.textured, variant.colors,
                                     a.surface->bindings, pt_seen_side(variant.flags, b.at, back),
                                     b.p);
    }
    b.table = w.tables + a.surface->material.table;
    return b;
}

/* Next-event estimation: a shadow ray to a point of some light, with what would come along it. */
static inline void pt_shade_light(struct pt_world w, struct pt_variant variant, struct pt_arrival a,
                                  struct pt_scatterer b, struct pt_light_sample light)
{
    brdf_vec3 wi = brdf_to_local(b.at.frame, light.wi);
    brdf_rgb f = brdf_surface_eval(variant.model, variant.flags, b.p, b.wo, wi, b.table);
    if (variant.tilt) {
        f = brdf_rgb_scale(f, pt_tilt_factor(b.tilt, light.wi, wi));
    }
    brdf_real pdf = brdf_surface_pdf(variant.model, variant.flags, b.p, b.wo, wi, b.table);
    brdf_mask possible = a.used & (light.pdf > 0.0f);
    brdf_real scale = fabsf(wi.z) * pt_mis(light.pdf, pdf) / brdf_pick(possible, light.pdf, 1.0f);
    brdf_rgb radiance =
        brdf_rgb_scale(brdf_rgb_mul(brdf_rgb_mul(a.m.throughput, f), light.radiance), scale);
    pt_ask_shadow(w, a.path, possible & (brdf_rgb_largest(radiance) > 0.0f),
                  pt_shadow_ray_make(b.at, light), radiance);
}

static inline void pt_shade(struct pt_world w, struct pt_pass pass, struct pt_variant variant,
                            int packet, int depth)
{
    struct pt_arrival a = pt_arrive(w, packet);
    if (depth + 1 >= w.settings->max_depth) {
        return;
    }
    struct pt_scatterer b = pt_scatterer_at(w, variant, a);
    int set = pt_bounce_set(depth);
    struct pt_random choose = pt_path_random(w, pass, a.path, set);
    struct pt_random place = pt_path_random(w, pass, a.path, set + 1);

    int lights = PT_HAS(w.settings, PT_HAS_LIGHTS | PT_HAS_CONSTANT | PT_HAS_MAP) != 0;
    if (lights & !(variant.flags & BRDF_DELTA)) {
        pt_shade_light(w, variant, a, b, pt_sample_light(w, b.at.p, choose.a, place.a, place.b));
    }

    struct brdf_sample s = brdf_surface_sample(variant.model, variant.flags, b.p, b.wo,
                                               brdf_vec3_make(place.c, place.d, choose.b), b.table);
    brdf_vec3 next = brdf_normalize(brdf_to_world(b.at.frame, s.wi));
    if (variant.tilt) {
        s.weight = brdf_rgb_scale(s.weight, pt_tilt_factor(b.tilt, next, s.wi));
    }
    brdf_rgb throughput = brdf_rgb_mul(a.m.throughput, s.weight);
    brdf_real eta = a.m.eta * s.eta;
    if (depth + 1 >= w.settings->rr_depth) {
        throughput = brdf_rgb_scale(throughput, pt_roulette(throughput, eta, choose.c));
    }
    brdf_real pdf = brdf_pick(s.delta, -1.0f, s.pdf);
    brdf_mask alive = a.used & (s.pdf > 0.0f) & (brdf_rgb_largest(throughput) > 0.0f);
    brdf_int record = a.path * PT_PATH_WORDS;
    pt_store_quad(w.paths + PT_PATH_ORIGIN, record, pt_quad_of_vec3(pt_leave(b.at, next), pdf));
    pt_store_quad(w.paths + PT_PATH_DIRECTION, record, pt_quad_of_vec3(next, eta));
    pt_store_quad(w.paths + PT_PATH_THROUGHPUT, record, pt_quad_of_rgb(throughput, 0.0f));
    pt_continue(w, a.path, alive, depth);
}

#endif
