/*
 * environment.h - light from infinitely far: constant, or a latitude-longitude map.
 *
 * The map is Mitsuba 3's: in its own frame u = atan2(x, -z) / 2 pi, v = acos(y) / pi; columns have
 * their centres at half integers and wrap around, while rows 0 and height - 1 lie on the poles. In
 * between it is bilinear. Next-event estimation chooses a cell between four pixels (width columns
 * by height - 1 rows) by their mean luminance times sin(theta), and a point uniformly in the cell.
 */
#ifndef PT_ENVIRONMENT_H
#define PT_ENVIRONMENT_H

#include "brdf/math.h"
#include "brdf/warp.h"
#include "intersect.h"
#include "path.h"
#include "search.h"

struct pt_light_sample {
    brdf_vec3 wi;      /* towards the light, unit, world space */
    brdf_real length;  /* how far away it is; PT_MISS_T: infinitely far */
    brdf_rgb radiance; /* that comes from there */
    brdf_real pdf;     /* [1/sr], with the probability of choosing the light; 0 = nothing there */
};

static inline brdf_vec3 pt_environment_to_map(BRDF_GLOBAL const struct pt_settings *settings,
                                              brdf_vec3 w)
{
    BRDF_GLOBAL const float *m = settings->environment_to_world;
    return brdf_vec3_make(m[0] * w.x + m[3] * w.y + m[6] * w.z,
                          m[1] * w.x + m[4] * w.y + m[7] * w.z,
                          m[2] * w.x + m[5] * w.y + m[8] * w.z);
}

static inline brdf_vec3 pt_environment_to_world(BRDF_GLOBAL const struct pt_settings *settings,
                                                brdf_vec3 w)
{
    BRDF_GLOBAL const float *m = settings->environment_to_world;
    return brdf_vec3_make(m[0] * w.x + m[1] * w.y + m[2] * w.z,
                          m[3] * w.x + m[4] * w.y + m[5] * w.z,
                          m[6] * w.x + m[7] * w.y + m[8] * w.z);
}

/* A place on the map: a cell, and where in it. */
struct pt_map_place {
    brdf_int column; /* left pixel column, 0 .. width - 1 */
    brdf_int row;    /* upper pixel row, 0 .. height - 2 */
    brdf_real x;     /* 0 at the left column, 1 at the right */
    brdf_real y;     /* 0 at the upper row, 1 at the lower */
};

static inline struct pt_map_place pt_map_locate(BRDF_GLOBAL const struct pt_settings *settings,
                                                brdf_vec3 w)
{
    int width = settings->environment_width;
    int cells = settings->environment_height - 1;
    brdf_real turn = brdf_atan2(w.x, -w.z) * (0.5f * BRDF_1_PI) - 0.5f / (float)width;
    brdf_real x = (turn - brdf_floor(turn)) * (float)width;
    brdf_real y = brdf_acos(w.y) * BRDF_1_PI * (float)cells;
    brdf_real column = brdf_clamp(brdf_floor(x), 0.0f, (float)(width - 1));
    brdf_real row = brdf_clamp(brdf_floor(y), 0.0f, (float)(cells - 1));
    struct pt_map_place place;
    place.column = brdf_to_int(column);
    place.row = brdf_to_int(row);
    place.x = brdf_clamp(x - column, 0.0f, 1.0f);
    place.y = brdf_clamp(y - row, 0.0f, 1.0f);
    return place;
}

static inline brdf_rgb pt_map_pixel(struct pt_world w, brdf_int column, brdf_int row)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    brdf_int pixel = row * settings->environment_width + column;
    return pt_quad_rgb(brdf_gather_quad(w.scene + settings->environment_texels, pixel * 4));
}

static inline brdf_rgb pt_map_radiance(struct pt_world w, struct pt_map_place place)
{
    brdf_int right = place.column + 1;
    right = brdf_pick_int(right < w.settings->environment_width, right, 0);
    brdf_rgb upper =
        brdf_rgb_add(brdf_rgb_scale(pt_map_pixel(w, place.column, place.row), 1.0f - place.x),
                     brdf_rgb_scale(pt_map_pixel(w, right, place.row), place.x));
    brdf_rgb lower =
        brdf_rgb_add(brdf_rgb_scale(pt_map_pixel(w, place.column, place.row + 1), 1.0f - place.x),
                     brdf_rgb_scale(pt_map_pixel(w, right, place.row + 1), place.x));
    return brdf_rgb_add(brdf_rgb_scale(upper, 1.0f - place.y), brdf_rgb_scale(lower, place.y));
}

/* From the probability of a cell to [1/sr] at a direction of the map's frame. */
static inline brdf_real pt_map_density(BRDF_GLOBAL const struct pt_settings *settings,
                                       brdf_real mass, brdf_vec3 w)
{
    brdf_real cells =
        (float)settings->environment_width * (float)(settings->environment_height - 1);
    brdf_real sine = sqrtf(brdf_max(1.0f - w.y * w.y, 1e-12f));
    return mass * cells * (0.5f * BRDF_1_PI * BRDF_1_PI) / sine;
}

static inline brdf_real pt_cdf_mass(struct pt_world w, brdf_int first)
{
    return brdf_gather(w.scene, first + 1) - brdf_gather(w.scene, first);
}

static inline brdf_int pt_map_row_cdf(struct pt_world w, brdf_int row)
{
    return w.settings->environment_columns + row * (w.settings->environment_width + 1);
}

/* Radiance from direction `d`, and the density with which next-event estimation chooses it. */
static inline brdf_rgb pt_environment_radiance(struct pt_world w, brdf_vec3 d, brdf_real *pdf)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    if (PT_HAS(settings, PT_HAS_MAP)) {
        brdf_vec3 in_map = pt_environment_to_map(settings, d);
        struct pt_map_place place = pt_map_locate(settings, in_map);
        brdf_real mass = pt_cdf_mass(w, settings->environment_rows + place.row) *
                         pt_cdf_mass(w, pt_map_row_cdf(w, place.row) + place.column);
        *pdf = settings->environment_select * pt_map_density(settings, mass, in_map);
        return pt_map_radiance(w, place);
    }
    BRDF_GLOBAL const float *rgb = settings->environment_radiance;
    *pdf = settings->environment_select * (0.25f * BRDF_1_PI);
    return brdf_rgb_make(rgb[0], rgb[1], rgb[2]);
}

/* A direction to the environment for u, v in [0, 1). */
static inline struct pt_light_sample pt_environment_sample(struct pt_world w, brdf_real u,
                                                           brdf_real v)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    struct pt_light_sample s;
    s.length = PT_MISS_T;
    if (PT_HAS(settings, PT_HAS_MAP)) {
        int width = settings->environment_width;
        int cells = settings->environment_height - 1;
        struct pt_choice row = pt_search(w.scene, settings->environment_rows, cells,
                                         settings->environment_row_steps, v);
        struct pt_choice column = pt_search(w.scene, pt_map_row_cdf(w, row.index), width,
                                            settings->environment_column_steps, u);
        struct pt_map_place place;
        place.column = column.index;
        place.row = row.index;
        place.x = column.remainder;
        place.y = row.remainder;
        brdf_real turn = (brdf_to_real(place.column) + 0.5f + place.x) / (float)width;
        brdf_real half_turn = (brdf_to_real(place.row) + place.y) / (float)cells;
        struct brdf_sincos phi = brdf_sincos_2pi(turn);
        struct brdf_sincos theta = brdf_sincos_2pi(0.5f * half_turn);
        brdf_vec3 in_map = brdf_vec3_make(phi.sin * theta.sin, theta.cos, -(phi.cos * theta.sin));
        s.wi = brdf_normalize(pt_environment_to_world(settings, in_map));
        s.radiance = pt_map_radiance(w, place);
        s.pdf =
            settings->environment_select * pt_map_density(settings, row.mass * column.mass, in_map);
        return s;
    }
    BRDF_GLOBAL const float *rgb = settings->environment_radiance;
    s.wi = brdf_warp_sphere(u, v);
    s.radiance = brdf_rgb_make(rgb[0], rgb[1], rgb[2]);
    s.pdf = settings->environment_select * (0.25f * BRDF_1_PI);
    return s;
}

#endif
