/*
 * test_evaluate.c - a material over arrays on a device: the bits of C, for any number of elements.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/info.h>
#include <brdfcl/evaluate.h>

#include "check_cases.h"
#include "support_bsdf.h"

enum { COUNT = 1025, PLANES = 13 }; /* one more than a whole number of packets */

/* Results of one backend: f, pdf, and a sample's wi, weight, pdf, eta, delta. */
struct results {
    float plane[PLANES][COUNT];
};

struct inputs {
    float wo[3][COUNT];
    float wi[3][COUNT];
    float u[3][COUNT];
};

static struct brdf_vectors vectors_of(float planes[3][COUNT])
{
    struct brdf_vectors vectors = {planes[0], planes[1], planes[2]};
    return vectors;
}

static struct brdf_colors colors_of(float planes[][COUNT])
{
    struct brdf_colors colors = {planes[0], planes[1], planes[2]};
    return colors;
}

static struct brdf_samples samples_of(struct results *results)
{
    struct brdf_samples samples = {results->plane[4],
                                   results->plane[5],
                                   results->plane[6],
                                   colors_of(results->plane + 7),
                                   results->plane[10],
                                   results->plane[11],
                                   (int *)(void *)results->plane[12]};
    return samples;
}

static void inputs_make(struct inputs *inputs)
{
    struct brdfcl_random random = {7};
    for (size_t i = 0; i < COUNT; ++i) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&random);
        inputs->wo[0][i] = in.wo.x, inputs->wo[1][i] = in.wo.y, inputs->wo[2][i] = in.wo.z;
        inputs->wi[0][i] = in.wi.x, inputs->wi[1][i] = in.wi.y, inputs->wi[2][i] = in.wi.z;
        inputs->u[0][i] = in.u.x, inputs->u[1][i] = in.u.y, inputs->u[2][i] = in.u.z;
    }
}

/* The first `count` of each plane have the same bits, and nothing is written behind them. */
static void assert_same(const struct results *c, const struct results *opencl, size_t count,
                        const char *what)
{
    static const unsigned char untouched[4] = {0xa5, 0xa5, 0xa5, 0xa5};
    for (int k = 0; k < PLANES; ++k) {
        for (size_t i = 0; i < count; ++i) {
            if (memcmp(&c->plane[k][i], &opencl->plane[k][i], 4) != 0) {
                fail_msg("%s: plane %d, element %zu is %.9g in C and %.9g in OpenCL", what, k, i,
                         (double)c->plane[k][i], (double)opencl->plane[k][i]);
            }
        }
        for (size_t i = count; i < COUNT; ++i) {
            assert_memory_equal(&opencl->plane[k][i], untouched, 4);
        }
    }
}

/* Each operation by itself into one set of results. */
static void run_each(const struct brdf_bsdf *bsdf, struct brdfcl_evaluator *evaluator,
                     struct inputs *in, size_t count, const char *what)
{
    static struct results c, opencl;
    struct brdf_vectors wo = vectors_of(in->wo), wi = vectors_of(in->wi), u = vectors_of(in->u);
    memset(&c, 0xa5, sizeof c);
    memset(&opencl, 0xa5, sizeof opencl);
    brdf_eval_many(bsdf, count, wo, wi, colors_of(c.plane));
    brdf_pdf_many(bsdf, count, wo, wi, c.plane[3]);
    brdf_sample_many(bsdf, count, wo, u, samples_of(&c));

    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status =
        brdfcl_evaluator_eval(evaluator, count, wo, wi, colors_of(opencl.plane), &error);
    status =
        status ? status : brdfcl_evaluator_pdf(evaluator, count, wo, wi, opencl.plane[3], &error);
    status = status ? status
                    : brdfcl_evaluator_sample(evaluator, count, wo, u, samples_of(&opencl), &error);
    if (status) {
        fail_msg("%s: %s", what, error.message);
    }
    assert_same(&c, &opencl, count, what);
}

/* A sample, and f and pdf for its direction, at once. */
static void run_bounce(const struct brdf_bsdf *bsdf, struct brdfcl_evaluator *evaluator,
                       struct inputs *in, size_t count, const char *what)
{
    static struct results c, opencl;
    struct brdf_vectors wo = vectors_of(in->wo), u = vectors_of(in->u);
    memset(&c, 0xa5, sizeof c);
    memset(&opencl, 0xa5, sizeof opencl);
    struct brdf_samples samples = samples_of(&c);
    struct brdf_vectors sampled = {samples.x, samples.y, samples.z};
    brdf_sample_many(bsdf, count, wo, u, samples);
    brdf_eval_many(bsdf, count, wo, sampled, colors_of(c.plane));
    brdf_pdf_many(bsdf, count, wo, sampled, c.plane[3]);

    struct brdf_error error = {BRDF_OK, ""};
    if (brdfcl_evaluator_bounce(evaluator, count, wo, u, samples_of(&opencl),
                                colors_of(opencl.plane), opencl.plane[3], &error)) {
        fail_msg("%s: %s", what, error.message);
    }
    assert_same(&c, &opencl, count, what);
}

static void check_material(struct brdfcl_device *device, const char *description)
{
    static struct inputs inputs;
    char what[256];
    struct brdf_error error = {BRDF_OK, ""};
    struct brdf_bsdf *bsdf;
    struct brdfcl_evaluator *evaluator;
    inputs_make(&inputs);
    if (brdfcl_check_bsdf_create(description, &bsdf, &error) ||
        brdfcl_evaluator_create(device, bsdf, &evaluator, &error)) {
        fail_msg("%s: %s", description, error.message);
    }
    /* Growing and shrinking arrays, and a single element. */
    const size_t counts[] = {1, COUNT, 17, 1024};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i) {
        snprintf(what, sizeof what, "%s at %d lanes, %zu elements", description,
                 brdfcl_device_array_lanes(device), counts[i]);
        run_each(bsdf, evaluator, &inputs, counts[i], what);
        run_bounce(bsdf, evaluator, &inputs, counts[i], what);
    }
    brdfcl_evaluator_destroy(evaluator);
    brdf_bsdf_destroy(bsdf);
}

static struct brdfcl_device *open_device(int lanes)
{
    struct brdfcl_device *device = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    if (brdfcl_device_count() == 0) {
        skip();
    }
    if (brdfcl_device_open(NULL, lanes, 0, &device, &error)) {
        fail_msg("%s", error.message);
    }
    return device;
}

/* A model of each kind: what is tested here is how arrays get there and back. That all models have
   the bits of C is for test_models_opencl. */
static void models_have_the_bits_of_c(void **state)
{
    (void)state;
    const char *const models[] = {"diffuse", "dielectric", "roughdielectric", "plastic", "merl"};
    struct brdfcl_device *device = open_device(0);
    for (size_t i = 0; i < sizeof models / sizeof models[0]; ++i) {
        check_material(device, models[i]);
    }
    brdfcl_device_close(device);
}

static void every_lane_count_has_the_bits_of_c(void **state)
{
    (void)state;
    const int lanes[] = {1, 4, 8, 16, 32};
    for (size_t i = 0; i < sizeof lanes / sizeof lanes[0]; ++i) {
        struct brdfcl_device *device = open_device(lanes[i]);
        check_material(device, "roughconductor:distribution=ggx,alpha_u=0.3,alpha_v=0.1,twosided");
        brdfcl_device_close(device);
    }
}

/* Left to itself, an evaluator takes two vectors of a processor. */
static void lanes_are_twice_those_of_renders(void **state)
{
    (void)state;
    struct brdfcl_device *device = open_device(0);
    int lanes = brdfcl_device_lanes(device);
    int twice = brdfcl_device_get_info(device).cpu && lanes > 1;
    assert_int_equal(brdfcl_device_array_lanes(device), twice ? 2 * lanes : lanes);
    brdfcl_device_close(device);
    device = open_device(8);
    assert_int_equal(brdfcl_device_array_lanes(device), 8);
    brdfcl_device_close(device);
    assert_int_equal(brdfcl_device_open(NULL, 64, 0, &device, NULL), BRDF_OUT_OF_RANGE);
}

static void arrays_that_are_not_wanted_may_be_missing(void **state)
{
    (void)state;
    static struct inputs inputs;
    static struct results full, part;
    struct brdfcl_device *device = open_device(0);
    struct brdf_bsdf *bsdf = bsdf_make("dielectric");
    struct brdfcl_evaluator *evaluator;
    inputs_make(&inputs);
    assert_int_equal(brdfcl_evaluator_create(device, bsdf, &evaluator, NULL), BRDF_OK);
    struct brdf_samples samples = samples_of(&full);
    struct brdf_samples few = samples_of(&part);
    few.eta = NULL;
    few.delta = NULL;
    struct brdf_vectors wo = vectors_of(inputs.wo), u = vectors_of(inputs.u);
    assert_int_equal(brdfcl_evaluator_sample(evaluator, COUNT, wo, u, samples, NULL), BRDF_OK);
    assert_int_equal(brdfcl_evaluator_sample(evaluator, COUNT, wo, u, few, NULL), BRDF_OK);
    assert_memory_equal(full.plane[4], part.plane[4], 7 * sizeof full.plane[4]);
    assert_int_equal(brdfcl_evaluator_sample(evaluator, 0, wo, u, samples, NULL), BRDF_OK);
    brdfcl_evaluator_destroy(evaluator);
    brdfcl_evaluator_destroy(NULL);
    brdf_bsdf_destroy(bsdf);
    brdfcl_device_close(device);
}

static void a_call_is_repeated_in_place(void **state)
{
    (void)state;
    static struct inputs inputs;
    static struct results results;
    struct brdfcl_device *device = open_device(0);
    struct brdf_bsdf *bsdf = bsdf_make("phong");
    struct brdfcl_evaluator *evaluator;
    struct brdf_error error = {BRDF_OK, ""};
    double seconds = -1.0;
    inputs_make(&inputs);
    assert_int_equal(brdfcl_evaluator_create(device, bsdf, &evaluator, NULL), BRDF_OK);
    assert_int_equal(brdfcl_evaluator_repeat(evaluator, 1, &seconds, &error), BRDF_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "call"));
    assert_int_equal(brdfcl_evaluator_pdf(evaluator, COUNT, vectors_of(inputs.wo),
                                          vectors_of(inputs.wi), results.plane[0], NULL),
                     BRDF_OK);
    assert_int_equal(brdfcl_evaluator_repeat(evaluator, 0, &seconds, &error), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdfcl_evaluator_repeat(evaluator, 3, &seconds, &error), BRDF_OK);
    assert_true(seconds > 0.0);
    brdfcl_evaluator_destroy(evaluator);
    brdf_bsdf_destroy(bsdf);
    brdfcl_device_close(device);
}

static void too_many_elements_are_refused(void **state)
{
    (void)state;
    float x = 1.0f, y = 0.0f;
    struct brdfcl_device *device = open_device(0);
    struct brdf_bsdf *bsdf = bsdf_make("diffuse");
    struct brdfcl_evaluator *evaluator;
    struct brdf_error error = {BRDF_OK, ""};
    struct brdf_vectors w = {&y, &y, &x};
    assert_int_equal(brdfcl_evaluator_create(device, bsdf, &evaluator, NULL), BRDF_OK);
    brdf_status status = brdfcl_evaluator_pdf(evaluator, (size_t)1 << 40, w, w, &y, &error);
    assert_int_equal(status, BRDF_OUT_OF_RANGE);
    assert_non_null(strstr(error.message, "too many"));
    brdfcl_evaluator_destroy(evaluator);
    brdf_bsdf_destroy(bsdf);
    brdfcl_device_close(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_have_the_bits_of_c),
        cmocka_unit_test(every_lane_count_has_the_bits_of_c),
        cmocka_unit_test(lanes_are_twice_those_of_renders),
        cmocka_unit_test(arrays_that_are_not_wanted_may_be_missing),
        cmocka_unit_test(a_call_is_repeated_in_place),
        cmocka_unit_test(too_many_elements_are_refused),
    };
    return cmocka_run_group_tests_name("evaluate", tests, NULL, NULL);
}
