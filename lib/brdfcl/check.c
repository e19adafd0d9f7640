/*
 * check.c - C against OpenCL over random materials, directions and numbers.
 */
#include <brdfcl/check.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/surface.h>

#include "check_cases.h"
#include "opencl.h"

enum {
    MATERIALS = 64,
    INPUTS = 9,   /* planes of check.cl: wo, wi, u */
    OUTPUTS = 13, /* planes of check.cl: f, pdf, and a sample's wi, weight, pdf, eta, delta */
    OPERATIONS = 3,
    GROUP = 256 /* calls in a work-group, at any lanes */
};

/* The planes of each operation's results: [first, end). */
static const struct operation {
    const char *name;
    int first;
    int end;
} operations[OPERATIONS] = {{"eval", 0, 3}, {"pdf", 3, 4}, {"sample", 4, OUTPUTS}};

struct check {
    struct brdfcl_device *device;
    const struct brdf_model_info *model;
    size_t stride; /* calls in a batch: the length of a plane */
    struct brdfcl_random random;
    struct brdf_bsdf *bsdf; /* owns the table */
    const float *table;
    struct brdf_material material; /* of this batch */
    brdf_parameters parameters;    /* the same, unpacked */
    float *input;                  /* host memory of the planes */
    float *reference;              /* output of C */
    float *output;                 /* output of OpenCL */
    cl_program program;
    cl_kernel kernel;
    cl_mem word_buffer;
    cl_mem table_buffer;
    cl_mem input_buffer;
    cl_mem output_buffer;
    struct brdfcl_check_result result[OPERATIONS];
    char first[OPERATIONS][1024];
};

/* How many floats lie between two bit patterns, counted through zero. */
static unsigned ulp_between(float a, float b)
{
    int bits[2] = {brdf_bits(a), brdf_bits(b)};
    long long order[2];
    for (int i = 0; i < 2; ++i) {
        order[i] = bits[i] >= 0 ? bits[i] : -2147483648LL - bits[i];
    }
    long long distance = order[0] > order[1] ? order[0] - order[1] : order[1] - order[0];
    /* +0 and -0 differ in a bit, and must count. */
    return distance == 0 && bits[0] != bits[1] ? 1u : (unsigned)distance;
}

static brdf_vec3 vec_at(const float *plane, size_t stride, size_t i)
{
    return brdf_vec3_make(plane[i], plane[stride + i], plane[2 * stride + i]);
}

static void vec_put(float *plane, size_t stride, size_t i, float x, float y, float z)
{
    plane[i] = x;
    plane[stride + i] = y;
    plane[2 * stride + i] = z;
}

static void make_inputs(struct check *check)
{
    for (size_t i = 0; i < check->stride; ++i) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&check->random);
        vec_put(check->input, check->stride, i, in.wo.x, in.wo.y, in.wo.z);
        vec_put(check->input + 3 * check->stride, check->stride, i, in.wi.x, in.wi.y, in.wi.z);
        vec_put(check->input + 6 * check->stride, check->stride, i, in.u.x, in.u.y, in.u.z);
    }
}

static void run_c(struct check *check)
{
    const struct brdf_material *m = &check->material;
    size_t n = check->stride;
    float *out = check->reference;
    check->parameters = brdf_parameters_load(m->model, m->choices, m->word);
    const brdf_parameters p = check->parameters;
    for (size_t i = 0; i < n; ++i) {
        brdf_vec3 wo = vec_at(check->input, n, i);
        brdf_vec3 wi = vec_at(check->input + 3 * n, n, i);
        brdf_vec3 u = vec_at(check->input + 6 * n, n, i);
        brdf_rgb f = brdf_surface_eval(m->model, m->flags, p, wo, wi, check->table);
        struct brdf_sample s = brdf_surface_sample(m->model, m->flags, p, wo, u, check->table);
        vec_put(out, n, i, f.r, f.g, f.b);
        out[3 * n + i] = brdf_surface_pdf(m->model, m->flags, p, wo, wi, check->table);
        vec_put(out + 4 * n, n, i, s.wi.x, s.wi.y, s.wi.z);
        vec_put(out + 7 * n, n, i, s.weight.r, s.weight.g, s.weight.b);
        out[10 * n + i] = s.pdf;
        out[11 * n + i] = s.eta;
        out[12 * n + i] = s.delta ? 1.0f : 0.0f;
    }
}

static brdf_status write_buffer(struct check *check, cl_mem buffer, const void *data, size_t bytes,
                                struct brdf_error *error)
{
    cl_int status =
        clEnqueueWriteBuffer(check->device->queue, buffer, CL_TRUE, 0, bytes, data, 0, NULL, NULL);
    return opencl_check(status, "clEnqueueWriteBuffer", error);
}

static brdf_status set_arguments(struct check *check, struct brdf_error *error)
{
    cl_uint packets = (cl_uint)(check->stride / (size_t)check->device->lanes);
    const struct argument {
        size_t size;
        const void *value;
    } arguments[] = {
        {sizeof(cl_mem), &check->word_buffer},
        {sizeof(cl_mem), &check->table_buffer},
        {sizeof packets, &packets},
        {sizeof(cl_mem), &check->input_buffer},
        {sizeof(cl_mem), &check->output_buffer},
    };
    cl_int status = CL_SUCCESS;
    for (cl_uint i = 0; i < sizeof arguments / sizeof arguments[0] && status == CL_SUCCESS; ++i) {
        status = clSetKernelArg(check->kernel, i, arguments[i].size, arguments[i].value);
    }
    return opencl_check(status, "clSetKernelArg", error);
}

static brdf_status run_opencl(struct check *check, struct brdf_error *error)
{
    size_t plane = check->stride * sizeof(float);
    size_t packets = check->stride / (size_t)check->device->lanes;
    brdf_status status =
        write_buffer(check, check->input_buffer, check->input, INPUTS * plane, error);
    if (!status) {
        status = write_buffer(check, check->word_buffer, check->material.word,
                              sizeof check->material.word, error);
    }
    if (!status) {
        status = set_arguments(check, error);
    }
    if (!status) {
        /* Left to itself, PoCL takes thousands of work-items a group, and their stack runs out. */
        size_t group = GROUP / (size_t)check->device->lanes;
        cl_int cl = clEnqueueNDRangeKernel(check->device->queue, check->kernel, 1, NULL, &packets,
                                           &group, 0, NULL, NULL);
        status = opencl_check(cl, "clEnqueueNDRangeKernel", error);
    }
    if (!status) {
        cl_int cl = clEnqueueReadBuffer(check->device->queue, check->output_buffer, CL_TRUE, 0,
                                        OUTPUTS * plane, check->output, 0, NULL, NULL);
        status = opencl_check(cl, "clEnqueueReadBuffer", error);
    }
    return status;
}

/* Say which call it was, so that it can be made again. */
static void describe_call(struct check *check, size_t i, int plane, char *text, size_t size)
{
    const float *in = check->input + i;
    size_t n = check->stride;
    int length = snprintf(text, size, "output %d is %.9g in C, %.9g in OpenCL; wo = ", plane,
                          (double)check->reference[(size_t)plane * n + i],
                          (double)check->output[(size_t)plane * n + i]);
    for (size_t k = 0; k < INPUTS; ++k) {
        length += snprintf(text + length, size - (size_t)length, "%s%.9g",
                           k == 0   ? ""
                           : k == 3 ? ", wi = "
                           : k == 6 ? ", u = "
                                    : "/",
                           (double)in[k * n]);
    }
    length += snprintf(text + length, size - (size_t)length, "; ");
    brdfcl_check_material_describe(&check->material, check->model, text + length,
                                   size - (size_t)length);
}

static void compare(struct check *check)
{
    for (int k = 0; k < OPERATIONS; ++k) {
        struct brdfcl_check_result *result = &check->result[k];
        for (size_t i = 0; i < check->stride; ++i) {
            unsigned worst = 0;
            int worst_plane = 0;
            for (int plane = operations[k].first; plane < operations[k].end; ++plane) {
                size_t at = (size_t)plane * check->stride + i;
                unsigned ulp = ulp_between(check->reference[at], check->output[at]);
                worst_plane = ulp > worst ? plane : worst_plane;
                worst = ulp > worst ? ulp : worst;
            }
            ++result->compared;
            if (worst && !result->differing++) {
                describe_call(check, i, worst_plane, check->first[k], sizeof check->first[k]);
                result->first = check->first[k];
            }
            result->max_ulp = worst > result->max_ulp ? worst : result->max_ulp;
        }
    }
}

static void release_program(struct check *check)
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

/* The kernel for the model, the flags and the choices of the material: constants, as in a render.
 */
static brdf_status open_program(struct check *check, struct brdf_error *error)
{
    char options[128];
    snprintf(options, sizeof options, "-DCHECK_MODEL=%uu -DCHECK_FLAGS=%uu -DCHECK_CHOICES=%uu",
             check->material.model, check->material.flags, check->material.choices);
    release_program(check);
    brdf_status status = opencl_build(check->device, "#include \"kernels/check.cl\"\n", "check",
                                      options, &check->program, error);
    if (!status) {
        cl_int cl;
        check->kernel = clCreateKernel(check->program, "check", &cl);
        status = opencl_check(cl, "clCreateKernel", error);
    }
    return status;
}

static brdf_status open_buffers(struct check *check, struct brdf_error *error)
{
    size_t plane = check->stride * sizeof(float);
    size_t words = 0;
    check->table = brdf_bsdf_table(check->bsdf, &words);
    check->input = malloc(INPUTS * plane);
    check->reference = malloc(OUTPUTS * plane);
    check->output = malloc(OUTPUTS * plane);
    if (!check->input || !check->reference || !check->output) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu calls", check->stride);
    }
    brdf_status status = opencl_buffer_over(check->device, check->table, words * sizeof(float),
                                            &check->table_buffer, error);
    if (!status) {
        status =
            opencl_buffer(check->device, sizeof check->material.word, &check->word_buffer, error);
    }
    if (!status) {
        status = opencl_buffer(check->device, INPUTS * plane, &check->input_buffer, error);
    }
    if (!status) {
        status = opencl_buffer(check->device, OUTPUTS * plane, &check->output_buffer, error);
    }
    return status;
}

static void release(struct check *check)
{
    cl_mem buffers[] = {check->word_buffer, check->table_buffer, check->input_buffer,
                        check->output_buffer};
    for (size_t i = 0; i < sizeof buffers / sizeof buffers[0]; ++i) {
        if (buffers[i]) {
            clReleaseMemObject(buffers[i]);
        }
    }
    release_program(check);
    free(check->input);
    free(check->reference);
    free(check->output);
    brdf_bsdf_destroy(check->bsdf);
    free(check);
}

static brdf_status run_batch(struct check *check, struct brdf_error *error)
{
    make_inputs(check);
    run_c(check);
    brdf_status status = run_opencl(check, error);
    if (!status) {
        compare(check);
    }
    return status;
}

/* Every variant with the initial parameters, then with others. */
static brdf_status run_variants(struct check *check, int variants, int batches,
                                struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    for (int variant = 0; variant < variants && !status; ++variant) {
        check->material = *brdf_bsdf_material(check->bsdf);
        brdfcl_check_material_vary(&check->material, check->model, variant);
        status = open_program(check, error);
        for (int batch = 0; batch < batches && !status; ++batch) {
            status = run_batch(check, error);
            brdfcl_check_material_change(&check->material, check->model, &check->random);
        }
    }
    return status;
}

brdf_status brdfcl_check_model(struct brdfcl_device *device, int model, size_t count, unsigned seed,
                               brdfcl_check_report *report, void *data, struct brdf_error *error)
{
    const struct brdf_model_info *info = brdf_model_info(model);
    if (!device || !info || !report) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "checking model %d: there is no such model, or "
                         "no device, or no report",
                         model);
    }
    struct check *check = calloc(1, sizeof *check);
    if (!check) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for a check");
    }
    check->device = device;
    check->model = info;
    check->random.state = seed;
    int variants = brdfcl_check_variant_count(info);
    int batches = (MATERIALS + variants - 1) / variants;
    size_t calls = count / (size_t)(variants * batches) + 1;
    check->stride = (calls + GROUP - 1) / GROUP * GROUP;
    for (int k = 0; k < OPERATIONS; ++k) {
        check->result[k].model = info->name;
        check->result[k].operation = operations[k].name;
        check->result[k].lanes = device->lanes;
    }
    brdf_status status = brdfcl_check_bsdf_create(info->name, &check->bsdf, error);
    status = status ? status : open_buffers(check, error);
    status = status ? status : run_variants(check, variants, batches, error);
    for (int k = 0; k < OPERATIONS && !status; ++k) {
        report(&check->result[k], data);
    }
    release(check);
    return status;
}
