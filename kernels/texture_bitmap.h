/*
 * texture_bitmap.h - looking up a picture: bilinear or nearest; repeated, mirrored or clamped.
 *
 * As in Mitsuba 3: texel (x, y) covers [x, x + 1] / width by [y, y + 1] / height with its centre in
 * the middle, and row 0, the uppermost of the file, lies at v = 0.
 */
#ifndef PT_TEXTURE_BITMAP_H
#define PT_TEXTURE_BITMAP_H

#include "brdf/math.h"
#include "path.h"
#include "texture_record.h"

/* Into [0, 1], where the picture is. */
static inline brdf_real pt_wrap(int wrap, brdf_real x)
{
    if (wrap == PT_WRAP_REPEAT) {
        return x - brdf_floor(x);
    }
    if (wrap == PT_WRAP_MIRROR) {
        brdf_real there = x - 2.0f * brdf_floor(0.5f * x); /* there and back, in [0, 2) */
        return brdf_pick(there > 1.0f, 2.0f - there, there);
    }
    return brdf_clamp(x, 0.0f, 1.0f);
}

/* Two neighbours along one axis, and how far from the first to the second. */
struct pt_neighbours {
    brdf_int first;
    brdf_int second;
    brdf_real between;
};

/* Whatever x is, even a NaN, the neighbours are texels. */
static inline struct pt_neighbours pt_neighbours_of(int wrap, int size, brdf_real x)
{
    int last = size - 1;
    brdf_real at = pt_wrap(wrap, x) * (float)size - 0.5f;
    brdf_real first = brdf_clamp(brdf_floor(at), -1.0f, (float)last);
    struct pt_neighbours n;
    n.between = brdf_clamp(at - first, 0.0f, 1.0f);
    n.first = brdf_to_int(first);
    n.second = n.first + 1;
    n.first = brdf_pick_int(n.first < 0, wrap == PT_WRAP_REPEAT ? last : 0, n.first);
    n.second = brdf_pick_int(n.second > last, wrap == PT_WRAP_REPEAT ? 0 : last, n.second);
    return n;
}

static inline brdf_int pt_nearest_of(int wrap, int size, brdf_real x)
{
    brdf_real at = brdf_floor(pt_wrap(wrap, x) * (float)size);
    return brdf_to_int(brdf_clamp(at, 0.0f, (float)(size - 1)));
}

static inline brdf_rgb pt_texel(struct pt_world w, BRDF_GLOBAL const struct pt_texture *texture,
                                brdf_int x, brdf_int y)
{
    BRDF_GLOBAL const float *texels = w.scene + texture->texels;
    brdf_int number = y * texture->width + x;
    if (texture->decode < 0) {
        return pt_quad_rgb(pt_load_quad(texels, number * 4));
    }
    BRDF_GLOBAL const float *values = w.scene + texture->decode;
    brdf_int codes = brdf_bits(brdf_gather(texels, number));
    return brdf_rgb_make(brdf_gather(values, codes & 255), brdf_gather(values, codes >> 8 & 255),
                         brdf_gather(values, codes >> 16 & 255));
}

static inline brdf_rgb pt_rgb_between(brdf_rgb a, brdf_rgb b, brdf_real x)
{
    return brdf_rgb_add(brdf_rgb_scale(a, 1.0f - x), brdf_rgb_scale(b, x));
}

static inline brdf_rgb pt_bitmap(struct pt_world w, BRDF_GLOBAL const struct pt_texture *texture,
                                 brdf_real u, brdf_real v)
{
    if (texture->nearest) {
        return pt_texel(w, texture, pt_nearest_of(texture->wrap, texture->width, u),
                        pt_nearest_of(texture->wrap, texture->height, v));
    }
    struct pt_neighbours x = pt_neighbours_of(texture->wrap, texture->width, u);
    struct pt_neighbours y = pt_neighbours_of(texture->wrap, texture->height, v);
    brdf_rgb first = pt_rgb_between(pt_texel(w, texture, x.first, y.first),
                                    pt_texel(w, texture, x.second, y.first), x.between);
    brdf_rgb second = pt_rgb_between(pt_texel(w, texture, x.first, y.second),
                                     pt_texel(w, texture, x.second, y.second), x.between);
    return pt_rgb_between(first, second, y.between);
}

#endif
