/*
 * texture_gradient.h - how the brightness of a picture changes with texture coordinates.
 *
 * The derivative of the bilinear interpolation in texture_bitmap.h, as in Mitsuba 3; pictures that
 * are looked up at the nearest texel are flat.
 */
#ifndef PT_TEXTURE_GRADIENT_H
#define PT_TEXTURE_GRADIENT_H

#include "texture.h"

struct pt_gradient {
    brdf_real u;
    brdf_real v;
};

/* Whether the picture runs backwards here. */
static inline brdf_real pt_wrap_direction(int wrap, brdf_real x)
{
    if (wrap == PT_WRAP_MIRROR) {
        brdf_real there = x - 2.0f * brdf_floor(0.5f * x);
        return brdf_pick(there > 1.0f, -1.0f, 1.0f);
    }
    return 1.0f;
}

/* By the surface's u and v, of bitmap `number`. */
static inline struct pt_gradient pt_texture_gradient(struct pt_world w, int number,
                                                     struct pt_interaction at)
{
    BRDF_GLOBAL const struct pt_texture *texture = pt_texture_at(w, number);
    BRDF_GLOBAL const float *m = texture->to_uv;
    int wrap = texture->wrap;
    struct pt_gradient gradient = {0.0f, 0.0f};
    if (texture->nearest) {
        return gradient;
    }
    brdf_real u = m[0] * at.u + m[1] * at.v + m[2];
    brdf_real v = m[3] * at.u + m[4] * at.v + m[5];
    struct pt_neighbours x = pt_bilinear_of(wrap, texture->width, u);
    struct pt_neighbours y = pt_bilinear_of(wrap, texture->height, v);
    brdf_real by_x = 0.0f;
    brdf_real by_y = 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
        int right = corner & 1;
        int lower = corner >> 1;
        brdf_real value = brdf_rgb_luminance(
            pt_texel(w, texture, right ? x.second : x.first, lower ? y.second : y.first));
        brdf_real along_x = value * (lower ? y.between : 1.0f - y.between);
        brdf_real along_y = value * (right ? x.between : 1.0f - x.between);
        by_x = by_x + (right ? along_x : -along_x);
        by_y = by_y + (lower ? along_y : -along_y);
    }
    by_x = by_x * (float)texture->width * pt_wrap_direction(wrap, u);
    by_y = by_y * (float)texture->height * pt_wrap_direction(wrap, v);
    gradient.u = m[0] * by_x + m[3] * by_y;
    gradient.v = m[1] * by_x + m[4] * by_y;
    return gradient;
}

#endif
