/*
 * woodgrain.h - a solid texture of wood: rings around a trunk, and the fibres that run along it.
 *
 * Where a tree stood straight, its fibres would be parallel to the trunk's axis (z) and its rings
 * circles around it. Here every fibre is moved sideways by d(x, y, z), a smooth noise that is long
 * along z, and all else follows it: the rings are looked up at the place the fibre comes from, and
 * the fibre's direction is (dd_x/dz, dd_y/dz, 1). So the highlight of a model of wood moves with
 * the pattern that is seen, as it does in figured wood. Ring borders wander by a second noise; a
 * third, as fine as fibres, darkens streaks.
 */
#ifndef PT_WOODGRAIN_H
#define PT_WOODGRAIN_H

#include "brdf/math.h"
#include "interaction.h"
#include "random.h"
#include "texture_record.h"

/* Two independent noises at a place, in [-1, 1], and how they change along z. */
struct pt_noise {
    brdf_real a;
    brdf_real b;
    brdf_real a_z;
    brdf_real b_z;
};

/* Beyond this many cells lattice points are not whole numbers any more. */
#define PT_NOISE_FAR 4.0e6f

/* A coordinate as the lower of two lattice points, and the weight of the upper, which is
   6 t^5 - 15 t^4 + 10 t^3 [Perlin 2002], with its slope. */
struct pt_cell {
    brdf_int lower;
    brdf_real upper;
    brdf_real slope;
};

static inline struct pt_cell pt_cell_of(brdf_real x)
{
    struct pt_cell cell;
    x = brdf_clamp(x, -PT_NOISE_FAR, PT_NOISE_FAR);
    brdf_real lower = brdf_floor(x);
    brdf_real t = x - lower;
    cell.lower = brdf_to_int(lower);
    cell.upper = t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
    cell.slope = 30.0f * t * t * (t - 1.0f) * (t - 1.0f);
    return cell;
}

/* Random values at lattice points, interpolated. */
static inline struct pt_noise pt_noise_at(brdf_vec3 p, int seed)
{
    struct pt_cell x = pt_cell_of(p.x);
    struct pt_cell y = pt_cell_of(p.y);
    struct pt_cell z = pt_cell_of(p.z);
    struct pt_noise noise = {0.0f, 0.0f, 0.0f, 0.0f};
    brdf_uint seed_bits = brdf_uint_of((brdf_int)seed);
    /* A loop, so that a kernel holds one hash and not eight. */
    for (int corner = 0; corner < 8; ++corner) {
        int i = corner & 1;
        int j = corner >> 1 & 1;
        int k = corner >> 2;
        struct pt_bits4 h = pt_hash4(brdf_uint_of(x.lower + i), brdf_uint_of(y.lower + j),
                                     brdf_uint_of(z.lower + k), seed_bits);
        brdf_real a = 2.0f * pt_unit(h.x) - 1.0f;
        brdf_real b = 2.0f * pt_unit(h.y) - 1.0f;
        brdf_real plane = (i ? x.upper : 1.0f - x.upper) * (j ? y.upper : 1.0f - y.upper);
        brdf_real weight = plane * (k ? z.upper : 1.0f - z.upper);
        brdf_real change = plane * (k ? z.slope : -z.slope);
        noise.a = noise.a + weight * a;
        noise.b = noise.b + weight * b;
        noise.a_z = noise.a_z + change * a;
        noise.b_z = noise.b_z + change * b;
    }
    return noise;
}

/* What the wood is at one place. */
struct pt_grain {
    brdf_real late;   /* 0 in early wood, up to 1 in late wood, which is darker and denser */
    brdf_real streak; /* how dark a streak is here, 0 to 1 */
    brdf_vec3 axis;   /* of the fibres, unit, in the local frame of the surface */
};

static inline brdf_vec3 pt_log_point(BRDF_GLOBAL const float *m, brdf_vec3 p)
{
    return brdf_vec3_make(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
                          m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
                          m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]);
}

static inline brdf_vec3 pt_log_direction(BRDF_GLOBAL const float *m, brdf_vec3 v)
{
    return brdf_vec3_make(m[0] * v.x + m[1] * v.y + m[2] * v.z,
                          m[3] * v.x + m[4] * v.y + m[5] * v.z,
                          m[6] * v.x + m[7] * v.y + m[8] * v.z);
}

/* How late in its year the wood grew at `rings`, counted from the pith: slowly later, then within
   the last tenth of the ring, the winter, all at once early again. */
static inline brdf_real pt_ring_late(brdf_real rings)
{
    brdf_real year = rings - brdf_floor(rings);
    brdf_real winter = brdf_clamp((year - 0.9f) * 10.0f, 0.0f, 1.0f);
    return year * year * year * (1.0f - winter * winter * (3.0f - 2.0f * winter));
}

static inline struct pt_grain pt_grain_at(BRDF_GLOBAL const struct pt_texture *texture,
                                          struct pt_interaction at)
{
    BRDF_GLOBAL const float *size = texture->sizes;
    brdf_vec3 p = pt_log_point(texture->log_from_world, at.p);

    /* Sideways: as wide as a few rings, as long as the figure. Where neighbours are -1 and 1, the
       noise rises by 2 within a cell, and by 15/8 of that in the middle: 3.75 is the steepest. */
    brdf_real wide = 1.0f / (6.0f * size[PT_GRAIN_RING]);
    brdf_real lengthwise = 1.0f / size[PT_GRAIN_FIGURE_LENGTH];
    struct pt_noise aside =
        pt_noise_at(brdf_vec3_make(p.x * wide, p.y * wide, p.z * lengthwise), texture->seed);
    brdf_real slope = size[PT_GRAIN_FIGURE] * (1.0f / 3.75f);
    brdf_vec3 along = brdf_vec3_make(slope * aside.a_z, slope * aside.b_z, 1.0f);
    brdf_real amount = slope * size[PT_GRAIN_FIGURE_LENGTH];
    brdf_vec3 q = brdf_vec3_make(p.x - amount * aside.a, p.y - amount * aside.b, p.z);

    brdf_real ring = 1.0f / size[PT_GRAIN_RING];
    struct pt_noise wander = pt_noise_at(
        brdf_scale(brdf_vec3_make(q.x, q.y, 0.1f * q.z), 0.25f * ring), texture->seed + 1);
    brdf_real rings = sqrtf(q.x * q.x + q.y * q.y) * ring + size[PT_GRAIN_WANDER] * wander.a;

    brdf_real fine = 8.0f * ring;
    struct pt_noise fibers =
        pt_noise_at(brdf_vec3_make(q.x * fine, q.y * fine, q.z * fine * 0.02f), texture->seed + 2);

    struct pt_grain grain;
    grain.late = pt_ring_late(brdf_clamp(rings, -PT_NOISE_FAR, PT_NOISE_FAR));
    grain.streak = 0.5f + 0.5f * fibers.a;
    grain.axis = brdf_normalize(
        brdf_to_local(at.frame, brdf_normalize(pt_log_direction(texture->world_from_log, along))));
    return grain;
}

static inline brdf_rgb pt_grain_color(struct pt_grain grain, BRDF_GLOBAL const float *early,
                                      BRDF_GLOBAL const float *late, float streaks)
{
    brdf_rgb c = brdf_rgb_make(brdf_mix(early[0], late[0], grain.late),
                               brdf_mix(early[1], late[1], grain.late),
                               brdf_mix(early[2], late[2], grain.late));
    return brdf_rgb_scale(c, 1.0f - streaks * grain.streak);
}

/* One of the things that a grain can set. */
static inline brdf_rgb pt_grain_output(BRDF_GLOBAL const struct pt_texture *texture,
                                       struct pt_grain grain, int output)
{
    float streaks = texture->sizes[PT_GRAIN_STREAKS];
    switch (output) {
    case PT_GRAIN_COLOR:
        return pt_grain_color(grain, texture->color0, texture->color1, streaks);
    case PT_GRAIN_FIBER_COLOR:
        return pt_grain_color(grain, texture->fiber0, texture->fiber1, streaks);
    case PT_GRAIN_FIBER_AXIS:
        return brdf_rgb_make(0.5f + 0.5f * grain.axis.x, 0.5f + 0.5f * grain.axis.y,
                             0.5f + 0.5f * grain.axis.z);
    case PT_GRAIN_BETA:
        return brdf_gray(brdf_mix(texture->beta[0], texture->beta[1], grain.late));
    case PT_GRAIN_ALPHA:
        return brdf_gray(brdf_mix(texture->alpha[0], texture->alpha[1], grain.late));
    default:
        return brdf_gray(grain.late);
    }
}

#endif
