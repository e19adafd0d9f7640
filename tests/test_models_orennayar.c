/*
 * test_models_orennayar.c - rough diffuse surfaces: what is known of the variants of orennayar.
 *
 * Known albedos are from quadratures made apart from this project's code, and closed forms.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/warp.h>

#include "angle.h"
#include "support_bsdf.h"
#include "support_matte.h"
#include "support_models.h"

static void oren_nayar_of_1994(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double albedo[ENERGY_COSINES];
    } known[] = {
        {"orennayar:reflectance=1,variant=qualitative,sigma=10",
         {1.0108, 1.0041, .9917, .9783, .9577}},
        {"orennayar:reflectance=1,variant=qualitative,sigma=30",
         {.9309, .9112, .8741, .8343, .7731}},
        {"orennayar:reflectance=1,variant=full,sigma=10", {1.0225, 1.0123, 1.0006, .9931, .9900}},
        {"orennayar:reflectance=1,variant=full,sigma=20", {1.0214, .9981, .9714, .9544, .9474}},
        {"orennayar:reflectance=1,variant=full,sigma=30", {.9852, .9547, .9198, .8975, .8884}},
        {"orennayar:reflectance=1,variant=full,sigma=40", {.9446, .9104, .8713, .8463, .8361}},
    };
    int failures = 0;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        failures += matte_expect_albedos(known[i].description, known[i].albedo, 2e-4);
    }
    assert_int_equal(failures, 0);
}

/* Portsmouth et al.: the albedo of fujii, written as they do, and its average. */
static double fujii_albedo(double mu, double r)
{
    double a = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * r);
    double s = sqrt(1.0 - mu * mu);
    double g = s * (acos(mu) - s * mu) + 2.0 / 3.0 * (s / mu * (1.0 - s * s * s) - s);
    return a + r * a / pi * g;
}

static void fujii_albedos(void **state)
{
    (void)state;
    static const double roughest[ENERGY_COSINES] = {.974307, .933386, .865320, .807855, .776522};
    int failures =
        matte_expect_albedos("orennayar:reflectance=1,variant=fujii,roughness=1", roughest, 1e-4);
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        failures += matte_expect("closed form", energy_cosines[i],
                                 fujii_albedo(energy_cosines[i], 1.0), roughest[i], 1e-6);
    }
    static const double averages[] = {.949786, .905890, .867188, .832811};
    for (int k = 0; k < 4; ++k) {
        char description[80];
        snprintf(description, sizeof description,
                 "orennayar:reflectance=1,variant=fujii,roughness=%.2f", 0.25 * (k + 1));
        struct brdf_bsdf *bsdf = bsdf_make(description);
        double sum = 0.0;
        for (int i = 0; i < 32; ++i) {
            double mu = (i + 0.5) / 32;
            sum += 2.0 * mu * matte_albedo(bsdf, mu, 24) / 32;
        }
        failures += matte_expect("average", 0.0, sum, averages[k], 3e-4);
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* A surface that absorbs nothing reflects everything, whatever the angle and the roughness. */
static void eon_keeps_everything(void **state)
{
    (void)state;
    static const double mus[] = {0.003, 0.02, 0.1, 0.3, 0.6, 0.9, 1.0};
    static const char *const roughness[] = {"0", "0.1", "0.35", "0.7", "1"};
    int failures = 0;
    for (int k = 0; k < 5; ++k) {
        char description[64];
        snprintf(description, sizeof description, "orennayar:reflectance=1,roughness=%s",
                 roughness[k]);
        struct brdf_bsdf *bsdf = bsdf_make(description);
        for (int i = 0; i < 7; ++i) {
            failures +=
                matte_expect(description, mus[i], matte_albedo(bsdf, mus[i], 96), 1.0, 1e-4);
            failures += matte_expect(description, mus[i], matte_albedo_by_sampling(bsdf, mus[i]),
                                     1.0, 1e-3);
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* rho E + rho^2 average / (1 - rho (1 - average)) (1 - E). */
static void eon_albedo_of_gray(void **state)
{
    (void)state;
    double known[ENERGY_COSINES];
    double rho = 0.5;
    double average = .832811;
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        double e = fujii_albedo(energy_cosines[i], 1.0);
        known[i] = rho * e + rho * rho * average / (1.0 - rho * (1.0 - average)) * (1.0 - e);
    }
    assert_int_equal(matte_expect_albedos("orennayar:reflectance=0.5,roughness=1", known, 1e-4), 0);
}

/* Smooth is Lambert, and sampled as such: every weight is the reflectance. */
static void smooth_is_lambert(void **state)
{
    (void)state;
    static const char *const smooth[] = {"eon,roughness=0", "fujii,roughness=0", "full,sigma=0",
                                         "qualitative,sigma=0"};
    for (int k = 0; k < 4; ++k) {
        char description[80];
        snprintf(description, sizeof description, "orennayar:reflectance=0.6,variant=%s",
                 smooth[k]);
        struct brdf_bsdf *bsdf = bsdf_make(description);
        for (size_t i = 0; i < 1000; ++i) {
            brdf_vec3 wo = brdf_warp_cosine((float)(i % 40) / 40.0f, 0.3f);
            struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, 1000));
            assert_true(s.pdf == 0.0f || fabsf(s.weight.g - 0.6f) < 1e-5f);
            assert_true(fabsf(brdf_eval(bsdf, wo, s.wi).g - 0.6f * BRDF_1_PI) < 1e-6f ||
                        s.pdf == 0.0f);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* The variance of sample weights, relative to the square of their mean; the largest in *most. */
static double variance(const struct brdf_bsdf *bsdf, double mu, int by_cosine, double *most)
{
    size_t count = 1 << 14;
    brdf_vec3 wo = energy_direction(mu, 0.0);
    double sum = 0.0;
    double squares = 0.0;
    *most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        brdf_vec3 u = models_even_point(i, count);
        double weight = by_cosine ? (double)brdf_eval(bsdf, wo, brdf_warp_cosine(u.x, u.y)).g * pi
                                  : (double)brdf_sample(bsdf, wo, u).weight.g;
        sum += weight;
        squares += weight * weight;
        *most = fmax(*most, weight);
    }
    double mean = sum / (double)count;
    return squares / (double)count / (mean * mean) - 1.0;
}

/* Better than the cosine towards grazing, never much worse, and with bounded weights. */
static void samplers_earn_their_keep(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double gain; /* at least, at grazing */
        double most; /* weight over albedo */
    } wanted[] = {
        {"orennayar:reflectance=0.8,roughness=1", 5.0, 2.0},
        {"orennayar:reflectance=0.8,roughness=0.3", 3.0, 2.0},
        {"orennayar:reflectance=0.8,variant=full,sigma=40", 2.0, 3.0},
        {"orennayar:reflectance=0.8,variant=qualitative,sigma=40", 2.0, 3.0},
        {"lommelseeliger", 20.0, 1.2},
        {"hapke", 1.8, 8.0},
        {"hapke:b=0.8,theta=0", 20.0, 4.0},
    };
    int failures = 0;
    for (size_t k = 0; k < sizeof wanted / sizeof wanted[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(wanted[k].description);
        for (int i = 0; i < 3; ++i) {
            static const double mus[] = {0.02, 0.3, 0.95};
            double most;
            double cosine_most;
            double own = variance(bsdf, mus[i], 0, &most);
            double cosine = variance(bsdf, mus[i], 1, &cosine_most);
            double bound = wanted[k].most * matte_albedo(bsdf, mus[i], 64);
            double gain = i == 0 ? wanted[k].gain : 0.5;
            if (!(own * gain <= cosine + 0.02) || !(most <= bound)) {
                print_error("%s at cos = %.2f: variance %.4f, by cosine %.4f; weights to %.3f of"
                            " %.3f\n",
                            wanted[k].description, mus[i], own, cosine, most, bound);
                ++failures;
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oren_nayar_of_1994),   cmocka_unit_test(fujii_albedos),
        cmocka_unit_test(eon_keeps_everything), cmocka_unit_test(eon_albedo_of_gray),
        cmocka_unit_test(smooth_is_lambert),    cmocka_unit_test(samplers_earn_their_keep),
    };
    return cmocka_run_group_tests_name("the moon", tests, NULL, NULL);
}
