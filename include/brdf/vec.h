/*
 * vec.h - directions and colours: three values each, passed and returned by value.
 */
#ifndef BRDF_VEC_H
#define BRDF_VEC_H

#include "dialect.h"

struct brdf_vec3 {
    brdf_real x;
    brdf_real y;
    brdf_real z;
};
typedef struct brdf_vec3 brdf_vec3;

/* Linear Rec. 709 reflectance or radiance. */
struct brdf_rgb {
    brdf_real r;
    brdf_real g;
    brdf_real b;
};
typedef struct brdf_rgb brdf_rgb;

static inline brdf_vec3 brdf_vec3_make(brdf_real x, brdf_real y, brdf_real z)
{
    brdf_vec3 v;
    v.x = x;
    v.y = y;
    v.z = z;
    return v;
}

static inline brdf_vec3 brdf_add(brdf_vec3 a, brdf_vec3 b)
{
    return brdf_vec3_make(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline brdf_vec3 brdf_sub(brdf_vec3 a, brdf_vec3 b)
{
    return brdf_vec3_make(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline brdf_vec3 brdf_scale(brdf_vec3 a, brdf_real s)
{
    return brdf_vec3_make(a.x * s, a.y * s, a.z * s);
}

static inline brdf_vec3 brdf_negate(brdf_vec3 a)
{
    return brdf_vec3_make(-a.x, -a.y, -a.z);
}

static inline brdf_real brdf_dot(brdf_vec3 a, brdf_vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline brdf_vec3 brdf_cross(brdf_vec3 a, brdf_vec3 b)
{
    return brdf_vec3_make(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

/* Unit length; the zero vector gives +z, so that no lane ever holds a NaN. */
static inline brdf_vec3 brdf_normalize(brdf_vec3 a)
{
    brdf_real square = brdf_dot(a, a);
    brdf_mask valid = square > 0.0f;
    brdf_real inverse = 1.0f / sqrtf(brdf_pick(valid, square, 1.0f));
    return brdf_vec3_make(a.x * inverse, a.y * inverse, brdf_pick(valid, a.z * inverse, 1.0f));
}

static inline brdf_vec3 brdf_vec3_pick(brdf_mask mask, brdf_vec3 yes, brdf_vec3 no)
{
    return brdf_vec3_make(brdf_pick(mask, yes.x, no.x), brdf_pick(mask, yes.y, no.y),
                          brdf_pick(mask, yes.z, no.z));
}

/* The mirror direction of w about the unit normal h; w points away from the surface, as always. */
static inline brdf_vec3 brdf_reflect(brdf_vec3 w, brdf_vec3 h)
{
    return brdf_sub(brdf_scale(h, 2.0f * brdf_dot(w, h)), w);
}

static inline brdf_rgb brdf_rgb_make(brdf_real r, brdf_real g, brdf_real b)
{
    brdf_rgb c;
    c.r = r;
    c.g = g;
    c.b = b;
    return c;
}

static inline brdf_rgb brdf_gray(brdf_real value)
{
    return brdf_rgb_make(value, value, value);
}

static inline brdf_rgb brdf_rgb_add(brdf_rgb a, brdf_rgb b)
{
    return brdf_rgb_make(a.r + b.r, a.g + b.g, a.b + b.b);
}

static inline brdf_rgb brdf_rgb_mul(brdf_rgb a, brdf_rgb b)
{
    return brdf_rgb_make(a.r * b.r, a.g * b.g, a.b * b.b);
}

static inline brdf_rgb brdf_rgb_scale(brdf_rgb a, brdf_real s)
{
    return brdf_rgb_make(a.r * s, a.g * s, a.b * s);
}

static inline brdf_rgb brdf_rgb_pick(brdf_mask mask, brdf_rgb yes, brdf_rgb no)
{
    return brdf_rgb_make(brdf_pick(mask, yes.r, no.r), brdf_pick(mask, yes.g, no.g),
                         brdf_pick(mask, yes.b, no.b));
}

static inline brdf_real brdf_rgb_largest(brdf_rgb a)
{
    return brdf_max(a.r, brdf_max(a.g, a.b));
}

/* Relative luminance of linear Rec. 709 (ITU-R BT.709-6, section 3). */
static inline brdf_real brdf_rgb_luminance(brdf_rgb a)
{
    return 0.2126f * a.r + 0.7152f * a.g + 0.0722f * a.b;
}

#endif
