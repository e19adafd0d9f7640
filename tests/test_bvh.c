/*
 * test_bvh.c - the hierarchy finds what a loop over all primitives finds, bit for bit.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "bvh_world.h"

#define RAYS 4000
#define MESH 158 /* 99,856 triangles */
#define MESH_RAYS 400

static brdf_vec3 vector_of(const float *words)
{
    return brdf_vec3_make(words[0], words[1], words[2]);
}

static struct pt_hit_record brute_force(const struct bvh_scene *scene, const float *r)
{
    struct pt_ray ray = {vector_of(r), vector_of(r + 3)};
    struct pt_hit_record best = {PT_MISS_T, 0.0f, 0.0f, -1};
    for (size_t i = 0; i < scene->count; ++i) {
        const float *row = scene->rows + PT_ROW * i;
        int kind = brdf_bits(row[PT_KIND]);
        struct pt_distance hit =
            kind == PT_SPHERE ? pt_sphere_distance(ray, vector_of(row), row[PT_RADIUS])
                              : pt_planar_distance(ray, vector_of(row), vector_of(row + PT_E1),
                                                   vector_of(row + PT_E2), kind);
        if (hit.t < best.t) {
            best.t = hit.t;
            best.u = hit.u;
            best.v = hit.v;
            best.prim = (int)i;
        }
    }
    return best;
}

/* Compare the first rays with brute force; returns how many of them hit. */
static size_t check_rays(const char *name, const struct bvh_scene *scene, size_t count)
{
    struct world world;
    world_make(scene, &world);
    size_t hits = 0;
    for (size_t i = 0; i < count; ++i) {
        const float *ray = scene->rays + RAY_WORDS * i;
        struct pt_hit_record expected = brute_force(scene, ray);
        assert_same_hit(name, i, expected, world_closest(&world, ray));
        hits += expected.prim >= 0;
        /* Just before the hit, at it, just behind it, and anywhere. */
        float limits[] = {nextafterf(expected.t, 0.0f), expected.t,
                          nextafterf(expected.t, PT_MISS_T), ray[6]};
        for (size_t k = 0; k < sizeof limits / sizeof limits[0]; ++k) {
            int occluded = world_occluded(&world, ray, limits[k]);
            if (occluded != (expected.t < limits[k])) {
                fail_msg("%s, ray %zu: occluded is %d up to %.9g, but the first hit is at %.9g",
                         name, i, occluded, (double)limits[k], (double)expected.t);
            }
        }
    }
    world_free(&world);
    return hits;
}

static void random_scenes_equal_brute_force(void **state)
{
    (void)state;
    for (size_t i = 0; i < recipe_count; ++i) {
        struct bvh_scene scene = bvh_scene_random(&recipes[i], RAYS);
        size_t hits = check_rays(recipes[i].name, &scene, RAYS);
        assert_in_range(hits, 20, RAYS);
        bvh_scene_free(&scene);
    }
}

static void mesh_equals_brute_force(void **state)
{
    (void)state;
    struct bvh_scene scene = bvh_scene_mesh(MESH, MESH_RAYS);
    assert_in_range(check_rays("mesh", &scene, MESH_RAYS), 20, MESH_RAYS);
    bvh_scene_free(&scene);
}

/* A ray towards a point in the plane of a triangle that meets the plane at a slope of 10^-exponent;
   both near the triangle and at its level beside it. */
static struct pt_ray grazing_ray(const float *row, int k, int exponent)
{
    double e1[3], e2[3], n[3], d[3], u = 0.3 * (k % 12) - 1.5, v = 0.3 * (k / 12) - 1.5;
    double length = 0.0, area = 0.0;
    float o[3];
    for (int i = 0; i < 3; ++i) {
        e1[i] = (double)row[PT_E1 + i];
        e2[i] = (double)row[PT_E2 + i];
    }
    for (int i = 0; i < 3; ++i) {
        int j = (i + 1) % 3, l = (i + 2) % 3;
        n[i] = e1[j] * e2[l] - e1[l] * e2[j];
        area += n[i] * n[i];
        d[i] = 0.7 * e1[i] - 0.4 * e2[i];
        length += d[i] * d[i];
    }
    for (int i = 0; i < 3; ++i) {
        d[i] = d[i] / sqrt(length) + pow(10.0, -exponent) * n[i] / sqrt(area);
        o[i] = (float)((double)row[PT_P + i] + u * e1[i] + v * e2[i] - 5.0 * d[i]);
    }
    struct pt_ray ray;
    ray.o = vector_of(o);
    ray.d = brdf_normalize(brdf_vec3_make((float)d[0], (float)d[1], (float)d[2]));
    return ray;
}

/* Does the ray meet the triangle? If so, it must do so in its box, as far as the hierarchy allows.
 */
static int meets_in_box(const float *row, struct pt_ray ray)
{
    struct bvh_box box;
    assert_true(bvh_primitive_box(row, &box));
    struct pt_distance hit = pt_planar_distance(ray, vector_of(row), vector_of(row + PT_E1),
                                                vector_of(row + PT_E2), PT_TRIANGLE);
    if (hit.t >= PT_MISS_T) {
        return 0;
    }
    brdf_vec3 at = brdf_add(ray.o, brdf_scale(ray.d, hit.t));
    float slack = PT_BVH_SLACK * (hit.t + 1.0f);
    assert_true(at.x >= box.lower[0] - slack && at.x <= box.upper[0] + slack);
    assert_true(at.y >= box.lower[1] - slack && at.y <= box.upper[1] + slack);
    assert_true(at.z >= box.lower[2] - slack && at.z <= box.upper[2] + slack);
    return 1;
}

/* Moeller and Trumbore would report hits of such rays that are noise, and in no box. */
static void grazing_rays_meet_what_they_hit(void **state)
{
    (void)state;
    const struct recipe grazed = {"grazed", 200, 1, 1.0f, 0.3f, 0.0f, 0, 1};
    struct bvh_scene scene = bvh_scene_random(&grazed, 1);
    int hits = 0;
    for (size_t i = 0; i < scene.count; ++i) {
        const float *row = scene.rows + PT_ROW * i;
        for (int k = 0; k < 144 * 8; ++k) {
            hits += meets_in_box(row, grazing_ray(row, k % 144, 2 + k / 144));
        }
    }
    assert_true(hits > 1000);
    bvh_scene_free(&scene);
}

/* Rounding makes slivers longer; rays around their tip, along the line of their edge. */
static void slivers_keep_to_their_box(void **state)
{
    (void)state;
    const struct recipe slivers = {"slivers", 1000, 1, 1.0f, 1.0f, 0.0f, -1, 1};
    struct bvh_scene scene = bvh_scene_random(&slivers, 1);
    int hits = 0;
    for (size_t i = 0; i < scene.count; ++i) {
        const float *row = scene.rows + PT_ROW * i;
        for (int k = 0; k < 400; ++k) {
            float u = 1.0f + 1.0e-4f * (float)(k - 200);
            brdf_vec3 target = brdf_add(vector_of(row), brdf_scale(vector_of(row + PT_E1), u));
            struct pt_ray ray;
            ray.d = brdf_normalize(brdf_vec3_make((float)(k % 7) - 2.8f, (float)(k % 5) - 1.7f,
                                                  (float)(k % 3) - 1.2f));
            ray.o = brdf_sub(target, brdf_scale(ray.d, 0.1f));
            hits += meets_in_box(row, ray);
        }
    }
    assert_true(hits > 1000);
    bvh_scene_free(&scene);
}

static void ties_go_to_the_smallest_number(void **state)
{
    (void)state;
    struct recipe twins = {"twins", 100, 1, 0.1f, 1.0f, 0.0f, 0, 100};
    struct bvh_scene scene = bvh_scene_random(&twins, 1000);
    struct world world;
    world_make(&scene, &world);
    size_t hits = 0;
    for (size_t i = 0; i < scene.ray_count; ++i) {
        int prim = world_closest(&world, scene.rays + RAY_WORDS * i).prim;
        assert_true(prim == 0 || prim == -1);
        hits += prim == 0;
    }
    assert_true(hits > 50);
    world_free(&world);
    bvh_scene_free(&scene);
}

static void known_distances(void **state)
{
    (void)state;
    float rows[2 * PT_ROW] = {0};
    float *sphere = rows, *rectangle = rows + PT_ROW;
    sphere[PT_P + 2] = 5.0f;
    sphere[PT_RADIUS] = 1.0f;
    sphere[PT_KIND] = brdf_from_bits(PT_SPHERE);
    rectangle[PT_P] = rectangle[PT_P + 1] = -1.0f;
    rectangle[PT_P + 2] = 7.0f;
    rectangle[PT_E1] = rectangle[PT_E2 + 1] = 2.0f;
    rectangle[PT_KIND] = brdf_from_bits(PT_RECTANGLE);
    struct bvh_scene scene = {rows, 2, NULL, 0};
    struct world world;
    world_make(&scene, &world);

    float ray[RAY_WORDS] = {0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};
    struct pt_hit_record hit = world_closest(&world, ray);
    assert_int_equal(hit.prim, 0);
    assert_true(hit.t == 4.0f);
    ray[2] = 6.5f;
    ray[0] = 0.5f;
    hit = world_closest(&world, ray);
    assert_int_equal(hit.prim, 1);
    assert_true(hit.t == 0.5f && hit.u == 0.75f && hit.v == 0.5f);
    ray[0] = 1.5f;
    assert_int_equal(world_closest(&world, ray).prim, -1);
    world_free(&world);
}

static void nothing_is_hit_where_nothing_is(void **state)
{
    (void)state;
    float degenerate[PT_ROW] = {0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f, 2.0f};
    struct bvh_scene scenes[] = {{degenerate, 0, NULL, 0}, {degenerate, 1, NULL, 0}};
    float ray[RAY_WORDS] = {0.5f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};
    for (size_t i = 0; i < 2; ++i) {
        struct world world;
        world_make(&scenes[i], &world);
        struct pt_hit_record hit = world_closest(&world, ray);
        assert_int_equal(hit.prim, -1);
        assert_true(hit.t >= PT_MISS_T);
        assert_false(world_occluded(&world, ray, PT_MISS_T));
        world_free(&world);
    }
}

static void builds_are_the_same(void **state)
{
    (void)state;
    struct bvh_scene scene = bvh_scene_mesh(60, 1);
    struct bvh first, second;
    struct brdf_error error;
    for (int i = 0; i < 4; ++i) {
        assert_int_equal(bvh_build(scene.rows, scene.count, &first, &error), BRDF_OK);
        assert_int_equal(bvh_build(scene.rows, scene.count, &second, &error), BRDF_OK);
        assert_int_equal(first.root, second.root);
        assert_int_equal(first.node_words, second.node_words);
        assert_int_equal(first.leaf_words, second.leaf_words);
        assert_memory_equal(first.nodes, second.nodes, first.node_words * sizeof(float));
        assert_memory_equal(first.leaves, second.leaves, first.leaf_words * sizeof(float));
        bvh_destroy(&first);
        bvh_destroy(&second);
    }
    bvh_scene_free(&scene);
}

static void depth_is_bounded(void **state)
{
    (void)state;
    struct bvh_scene scene = bvh_scene_nested(1500, 300);
    struct world world;
    world_make(&scene, &world);
    assert_in_range(world.bvh.depth, 1, PT_BVH_DEPTH);
    world_free(&world);
    assert_true(check_rays("nested", &scene, scene.ray_count) > 20);
    bvh_scene_free(&scene);
}

static void bad_coordinates_are_refused(void **state)
{
    (void)state;
    const float bad[] = {NAN, INFINITY, -INFINITY, 1.0e19f};
    const struct recipe recipe = {"good", 40, 15, 1.0f, 0.1f, 0.0f, 0, 1};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        struct bvh_scene scene = bvh_scene_random(&recipe, 1);
        struct bvh bvh;
        struct brdf_error error;
        scene.rows[PT_ROW * 37 + PT_P + 1] = bad[i];
        assert_int_equal(bvh_build(scene.rows, scene.count, &bvh, &error), BRDF_OUT_OF_RANGE);
        assert_non_null(strstr(error.message, "primitive 37"));
        assert_null(bvh.nodes);
        assert_null(bvh.leaves);
        bvh_scene_free(&scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_scenes_equal_brute_force),
        cmocka_unit_test(mesh_equals_brute_force),
        cmocka_unit_test(grazing_rays_meet_what_they_hit),
        cmocka_unit_test(slivers_keep_to_their_box),
        cmocka_unit_test(ties_go_to_the_smallest_number),
        cmocka_unit_test(known_distances),
        cmocka_unit_test(nothing_is_hit_where_nothing_is),
        cmocka_unit_test(builds_are_the_same),
        cmocka_unit_test(depth_is_bounded),
        cmocka_unit_test(bad_coordinates_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
