/*
 * opencl.c - programs and buffers on a device, and OpenCL's errors as sentences.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "embedded.h"
#include "opencl.h"

#include <brdf/source.h>

const char *opencl_status_name(cl_int status)
{
    switch (status) {
#define NAME(value)                                                                                \
    case value:                                                                                    \
        return #value;
        NAME(CL_SUCCESS)
        NAME(CL_DEVICE_NOT_FOUND)
        NAME(CL_DEVICE_NOT_AVAILABLE)
        NAME(CL_COMPILER_NOT_AVAILABLE)
        NAME(CL_MEM_OBJECT_ALLOCATION_FAILURE)
        NAME(CL_OUT_OF_RESOURCES)
        NAME(CL_OUT_OF_HOST_MEMORY)
        NAME(CL_BUILD_PROGRAM_FAILURE)
        NAME(CL_INVALID_VALUE)
        NAME(CL_INVALID_BUFFER_SIZE)
        NAME(CL_INVALID_MEM_OBJECT)
        NAME(CL_INVALID_PROGRAM_EXECUTABLE)
        NAME(CL_INVALID_KERNEL_NAME)
        NAME(CL_INVALID_KERNEL_ARGS)
        NAME(CL_INVALID_ARG_SIZE)
        NAME(CL_INVALID_WORK_GROUP_SIZE)
        NAME(CL_INVALID_OPERATION)
#undef NAME
    default:
        return "an OpenCL error";
    }
}

brdf_status opencl_check(cl_int status, const char *call, struct brdf_error *error)
{
    if (status == CL_SUCCESS) {
        return BRDF_OK;
    }
    int memory = status == CL_MEM_OBJECT_ALLOCATION_FAILURE || status == CL_OUT_OF_RESOURCES ||
                 status == CL_OUT_OF_HOST_MEMORY || status == CL_INVALID_BUFFER_SIZE;
    return brdf_fail(error, memory ? BRDF_OUT_OF_MEMORY : BRDF_DEVICE, "%s: %s (%d)%s", call,
                     opencl_status_name(status), status,
                     memory ? ": the device has too little memory for this; make the scene or the "
                              "image smaller, or use the C renderer (--backend c)"
                            : "");
}

/* The compiler's log, shortened to its beginning, where the first error is. */
static brdf_status build_failed(struct brdfcl_device *device, cl_program program, const char *name,
                                struct brdf_error *error)
{
    size_t size = 0;
    clGetProgramBuildInfo(program, device->id, CL_PROGRAM_BUILD_LOG, 0, NULL, &size);
    char *log = calloc(size + 1, 1);
    if (log) {
        clGetProgramBuildInfo(program, device->id, CL_PROGRAM_BUILD_LOG, size, log, NULL);
    }
    brdf_fail(error, BRDF_DEVICE, "%s: the OpenCL compiler of %s refused it:\n%.800s", name,
              device->info.name, log ? log : "(no log)");
    free(log);
    return BRDF_DEVICE;
}

brdf_status opencl_build(struct brdfcl_device *device, int lanes,
                         const struct opencl_materials *materials, const char *text,
                         const char *text_name, const char *options, cl_program *program,
                         struct brdf_error *error)
{
    *program = NULL;
    char *expanded = NULL;
    brdf_status result = opencl_expand(materials, text, text_name, &expanded, error);
    if (result != BRDF_OK) {
        return result;
    }
    char all_options[512];
    cl_device_fp_config precision = 0;
    clGetDeviceInfo(device->id, CL_DEVICE_SINGLE_FP_CONFIG, sizeof precision, &precision, NULL);
    snprintf(all_options, sizeof all_options, "-cl-std=CL1.2 %s -DBRDF_LANES=%d %s",
             precision & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT
                 ? "-cl-fp32-correctly-rounded-divide-sqrt"
                 : "",
             lanes, options);

    const char *source = expanded;
    cl_int status;
    *program = clCreateProgramWithSource(device->context, 1, &source, NULL, &status);
    result = opencl_check(status, "clCreateProgramWithSource", error);
    if (result == BRDF_OK) {
        status = clBuildProgram(*program, 1, &device->id, all_options, NULL, NULL);
        if (status != CL_SUCCESS) {
            result = build_failed(device, *program, text_name, error);
        }
    }
    if (result != BRDF_OK && *program) {
        clReleaseProgram(*program);
        *program = NULL;
    }
    free(expanded);
    return result;
}

brdf_status opencl_buffer_over(struct brdfcl_device *device, const void *data, size_t bytes,
                               cl_mem *buffer, struct brdf_error *error)
{
    if (bytes == 0) {
        return opencl_buffer(device, 64, buffer, error);
    }
    /* The host never writes through it, and kernels only read: the cast takes nothing away. */
    void *memory = (void *)(uintptr_t)data;
    cl_mem_flags how = device->info.cpu ? CL_MEM_USE_HOST_PTR : CL_MEM_COPY_HOST_PTR;
    cl_int status;
    *buffer = clCreateBuffer(device->context, CL_MEM_READ_ONLY | how, bytes, memory, &status);
    return opencl_check(status, "clCreateBuffer", error);
}

brdf_status opencl_buffer(struct brdfcl_device *device, size_t bytes, cl_mem *buffer,
                          struct brdf_error *error)
{
    cl_int status;
    *buffer = clCreateBuffer(device->context, CL_MEM_READ_WRITE, bytes, NULL, &status);
    return opencl_check(status, "clCreateBuffer", error);
}
