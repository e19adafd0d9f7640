/*
 * evaluate.c - a bsdf over arrays on an OpenCL device.
 */
#define _POSIX_C_SOURCE 200809L
#include <brdfcl/evaluate.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <brdf/model.h>

#include "evaluate_arrays.h"
#include "opencl.h"

enum operation { EVAL, PDF, SAMPLE, BOUNCE, OPERATIONS };

struct brdfcl_evaluator {
    cl_program program;
    cl_kernel kernel[OPERATIONS];
    cl_mem word;
    cl_mem table;
    struct evaluate_arrays arrays;
    int last; /* operation of the last call; -1 before it */
};

static brdf_status build(struct brdfcl_evaluator *evaluator, const struct brdf_material *material,
                         struct brdf_error *error)
{
    static const char *const names[OPERATIONS] = {"evaluate_eval", "evaluate_pdf",
                                                  "evaluate_sample", "evaluate_bounce"};
    char options[128];
    snprintf(options, sizeof options,
             "-DEVALUATE_MODEL=%s -DEVALUATE_FLAGS=%uu -DEVALUATE_CHOICES=%uu",
             opencl_model_tag(material->model), material->flags, material->choices);
    struct opencl_materials materials = {0};
    opencl_materials_add(&materials, material->model, material->choices);
    brdf_status status = opencl_build(
        evaluator->arrays.device, evaluator->arrays.device->array_lanes, &materials,
        "#include \"kernels/evaluate.cl\"\n", "evaluate", options, &evaluator->program, error);
    for (int i = 0; i < OPERATIONS && !status; ++i) {
        cl_int cl;
        evaluator->kernel[i] = clCreateKernel(evaluator->program, names[i], &cl);
        status = opencl_check(cl, "clCreateKernel", error);
    }
    return status;
}

brdf_status brdfcl_evaluator_create(struct brdfcl_device *device, const struct brdf_bsdf *bsdf,
                                    struct brdfcl_evaluator **out, struct brdf_error *error)
{
    const struct brdf_material *material = brdf_bsdf_material(bsdf);
    size_t words = 0;
    const float *table = brdf_bsdf_table(bsdf, &words);
    *out = NULL;
    struct brdfcl_evaluator *evaluator = calloc(1, sizeof *evaluator);
    if (!evaluator) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for an evaluator");
    }
    evaluator->arrays.device = device;
    evaluator->last = -1;
    brdf_status status = build(evaluator, material, error);
    if (!status) {
        status = opencl_buffer_over(device, material->word, sizeof material->word, &evaluator->word,
                                    error);
    }
    if (!status) {
        status = opencl_buffer_over(device, table, words * sizeof(float), &evaluator->table, error);
    }
    if (status) {
        brdfcl_evaluator_destroy(evaluator);
        return status;
    }
    *out = evaluator;
    return BRDF_OK;
}

void brdfcl_evaluator_destroy(struct brdfcl_evaluator *evaluator)
{
    if (!evaluator) {
        return;
    }
    evaluate_arrays_release(&evaluator->arrays);
    if (evaluator->word) {
        clReleaseMemObject(evaluator->word);
    }
    if (evaluator->table) {
        clReleaseMemObject(evaluator->table);
    }
    for (int i = 0; i < OPERATIONS; ++i) {
        if (evaluator->kernel[i]) {
            clReleaseKernel(evaluator->kernel[i]);
        }
    }
    if (evaluator->program) {
        clReleaseProgram(evaluator->program);
    }
    free(evaluator);
}

static brdf_status get_samples(struct evaluate_arrays *arrays, size_t count, struct brdf_samples to,
                               struct brdf_error *error)
{
    void *const planes[] = {to.x,        to.y,   to.z,   to.weight.r, to.weight.g,
                            to.weight.b, to.pdf, to.eta, to.delta};
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < sizeof planes / sizeof planes[0] && !status; ++i) {
        status = evaluate_arrays_get(arrays, EVALUATE_OUT_SAMPLE + i, count, planes[i], error);
    }
    return status;
}

static brdf_status set_arguments(struct brdfcl_evaluator *evaluator, cl_kernel kernel,
                                 struct brdf_error *error)
{
    cl_ulong apart =
        (cl_ulong)(evaluator->arrays.stride / (size_t)evaluator->arrays.device->array_lanes);
    cl_int cl = clSetKernelArg(kernel, 0, sizeof(cl_mem), &evaluator->word);
    cl = cl ? cl : clSetKernelArg(kernel, 1, sizeof(cl_mem), &evaluator->table);
    cl = cl ? cl : clSetKernelArg(kernel, 2, sizeof apart, &apart);
    cl = cl ? cl : clSetKernelArg(kernel, 3, sizeof(cl_mem), &evaluator->arrays.input);
    cl = cl ? cl : clSetKernelArg(kernel, 4, sizeof(cl_mem), &evaluator->arrays.output);
    return opencl_check(cl, "clSetKernelArg", error);
}

static brdf_status launch(struct brdfcl_evaluator *evaluator, enum operation operation, int times,
                          struct brdf_error *error)
{
    cl_kernel kernel = evaluator->kernel[operation];
    size_t packets = evaluator->arrays.padded / (size_t)evaluator->arrays.device->array_lanes;
    /* Left to itself, PoCL takes thousands of work-items a group, and their stack runs out. */
    size_t group = EVALUATE_PADDING / (size_t)evaluator->arrays.device->array_lanes;
    brdf_status status = set_arguments(evaluator, kernel, error);
    for (int i = 0; i < times && !status; ++i) {
        cl_int cl = clEnqueueNDRangeKernel(evaluator->arrays.device->queue, kernel, 1, NULL,
                                           &packets, &group, 0, NULL, NULL);
        status = opencl_check(cl, "clEnqueueNDRangeKernel", error);
    }
    if (!status) {
        status = opencl_check(clFinish(evaluator->arrays.device->queue), "clFinish", error);
    }
    return status;
}

/* Copy the arrays in and run; `second` goes to the planes that the operation reads beside wo. */
static brdf_status call(struct brdfcl_evaluator *evaluator, enum operation operation, size_t count,
                        struct brdf_vectors wo, struct brdf_vectors second,
                        struct brdf_error *error)
{
    size_t plane = operation == EVAL || operation == PDF ? EVALUATE_IN_WI : EVALUATE_IN_U;
    brdf_status status = evaluate_arrays_fit(&evaluator->arrays, count, error);
    status =
        status ? status : evaluate_arrays_put(&evaluator->arrays, EVALUATE_IN_WO, count, wo, error);
    status = status ? status : evaluate_arrays_put(&evaluator->arrays, plane, count, second, error);
    status = status ? status : launch(evaluator, operation, 1, error);
    evaluator->last = status ? -1 : (int)operation;
    return status;
}

brdf_status brdfcl_evaluator_eval(struct brdfcl_evaluator *evaluator, size_t count,
                                  struct brdf_vectors wo, struct brdf_vectors wi,
                                  struct brdf_colors f, struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, EVAL, count, wo, wi, error);
    return status ? status
                  : evaluate_arrays_get_colors(&evaluator->arrays, EVALUATE_OUT_F, count, f, error);
}

brdf_status brdfcl_evaluator_pdf(struct brdfcl_evaluator *evaluator, size_t count,
                                 struct brdf_vectors wo, struct brdf_vectors wi, float *pdf,
                                 struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, PDF, count, wo, wi, error);
    return status ? status
                  : evaluate_arrays_get(&evaluator->arrays, EVALUATE_OUT_PDF, count, pdf, error);
}

brdf_status brdfcl_evaluator_sample(struct brdfcl_evaluator *evaluator, size_t count,
                                    struct brdf_vectors wo, struct brdf_vectors u,
                                    struct brdf_samples samples, struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, SAMPLE, count, wo, u, error);
    return status ? status : get_samples(&evaluator->arrays, count, samples, error);
}

brdf_status brdfcl_evaluator_bounce(struct brdfcl_evaluator *evaluator, size_t count,
                                    struct brdf_vectors wo, struct brdf_vectors u,
                                    struct brdf_samples samples, struct brdf_colors f, float *pdf,
                                    struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, BOUNCE, count, wo, u, error);
    status = status ? status : get_samples(&evaluator->arrays, count, samples, error);
    status = status
                 ? status
                 : evaluate_arrays_get_colors(&evaluator->arrays, EVALUATE_OUT_F, count, f, error);
    return status ? status
                  : evaluate_arrays_get(&evaluator->arrays, EVALUATE_OUT_PDF, count, pdf, error);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

brdf_status brdfcl_evaluator_repeat(struct brdfcl_evaluator *evaluator, int times, double *seconds,
                                    struct brdf_error *error)
{
    if (evaluator->last < 0 || times < 1) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "repeating %d times: there must be a call to repeat, and once at least",
                         times);
    }
    double begin = now();
    brdf_status status = launch(evaluator, (enum operation)evaluator->last, times, error);
    *seconds = now() - begin;
    return status;
}
