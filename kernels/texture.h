/*
 * texture.h - the value of a texture where a path met a surface, and parameters that have one.
 *
 * The number of the texture is one for all lanes, so that what kind it is costs a branch that all
 * take together; kinds that a scene does not have fold away.
 */
#ifndef PT_TEXTURE_H
#define PT_TEXTURE_H

#include "brdf/model.h"
#include "interaction.h"
#include "texture_bitmap.h"
#include "woodgrain.h"

static inline BRDF_GLOBAL const struct pt_texture *pt_texture_at(struct pt_world w, int number)
{
    BRDF_GLOBAL const void *textures = w.scene + w.settings->textures;
    return (BRDF_GLOBAL const struct pt_texture *)textures + number;
}

/* Squares of half a unit: color0 where both coordinates lie in the same half. */
static inline brdf_rgb pt_checkerboard(BRDF_GLOBAL const struct pt_texture *texture, brdf_real u,
                                       brdf_real v)
{
    brdf_real right = brdf_pick(u - brdf_floor(u) > 0.5f, 1.0f, 0.0f);
    brdf_real upper = brdf_pick(v - brdf_floor(v) > 0.5f, 1.0f, 0.0f);
    BRDF_GLOBAL const float *a = texture->color0;
    BRDF_GLOBAL const float *b = texture->color1;
    brdf_mask same = right == upper;
    return brdf_rgb_make(brdf_pick(same, a[0], b[0]), brdf_pick(same, a[1], b[1]),
                         brdf_pick(same, a[2], b[2]));
}

/* What is looked up once, whatever is made of it. */
struct pt_texture_found {
    brdf_rgb color;
    struct pt_grain grain;
};

/* Called, not inlined: a kernel asks for several textures, and a look-up is much code. */
PT_OWN_FRAME struct pt_texture_found pt_texture_find(struct pt_world w, int number,
                                                     struct pt_interaction at)
{
    BRDF_GLOBAL const struct pt_texture *texture = pt_texture_at(w, number);
    BRDF_GLOBAL const float *m = texture->to_uv;
    brdf_real u = m[0] * at.u + m[1] * at.v + m[2];
    brdf_real v = m[3] * at.u + m[4] * at.v + m[5];
    struct pt_texture_found found;
    found.color = brdf_gray(0.0f);
    found.grain.late = 0.0f;
    found.grain.streak = 0.0f;
    found.grain.axis = brdf_vec3_make(0.0f, 0.0f, 1.0f);
    if (PT_HAS(w.settings, PT_HAS_BITMAPS) && texture->kind == PT_TEXTURE_BITMAP) {
        found.color = pt_bitmap(w, texture, u, v);
    } else if (PT_HAS(w.settings, PT_HAS_WOODGRAINS) && texture->kind == PT_TEXTURE_WOODGRAIN) {
        found.grain = pt_grain_at(texture, at);
    } else {
        found.color = pt_checkerboard(texture, u, v);
    }
    return found;
}

static inline brdf_rgb pt_texture_value(struct pt_world w, int number,
                                        struct pt_texture_found found, int output)
{
    BRDF_GLOBAL const struct pt_texture *texture = pt_texture_at(w, number);
    if (PT_HAS(w.settings, PT_HAS_WOODGRAINS) && texture->kind == PT_TEXTURE_WOODGRAIN) {
        return pt_grain_output(texture, found.grain, output);
    }
    return found.color;
}

/* The value of texture `number` at a place: linear Rec. 709, or three equal numbers. */
static inline brdf_rgb pt_texture_eval(struct pt_world w, int number, struct pt_interaction at)
{
    return pt_texture_value(w, number, pt_texture_find(w, number, at),
                            pt_texture_at(w, number)->output);
}

/* The side that is looked at: where the material is the same on both, the frame is mirrored as
   brdf_surface_eval mirrors directions, so that what has a direction in a texture stays put. */
static inline struct pt_interaction pt_seen_side(unsigned flags, struct pt_interaction at,
                                                 brdf_vec3 wo)
{
    if (flags & BRDF_TWOSIDED) {
        brdf_mask below = brdf_dot(at.frame.n, wo) < 0.0f;
        at.frame.n = brdf_vec3_pick(below, brdf_negate(at.frame.n), at.frame.n);
    }
    return at;
}

/* A material's parameters with those that are textured replaced; bit i of `textured` says that a
   texture sets word i, and bit i of `colors` that it sets the two words behind it as well. */
static inline brdf_parameters pt_textured_parameters(struct pt_world w, unsigned model,
                                                     unsigned textured, unsigned colors,
                                                     int bindings, struct pt_interaction at,
                                                     brdf_parameters p)
{
    BRDF_GLOBAL const void *first = w.scene + bindings;
    BRDF_GLOBAL const struct pt_binding *binding = (BRDF_GLOBAL const struct pt_binding *)first;
    struct pt_texture_found found = pt_texture_find(w, binding->texture, at);
    int known = binding->texture; /* often the same one sets several parameters */
    BRDF_UNROLL
    for (unsigned left = textured; left; left &= left - 1u) {
        int word = pt_lowest_bit(left);
        if (binding->texture != known) {
            known = binding->texture;
            found = pt_texture_find(w, known, at);
        }
        brdf_rgb value = pt_texture_value(w, known, found, binding->output);
        float low = binding->low;
        float high = binding->high;
        if (colors >> word & 1u) {
            p = brdf_parameters_set(p, model, word, brdf_clamp(value.r, low, high));
            p = brdf_parameters_set(p, model, word + 1, brdf_clamp(value.g, low, high));
            p = brdf_parameters_set(p, model, word + 2, brdf_clamp(value.b, low, high));
        } else {
            p = brdf_parameters_set(p, model, word,
                                    brdf_clamp(brdf_rgb_luminance(value), low, high));
        }
        ++binding;
    }
    return p;
}

#endif
