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

static inline brdf_real pt_texel_luminance(struct pt_world w,
                                           BRDF_GLOBAL const struct pt_texture *texture, brdf_int x,
                                           brdf_int y)
{
    return brdf_rgb_luminance(pt_texel(w, texture, x, y));
}

/* By the surface's u and v, of bitmap `number`. */
static inline struct pt_gradient pt_texture_gradient(struct pt_world w, int number,
                                                     struct pt_interaction at)
{
    BRDF_GLOBAL const struct pt_texture *texture = pt_texture_at(w, number);
    BRDF_GLOBAL const float *m = texture->to_uv;
    brdf_real u = m[0] * at.u + m[1] * at.v + m[2];
    brdf_real v = m[3] * at.u + m[4] * at.v + m[5];
    struct pt_neighbours x = pt_neighbours_of(texture->wrap, texture->width, u);
    struct pt_neighbours y = pt_neighbours_of(texture->wrap, texture->height, v);
    brdf_real f00 = pt_texel_luminance(w, texture, x.first, y.first);
    brdf_real f10 = pt_texel_luminance(w, texture, x.second, y.first);
    brdf_real f01 = pt_texel_luminance(w, texture, x.first, y.second);
    brdf_real f11 = pt_texel_luminance(w, texture, x.second, y.second);
    brdf_real by_x = (f10 - f00) * (1.0f - y.between) + (f11 - f01) * y.between;
    brdf_real by_y = (f01 - f00) * (1.0f - x.between) + (f11 - f10) * x.between;
    by_x = by_x * (float)texture->width * pt_wrap_direction(texture->wrap, u);
    by_y = by_y * (float)texture->height * pt_wrap_direction(texture->wrap, v);
    struct pt_gradient gradient;
    float smooth = texture->nearest ? 0.0f : 1.0f;
    gradient.u = (m[0] * by_x + m[3] * by_y) * smooth;
    gradient.v = (m[1] * by_x + m[4] * by_y) * smooth;
    return gradient;
}

#endif
