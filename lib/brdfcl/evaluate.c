/*
 * evaluate.c - a bsdf over arrays on an OpenCL device.
 */
#define _POSIX_C_SOURCE 200809L
#include <brdfcl/evaluate.h>

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include <brdf/model.h>

#include "opencl.h"

/*
 * Elements are padded to whole packets at any lanes, and whole work-groups of them. Planes are some
 * cache lines further apart than that: at a power of two all of them would fall into one set of the
 * cache, which has room for fewer than an operation uses (five times slower for `diffuse`).
 */
enum { PADDING = 1024, APART = 80, COUNT_MAX = 1 << 30 };

/* The planes of evaluate.cl. */
enum {
    IN_WO = 0,
    IN_WI = 3,
    IN_U = 6,
    IN_PLANES = 9,
    OUT_F = 0,
    OUT_PDF = 3,
    OUT_SAMPLE = 4,
    OUT_PLANES = 13
};

enum operation { EVAL, PDF, SAMPLE, BOUNCE, OPERATIONS };

struct brdfcl_evaluator {
    struct brdfcl_device *device;
    cl_program program;
    cl_kernel kernel[OPERATIONS];
    cl_mem word;
    cl_mem table;
    cl_mem input;
    cl_mem output;
    size_t padded; /* elements that are computed */
    size_t stride; /* from a plane to the next, in elements */
    int last;      /* operation of the last call; -1 before it */
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
    brdf_status status =
        opencl_build(evaluator->device, &materials, "#include \"kernels/evaluate.cl\"\n",
                     "evaluate", options, &evaluator->program, error);
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
    evaluator->device = device;
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

static void release_arrays(struct brdfcl_evaluator *evaluator)
{
    if (evaluator->input) {
        clReleaseMemObject(evaluator->input);
    }
    if (evaluator->output) {
        clReleaseMemObject(evaluator->output);
    }
    evaluator->input = NULL;
    evaluator->output = NULL;
    evaluator->padded = 0;
    evaluator->stride = 0;
    evaluator->last = -1;
}

void brdfcl_evaluator_destroy(struct brdfcl_evaluator *evaluator)
{
    if (!evaluator) {
        return;
    }
    release_arrays(evaluator);
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

/* One number in a whole plane: what pads the arrays must be a direction, too. */
static brdf_status fill_plane(struct brdfcl_evaluator *evaluator, size_t plane, float value,
                              struct brdf_error *error)
{
    size_t bytes = evaluator->stride * sizeof(float);
    cl_int cl = clEnqueueFillBuffer(evaluator->device->queue, evaluator->input, &value,
                                    sizeof value, plane * bytes, bytes, 0, NULL, NULL);
    return opencl_check(cl, "clEnqueueFillBuffer", error);
}

/* Arrays for `count` elements; those that are there stay if they have just the right size. */
static brdf_status make_arrays(struct brdfcl_evaluator *evaluator, size_t count,
                               struct brdf_error *error)
{
    if (count > COUNT_MAX) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%zu elements are too many for one call: at most %d", count, COUNT_MAX);
    }
    size_t padded = (count + PADDING - 1) / PADDING * PADDING;
    size_t stride = padded + APART;
    if (padded == evaluator->padded) {
        return BRDF_OK;
    }
    release_arrays(evaluator);
    brdf_status status = opencl_buffer(evaluator->device, IN_PLANES * stride * sizeof(float),
                                       &evaluator->input, error);
    if (!status) {
        status = opencl_buffer(evaluator->device, OUT_PLANES * stride * sizeof(float),
                               &evaluator->output, error);
    }
    if (status) {
        release_arrays(evaluator);
        return status;
    }
    evaluator->padded = padded;
    evaluator->stride = stride;
    for (size_t plane = 0; plane < IN_PLANES && !status; ++plane) {
        float value = plane >= IN_U ? 0.5f : plane % 3 == 2 ? 1.0f : 0.0f;
        status = fill_plane(evaluator, plane, value, error);
    }
    return status;
}

static brdf_status put(struct brdfcl_evaluator *evaluator, size_t plane, size_t count,
                       struct brdf_vectors vectors, struct brdf_error *error)
{
    const float *const axes[3] = {vectors.x, vectors.y, vectors.z};
    cl_int cl = CL_SUCCESS;
    for (size_t i = 0; i < 3 && cl == CL_SUCCESS; ++i) {
        cl = clEnqueueWriteBuffer(evaluator->device->queue, evaluator->input, CL_TRUE,
                                  (plane + i) * evaluator->stride * sizeof(float),
                                  count * sizeof(float), axes[i], 0, NULL, NULL);
    }
    return opencl_check(cl, "clEnqueueWriteBuffer", error);
}

/* One plane of 4-byte words; not wanted where `to` is NULL. */
static brdf_status get(struct brdfcl_evaluator *evaluator, size_t plane, size_t count, void *to,
                       struct brdf_error *error)
{
    if (!to) {
        return BRDF_OK;
    }
    cl_int cl = clEnqueueReadBuffer(evaluator->device->queue, evaluator->output, CL_TRUE,
                                    plane * evaluator->stride * sizeof(float),
                                    count * sizeof(float), to, 0, NULL, NULL);
    return opencl_check(cl, "clEnqueueReadBuffer", error);
}

static brdf_status get_colors(struct brdfcl_evaluator *evaluator, size_t plane, size_t count,
                              struct brdf_colors to, struct brdf_error *error)
{
    brdf_status status = get(evaluator, plane, count, to.r, error);
    status = status ? status : get(evaluator, plane + 1, count, to.g, error);
    return status ? status : get(evaluator, plane + 2, count, to.b, error);
}

static brdf_status get_samples(struct brdfcl_evaluator *evaluator, size_t count,
                               struct brdf_samples to, struct brdf_error *error)
{
    struct brdf_colors wi = {to.x, to.y, to.z};
    brdf_status status = get_colors(evaluator, OUT_SAMPLE, count, wi, error);
    status = status ? status : get_colors(evaluator, OUT_SAMPLE + 3, count, to.weight, error);
    status = status ? status : get(evaluator, OUT_SAMPLE + 6, count, to.pdf, error);
    status = status ? status : get(evaluator, OUT_SAMPLE + 7, count, to.eta, error);
    return status ? status : get(evaluator, OUT_SAMPLE + 8, count, to.delta, error);
}

static brdf_status set_arguments(struct brdfcl_evaluator *evaluator, cl_kernel kernel,
                                 struct brdf_error *error)
{
    cl_ulong apart = (cl_ulong)(evaluator->stride / (size_t)evaluator->device->lanes);
    cl_int cl = clSetKernelArg(kernel, 0, sizeof(cl_mem), &evaluator->word);
    cl = cl ? cl : clSetKernelArg(kernel, 1, sizeof(cl_mem), &evaluator->table);
    cl = cl ? cl : clSetKernelArg(kernel, 2, sizeof apart, &apart);
    cl = cl ? cl : clSetKernelArg(kernel, 3, sizeof(cl_mem), &evaluator->input);
    cl = cl ? cl : clSetKernelArg(kernel, 4, sizeof(cl_mem), &evaluator->output);
    return opencl_check(cl, "clSetKernelArg", error);
}

static brdf_status launch(struct brdfcl_evaluator *evaluator, enum operation operation, int times,
                          struct brdf_error *error)
{
    cl_kernel kernel = evaluator->kernel[operation];
    size_t packets = evaluator->padded / (size_t)evaluator->device->lanes;
    /* Left to itself, PoCL takes thousands of work-items a group, and their stack runs out. */
    size_t group = PADDING / (size_t)evaluator->device->lanes;
    brdf_status status = set_arguments(evaluator, kernel, error);
    for (int i = 0; i < times && !status; ++i) {
        cl_int cl = clEnqueueNDRangeKernel(evaluator->device->queue, kernel, 1, NULL, &packets,
                                           &group, 0, NULL, NULL);
        status = opencl_check(cl, "clEnqueueNDRangeKernel", error);
    }
    if (!status) {
        status = opencl_check(clFinish(evaluator->device->queue), "clFinish", error);
    }
    return status;
}

/* Copy the arrays in and run; `second` goes to the planes that the operation reads beside wo. */
static brdf_status call(struct brdfcl_evaluator *evaluator, enum operation operation, size_t count,
                        struct brdf_vectors wo, struct brdf_vectors second,
                        struct brdf_error *error)
{
    size_t plane = operation == EVAL || operation == PDF ? IN_WI : IN_U;
    brdf_status status = make_arrays(evaluator, count, error);
    status = status ? status : put(evaluator, IN_WO, count, wo, error);
    status = status ? status : put(evaluator, plane, count, second, error);
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
    return status ? status : get_colors(evaluator, OUT_F, count, f, error);
}

brdf_status brdfcl_evaluator_pdf(struct brdfcl_evaluator *evaluator, size_t count,
                                 struct brdf_vectors wo, struct brdf_vectors wi, float *pdf,
                                 struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, PDF, count, wo, wi, error);
    return status ? status : get(evaluator, OUT_PDF, count, pdf, error);
}

brdf_status brdfcl_evaluator_sample(struct brdfcl_evaluator *evaluator, size_t count,
                                    struct brdf_vectors wo, struct brdf_vectors u,
                                    struct brdf_samples samples, struct brdf_error *error)
{
    if (count == 0) {
        return BRDF_OK;
    }
    brdf_status status = call(evaluator, SAMPLE, count, wo, u, error);
    return status ? status : get_samples(evaluator, count, samples, error);
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
    status = status ? status : get_samples(evaluator, count, samples, error);
    status = status ? status : get_colors(evaluator, OUT_F, count, f, error);
    return status ? status : get(evaluator, OUT_PDF, count, pdf, error);
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
