/*
 * test_bvh_opencl.c - the hierarchy finds the same bits in OpenCL as in C, at every number of
 * lanes.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "bvh_world.h"
#include "opencl.h"

#define RAYS 2000
#define MESH 158 /* 99,856 triangles */
#define MESH_RAYS 20000

static const char program_text[] =
    "#include \"kernels/bvh.h\"\n"
    "kernel void trace(global const struct pt_settings *settings, global const float *scene,\n"
    "                  global const float *rays, global float *hits)\n"
    "{\n"
    "    size_t i = get_global_id(0);\n"
    "    global const float *r = rays + 8 * i;\n"
    "    struct pt_bvh_ray ray = {r[0], r[1], r[2], r[3], r[4], r[5]};\n"
    "    struct pt_hit_record hit = pt_bvh_closest(settings, scene, ray);\n"
    "    hits[5 * i] = hit.t;\n"
    "    hits[5 * i + 1] = hit.u;\n"
    "    hits[5 * i + 2] = hit.v;\n"
    "    hits[5 * i + 3] = as_float(hit.prim);\n"
    "    hits[5 * i + 4] = pt_bvh_occluded(settings, scene, ray, r[6]) ? 1.0f : 0.0f;\n"
    "}\n";

static void check_cl(cl_int status, const char *call)
{
    struct brdf_error error;
    if (opencl_check(status, call, &error) != BRDF_OK) {
        fail_msg("%s", error.message);
    }
}

/* All rays of a scene on the device: t, u, v, primitive and occluded for each. */
static void trace_on(struct brdfcl_device *device, cl_kernel kernel, const struct world *world,
                     const struct bvh_scene *scene, float *hits)
{
    struct brdf_error error;
    size_t words = world->bvh.node_words + world->bvh.leaf_words;
    size_t hit_bytes = scene->ray_count * 5 * sizeof(float);
    cl_mem buffers[4];
    brdf_status status =
        opencl_buffer_over(device, &world->settings, sizeof world->settings, &buffers[0], &error);
    status |= opencl_buffer_over(device, world->words, words * sizeof(float), &buffers[1], &error);
    status |= opencl_buffer_over(device, scene->rays, scene->ray_count * RAY_WORDS * sizeof(float),
                                 &buffers[2], &error);
    status |= opencl_buffer(device, hit_bytes, &buffers[3], &error);
    assert_int_equal(status, BRDF_OK);
    for (cl_uint i = 0; i < 4; ++i) {
        check_cl(clSetKernelArg(kernel, i, sizeof buffers[i], &buffers[i]), "clSetKernelArg");
    }
    check_cl(clEnqueueNDRangeKernel(device->queue, kernel, 1, NULL, &scene->ray_count, NULL, 0,
                                    NULL, NULL),
             "clEnqueueNDRangeKernel");
    check_cl(
        clEnqueueReadBuffer(device->queue, buffers[3], CL_TRUE, 0, hit_bytes, hits, 0, NULL, NULL),
        "clEnqueueReadBuffer");
    for (int i = 0; i < 4; ++i) {
        clReleaseMemObject(buffers[i]);
    }
}

static void compare_on(struct brdfcl_device *device, cl_kernel kernel, const char *name,
                       struct bvh_scene scene)
{
    struct world world;
    world_make(&scene, &world);
    float *hits = malloc(scene.ray_count * 5 * sizeof *hits);
    assert_non_null(hits);
    trace_on(device, kernel, &world, &scene, hits);
    for (size_t i = 0; i < scene.ray_count; ++i) {
        const float *ray = scene.rays + RAY_WORDS * i;
        const float *hit = hits + 5 * i;
        struct pt_hit_record got = {hit[0], hit[1], hit[2], brdf_bits(hit[3])};
        assert_same_hit(name, i, world_closest(&world, ray), got);
        assert_int_equal(hit[4] != 0.0f, world_occluded(&world, ray, ray[6]));
    }
    free(hits);
    world_free(&world);
    bvh_scene_free(&scene);
}

static void opencl_equals_c(void **state)
{
    int lanes = *(const int *)*state;
    struct brdfcl_device *device;
    struct brdf_error error;
    if (brdfcl_device_open(NULL, lanes, 0, &device, &error) != BRDF_OK) {
        skip();
    }
    cl_program program;
    const struct opencl_materials none = {0};
    if (opencl_build(device, brdfcl_device_lanes(device), &none, program_text, "trace.cl", "",
                     &program, &error) != BRDF_OK) {
        fail_msg("%s", error.message);
    }
    cl_int status;
    cl_kernel kernel = clCreateKernel(program, "trace", &status);
    check_cl(status, "clCreateKernel");
    for (size_t i = 0; i < recipe_count; ++i) {
        compare_on(device, kernel, recipes[i].name, bvh_scene_random(&recipes[i], RAYS));
    }
    compare_on(device, kernel, "nested", bvh_scene_nested(1500, 300));
    compare_on(device, kernel, "mesh", bvh_scene_mesh(MESH, MESH_RAYS));
    clReleaseKernel(kernel);
    clReleaseProgram(program);
    brdfcl_device_close(device);
}

int main(void)
{
    static int lanes[] = {1, 4, 8, 16};
#define AT_LANES(i, name)                                                                          \
    {                                                                                              \
        name, opencl_equals_c, NULL, NULL, &lanes[i]                                               \
    }
    const struct CMUnitTest tests[] = {
        AT_LANES(0, "opencl_equals_c at 1 lane"),
        AT_LANES(1, "opencl_equals_c at 4 lanes"),
        AT_LANES(2, "opencl_equals_c at 8 lanes"),
        AT_LANES(3, "opencl_equals_c at 16 lanes"),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
