/*
 * scene.h - a scene in the host's memory: what the loader makes and world.c lays out.
 */
#ifndef BRDFCL_LIB_SCENE_H
#define BRDFCL_LIB_SCENE_H

#include <brdf/material.h>
#include <brdfcl/image.h>
#include <brdfcl/scene.h>

#include "kernels/scene.h"
#include "kernels/texture_record.h"

enum scene_environment_kind { ENVIRONMENT_NONE, ENVIRONMENT_CONSTANT, ENVIRONMENT_MAP };

enum scene_fov_axis { FOV_X, FOV_Y, FOV_DIAGONAL, FOV_SMALLER, FOV_LARGER };

struct scene_environment {
    enum scene_environment_kind kind;
    float radiance[3];         /* constant */
    struct brdfcl_image image; /* map, already scaled */
    float to_world[9];         /* rotation, row-major: map -> world */
};

/* A normal map or a bump map. */
struct scene_tilt {
    unsigned how; /* enum pt_tilt_how; 0: none */
    int texture;
    float scale;
};

struct scene_surface {
    struct brdf_bsdf *bsdf; /* not owned: one of brdfcl_scene.bsdfs; NULL: light goes through it */
    float radiance[3];
    int emits;
    struct scene_tilt tilt;
};

/* A texture; of a bitmap also its texels, owned. */
struct scene_texture {
    struct pt_texture record; /* its places in the scene array are not known yet */
    unsigned *codes;          /* one a texel: 8 bits a channel, red lowest; or NULL, then: */
    float *rgb;               /* three a texel */
    int raw;                  /* what the codes stand for, see brdfcl_image_codes */
    float least;              /* of the values of all channels; not of a woodgrain */
    float most;
    int output_given; /* the file says which output of a woodgrain is wanted */
};

/* A texture sets a parameter of a bsdf. */
struct scene_binding {
    const struct brdf_bsdf *bsdf;
    int word;  /* of its material */
    int color; /* the two words behind it, too */
    struct pt_binding record;
};

/* Where a path goes on to one of two: references to a surface (its number) or to another fork,
   which comes before (-1 - its number). A primitive's PT_SURFACE is such a reference. */
struct scene_fork {
    int first;
    int second;
    int kind;     /* enum pt_fork_kind */
    int texture;  /* PT_FORK_TEXTURE: its number */
    float weight; /* PT_FORK_SHARE: probability of the second */
};

/* A growing array of 16-word records. */
struct scene_rows {
    float *words;
    size_t count;    /* records */
    size_t capacity; /* records */
};

struct brdfcl_scene {
    /* sensor */
    float camera_to_world[16]; /* row-major; Mitsuba's camera looks along +z, +x left, +y up */
    float fov;                 /* field of view along fov_axis [degrees] */
    enum scene_fov_axis fov_axis;
    float principal_offset[2]; /* of the film, as fractions of its width and height */
    int width;
    int height;
    int filter; /* PT_FILTER_... */
    float filter_radius;
    float filter_sigma;
    int half; /* hdrfilm component_format = float16 */
    /* sampler and integrator */
    int sobol; /* else independent */
    int spp;
    int seed;
    int max_depth; /* -1 = unlimited */
    int rr_depth;
    /* content */
    struct scene_rows primitives; /* kernels/scene.h; PT_LIGHT_PDF is filled in later */
    struct scene_rows shading;
    struct scene_surface *surfaces;
    size_t surface_count;
    struct scene_fork *forks;
    size_t fork_count;
    struct brdf_bsdf **bsdfs;
    size_t bsdf_count;
    struct scene_texture *textures;
    size_t texture_count;
    struct scene_binding *bindings; /* those of a bsdf together, in the order of their words */
    size_t binding_count;
    struct scene_environment environment;
    /* what the loader has to say: sampler mapped, triangles dropped; one line each, malloc'd */
    char **notes;
    size_t note_count;
    char *path;
};

/* The bindings of a bsdf, *count of them. scene_binding.c */
const struct scene_binding *scene_bindings_of(const struct brdfcl_scene *scene,
                                              const struct brdf_bsdf *bsdf, size_t *count);

#endif
