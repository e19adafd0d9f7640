/*
 * bvh_scenes.h - primitives and rays to try the hierarchy on.
 */
#ifndef TEST_BVH_SCENES_H
#define TEST_BVH_SCENES_H

#include <stddef.h>

#define RAY_WORDS 8 /* origin, direction, tmax, unused */

/* Where random primitives lie and how large they are. */
struct recipe {
    const char *name;
    size_t count;
    int kinds;    /* bit k: kind k of kernels/scene.h occurs */
    float extent; /* half the edge of the cube that holds the centres */
    float size;   /* of a primitive */
    float centre; /* x, y and z of the middle of the cube */
    int flat;     /* 1: edges along the axes; -1: edges along each other, all but */
    int copies;   /* each primitive so many times */
};

struct bvh_scene {
    float *rows;
    size_t count;
    float *rays;
    size_t ray_count;
};

extern const struct recipe recipes[];
extern const size_t recipe_count;

/* Random primitives, and rays of every kind that is likely to go wrong. */
struct bvh_scene bvh_scene_random(const struct recipe *recipe, size_t rays);

/* A displaced sphere of about 4 n^2 triangles. */
struct bvh_scene bvh_scene_mesh(int n, size_t rays);

/* Triangles that shrink by a constant factor towards a point: as deep a tree as can be asked for.
 */
struct bvh_scene bvh_scene_nested(size_t count, size_t rays);

void bvh_scene_free(struct bvh_scene *scene);

#endif
