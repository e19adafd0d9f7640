/*
 * generate.h - stage 1: a path starts at the camera.
 *
 * reads: the pass; writes: record, radiance = 0 and active queue entry of a packet of paths.
 */
#ifndef PT_GENERATE_H
#define PT_GENERATE_H

#include "brdf/math.h"
#include "path.h"

/*
 * Where in the filter's support a sample lies [pixels from the centre]: distributed as the filter
 * itself, so that every sample counts the same [Ernst et al. 2006, filter importance sampling].
 */
static inline brdf_real pt_filter_offset(BRDF_GLOBAL const struct pt_settings *settings,
                                         brdf_real u)
{
    if (settings->filter == PT_FILTER_TENT) {
        brdf_mask left = u < 0.5f;
        brdf_real rising = sqrtf(2.0f * u) - 1.0f;
        brdf_real falling = 1.0f - sqrtf(brdf_max(2.0f - 2.0f * u, 0.0f));
        return settings->filter_radius * brdf_pick(left, rising, falling);
    }
    if (settings->filter == PT_FILTER_GAUSSIAN) {
        brdf_real scale = settings->filter_sigma * 1.41421356f;
        brdf_real limit = brdf_erf(settings->filter_radius / scale);
        return scale * brdf_erfinv((2.0f * u - 1.0f) * limit);
    }
    return settings->filter_radius * (2.0f * u - 1.0f);
}

static inline void pt_generate(struct pt_world w, struct pt_pass pass, int packet)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    brdf_int path = packet * BRDF_LANES + brdf_lane_numbers();
    brdf_mask used = path < pass.path_count;
    pt_store_ints(w.queues + settings->active[0] + packet * BRDF_LANES, path);
    path = brdf_pick_int(used, path, settings->pool);

    brdf_int pixel = pt_pixel_of(pass, path);
    brdf_int y = pixel / settings->width;
    brdf_int x = pixel - y * settings->width;
    struct pt_random r = pt_path_random(w, pass, path, 0);
    brdf_real film_x = brdf_to_real(x) + 0.5f + pt_filter_offset(settings, r.a);
    brdf_real film_y = brdf_to_real(y) + 0.5f + pt_filter_offset(settings, r.b);
    film_x = film_x / (float)settings->width;
    film_y = film_y / (float)settings->height;

    BRDF_GLOBAL const float *corner = settings->camera_corner;
    BRDF_GLOBAL const float *right = settings->camera_right;
    BRDF_GLOBAL const float *down = settings->camera_down;
    BRDF_GLOBAL const float *origin = settings->camera_origin;
    brdf_vec3 d = brdf_vec3_make(corner[0] + film_x * right[0] + film_y * down[0],
                                 corner[1] + film_x * right[1] + film_y * down[1],
                                 corner[2] + film_x * right[2] + film_y * down[2]);
    brdf_vec3 o = brdf_vec3_make(origin[0], origin[1], origin[2]);

    brdf_int record = path * PT_PATH_WORDS;
    pt_store_quad(w.paths + PT_PATH_ORIGIN, record, pt_quad_of_vec3(o, -1.0f));
    pt_store_quad(w.paths + PT_PATH_DIRECTION, record, pt_quad_of_vec3(brdf_normalize(d), 1.0f));
    pt_store_quad(w.paths + PT_PATH_THROUGHPUT, record, brdf_quad_make(1.0f, 1.0f, 1.0f, 0.0f));
    pt_store_quad(w.radiance, path * 4, brdf_quad_make(0.0f, 0.0f, 0.0f, 0.0f));
}

#endif
