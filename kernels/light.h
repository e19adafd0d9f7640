/*
 * light.h - next-event estimation: choosing a light and a point on it, and the density of that.
 */
#ifndef PT_LIGHT_H
#define PT_LIGHT_H

#include "environment.h"
#include "interaction.h"

/* The area of a planar primitive over |e1 x e2|. */
static inline brdf_real pt_area_factor(brdf_int kind)
{
    return brdf_pick(kind == PT_TRIANGLE, 0.5f, brdf_pick(kind == PT_DISK, BRDF_PI, 1.0f));
}

/* 1 - cos of the half angle under which a sphere is seen from `distance2` = distance^2; 2 inside.
 */
static inline brdf_real pt_sphere_cap(brdf_real distance2, brdf_real radius)
{
    brdf_real sin2 = radius * radius / brdf_max(distance2, 1e-30f);
    brdf_mask inside = sin2 >= 1.0f;
    brdf_real cosine = sqrtf(brdf_max(1.0f - sin2, 0.0f));
    return brdf_pick(inside, 2.0f, sin2 / (1.0f + cosine));
}

/*
 * Density [1/sr] of choosing the direction that met an emitting primitive at `distance` from `o`;
 * with the probability of choosing the primitive.
 */
static inline brdf_real pt_light_density(BRDF_GLOBAL const struct pt_settings *settings,
                                         struct pt_primitive primitive, struct pt_ray ray,
                                         brdf_real distance)
{
    brdf_vec3 across = brdf_cross(primitive.e1, primitive.e2);
    brdf_real facing = fabsf(brdf_dot(across, ray.d)) * pt_area_factor(primitive.kind);
    brdf_real pdf = distance * distance / brdf_max(facing, 1e-20f);
    if (PT_HAS(settings, PT_HAS_SPHERE_LIGHTS)) {
        brdf_vec3 to = brdf_sub(primitive.p, ray.o);
        brdf_real cap = pt_sphere_cap(brdf_dot(to, to), primitive.radius);
        pdf =
            brdf_pick(primitive.kind == PT_SPHERE, (0.5f * BRDF_1_PI) / brdf_max(cap, 1e-12f), pdf);
    }
    return primitive.light_pdf * pdf;
}

/* A point on a planar primitive, uniform over its area, as coordinates along e1 and e2. */
static inline brdf_vec3 pt_planar_point(brdf_vec3 p, brdf_vec3 e1, brdf_vec3 e2, brdf_int kind,
                                        brdf_real u, brdf_real v)
{
    brdf_real root = sqrtf(u);
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_mask triangle = kind == PT_TRIANGLE;
    brdf_mask disk = kind == PT_DISK;
    brdf_real s = brdf_pick(triangle, 1.0f - root, brdf_pick(disk, root * turn.cos, u));
    brdf_real t = brdf_pick(triangle, v * root, brdf_pick(disk, root * turn.sin, v));
    return brdf_add(p, brdf_add(brdf_scale(e1, s), brdf_scale(e2, t)));
}

/* A light as loaded from its record; kind -1 is the environment. */
struct pt_light {
    brdf_vec3 p;
    brdf_vec3 e1;
    brdf_vec3 e2;
    brdf_int kind;
    brdf_rgb radiance;
    brdf_real select;
    brdf_real radius;
    brdf_real flip;
};

static inline struct pt_light pt_load_light(struct pt_world w, brdf_int number)
{
    BRDF_GLOBAL const float *words = w.scene + w.settings->lights;
    struct pt_row row = pt_load_row(words, number * PT_ROW);
    struct pt_light light;
    light.p = pt_quad_vec3(row.q0);
    light.e1 = brdf_vec3_make(row.q0.d, row.q1.a, row.q1.b);
    light.e2 = brdf_vec3_make(row.q1.c, row.q1.d, row.q2.a);
    light.kind = brdf_bits(row.q2.b);
    light.radiance = brdf_rgb_make(row.q2.c, row.q2.d, row.q3.a);
    light.select = row.q3.b;
    light.radius = row.q3.c;
    light.flip = row.q3.d;
    return light;
}

static inline struct pt_light_sample pt_planar_sample(struct pt_light light, brdf_vec3 from,
                                                      brdf_real u, brdf_real v)
{
    brdf_vec3 to = brdf_sub(pt_planar_point(light.p, light.e1, light.e2, light.kind, u, v), from);
    brdf_real distance2 = brdf_max(brdf_dot(to, to), 1e-20f);
    brdf_real distance = sqrtf(distance2);
    struct pt_light_sample s;
    s.wi = brdf_scale(to, 1.0f / distance);
    s.length = distance;
    s.radiance = light.radiance;
    brdf_real facing = -brdf_dot(brdf_cross(light.e1, light.e2), s.wi) * light.flip;
    brdf_mask lit = facing > 0.0f;
    brdf_real area = brdf_pick(lit, facing, 1.0f) * pt_area_factor(light.kind);
    s.pdf = brdf_pick(lit, light.select * distance2 / brdf_max(area, 1e-20f), 0.0f);
    return s;
}

/* Directions to a sphere, uniform over the solid angle that it fills. */
static inline struct pt_light_sample pt_sphere_sample(struct pt_light light, brdf_vec3 from,
                                                      brdf_real u, brdf_real v)
{
    brdf_vec3 to = brdf_sub(light.p, from);
    brdf_real distance2 = brdf_dot(to, to);
    brdf_real cap = pt_sphere_cap(distance2, light.radius);
    brdf_real one_minus_cos = u * cap;
    brdf_real sine = sqrtf(brdf_max(one_minus_cos * (2.0f - one_minus_cos), 0.0f));
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_frame frame = brdf_frame_from_normal(brdf_normalize(to));
    struct pt_light_sample s;
    s.wi = brdf_normalize(brdf_to_world(
        frame, brdf_vec3_make(sine * turn.cos, sine * turn.sin, 1.0f - one_minus_cos)));
    struct pt_ray ray;
    ray.o = from;
    ray.d = s.wi;
    struct pt_distance hit = pt_sphere_distance(ray, light.p, light.radius);
    /* Rounding may let a direction at the rim miss: then there is no sample. */
    brdf_mask inside = distance2 < light.radius * light.radius;
    brdf_mask lit = (hit.t < PT_MISS_T) & (brdf_pick(inside, -light.flip, light.flip) > 0.0f);
    s.length = brdf_pick(lit, hit.t, 1.0f);
    s.radiance = light.radiance;
    s.pdf = brdf_pick(lit, light.select * (0.5f * BRDF_1_PI) / brdf_max(cap, 1e-12f), 0.0f);
    return s;
}

static inline struct pt_light_sample
pt_light_sample_pick(brdf_mask mask, struct pt_light_sample yes, struct pt_light_sample no)
{
    struct pt_light_sample s;
    s.wi = brdf_vec3_pick(mask, yes.wi, no.wi);
    s.length = brdf_pick(mask, yes.length, no.length);
    s.radiance = brdf_rgb_pick(mask, yes.radiance, no.radiance);
    s.pdf = brdf_pick(mask, yes.pdf, no.pdf);
    return s;
}

/* A direction from `from` to some light: `select` chooses it, u and v the point on it. */
static inline struct pt_light_sample pt_sample_light(struct pt_world w, brdf_vec3 from,
                                                     brdf_real select, brdf_real u, brdf_real v)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    int environment = PT_HAS(settings, PT_HAS_CONSTANT | PT_HAS_MAP) != 0;
    if (!PT_HAS(settings, PT_HAS_LIGHTS)) {
        return pt_environment_sample(w, u, v);
    }
    struct pt_choice choice = pt_search(w.scene, settings->light_cdf, settings->light_count,
                                        settings->light_steps, select);
    struct pt_light light = pt_load_light(w, choice.index);
    struct pt_light_sample s = pt_planar_sample(light, from, u, v);
    if (PT_HAS(settings, PT_HAS_SPHERE_LIGHTS)) {
        s = pt_light_sample_pick(light.kind == PT_SPHERE, pt_sphere_sample(light, from, u, v), s);
    }
    if (environment & brdf_any(light.kind < 0)) {
        s = pt_light_sample_pick(light.kind < 0, pt_environment_sample(w, u, v), s);
    }
    return s;
}

#endif
