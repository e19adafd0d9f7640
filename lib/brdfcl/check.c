/*
 * check.c - C against OpenCL over random materials, directions and numbers.
 */
#include <brdfcl/check.h>
#include <brdfcl/device.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/surface.h>

#include "check_cases.h"
#include "check_device.h"
#include "check_variants.h"

enum { MATERIALS = 64, OPERATIONS = 3 };

/* The planes of each operation's results: [first, end). */
static const struct operation {
    const char *name;
    int first;
    int end;
} operations[OPERATIONS] = {{"eval", 0, 3}, {"pdf", 3, 4}, {"sample", 4, CHECK_OUTPUTS}};

struct check {
    const struct brdf_model_info *model;
    struct brdfcl_random random;
    int base;               /* check_cases.h */
    struct brdf_bsdf *bsdf; /* that base; owns the table */
    const float *table;
    struct brdf_material material; /* of this batch */
    brdf_parameters parameters;    /* the same, unpacked */
    struct check_device *device;
    size_t stride;    /* calls in a batch: the length of a plane */
    float *input;     /* planes of wo, wi and u */
    float *reference; /* output of C */
    float *output;    /* output of OpenCL */
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

/* Say which call it was, so that it can be made again. */
static void describe_call(struct check *check, size_t i, int plane, char *text, size_t size)
{
    const float *in = check->input + i;
    size_t n = check->stride;
    int length = snprintf(text, size, "output %d is %.9g in C, %.9g in OpenCL; wo = ", plane,
                          (double)check->reference[(size_t)plane * n + i],
                          (double)check->output[(size_t)plane * n + i]);
    for (size_t k = 0; k < CHECK_INPUTS; ++k) {
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

static brdf_status run_batch(struct check *check, struct brdf_error *error)
{
    make_inputs(check);
    run_c(check);
    brdf_status status =
        check_device_run(check->device, check->material.word, check->input, check->output, error);
    if (!status) {
        compare(check);
    }
    return status;
}

/* Variants with the initial parameters, then with others. */
static brdf_status run_variants(struct check *check, struct check_share share, int variants,
                                int batches, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    for (int variant = share.part; variant < variants && !status; variant += share.parts) {
        check->material = *brdf_bsdf_material(check->bsdf);
        brdfcl_check_material_vary(&check->material, check->model, variant);
        if (!brdfcl_check_base_serves(check->model, check->base, &check->material)) {
            continue;
        }
        status = check_device_build(check->device, &check->material, error);
        for (int batch = 0; batch < batches && !status; ++batch) {
            status = run_batch(check, error);
            brdfcl_check_material_change(&check->material, check->model, &check->random);
        }
    }
    return status;
}

static void base_close(struct check *check)
{
    check_device_close(check->device);
    brdf_bsdf_destroy(check->bsdf);
    check->device = NULL;
    check->bsdf = NULL;
}

/* The next base; no bsdf if there are no more. */
static brdf_status base_open(struct check *check, struct brdfcl_device *device,
                             struct brdf_error *error)
{
    size_t words = 0;
    brdf_status status = brdfcl_check_base_create(check->model, check->base, &check->bsdf, error);
    if (!status && check->bsdf) {
        check->table = brdf_bsdf_table(check->bsdf, &words);
        status =
            check_device_open(device, check->table, words, check->stride, &check->device, error);
    }
    return status;
}

static void check_close(struct check *check)
{
    base_close(check);
    free(check->input);
    free(check->reference);
    free(check->output);
    free(check);
}

static brdf_status check_reserve(struct check *check, struct brdf_error *error)
{
    size_t plane = check->stride * sizeof(float);
    check->input = malloc(CHECK_INPUTS * plane);
    check->reference = malloc(CHECK_OUTPUTS * plane);
    check->output = malloc(CHECK_OUTPUTS * plane);
    if (!check->input || !check->reference || !check->output) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu calls", check->stride);
    }
    return BRDF_OK;
}

static void name_results(struct check *check, int lanes)
{
    for (int k = 0; k < OPERATIONS; ++k) {
        check->result[k].model = check->model->name;
        check->result[k].operation = operations[k].name;
        check->result[k].lanes = lanes;
    }
}

brdf_status check_model_share(struct brdfcl_device *device, int model, size_t count, unsigned seed,
                              struct check_share share, brdfcl_check_report *report, void *data,
                              struct brdf_error *error)
{
    const struct brdf_model_info *info = brdf_model_info(model);
    if (!device || !info || !report) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "checking model %d: there is no such model, or no device, or no report",
                         model);
    }
    struct check *check = calloc(1, sizeof *check);
    if (!check) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for a check");
    }
    int variants = brdfcl_check_variant_count(info);
    share.parts = share.parts < variants ? share.parts : variants;
    share.part %= share.parts;
    int mine = (variants - share.part + share.parts - 1) / share.parts;
    int batches = (MATERIALS + mine - 1) / mine;
    size_t calls = count / (size_t)(mine * batches) + 1;
    check->model = info;
    check->random.state = seed;
    check->stride = (calls + CHECK_GROUP - 1) / CHECK_GROUP * CHECK_GROUP;
    name_results(check, brdfcl_device_lanes(device));
    brdf_status status = check_reserve(check, error);
    status = status ? status : base_open(check, device, error);
    while (!status && check->bsdf) {
        status = run_variants(check, share, variants, batches, error);
        base_close(check);
        ++check->base;
        status = status ? status : base_open(check, device, error);
    }
    for (int k = 0; k < OPERATIONS && !status; ++k) {
        report(&check->result[k], data);
    }
    check_close(check);
    return status;
}

brdf_status brdfcl_check_model(struct brdfcl_device *device, int model, size_t count, unsigned seed,
                               brdfcl_check_report *report, void *data, struct brdf_error *error)
{
    struct check_share all = {0, 1};
    return check_model_share(device, model, count, seed, all, report, data, error);
}
