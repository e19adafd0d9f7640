/*
 * test_models_opencl.c - every model gives the same bits in C and in OpenCL, at every lane count;
 * and what crosses to the device lies there as it does here.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include <brdfcl/check.h>

#include "check_variants.h"
#include "kernels/scene.h"
#include "opencl.h"
#include "support_models.h"

static const int lane_counts[] = {1, 4, 8, 16, 32};

enum { LANE_COUNTS = sizeof lane_counts / sizeof lane_counts[0] };

static void skip_without_device(void)
{
    if (brdfcl_device_count() == 0) {
        print_message("no OpenCL device\n");
        skip();
    }
}

static struct brdfcl_device *device_open(int lanes)
{
    struct brdfcl_device *device;
    struct brdf_error error;
    if (brdfcl_device_open(NULL, lanes, 0, &device, &error)) {
        fail_msg("%s", error.message);
    }
    return device;
}

struct totals {
    struct model_cases *cases;
    int reports;
};

static void report(const struct brdfcl_check_result *result, void *data)
{
    struct totals *totals = data;
    ++totals->reports;
    if (result->compared < 60000) {
        models_fail(totals->cases, &totals->cases->set.items[0], "only %zu compared",
                    result->compared);
    }
    if (result->differing) {
        models_fail(totals->cases, &totals->cases->set.items[0],
                    "%s at %d lanes: %zu of %zu differ, by up to %u ulp; the first: %s",
                    result->operation, result->lanes, result->differing, result->compared,
                    result->max_ulp, result->first);
    }
}

/*
 * Compiling every variant at every lane count would take minutes: the long form does it, and so
 * does `brdfcl check`. Here each model takes the device's own lane count and one of the others in
 * turns, and at each a share of its variants.
 */
static void same_bits_at_every_lane_count(void **state)
{
    struct model_cases *cases = *state;
    skip_without_device();
    size_t count = models_long() ? 10000000 : 65536;
    struct brdfcl_device *native = device_open(0);
    int native_lanes = brdfcl_device_lanes(native);
    brdfcl_device_close(native);
    for (int i = 0; i < LANE_COUNTS; ++i) {
        int turn = (i + cases->set.model->tag) % LANE_COUNTS == 0;
        if (!models_long() && lane_counts[i] != native_lanes && !turn) {
            continue;
        }
        struct brdfcl_device *device = device_open(lane_counts[i]);
        struct totals totals = {cases, 0};
        struct brdf_error error;
        struct check_share share = {i, models_long() ? 1 : LANE_COUNTS};
        if (check_model_share(device, cases->set.model->tag, count, 1, share, report, &totals,
                              &error)) {
            fail_msg("%s", error.message);
        }
        assert_int_equal(totals.reports, 3);
        brdfcl_device_close(device);
    }
    models_verdict(cases);
}

/* Every structure that crosses: its size, and where its members are. One list for both sides. */
#define STRUCTURES(SIZE, MEMBER)                                                                   \
    SIZE(brdf_material)                                                                            \
    MEMBER(brdf_material, model)                                                                   \
    MEMBER(brdf_material, flags)                                                                   \
    MEMBER(brdf_material, choices)                                                                 \
    MEMBER(brdf_material, table)                                                                   \
    MEMBER(brdf_material, word)                                                                    \
    MEMBER(brdf_material, word[BRDF_MATERIAL_WORDS - 1])                                           \
    SIZE(pt_surface)                                                                               \
    MEMBER(pt_surface, material)                                                                   \
    MEMBER(pt_surface, radiance)                                                                   \
    MEMBER(pt_surface, emits)                                                                      \
    MEMBER(pt_surface, variant)                                                                    \
    SIZE(pt_settings)                                                                              \
    MEMBER(pt_settings, camera_origin)                                                             \
    MEMBER(pt_settings, width)                                                                     \
    MEMBER(pt_settings, filter_radius)                                                             \
    MEMBER(pt_settings, features)                                                                  \
    MEMBER(pt_settings, primitives)                                                                \
    MEMBER(pt_settings, root)                                                                      \
    MEMBER(pt_settings, environment_radiance)                                                      \
    MEMBER(pt_settings, environment_to_world)                                                      \
    MEMBER(pt_settings, environment_column_steps)

#define HOST_SIZE(type) {"sizeof " #type, sizeof(struct type)},
#define HOST_MEMBER(type, member) {#type "." #member, offsetof(struct type, member)},
#define DEVICE_SIZE(type) "*out++ = sizeof(struct " #type ");\n"
#define DEVICE_MEMBER(type, member)                                                                \
    "{ struct " #type " s; *out++ = (uint)((char *)&s." #member " - (char *)&s); }\n"

static const char layout_text[] = "#include \"kernels/scene.h\"\n"
                                  "kernel void layout(global uint *out)\n"
                                  "{\n" STRUCTURES(DEVICE_SIZE, DEVICE_MEMBER) "}\n";

static const struct {
    const char *name;
    size_t place;
} layout[] = {STRUCTURES(HOST_SIZE, HOST_MEMBER)};

enum { PLACES = sizeof layout / sizeof layout[0] };

static void run_layout(struct brdfcl_device *device, cl_uint places[PLACES])
{
    struct brdf_error error;
    cl_program program = NULL;
    cl_mem buffer = NULL;
    cl_int status;
    size_t one = 1;
    struct opencl_materials materials = {0};
    opencl_materials_add(&materials, 0, 0);
    if (opencl_build(device, brdfcl_device_lanes(device), &materials, layout_text, "layout", "",
                     &program, &error) ||
        opencl_buffer(device, PLACES * sizeof(cl_uint), &buffer, &error)) {
        fail_msg("%s", error.message);
    }
    cl_kernel kernel = clCreateKernel(program, "layout", &status);
    assert_int_equal(status, CL_SUCCESS);
    assert_int_equal(clSetKernelArg(kernel, 0, sizeof buffer, &buffer), CL_SUCCESS);
    assert_int_equal(
        clEnqueueNDRangeKernel(device->queue, kernel, 1, NULL, &one, &one, 0, NULL, NULL),
        CL_SUCCESS);
    assert_int_equal(clEnqueueReadBuffer(device->queue, buffer, CL_TRUE, 0,
                                         PLACES * sizeof(cl_uint), places, 0, NULL, NULL),
                     CL_SUCCESS);
    clReleaseMemObject(buffer);
    clReleaseKernel(kernel);
    clReleaseProgram(program);
}

static void structures_lie_on_the_device_as_here(void **state)
{
    (void)state;
    skip_without_device();
    for (int i = 0; i < LANE_COUNTS; ++i) {
        struct brdfcl_device *device = device_open(lane_counts[i]);
        cl_uint places[PLACES];
        run_layout(device, places);
        for (size_t k = 0; k < PLACES; ++k) {
            if (places[k] != layout[k].place) {
                fail_msg("%d lanes: %s is %u on the device, %zu here", lane_counts[i],
                         layout[k].name, places[k], layout[k].place);
            }
        }
        brdfcl_device_close(device);
    }
    assert_int_equal(sizeof(struct brdf_material), 128);
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    skip_without_device();
    struct brdfcl_device *device = device_open(1);
    struct brdf_error error;
    struct totals totals = {NULL, 0};
    assert_int_equal(brdfcl_check_model(device, -1, 1, 1, report, &totals, &error),
                     BRDF_BAD_ARGUMENT);
    assert_int_equal(brdfcl_check_model(device, brdf_model_count(), 1, 1, report, &totals, &error),
                     BRDF_BAD_ARGUMENT);
    assert_int_equal(brdfcl_check_model(NULL, 0, 1, 1, report, &totals, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(totals.reports, 0);
    brdfcl_device_close(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(structures_lie_on_the_device_as_here),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    const struct model_check checks[] = {
        {"same bits in OpenCL at every lane count", same_bits_at_every_lane_count, 0, 0},
    };
    int failures = cmocka_run_group_tests_name("OpenCL", tests, NULL, NULL);
    return failures + models_run(checks, sizeof checks / sizeof checks[0]);
}
