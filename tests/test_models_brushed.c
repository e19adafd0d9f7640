/*
 * test_models_brushed.c - energy compensation of surfaces that are rougher along one tangent: how
 * near it comes to giving everything back.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <brdf/round.h>

#include "support_bsdf.h"
#include "support_energy.h"

#define PI 3.14159265358979323846

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* What a material reflects and lets through, over azimuths and angles up to 73 degrees. */
struct spread {
    double least, most;
    double mean; /* over diffuse light */
};

static struct spread spread_of(const char *text, double side, double eta)
{
    enum { ANGLES = 6, TURNS = 5, SAMPLES = 2048 };
    struct brdf_bsdf *bsdf = bsdf_make(text);
    struct spread spread = {HUGE_VAL, -HUGE_VAL, 0.0};
    for (int i = 0; i < ANGLES * TURNS; ++i) {
        /* The squares of the cosines are even: the plain mean is that over diffuse light. */
        double cosine = side * sqrt((i / TURNS + 0.5) / ANGLES);
        double turn = (i % TURNS + 0.5) / TURNS * PI / 2.0;
        double albedo = energy_of_both_sides(bsdf, energy_direction(cosine, turn), eta, SAMPLES);
        spread.least = fmin(spread.least, albedo);
        spread.most = fmax(spread.most, albedo);
        spread.mean += albedo / (ANGLES * TURNS);
    }
    brdf_bsdf_destroy(bsdf);
    print_message("%s: %.3f to %.3f, mean %.3f\n", text, spread.least, spread.most, spread.mean);
    return spread;
}

struct brushed {
    double alpha_u, alpha_v;
    double each; /* how far from 1 a direction may be, and the mean */
    double mean;
};

/* As near to 1 as docs/models/roughconductor.md says, whichever tangent is the smoother. */
static void brushed_mirrors_reflect_nearly_everything(void **state)
{
    (void)state;
    static const char *const options[] = {
        "distribution=ggx,masking=correlated", "distribution=ggx,masking=separable",
        "distribution=ggx,masking=vcavity", "distribution=beckmann,masking=correlated"};
    static const struct brushed rows[] = {{0.2, 0.1, 0.01, 0.003},
                                          {0.1, 0.4, 0.02, 0.01},
                                          {0.05, 0.5, 0.03, 0.017},
                                          {1.0, 0.05, 0.06, 0.013}};
    for (size_t k = 0; k < COUNT(options); ++k) {
        for (size_t i = 0; i < COUNT(rows); ++i) {
            char text[160];
            snprintf(
                text, sizeof text,
                "roughconductor:material=none,%s,alpha_u=%g,alpha_v=%g,multiscatter=kullaconty",
                options[k], rows[i].alpha_u, rows[i].alpha_v);
            struct spread spread = spread_of(text, 1.0, 1.0);
            assert_true(spread.least >= 1.0 - rows[i].each && spread.most <= 1.0 + rows[i].each);
            assert_true(fabs(spread.mean - 1.0) <= rows[i].mean);
        }
    }
}

/* Glass has no azimuth in what it brings back: right over diffuse light. */
static void brushed_glass_is_right_on_average(void **state)
{
    (void)state;
    static const char *const options[] = {"distribution=ggx", "distribution=beckmann"};
    static const struct brushed rows[] = {{0.1, 0.4, 0.1, 0.01}, {1.0, 0.05, 0.23, 0.025}};
    for (size_t k = 0; k < COUNT(options); ++k) {
        for (size_t i = 0; i < COUNT(rows) * 2; ++i) {
            const struct brushed *row = &rows[i / 2];
            char text[160];
            snprintf(text, sizeof text,
                     "roughdielectric:int_ior=1.5,ext_ior=1,%s,alpha_u=%g,alpha_v=%g,"
                     "multiscatter=kullaconty",
                     options[k], row->alpha_u, row->alpha_v);
            struct spread spread = spread_of(text, i % 2 ? -1.0 : 1.0, i % 2 ? 1.0 / 1.5 : 1.5);
            assert_true(spread.least >= 1.0 - row->each && spread.most <= 1.0 + row->each);
            assert_true(fabs(spread.mean - 1.0) <= row->mean);
        }
    }
}

/* Equal alphas must not be told from one alpha. */
static void round_surfaces_stay_as_they_are(void **state)
{
    (void)state;
    static const float blends[] = {BRDF_ROUND_SMITH, BRDF_ROUND_VCAVITY};
    for (int i = 0; i < 2000; ++i) {
        float alpha = 1e-4f + 0.00099f * (float)i;
        struct brdf_round round = brdf_round_make(blends[i & 1], alpha, alpha);
        assert_true(round.alpha == alpha);
        brdf_vec3 w = energy_direction(cos(0.00078 * i), 0.01 * i);
        assert_true(brdf_round_cosine(round, w) == w.z);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(brushed_mirrors_reflect_nearly_everything),
        cmocka_unit_test(brushed_glass_is_right_on_average),
        cmocka_unit_test(round_surfaces_stay_as_they_are),
    };
    return cmocka_run_group_tests_name("energy compensation of brushed surfaces", tests, NULL,
                                       NULL);
}
