/*
 * meeting.h - a path where it met a surface: what stages read of its record, and the place itself.
 */
#ifndef PT_MEETING_H
#define PT_MEETING_H

#include "interaction.h"

struct pt_meeting {
    struct pt_ray ray;
    struct brdf_quad hit; /* distance, two coordinates, the primitive's number */
    brdf_real pdf;        /* PT_PATH_PDF */
    brdf_real eta;        /* PT_PATH_ETA */
    brdf_rgb throughput;
    struct pt_primitive primitive;
    struct pt_interaction at;
};

/* `met` tells which lanes have a path that met something; the others get some place. */
static inline struct pt_meeting pt_meet(struct pt_world w, brdf_int path, brdf_mask met)
{
    struct pt_meeting m;
    brdf_int record = path * PT_PATH_WORDS;
    struct brdf_quad origin = brdf_gather_quad(w.paths + PT_PATH_ORIGIN, record);
    struct brdf_quad direction = brdf_gather_quad(w.paths + PT_PATH_DIRECTION, record);
    m.hit = brdf_gather_quad(w.paths + PT_PATH_HIT_T, record);
    m.throughput = pt_quad_rgb(brdf_gather_quad(w.paths + PT_PATH_THROUGHPUT, record));
    m.ray.o = pt_quad_vec3(origin);
    m.ray.d = pt_quad_vec3(direction);
    m.pdf = origin.d;
    m.eta = direction.d;
    m.primitive = pt_load_primitive(w, brdf_pick_int(met, brdf_bits(m.hit.d), 0));
    m.at = pt_interact(w, m.primitive, m.ray, m.hit);
    return m;
}

#endif
