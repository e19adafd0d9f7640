/*
 * interaction.h - what a path meets: the place on a primitive, its normals and tangent.
 */
#ifndef PT_INTERACTION_H
#define PT_INTERACTION_H

#include "brdf/frame.h"
#include "brdf/math.h"
#include "intersect.h"
#include "path.h"

/* A primitive in every lane, as loaded from its record. */
struct pt_primitive {
    brdf_vec3 p;
    brdf_vec3 e1;
    brdf_vec3 e2;
    brdf_int kind;
    brdf_int shading;
    brdf_real flip;
    brdf_real radius;
    brdf_real light_pdf;
    brdf_real mirrored;
};

struct pt_interaction {
    brdf_vec3 p;      /* the point, world space */
    brdf_vec3 ng;     /* geometric normal, unit, on the side that the shape faces */
    brdf_frame frame; /* shading frame */
    brdf_real u;      /* texture coordinates; 0 where the scene has no textures */
    brdf_real v;
};

static inline struct pt_primitive pt_load_primitive(struct pt_world w, brdf_int number)
{
    BRDF_GLOBAL const float *words = w.scene + w.settings->primitives;
    struct pt_row row = pt_load_row(words, number * PT_ROW);
    struct pt_primitive primitive;
    primitive.p = pt_quad_vec3(row.q0);
    primitive.e1 = brdf_vec3_make(row.q0.d, row.q1.a, row.q1.b);
    primitive.e2 = brdf_vec3_make(row.q1.c, row.q1.d, row.q2.a);
    primitive.kind = brdf_bits(row.q2.b);
    primitive.shading = brdf_bits(row.q2.d);
    primitive.flip = row.q3.a;
    primitive.radius = row.q3.b;
    primitive.light_pdf = row.q3.c;
    primitive.mirrored = row.q3.d;
    return primitive;
}

/* Vertex normals and texture coordinates of triangles that have them: a smooth frame. */
static inline brdf_frame pt_triangle_frame(struct pt_world w, struct pt_primitive primitive,
                                           brdf_real u, brdf_real v, brdf_frame flat)
{
    brdf_mask has = primitive.shading >= 0;
    BRDF_GLOBAL const float *words = w.scene + w.settings->shading;
    struct pt_row row = pt_load_row(words, brdf_pick_int(has, primitive.shading, 0) * PT_ROW);
    brdf_real rest = 1.0f - u - v;
    brdf_vec3 n = brdf_vec3_make(row.q0.a * rest + row.q0.d * u + row.q1.c * v,
                                 row.q0.b * rest + row.q1.a * u + row.q1.d * v,
                                 row.q0.c * rest + row.q1.b * u + row.q2.a * v);
    /* Along growing u of the texture: solve e1, e2 for it over the differences of (u, v). */
    brdf_real du1 = row.q2.d - row.q2.b;
    brdf_real dv1 = row.q3.a - row.q2.c;
    brdf_real du2 = row.q3.b - row.q2.b;
    brdf_real dv2 = row.q3.c - row.q2.c;
    brdf_real determinant = du1 * dv2 - dv1 * du2;
    brdf_vec3 tangent = brdf_sub(brdf_scale(primitive.e1, dv2), brdf_scale(primitive.e2, dv1));
    tangent = brdf_scale(tangent, brdf_pick(determinant < 0.0f, -1.0f, 1.0f));
    tangent = brdf_vec3_pick((determinant > 0.0f) | (determinant < 0.0f), tangent,
                             brdf_vec3_make(0.0f, 0.0f, 0.0f));
    brdf_frame smooth = brdf_frame_from_tangent(brdf_normalize(n), tangent);
    brdf_frame frame;
    frame.s = brdf_vec3_pick(has, smooth.s, flat.s);
    frame.t = brdf_vec3_pick(has, smooth.t, flat.t);
    frame.n = brdf_vec3_pick(has, smooth.n, flat.n);
    return frame;
}

/* From an angle around an axis [rad] to turns in [0, 1]. */
static inline brdf_real pt_turns(brdf_real angle)
{
    brdf_real turns = angle * (0.5f * BRDF_1_PI);
    return brdf_pick(turns < 0.0f, turns + 1.0f, turns);
}

/* Texture coordinates, as in Mitsuba 3: of a mesh those of its file or else (u, v) of the triangle;
   of a rectangle (u, v); of a disk radius and turns; of a sphere turns and polar angle / pi. */
static inline struct pt_interaction pt_find_uv(struct pt_world w, struct pt_primitive primitive,
                                               struct brdf_quad hit, struct pt_interaction at)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    brdf_real radius = sqrtf(hit.b * hit.b + hit.c * hit.c);
    brdf_mask disk = primitive.kind == PT_DISK;
    at.u = brdf_pick(disk, radius, hit.b);
    at.v = brdf_pick(disk, pt_turns(brdf_atan2(hit.c, hit.b)), hit.c);
    if (PT_HAS(settings, PT_HAS_SHADING)) {
        brdf_mask has = primitive.shading >= 0;
        BRDF_GLOBAL const float *words = w.scene + settings->shading;
        struct pt_row row = pt_load_row(words, brdf_pick_int(has, primitive.shading, 0) * PT_ROW);
        brdf_real rest = 1.0f - hit.b - hit.c;
        brdf_real u = row.q2.b * rest + row.q2.d * hit.b + row.q3.b * hit.c;
        brdf_real v = row.q2.c * rest + row.q3.a * hit.b + row.q3.c * hit.c;
        at.u = brdf_pick(has, u, at.u);
        at.v = brdf_pick(has, v, at.v);
    }
    if (PT_HAS(settings, PT_HAS_SPHERES)) {
        brdf_mask sphere = primitive.kind == PT_SPHERE;
        brdf_vec3 out = brdf_normalize(brdf_sub(at.p, primitive.p));
        brdf_vec3 up = brdf_normalize(brdf_cross(primitive.e1, primitive.e2));
        brdf_real height = brdf_dot(out, up);
        height = brdf_pick(primitive.mirrored > 0.0f, -height, height);
        brdf_real turns =
            pt_turns(brdf_atan2(brdf_dot(out, primitive.e2), brdf_dot(out, primitive.e1)));
        at.u = brdf_pick(sphere, turns, at.u);
        at.v = brdf_pick(sphere, brdf_acos(height) * BRDF_1_PI, at.v);
    }
    return at;
}

static inline struct pt_interaction pt_interact(struct pt_world w, struct pt_primitive primitive,
                                                struct pt_ray ray, struct brdf_quad hit)
{
    BRDF_GLOBAL const struct pt_settings *settings = w.settings;
    struct pt_interaction at;
    brdf_vec3 across = brdf_cross(primitive.e1, primitive.e2);
    /* On the plane, not along the ray: its error does not grow with the distance. */
    at.p = brdf_add(primitive.p,
                    brdf_add(brdf_scale(primitive.e1, hit.b), brdf_scale(primitive.e2, hit.c)));
    at.ng = brdf_scale(brdf_normalize(across), primitive.flip);
    brdf_vec3 tangent = primitive.e1;
    brdf_vec3 radial = brdf_sub(at.p, primitive.p);
    tangent = brdf_vec3_pick(primitive.kind == PT_DISK, radial, tangent);
    /* A flat triangle has no tangent of its own: any will do, and the zero vector asks for it. */
    tangent =
        brdf_vec3_pick(primitive.kind == PT_TRIANGLE, brdf_vec3_make(0.0f, 0.0f, 0.0f), tangent);
    if (PT_HAS(settings, PT_HAS_SPHERES)) {
        brdf_mask sphere = primitive.kind == PT_SPHERE;
        brdf_vec3 out =
            brdf_normalize(brdf_sub(brdf_add(ray.o, brdf_scale(ray.d, hit.a)), primitive.p));
        brdf_vec3 on_sphere = brdf_add(primitive.p, brdf_scale(out, primitive.radius));
        at.p = brdf_vec3_pick(sphere, on_sphere, at.p);
        at.ng = brdf_vec3_pick(sphere, brdf_scale(out, primitive.flip), at.ng);
        tangent = brdf_vec3_pick(sphere, brdf_cross(across, out), tangent);
    }
    at.frame = brdf_frame_from_tangent(at.ng, tangent);
    if (PT_HAS(settings, PT_HAS_SHADING)) {
        at.frame = pt_triangle_frame(w, primitive, hit.b, hit.c, at.frame);
    }
    at.u = 0.0f;
    at.v = 0.0f;
    return PT_HAS(settings, PT_HAS_TEXTURES) ? pt_find_uv(w, primitive, hit, at) : at;
}

/*
 * Where a ray leaves the surface: moved along the geometric normal, to the side it goes to, by what
 * rounding may have moved the point, so that it cannot meet the surface again.
 */
static inline brdf_vec3 pt_leave(struct pt_interaction at, brdf_vec3 direction)
{
    brdf_real largest = brdf_max(brdf_max(fabsf(at.p.x), fabsf(at.p.y)), fabsf(at.p.z));
    brdf_real distance = (1.0f + largest) * 5e-5f;
    distance = brdf_pick(brdf_dot(at.ng, direction) < 0.0f, -distance, distance);
    return brdf_add(at.p, brdf_scale(at.ng, distance));
}

#endif
