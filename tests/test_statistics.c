/*
 * test_statistics.c - the statistics that the tests of sampling rely on.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "angle.h"
#include "check_random.h"
#include "sphere.h"
#include "statistics.h"

static void assert_close(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance)) {
        fail_msg("%.12g is not %.12g", value, expected);
    }
}

/* Closed forms: Q(1, x) = exp(-x), Q(1/2, x) = erfc(sqrt(x)), Q(n, x) a finite sum [DLMF 8.4]. */
static void gamma_q_has_its_closed_forms(void **state)
{
    (void)state;
    for (double x = 0.01; x < 600.0; x *= 1.3) {
        assert_close(lab_gamma_q(1.0, x), exp(-x), 1e-13);
        assert_close(lab_gamma_q(0.5, x), erfc(sqrt(x)), 1e-13);
        double term = exp(-x);
        double sum = term;
        for (int k = 1; k < 50; ++k) {
            term *= x / k;
            sum += term;
        }
        assert_close(lab_gamma_q(50.0, x), sum, 1e-12);
    }
    assert_close(lab_gamma_q(3.0, 0.0), 1.0, 0.0);
}

/* Quantiles of chi-square that are printed in every table. */
static void chi2_has_its_quantiles(void **state)
{
    (void)state;
    assert_close(lab_gamma_q(0.5, 0.5 * 6.6349), 0.01, 1e-6);
    assert_close(lab_gamma_q(5.0, 0.5 * 23.2093), 0.01, 1e-6);
    assert_close(lab_gamma_q(50.0, 0.5 * 135.8067), 0.01, 1e-6);
}

/* A die: fair throws pass, and a face that comes up 5 % too often does not. */
static void chi2_tells_a_loaded_die(void **state)
{
    (void)state;
    for (int loaded = 0; loaded < 2; ++loaded) {
        struct lab_bin bins[6] = {{0.0, 0.0}};
        struct brdfcl_random random = {1};
        for (int i = 0; i < 200000; ++i) {
            int face = brdfcl_random_below(&random, 6);
            int moved = loaded && face != 0 && brdfcl_random_below(&random, 80) == 0;
            bins[moved ? 0 : face].observed += 1.0;
        }
        for (int face = 0; face < 6; ++face) {
            bins[face].expected = 200000.0 / 6.0;
        }
        struct lab_chi2 result = lab_chi2_test(bins, 6);
        assert_int_equal(result.freedom, 5);
        assert_int_equal(result.p < 0.001, loaded);
    }
}

static void chi2_pools_and_sees_the_impossible(void **state)
{
    (void)state;
    struct lab_bin bins[] = {{0.0, 0.0}, {2.0, 3.0}, {2.0, 1.0}, {2.0, 2.0}, {94.0, 94.0}};
    struct lab_chi2 result = lab_chi2_test(bins, 5);
    assert_int_equal(result.freedom, 1);
    assert_int_equal(result.impossible, 0);
    assert_close(result.chi2, 0.0, 0.0);
    struct lab_bin others[] = {{0.0, 4.0}, {50.0, 46.0}, {50.0, 50.0}};
    assert_int_equal(lab_chi2_test(others, 3).impossible, 1);
}

static void sidak_is_nearly_a_division(void **state)
{
    (void)state;
    assert_close(lab_sidak(0.01, 1), 0.01, 1e-15);
    assert_close(lab_sidak(0.01, 100), 1.00498e-4, 1e-8);
}

/* A lobe exp(k (w.axis - 1)), whose integral is 2 pi (1 - exp(-2 k)) / k. */
struct lobe {
    brdf_vec3 axis;
    double sharpness;
};

static double lobe_value(brdf_vec3 w, void *data)
{
    const struct lobe *lobe = data;
    double x = (double)w.x - (double)lobe->axis.x;
    double y = (double)w.y - (double)lobe->axis.y;
    double z = (double)w.z - (double)lobe->axis.z;
    return exp(-0.5 * lobe->sharpness * (x * x + y * y + z * z));
}

/* Wide and narrow, at the pole, near the seam of the azimuth, on the horizon. */
static void cells_follow_a_lobe(void **state)
{
    (void)state;
    static const brdf_vec3 axes[] = {
        {0.0f, 0.0f, 1.0f}, {0.6f, -1e-4f, 0.8f}, {0.0f, 1.0f, 0.0f}, {0.48f, 0.6f, -0.64f}};
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; ++i) {
        for (double sharpness = 1.0; sharpness < 1e8; sharpness *= 20.0) {
            struct lobe lobe = {axes[i], sharpness};
            struct brdfcl_random random = {1};
            brdf_vec3 pilot[2000];
            float width = (float)(2.0 / sqrt(sharpness));
            for (int k = 0; k < 2000; ++k) {
                float a[3];
                for (int j = 0; j < 3; ++j) {
                    a[j] = width * (2.0f * brdfcl_random_uniform(&random) - 1.0f);
                }
                pilot[k] = brdf_normalize(brdf_add(axes[i], brdf_vec3_make(a[0], a[1], a[2])));
            }
            struct lab_sphere *sphere = lab_sphere_create(pilot, 2000);
            assert_non_null(sphere);
            double area = 2.0 * pi * (1.0 - exp(-2.0 * sharpness)) / sharpness;
            struct lab_sphere_sum sum = lab_sphere_integrate(sphere, lobe_value, &lobe, 1e-5, 1.0);
            assert_close(sum.value / area, 1.0, 1e-3);
            assert_close(sum.error, 0.0, 1e-4 * area);
            for (int k = 0; k < 2000; ++k) {
                assert_int_equal(sphere->nodes[lab_sphere_find(sphere, pilot[k])].child, -1);
            }
            lab_sphere_destroy(sphere);
        }
    }
}

/* 1 everywhere, and somewhere a lobe a thousandth of a degree wide that holds `height`. */
struct needle {
    brdf_vec3 axis;
    double height;
};

static const double needle_sharpness = 1e9;

static double needle_value(brdf_vec3 w, void *data)
{
    const struct needle *needle = data;
    struct lobe lobe = {needle->axis, needle_sharpness};
    return 1.0 + needle->height * needle_sharpness / (2.0 * pi) * lobe_value(w, &lobe);
}

/* At a pole, which is a corner of 32 cells, nothing else must know of it; elsewhere a pilot. */
static void needles_are_found(void **state)
{
    (void)state;
    static const brdf_vec3 axes[] = {
        {0.0f, 0.0f, -1.0f}, {0.0f, 0.0f, 1.0f}, {0.48f, 0.6f, -0.64f}, {0.6f, -1e-4f, 0.8f}};
    for (size_t i = 0; i < sizeof axes / sizeof axes[0]; ++i) {
        struct needle needle = {axes[i], 0.01};
        struct lab_sphere *sphere = lab_sphere_create(axes + i, i < 2 ? 0 : 1);
        assert_non_null(sphere);
        struct lab_sphere_sum sum = lab_sphere_integrate(sphere, needle_value, &needle, 1e-4, 1e-3);
        assert_close(sum.value, 4.0 * pi + 0.01, 2e-5);
        lab_sphere_destroy(sphere);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gamma_q_has_its_closed_forms),
        cmocka_unit_test(chi2_has_its_quantiles),
        cmocka_unit_test(chi2_tells_a_loaded_die),
        cmocka_unit_test(chi2_pools_and_sees_the_impossible),
        cmocka_unit_test(sidak_is_nearly_a_division),
        cmocka_unit_test(cells_follow_a_lobe),
        cmocka_unit_test(needles_are_found),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
