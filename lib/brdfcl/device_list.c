/*
 * device_list.c - which OpenCL devices there are, and what they say of themselves.
 */
#include <string.h>

#include "opencl.h"

#define PLATFORMS 32
#define DEVICES 64

int opencl_device_at(int index, cl_platform_id *platform, cl_device_id *id)
{
    cl_platform_id platforms[PLATFORMS];
    cl_uint platform_count = 0;
    if (clGetPlatformIDs(PLATFORMS, platforms, &platform_count) != CL_SUCCESS) {
        return 0;
    }
    for (cl_uint p = 0; p < platform_count && p < PLATFORMS; ++p) {
        cl_device_id devices[DEVICES];
        cl_uint count = 0;
        if (clGetDeviceIDs(platforms[p], CL_DEVICE_TYPE_ALL, DEVICES, devices, &count) !=
            CL_SUCCESS) {
            continue;
        }
        count = count < DEVICES ? count : DEVICES;
        if (index < (int)count) {
            *platform = platforms[p];
            *id = devices[index];
            return 1;
        }
        index -= (int)count;
    }
    return 0;
}

int brdfcl_device_count(void)
{
    cl_platform_id platform;
    cl_device_id id;
    int count = 0;
    while (opencl_device_at(count, &platform, &id)) {
        ++count;
    }
    return count;
}

static void copy_cut(char *text, size_t size, const char *whole)
{
    size_t length = strlen(whole);
    length = length < size ? length : size - 1;
    memcpy(text, whole, length);
    text[length] = '\0';
}

/* A string of the device, cut to the array; empty where the device has none. */
static void device_text(cl_device_id id, cl_device_info what, char *text, size_t size)
{
    char whole[1024] = "";
    if (clGetDeviceInfo(id, what, sizeof whole, whole, NULL) != CL_SUCCESS) {
        whole[0] = '\0';
    }
    copy_cut(text, size, whole);
}

static void platform_text(cl_platform_id id, cl_platform_info what, char *text, size_t size)
{
    char whole[1024] = "";
    if (clGetPlatformInfo(id, what, sizeof whole, whole, NULL) != CL_SUCCESS) {
        whole[0] = '\0';
    }
    copy_cut(text, size, whole);
}

void opencl_describe(cl_platform_id platform, cl_device_id id, struct brdfcl_device_info *info)
{
    memset(info, 0, sizeof *info);
    platform_text(platform, CL_PLATFORM_NAME, info->platform, sizeof info->platform);
    platform_text(platform, CL_PLATFORM_VERSION, info->platform_version,
                  sizeof info->platform_version);
    device_text(id, CL_DEVICE_NAME, info->name, sizeof info->name);
    device_text(id, CL_DEVICE_VERSION, info->version, sizeof info->version);
    device_text(id, CL_DRIVER_VERSION, info->driver, sizeof info->driver);

    cl_device_type type = 0;
    cl_uint units = 0;
    cl_uint lanes = 0;
    cl_ulong memory = 0;
    cl_ulong largest = 0;
    cl_bool available = CL_FALSE;
    clGetDeviceInfo(id, CL_DEVICE_TYPE, sizeof type, &type, NULL);
    clGetDeviceInfo(id, CL_DEVICE_MAX_COMPUTE_UNITS, sizeof units, &units, NULL);
    clGetDeviceInfo(id, CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT, sizeof lanes, &lanes, NULL);
    clGetDeviceInfo(id, CL_DEVICE_GLOBAL_MEM_SIZE, sizeof memory, &memory, NULL);
    clGetDeviceInfo(id, CL_DEVICE_MAX_MEM_ALLOC_SIZE, sizeof largest, &largest, NULL);
    clGetDeviceInfo(id, CL_DEVICE_AVAILABLE, sizeof available, &available, NULL);
    info->cpu = (type & CL_DEVICE_TYPE_CPU) != 0;
    info->compute_units = (int)units;
    info->native_lanes = lanes > 0 ? (int)lanes : 1;
    info->memory = memory;
    info->largest = largest;
    info->available = available == CL_TRUE;
}

brdf_status brdfcl_device_describe(int index, struct brdfcl_device_info *info,
                                   struct brdf_error *error)
{
    cl_platform_id platform;
    cl_device_id id;
    if (index < 0 || !opencl_device_at(index, &platform, &id)) {
        return brdf_fail(error, BRDF_NO_DEVICE, "there is no OpenCL device %d; there are %d", index,
                         brdfcl_device_count());
    }
    opencl_describe(platform, id, info);
    return BRDF_OK;
}
