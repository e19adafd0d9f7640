/*
 * bvh_scenes.c - primitives and rays to try the hierarchy on.
 */
#include "bvh_scenes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "kernels/scene.h"

#define ALL 15
#define PLANAR 7

const struct recipe recipes[] = {
    {"one triangle", 1, 1, 1.0f, 1.0f, 0.0f, 0, 1},
    {"one sphere", 1, 8, 1.0f, 1.0f, 0.0f, 0, 1},
    {"two primitives", 2, ALL, 1.0f, 0.5f, 0.0f, 0, 1},
    {"17 primitives", 17, ALL, 1.0f, 0.5f, 0.0f, 0, 1},
    {"a mixture", 1200, ALL, 1.0f, 0.1f, 0.0f, 0, 1},
    {"long ones", 300, ALL, 1.0f, 2.0f, 0.0f, 0, 1},
    {"along the axes", 600, PLANAR, 1.0f, 0.3f, 0.0f, 1, 1},
    {"along the axes, far away", 600, PLANAR, 1.0f, 0.3f, 3.0e3f, 1, 1},
    {"slivers", 600, PLANAR, 1.0f, 1.0f, 0.0f, -1, 1},
    {"six of each", 600, ALL, 1.0f, 0.2f, 0.0f, 0, 6},
    {"forty of each", 400, PLANAR, 1.0f, 0.3f, 0.0f, 1, 40},
    {"huge", 600, ALL, 1.0e9f, 1.0e8f, 0.0f, 0, 1},
    {"tiny", 600, ALL, 1.0e-9f, 1.0e-10f, 0.0f, 0, 1},
    {"far from the origin", 600, ALL, 1.0f, 0.2f, 3.0e3f, 0, 1},
    {"specks", 600, ALL, 1.0f, 1.0e-4f, 0.0f, 0, 1},
};
const size_t recipe_count = sizeof recipes / sizeof recipes[0];

static unsigned long long next_state(unsigned long long *state)
{
    *state = *state * 6364136223846793005ull + 1442695040888963407ull;
    return *state >> 33;
}

/* In [-1, 1]. */
static float either(unsigned long long *state)
{
    return (float)((double)next_state(state) / 1073741824.0 - 1.0);
}

static int below(unsigned long long *state, int count)
{
    return (int)(next_state(state) % (unsigned long long)count);
}

static void int_word(float *word, int value)
{
    memcpy(word, &value, sizeof value);
}

static int kind_of(const float *row)
{
    int kind;
    memcpy(&kind, row + PT_KIND, sizeof kind);
    return kind;
}

static void random_primitive(const struct recipe *recipe, unsigned long long *state, float *row)
{
    int kind = below(state, 4);
    while (!(recipe->kinds >> kind & 1)) {
        kind = (kind + 1) % 4;
    }
    for (int i = 0; i < 3; ++i) {
        row[PT_P + i] = recipe->centre + recipe->extent * either(state);
    }
    for (int i = PT_E1; i < PT_KIND; ++i) {
        row[i] = recipe->size * either(state);
    }
    for (int i = 0; recipe->flat < 0 && i < 3; ++i) {
        row[PT_E2 + i] = 0.7f * row[PT_E1 + i] + 3.0e-5f * row[PT_E2 + i];
    }
    if (recipe->flat > 0) {
        int axis = below(state, 3);
        float a = row[PT_E1 + axis];
        float b = row[PT_E2 + (axis + 1) % 3];
        memset(row + PT_E1, 0, 6 * sizeof *row);
        row[PT_E1 + axis] = a;
        row[PT_E2 + (axis + 1) % 3] = b;
    }
    if (kind == PT_SPHERE) {
        row[PT_RADIUS] = recipe->size * (0.1f + fabsf(either(state)));
    }
    int_word(row + PT_KIND, kind);
}

static void aim(float *ray, const float target[3])
{
    double d[3], length = 0.0;
    for (int i = 0; i < 3; ++i) {
        d[i] = (double)target[i] - (double)ray[i];
        length += d[i] * d[i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; ++i) {
        ray[3 + i] = length > 0.0 ? (float)(d[i] / length) : (i == 2 ? 1.0f : 0.0f);
    }
}

/* A point in the plane of a primitive, anywhere within `reach` times its size. */
static void point_on(const float *row, float u, float v, float out[3])
{
    for (int i = 0; i < 3; ++i) {
        out[i] = kind_of(row) == PT_SPHERE
                     ? row[PT_P + i] + (i == 0   ? u
                                        : i == 1 ? v
                                                 : 0.0f) *
                                           row[PT_RADIUS]
                     : row[PT_P + i] + u * row[PT_E1 + i] + v * row[PT_E2 + i];
    }
}

static void axis_direction(unsigned long long *state, float *ray)
{
    int axis = below(state, 3);
    float zero = below(state, 2) ? 0.0f : -0.0f;
    float along = below(state, 2) ? 1.0f : -1.0f;
    for (int i = 0; i < 3; ++i) {
        ray[3 + i] = i == axis ? along : zero;
    }
}

static void random_ray(const float *rows, size_t count, float centre, float extent,
                       unsigned long long *state, float *ray)
{
    static const float corners[] = {0.0f, 0.0f, 0.5f, 1.0f, 0.0f};
    const float *row = rows + PT_ROW * ((size_t)next_state(state) % count);
    const float *other = rows + PT_ROW * ((size_t)next_state(state) % count);
    float target[3];
    int corner = below(state, 4);
    float beside;
    for (int i = 0; i < 3; ++i) {
        ray[i] = centre + 2.0f * extent * either(state);
    }
    switch (below(state, 8)) {
    case 0: /* at a vertex or the middle of an edge, or just beside it */
        beside = below(state, 2) ? 0.0f : 4.0e-3f * either(state);
        point_on(row, corners[corner] + beside, corners[corner + 1] - beside, target);
        aim(ray, target);
        break;
    case 1: /* in the plane of a primitive, all but along it */
        point_on(row, 8.0f * either(state), 8.0f * either(state), ray);
        point_on(row, either(state), either(state), target);
        aim(ray, target);
        break;
    case 2: /* from one surface to another */
        point_on(other, 0.3f, 0.3f, ray);
        point_on(row, 0.4f, 0.1f, target);
        aim(ray, target);
        break;
    case 3: /* along an axis, from the level of a vertex: in a plane of a box */
        axis_direction(state, ray);
        for (int i = 0; i < 3; ++i) {
            ray[i] = row[PT_P + i] - (float)(1 + below(state, 2)) * extent * ray[3 + i];
        }
        break;
    case 4: /* with a component of zero: as high as its target, or straight to it */
        point_on(row, 0.2f, 0.2f, target);
        target[below(state, 3)] = ray[below(state, 3)];
        corner = below(state, 3);
        ray[corner] = target[corner];
        aim(ray, target);
        break;
    case 5: /* from far away */
        for (int i = 0; i < 3; ++i) {
            ray[i] = centre + 1.0e4f * extent * either(state);
        }
        point_on(row, 0.25f, 0.25f, target);
        aim(ray, target);
        break;
    default: /* anywhere */
        for (int i = 0; i < 3; ++i) {
            target[i] = centre + extent * either(state);
        }
        aim(ray, target);
    }
    ray[6] = 3.0f * extent * fabsf(either(state));
}

static struct bvh_scene scene_allocate(size_t count, size_t ray_count)
{
    struct bvh_scene scene;
    scene.count = count;
    scene.ray_count = ray_count;
    scene.rows = calloc(count, PT_ROW * sizeof(float));
    scene.rays = calloc(ray_count, RAY_WORDS * sizeof(float));
    if (!scene.rows || !scene.rays) {
        abort();
    }
    return scene;
}

static void scene_shoot(struct bvh_scene *scene, float centre, float extent)
{
    unsigned long long state = 0x5eed;
    for (size_t i = 0; i < scene->ray_count; ++i) {
        random_ray(scene->rows, scene->count, centre, extent, &state, scene->rays + RAY_WORDS * i);
    }
}

struct bvh_scene bvh_scene_random(const struct recipe *recipe, size_t rays)
{
    struct bvh_scene scene = scene_allocate(recipe->count, rays);
    unsigned long long state = 0x5eed + (unsigned long long)recipe->count;
    size_t different = recipe->count / (size_t)recipe->copies;
    for (size_t i = 0; i < recipe->count; ++i) {
        float *row = scene.rows + PT_ROW * i;
        if (i < different) {
            random_primitive(recipe, &state, row);
        } else {
            memcpy(row, scene.rows + PT_ROW * (i % different), PT_ROW * sizeof *row);
        }
    }
    scene_shoot(&scene, recipe->centre, recipe->extent);
    return scene;
}

static void mesh_vertex(int n, int i, int j, float out[3])
{
    double theta = pi * i / n;
    double phi = pi * (j % (2 * n)) / n;
    double r = 1.0 + 0.05 * sin(20.0 * theta) * cos(23.0 * phi);
    out[0] = (float)(r * sin(theta) * cos(phi));
    out[1] = (float)(r * sin(theta) * sin(phi));
    out[2] = (float)(r * cos(theta));
}

struct bvh_scene bvh_scene_mesh(int n, size_t rays)
{
    struct bvh_scene scene = scene_allocate((size_t)(4 * n * n), rays);
    float *row = scene.rows;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < 2 * n; ++j) {
            for (int half = 0; half < 2; ++half, row += PT_ROW) {
                float a[3], b[3], c[3];
                mesh_vertex(n, i + half, j + half, a);
                mesh_vertex(n, i + 1 - half, j, b);
                mesh_vertex(n, i + half, j + 1 - half, c);
                for (int k = 0; k < 3; ++k) {
                    row[PT_P + k] = a[k];
                    row[PT_E1 + k] = b[k] - a[k];
                    row[PT_E2 + k] = c[k] - a[k];
                }
            }
        }
    }
    scene_shoot(&scene, 0.0f, 1.0f);
    return scene;
}

struct bvh_scene bvh_scene_nested(size_t count, size_t rays)
{
    struct bvh_scene scene = scene_allocate(count, rays);
    for (size_t i = 0; i < count; ++i) {
        float *row = scene.rows + PT_ROW * i;
        float size = (float)pow(0.98, (double)i);
        row[PT_P] = size;
        row[PT_P + 1] = 0.3f * size;
        row[PT_E1 + 1] = size;
        row[PT_E2 + 2] = size;
    }
    scene_shoot(&scene, 0.0f, 1.0f);
    return scene;
}

void bvh_scene_free(struct bvh_scene *scene)
{
    free(scene->rows);
    free(scene->rays);
    memset(scene, 0, sizeof *scene);
}
