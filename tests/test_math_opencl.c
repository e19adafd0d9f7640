/*
 * test_math_opencl.c - the elementary functions give the same bits in C and in OpenCL, at every
 * number of lanes, on every device of this machine that divides as IEEE 754 asks.
 */
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "math_functions.h"

#ifndef BRDFCL_SOURCE_DIR
#define BRDFCL_SOURCE_DIR "." /* tests run at the root of the source tree */
#endif

#define COUNT (1u << 20)
#define BYTES (COUNT * sizeof(float))
#define DEVICES 8

/* Arguments in, results of C, results of OpenCL; on the device three buffers in that order. */
struct fixture {
    cl_device_id devices[DEVICES];
    cl_uint device_count;
    float *a, *b, *expected, *got;
};

struct session {
    cl_context context;
    cl_command_queue queue;
    cl_program program;
    cl_mem buffers[3];
};

/* Every device of every platform that the bits can be asked of. */
static void devices_find(struct fixture *fixture)
{
    cl_platform_id platforms[8];
    cl_uint platform_count = 0;
    if (clGetPlatformIDs(8, platforms, &platform_count) != CL_SUCCESS) {
        return;
    }
    for (cl_uint p = 0; p < platform_count && p < 8; ++p) {
        cl_device_id devices[DEVICES];
        cl_uint count = 0;
        if (clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, DEVICES, devices, &count) !=
            CL_SUCCESS) {
            continue;
        }
        for (cl_uint d = 0; d < count && d < DEVICES && fixture->device_count < DEVICES; ++d) {
            cl_device_fp_config config = 0;
            clGetDeviceInfo(devices[d], CL_DEVICE_SINGLE_FP_CONFIG, sizeof config, &config, NULL);
            if (config & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) {
                fixture->devices[fixture->device_count++] = devices[d];
            }
        }
    }
}

static int fixture_make(void **state)
{
    struct fixture *fixture = calloc(1, sizeof *fixture);
    if (!fixture) {
        return -1;
    }
    fixture->a = malloc(BYTES);
    fixture->b = malloc(BYTES);
    fixture->expected = malloc(BYTES);
    fixture->got = malloc(BYTES);
    devices_find(fixture);
    *state = fixture;
    return fixture->a && fixture->b && fixture->expected && fixture->got ? 0 : -1;
}

static int fixture_free(void **state)
{
    struct fixture *fixture = *state;
    free(fixture->a);
    free(fixture->b);
    free(fixture->expected);
    free(fixture->got);
    free(fixture);
    return 0;
}

/* One kernel a function; the caller frees the text. */
static char *source_make(void)
{
    size_t size = 1 << 14;
    char *source = malloc(size);
    assert_non_null(source);
    int used = snprintf(source, size, "#include \"math.h\"\n");
    for (const struct math_function *f = math_functions; f->name; ++f) {
        used += snprintf(source + used, size - (size_t)used,
                         "__kernel void try_%s(__global const brdf_real *as,\n"
                         "    __global const brdf_real *bs, __global brdf_real *results)\n"
                         "{\n"
                         "    brdf_real a = as[get_global_id(0)];\n"
                         "    brdf_real b = bs[get_global_id(0)];\n"
                         "    results[get_global_id(0)] = %s;\n"
                         "}\n",
                         f->name, f->expression);
        assert_true((size_t)used < size);
    }
    return source;
}

static void session_open(struct session *session, cl_device_id device, int lanes)
{
    char options[1024];
    cl_int error = CL_SUCCESS;
    session->context = clCreateContext(NULL, 1, &device, NULL, NULL, &error);
    assert_int_equal(error, CL_SUCCESS);
    session->queue = clCreateCommandQueue(session->context, device, 0, &error);
    assert_int_equal(error, CL_SUCCESS);
    for (int i = 0; i < 3; ++i) {
        session->buffers[i] =
            clCreateBuffer(session->context, CL_MEM_READ_WRITE, BYTES, NULL, &error);
        assert_int_equal(error, CL_SUCCESS);
    }
    char *source = source_make();
    const char *text = source;
    session->program = clCreateProgramWithSource(session->context, 1, &text, NULL, &error);
    free(source);
    assert_int_equal(error, CL_SUCCESS);
    snprintf(options, sizeof options,
             "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt -DBRDF_LANES=%d -I%s", lanes,
             BRDFCL_SOURCE_DIR "/include/brdf");
    if (clBuildProgram(session->program, 1, &device, options, NULL, NULL) != CL_SUCCESS) {
        char log[4096] = "";
        clGetProgramBuildInfo(session->program, device, CL_PROGRAM_BUILD_LOG, sizeof log - 1, log,
                              NULL);
        fail_msg("%d lanes: %s", lanes, log);
    }
}

static void session_close(struct session *session)
{
    for (int i = 0; i < 3; ++i) {
        clReleaseMemObject(session->buffers[i]);
    }
    clReleaseProgram(session->program);
    clReleaseCommandQueue(session->queue);
    clReleaseContext(session->context);
}

static void session_run(struct session *session, struct fixture *fixture,
                        const struct math_function *f, int lanes)
{
    char name[64];
    size_t size = COUNT / (size_t)lanes;
    cl_int error = CL_SUCCESS;
    snprintf(name, sizeof name, "try_%s", f->name);
    cl_kernel kernel = clCreateKernel(session->program, name, &error);
    assert_int_equal(error, CL_SUCCESS);
    memset(fixture->got, 0xff, BYTES);
    const float *contents[] = {fixture->a, fixture->b, fixture->got};
    for (cl_uint i = 0; i < 3; ++i) {
        error |= clEnqueueWriteBuffer(session->queue, session->buffers[i], CL_TRUE, 0, BYTES,
                                      contents[i], 0, NULL, NULL);
        error |= clSetKernelArg(kernel, i, sizeof(cl_mem), &session->buffers[i]);
    }
    error |= clEnqueueNDRangeKernel(session->queue, kernel, 1, NULL, &size, NULL, 0, NULL, NULL);
    error |= clEnqueueReadBuffer(session->queue, session->buffers[2], CL_TRUE, 0, BYTES,
                                 fixture->got, 0, NULL, NULL);
    clReleaseKernel(kernel);
    assert_int_equal(error, CL_SUCCESS);
}

static void compare(const struct fixture *fixture, const struct math_function *f, int lanes)
{
    uint32_t differing = 0;
    uint32_t first = 0;
    for (uint32_t i = COUNT; i-- > 0;) {
        if (memcmp(&fixture->got[i], &fixture->expected[i], sizeof(float)) != 0) {
            ++differing;
            first = i;
        }
    }
    if (differing) {
        fail_msg("%s at %d lanes: %u of %u differ, first (%.9g, %.9g): C %.9g, OpenCL %.9g",
                 f->name, lanes, (unsigned)differing, (unsigned)COUNT, (double)fixture->a[first],
                 (double)fixture->b[first], (double)fixture->expected[first],
                 (double)fixture->got[first]);
    }
}

/* A sample of the domain; every 64th argument is a special one. */
static void arguments_fill(struct fixture *fixture, const struct math_function *f)
{
    static const float special[] = {0.0f, -0.0f, 1.0f, -1.0f, 0.5f, -0.5f, 8192.0f, -8192.0f};
    for (uint32_t i = 0; i < COUNT; ++i) {
        struct math_arguments arguments = math_arguments_make(f, i, COUNT);
        if (i % 64 == 0) {
            arguments.a = special[i / 64 % 8];
            arguments.b = special[i / 512 % 8];
        }
        fixture->a[i] = arguments.a;
        fixture->b[i] = arguments.b;
        fixture->expected[i] = f->ours(arguments.a, arguments.b);
    }
}

static void bits_are_those_of_c(void **state)
{
    static const int lanes[] = {1, 4, 8, 16, 32};
    struct fixture *fixture = *state;
    if (fixture->device_count == 0) {
        print_message("no OpenCL device with correctly rounded division\n");
        skip();
    }
    for (cl_uint d = 0; d < fixture->device_count; ++d) {
        struct session sessions[5];
        for (int i = 0; i < 5; ++i) {
            session_open(&sessions[i], fixture->devices[d], lanes[i]);
        }
        for (const struct math_function *f = math_functions; f->name; ++f) {
            arguments_fill(fixture, f);
            for (int i = 0; i < 5; ++i) {
                session_run(&sessions[i], fixture, f, lanes[i]);
                compare(fixture, f, lanes[i]);
            }
        }
        for (int i = 0; i < 5; ++i) {
            session_close(&sessions[i]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(bits_are_those_of_c, fixture_make, fixture_free),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
