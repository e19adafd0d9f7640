/*
 * check_device.c - running kernels/check.cl.
 */
#include "check_device.h"

#include <stdio.h>
#include <stdlib.h>

#include "opencl.h"

struct check_device {
    struct brdfcl_device *device;
    size_t stride;
    cl_program program;
    cl_kernel kernel;
    cl_mem word;
    cl_mem table;
    cl_mem input;
    cl_mem output;
};

brdf_status check_device_open(struct brdfcl_device *device, const float *table, size_t table_words,
                              size_t stride, struct check_device **out, struct brdf_error *error)
{
    size_t plane = stride * sizeof(float);
    struct check_device *check = calloc(1, sizeof *check);
    *out = check;
    if (!check) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for a check");
    }
    check->device = device;
    check->stride = stride;
    brdf_status status =
        opencl_buffer_over(device, table, table_words * sizeof(float), &check->table, error);
    if (!status) {
        status = opencl_buffer(device, BRDF_MATERIAL_WORDS * sizeof(float), &check->word, error);
    }
    if (!status) {
        status = opencl_buffer(device, CHECK_INPUTS * plane, &check->input, error);
    }
    if (!status) {
        status = opencl_buffer(device, CHECK_OUTPUTS * plane, &check->output, error);
    }
    return status;
}

static void release_program(struct check_device *check)
{
    if (check->kernel) {
        clReleaseKernel(check->kernel);
    }
    if (check->program) {
        clReleaseProgram(check->program);
    }
    check->kernel = NULL;
    check->program = NULL;
}

void check_device_close(struct check_device *check)
{
    if (!check) {
        return;
    }
    cl_mem buffers[] = {check->word, check->table, check->input, check->output};
    for (size_t i = 0; i < sizeof buffers / sizeof buffers[0]; ++i) {
        if (buffers[i]) {
            clReleaseMemObject(buffers[i]);
        }
    }
    release_program(check);
    free(check);
}

brdf_status check_device_build(struct check_device *check, const struct brdf_material *material,
                               struct brdf_error *error)
{
    char options[128];
    snprintf(options, sizeof options, "-DCHECK_MODEL=%s -DCHECK_FLAGS=%uu -DCHECK_CHOICES=%uu",
             opencl_model_tag(material->model), material->flags, material->choices);
    release_program(check);
    struct opencl_materials materials = {0};
    opencl_materials_add(&materials, material->model, material->choices);
    brdf_status status =
        opencl_build(check->device, check->device->lanes, &materials,
                     "#include \"kernels/check.cl\"\n", "check", options, &check->program, error);
    if (!status) {
        cl_int cl;
        check->kernel = clCreateKernel(check->program, "check", &cl);
        status = opencl_check(cl, "clCreateKernel", error);
    }
    return status;
}

static brdf_status set_arguments(struct check_device *check, struct brdf_error *error)
{
    cl_uint packets = (cl_uint)(check->stride / (size_t)check->device->lanes);
    const struct argument {
        size_t size;
        const void *value;
    } arguments[] = {
        {sizeof(cl_mem), &check->word},   {sizeof(cl_mem), &check->table},
        {sizeof packets, &packets},       {sizeof(cl_mem), &check->input},
        {sizeof(cl_mem), &check->output},
    };
    cl_int status = CL_SUCCESS;
    for (cl_uint i = 0; i < sizeof arguments / sizeof arguments[0] && status == CL_SUCCESS; ++i) {
        status = clSetKernelArg(check->kernel, i, arguments[i].size, arguments[i].value);
    }
    return opencl_check(status, "clSetKernelArg", error);
}

static brdf_status write_buffer(struct check_device *check, cl_mem buffer, const void *data,
                                size_t bytes, struct brdf_error *error)
{
    cl_int status =
        clEnqueueWriteBuffer(check->device->queue, buffer, CL_TRUE, 0, bytes, data, 0, NULL, NULL);
    return opencl_check(status, "clEnqueueWriteBuffer", error);
}

static brdf_status run_kernel(struct check_device *check, struct brdf_error *error)
{
    size_t packets = check->stride / (size_t)check->device->lanes;
    /* Left to itself, PoCL takes thousands of work-items a group, and their stack runs out. */
    size_t group = CHECK_GROUP / (size_t)check->device->lanes;
    cl_int status = clEnqueueNDRangeKernel(check->device->queue, check->kernel, 1, NULL, &packets,
                                           &group, 0, NULL, NULL);
    return opencl_check(status, "clEnqueueNDRangeKernel", error);
}

brdf_status check_device_run(struct check_device *check, const float *word, const float *input,
                             float *output, struct brdf_error *error)
{
    size_t plane = check->stride * sizeof(float);
    brdf_status status = write_buffer(check, check->input, input, CHECK_INPUTS * plane, error);
    if (!status) {
        status = write_buffer(check, check->word, word, BRDF_MATERIAL_WORDS * sizeof(float), error);
    }
    if (!status) {
        status = set_arguments(check, error);
    }
    if (!status) {
        status = run_kernel(check, error);
    }
    if (!status) {
        cl_int cl = clEnqueueReadBuffer(check->device->queue, check->output, CL_TRUE, 0,
                                        CHECK_OUTPUTS * plane, output, 0, NULL, NULL);
        status = opencl_check(cl, "clEnqueueReadBuffer", error);
    }
    return status;
}
