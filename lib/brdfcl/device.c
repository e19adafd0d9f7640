/*
 * device.c - opening an OpenCL device: which one, with how many lanes and threads.
 */
#define _POSIX_C_SOURCE 200809L
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "opencl.h"

static int contains_ignoring_case(const char *text, const char *part)
{
    size_t length = strlen(part);
    for (; *text; ++text) {
        size_t i = 0;
        while (i < length && tolower((unsigned char)text[i]) == tolower((unsigned char)part[i])) {
            ++i;
        }
        if (i == length) {
            return 1;
        }
    }
    return length == 0;
}

/* The device that `choice` means, or -1. */
static int device_index(const char *choice)
{
    cl_platform_id platform;
    cl_device_id id;
    struct brdfcl_device_info info;
    char *end;
    long number = strtol(choice, &end, 10);
    if (*choice && !*end) {
        return number >= 0 && number < brdfcl_device_count() ? (int)number : -1;
    }
    int first = -1;
    for (int i = 0; opencl_device_at(i, &platform, &id); ++i) {
        opencl_describe(platform, id, &info);
        int fits = contains_ignoring_case(info.name, choice) ||
                   contains_ignoring_case(info.platform, choice);
        if (fits && info.cpu) {
            return i;
        }
        if (fits && first < 0) {
            first = i;
        }
    }
    return first;
}

static brdf_status no_device(const char *choice, struct brdf_error *error)
{
    char known[512] = "";
    size_t used = 0;
    struct brdfcl_device_info info;
    for (int i = 0; i < 8 && brdfcl_device_describe(i, &info, NULL) == BRDF_OK; ++i) {
        int written =
            snprintf(known + used, sizeof known - used, "%s%d = %s", i ? ", " : "", i, info.name);
        used = written < 0 || used + (size_t)written >= sizeof known ? sizeof known - 1
                                                                     : used + (size_t)written;
    }
    if (!*known) {
        return brdf_fail(error, BRDF_NO_DEVICE,
                         "no OpenCL device found: install one (Debian: pocl-opencl-icd), or use "
                         "the C renderer (--backend c)");
    }
    return brdf_fail(error, BRDF_NO_DEVICE, "no OpenCL device fits \"%s\"; there are: %s", choice,
                     known);
}

/*
 * Where nobody chose: a vector of the device. Evaluators take two of a processor's, which hide each
 * other's latencies (up to 1.8 times as fast, docs/benchmark.md); a render's kernels have more
 * values than registers, and two vectors of each are slower.
 */
static void choose_lanes(struct brdfcl_device *device, int lanes)
{
    int native = device->info.native_lanes;
    int vector = native >= 16 ? 16 : native >= 8 ? 8 : native >= 4 ? 4 : 1;
    device->lanes = lanes != 0 ? lanes : vector;
    device->array_lanes = lanes != 0 ? lanes : vector * (device->info.cpu && vector > 1 ? 2 : 1);
}

brdf_status brdfcl_device_open(const char *choice, int lanes, int threads,
                               struct brdfcl_device **out, struct brdf_error *error)
{
    *out = NULL;
    if (lanes != 0 && lanes != 1 && lanes != 4 && lanes != 8 && lanes != 16 && lanes != 32) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%d lanes: there are kernels of 1, 4, 8, 16 and 32", lanes);
    }
    if (threads > 0) {
        char text[16];
        snprintf(text, sizeof text, "%d", threads);
        setenv("POCL_MAX_PTHREAD_COUNT", text, 1);
    }
    cl_platform_id platform;
    int index = device_index(choice ? choice : "");
    struct brdfcl_device *device = calloc(1, sizeof *device);
    if (!device) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for an OpenCL device");
    }
    if (index < 0 || !opencl_device_at(index, &platform, &device->id)) {
        free(device);
        return no_device(choice ? choice : "", error);
    }
    opencl_describe(platform, device->id, &device->info);
    choose_lanes(device, lanes);

    cl_int status;
    device->context = clCreateContext(NULL, 1, &device->id, NULL, NULL, &status);
    brdf_status result = opencl_check(status, "clCreateContext", error);
    if (result == BRDF_OK) {
        device->queue = clCreateCommandQueue(device->context, device->id, 0, &status);
        result = opencl_check(status, "clCreateCommandQueue", error);
    }
    if (result != BRDF_OK) {
        brdfcl_device_close(device);
        return result;
    }
    *out = device;
    return BRDF_OK;
}

void brdfcl_device_close(struct brdfcl_device *device)
{
    if (!device) {
        return;
    }
    if (device->queue) {
        clReleaseCommandQueue(device->queue);
    }
    if (device->context) {
        clReleaseContext(device->context);
    }
    free(device);
}

struct brdfcl_device_info brdfcl_device_get_info(const struct brdfcl_device *device)
{
    return device->info;
}

int brdfcl_device_lanes(const struct brdfcl_device *device)
{
    return device->lanes;
}

int brdfcl_device_array_lanes(const struct brdfcl_device *device)
{
    return device->array_lanes;
}
