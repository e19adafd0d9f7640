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

/* The texel's own middle is where it counts alone: half a texel from its border. */
static inline struct pt_neighbours pt_bilinear_of(int wrap, int size, brdf_real x)
{
    int last = size - 1;
    brdf_real at = pt_wrap(wrap, x) * (float)size - 0.5f;
    /* Clamped, so that they are texels whatever x is, even a NaN. */
    brdf_real first = brdf_clamp(brdf_floor(at), -1.0f, (float)last);
    struct pt_neighbours n;
    n.between = brdf_clamp(at - first, 0.0f, 1.0f);
    n.first = brdf_to_int(first);
    n.second = n.first + 1;
    n.first = brdf_pick_int(n.first < 0, wrap == PT_WRAP_REPEAT ? last : 0, n.first);
    n.second = brdf_pick_int(n.second > last, wrap == PT_WRAP_REPEAT ? 0 : last, n.second);
    return n;
}

static inline struct pt_neighbours pt_nearest_of(int wrap, int size, brdf_real x)
{
    brdf_real at = brdf_floor(pt_wrap(wrap, x) * (float)size);
    struct pt_neighbours n;
    n.between = 0.0f;
    n.first = brdf_to_int(brdf_clamp(at, 0.0f, (float)(size - 1)));
    n.second = n.first;
    return n;
}

static inline brdf_rgb pt_texel(struct pt_world w, BRDF_GLOBAL const struct pt_texture *texture,
                                brdf_int x, brdf_int y)
{
    BRDF_GLOBAL const float *texels = w.scene + texture->texels;
    brdf_int number = y * texture->width + x;
    if (PT_HAS(w.settings, PT_HAS_FLOAT_TEXELS) && texture->decode < 0) {
        return pt_quad_rgb(brdf_gather_quad(texels, number * 4));
    }
    BRDF_GLOBAL const float *values = w.scene + texture->decode;
    brdf_int codes = brdf_bits(brdf_gather(texels, number));
    return brdf_rgb_make(brdf_gather(values, codes & 255), brdf_gather(values, codes >> 8 & 255),
                         brdf_gather(values, codes >> 16 & 255));
}

static inline brdf_rgb pt_bitmap(struct pt_world w, BRDF_GLOBAL const struct pt_texture *texture,
                                 brdf_real u, brdf_real v)
{
    int nearest = texture->nearest;
    int wrap = texture->wrap;
    struct pt_neighbours x =
        nearest ? pt_nearest_of(wrap, texture->width, u) : pt_bilinear_of(wrap, texture->width, u);
    struct pt_neighbours y = nearest ? pt_nearest_of(wrap, texture->height, v)
                                     : pt_bilinear_of(wrap, texture->height, v);
    brdf_rgb sum = brdf_gray(0.0f);
    /* A loop, so that a kernel holds the gathers of one texel and not of four. */
    for (int corner = 0; corner < (nearest ? 1 : 4); ++corner) {
        int right = corner & 1;
        int lower = corner >> 1;
        brdf_rgb c = pt_texel(w, texture, right ? x.second : x.first, lower ? y.second : y.first);
        brdf_real weight =
            (right ? x.between : 1.0f - x.between) * (lower ? y.between : 1.0f - y.between);
        sum = brdf_rgb_add(sum, brdf_rgb_scale(c, weight));
    }
    return sum;
}

#endif
