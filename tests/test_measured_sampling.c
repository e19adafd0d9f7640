/*
 * test_measured_sampling.c - the model measured: its warp, its samples and their density, and C
 * against OpenCL.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <brdf/azimuth.h>
#include <brdf/model/measured.h>
#include <brdfcl/device.h>
#include <brdfcl/evaluate.h>

#include "density.h"
#include "rgl_pair.h"
#include "rgl_table.h"

/* Sampling the warp and inverting it, anywhere that has density. */
static void warps_are_inverted(void **state)
{
    struct rgl_pair *m = *state;
    struct brdfcl_random random = {2};
    const struct brdf_bsdf *materials[2] = {m->glossy, m->brushed};
    for (int i = 0; i < 100000; ++i) {
        size_t words;
        const float *table = brdf_bsdf_table(materials[i % 2], &words);
        struct brdf_measured_layout layout = brdf_measured_layout_of(table);
        assert_int_equal(layout.words, words);
        brdf_vec3 wo = random_above(&random);
        struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
        struct brdf_map map = i & 2 ? layout.luminance : layout.vndf;
        brdf_vec3 u = random_cube(&random);
        struct brdf_point there = brdf_map_sample(map, view.slices, u.x, u.y, table);
        struct brdf_point back = brdf_map_invert(map, view.slices, there.x, there.y, table);
        assert_float_equal(back.y, u.y, 1e-5f);
        if (there.pdf > 0.05f) {
            assert_float_equal(back.x, u.x, 1e-4f);
        }
        assert_true(fabsf(back.pdf - there.pdf) <= 2e-3f * there.pdf + 1e-3f);
    }
}

/* Of a map that is its own mirror image half is kept; the same numbers come out of all of it. */
static void half_of_a_mirrored_map_is_enough(void **state)
{
    (void)state;
    struct brdfcl_random random = {3};
    struct brdf_rgl_file file = rgl_test_make(GLOSSY, NULL);
    float *half, *all;
    size_t half_words, all_words;
    assert_int_equal(brdf_rgl_table_build(&file, &half, &half_words, NULL), BRDF_OK);
    for (int i = 0; i < file.vndf_columns; ++i) {
        file.vndf[i] *= 1.00002f; /* of one row, the others weigh as much as before */
    }
    assert_int_equal(brdf_rgl_table_build(&file, &all, &all_words, NULL), BRDF_OK);
    struct brdf_measured_layout a = brdf_measured_layout_of(half);
    struct brdf_measured_layout b = brdf_measured_layout_of(all);
    assert_true(a.vndf.mirrored && !b.vndf.mirrored && half_words < all_words);
    for (int i = 0; i < 100000; ++i) {
        brdf_vec3 u = random_cube(&random);
        struct brdf_slices slices = {(int)(u.z * (float)(a.thetas - 1)), u.x, 0.0f, 0};
        struct brdf_point there = brdf_map_sample(a.vndf, slices, u.x, u.y, half);
        struct brdf_point also = brdf_map_sample(b.vndf, slices, u.x, u.y, all);
        assert_float_equal(there.y, also.y, 1e-5f);
        if (there.pdf > 0.05f) {
            assert_float_equal(there.x, also.x, 1e-4f);
        }
        struct brdf_point back = brdf_map_invert(a.vndf, slices, u.x, u.y, half);
        struct brdf_point too = brdf_map_invert(b.vndf, slices, u.x, u.y, all);
        float density = brdf_map_density(a.vndf, slices, u.x, u.y, half);
        assert_float_equal(back.x, too.x, 5e-5f);
        assert_float_equal(back.y, too.y, 1e-5f);
        assert_true(fabsf(back.pdf - too.pdf) <= 1e-4f * too.pdf + 1e-6f);
        assert_true(density == back.pdf);
    }
    brdf_rgl_free(&file);
    free(half);
    free(all);
}

/* The generic tests do this for an isotropic file. */
static void samples_have_the_density_of_pdf(void **state)
{
    struct rgl_pair *m = *state;
    for (int view = 0; view < 4; ++view) {
        struct lab_density density;
        assert_int_equal(lab_try_density(m->brushed, view, 50000, 1, 1e-4, &density, NULL), 0);
        print_message("    %.0f degrees: mass off by %.2g, p = %.2g\n", lab_view_angle[view],
                      density.mass.measured, density.chi2.measured);
        assert_int_equal(density.mass.verdict, LAB_PASS);
        assert_int_equal(density.chi2.verdict, LAB_PASS);
    }
}

/* A sample knows value and density from the way that led to it; eval and pdf go back. */
static void samples_agree_with_eval_and_pdf(void **state)
{
    struct rgl_pair *m = *state;
    struct brdfcl_random random = {4};
    double all = 0.0, off_f = 0.0, off_pdf = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const struct brdf_bsdf *bsdf = i % 2 ? m->glossy : m->brushed;
        brdf_vec3 wo = random_above(&random);
        struct brdf_sample s = brdf_sample(bsdf, wo, random_cube(&random));
        if (s.pdf > 0.0f && wo.z > 0.02f) {
            double pdf = (double)brdf_pdf(bsdf, wo, s.wi);
            double f = (double)brdf_eval(bsdf, wo, s.wi).g * (double)s.wi.z;
            off_pdf += fabs(pdf / (double)s.pdf - 1.0);
            off_f += fabs(f / (double)(s.weight.g * s.pdf) - 1.0);
            all += 1.0;
            assert_true(fabs(pdf / (double)s.pdf - 1.0) < 0.02);
        }
    }
    print_message("    off by %.2g and %.2g on average\n", off_f / all, off_pdf / all);
    assert_true(off_f < 2e-5 * all && off_pdf < 2e-5 * all);
}

/* There the square of the file has neither area nor density, but directions around it have. */
static void the_mirror_direction_has_a_density(void **state)
{
    struct rgl_pair *m = *state;
    struct brdfcl_random random = {5};
    for (int i = 0; i < 1000; ++i) {
        const struct brdf_bsdf *bsdf = i % 2 ? m->glossy : m->brushed;
        brdf_vec3 wo = random_above(&random);
        wo = brdf_normalize(brdf_vec3_make(wo.x, wo.y, wo.z + 0.1f));
        brdf_vec3 mirror = brdf_vec3_make(-wo.x, -wo.y, wo.z);
        brdf_vec3 side = brdf_azimuth(brdf_vec3_make(-wo.y, wo.x, 0.0f));
        brdf_vec3 beside = /* the half vector is 1.4e-5 rad from the normal */
            brdf_normalize(brdf_add(mirror, brdf_scale(side, 2.8e-5f * wo.z)));
        float pdf = brdf_pdf(bsdf, wo, mirror);
        assert_true(fabsf(pdf / brdf_pdf(bsdf, wo, beside) - 1.0f) < 0.2f);
        assert_true(brdf_eval(bsdf, wo, mirror).g > 0.0f);
    }
}

/* The generic test does this for an isotropic file, at every number of lanes. */
static void opencl_gives_the_same_bits(void **state)
{
    enum { COUNT = 4096 };
    struct rgl_pair *m = *state;
    static float in[9][COUNT], f[3][COUNT], pdf[COUNT], out[7][COUNT];
    struct brdfcl_device *device = NULL;
    struct brdfcl_evaluator *evaluator = NULL;
    struct brdfcl_random random = {6};
    if (brdfcl_device_open(NULL, 0, 0, &device, NULL)) {
        print_message("    skipped, no OpenCL device\n");
        skip();
    }
    for (int i = 0; i < COUNT; ++i) {
        brdf_vec3 v[3] = {random_above(&random), random_above(&random), random_cube(&random)};
        for (int k = 0; k < 3; ++k) {
            in[3 * k][i] = v[k].x;
            in[3 * k + 1][i] = v[k].y;
            in[3 * k + 2][i] = v[k].z;
        }
    }
    struct brdf_vectors wo = {in[0], in[1], in[2]}, wi = {in[3], in[4], in[5]};
    struct brdf_vectors u = {in[6], in[7], in[8]};
    struct brdf_colors colors = {f[0], f[1], f[2]};
    struct brdf_samples samples = {out[0], out[1], out[2], {out[3], out[4], out[5]},
                                   out[6], NULL,   NULL};
    assert_int_equal(brdfcl_evaluator_create(device, m->brushed, &evaluator, NULL), BRDF_OK);
    assert_int_equal(brdfcl_evaluator_eval(evaluator, COUNT, wo, wi, colors, NULL), BRDF_OK);
    assert_int_equal(brdfcl_evaluator_pdf(evaluator, COUNT, wo, wi, pdf, NULL), BRDF_OK);
    assert_int_equal(brdfcl_evaluator_sample(evaluator, COUNT, wo, u, samples, NULL), BRDF_OK);
    for (int i = 0; i < COUNT; ++i) {
        brdf_vec3 o = brdf_vec3_make(in[0][i], in[1][i], in[2][i]);
        brdf_vec3 w = brdf_vec3_make(in[3][i], in[4][i], in[5][i]);
        brdf_rgb c = brdf_eval(m->brushed, o, w);
        assert_true(c.r == f[0][i] && c.g == f[1][i] && c.b == f[2][i]);
        assert_true(brdf_pdf(m->brushed, o, w) == pdf[i]);
        struct brdf_sample s =
            brdf_sample(m->brushed, o, brdf_vec3_make(in[6][i], in[7][i], in[8][i]));
        assert_true(s.wi.x == out[0][i] && s.wi.y == out[1][i] && s.wi.z == out[2][i]);
        assert_true(s.weight.r == out[3][i] && s.weight.g == out[4][i] && s.weight.b == out[5][i] &&
                    s.pdf == out[6][i]);
    }
    brdfcl_evaluator_destroy(evaluator);
    brdfcl_device_close(device);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(warps_are_inverted),
        cmocka_unit_test(half_of_a_mirrored_map_is_enough),
        cmocka_unit_test(samples_have_the_density_of_pdf),
        cmocka_unit_test(samples_agree_with_eval_and_pdf),
        cmocka_unit_test(the_mirror_direction_has_a_density),
        cmocka_unit_test(opencl_gives_the_same_bits),
    };
    return cmocka_run_group_tests(tests, rgl_pair_make, rgl_pair_free);
}
