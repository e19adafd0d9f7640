/*
 * test_models_brushed.c - energy compensation of surfaces that are rougher along one tangent: it
 * gives everything back, and nearly so where roughness varies over the surface.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/round.h>

#include "angle.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static const double pairs[][2] = {{0.2, 0.1},  {0.1, 0.5}, {0.05, 1.0},
                                  {0.01, 2.0}, {1.0, 2.0}, {1e-4, 0.5}};

/* Between nodes of tables, grazing included; azimuths in radians. */
static const double views[][2] = {{3.0, 1.1},  {30.0, 0.4},   {52.0, 0.9}, {63.0, 0.03},
                                  {75.0, 1.4}, {82.0, 0.003}, {85.0, 0.6}, {88.0, 0.08},
                                  {89.0, 1.2}, {89.9, 0.3}};

/* The worst difference from 1 of all that comes back from a side, over the views. */
static double worst_of(const char *text, double side, double eta, size_t samples)
{
    struct brdf_bsdf *bsdf = bsdf_make(text);
    double worst = 0.0;
    for (size_t i = 0; i < COUNT(views); ++i) {
        worst = fmax(
            worst, energy_missing(bsdf, text, views[i][0], side, views[i][1], eta, samples, 2e-3));
    }
    brdf_bsdf_destroy(bsdf);
    return worst;
}

static void brushed_mirrors_reflect_everything(void **state)
{
    (void)state;
    static const char *const options[] = {
        "distribution=beckmann,masking=correlated", "distribution=beckmann,masking=separable",
        "distribution=beckmann,masking=rational",   "distribution=beckmann,masking=vcavity",
        "distribution=ggx,masking=correlated",      "distribution=ggx,masking=separable",
        "distribution=ggx,masking=vcavity"};
    double worst = 0.0;
    for (size_t i = 0; i < COUNT(pairs) * COUNT(options); ++i) {
        const double *pair = pairs[i % COUNT(pairs)];
        const char *option = options[i / COUNT(pairs)];
        char text[160];
        if (!models_long() && (i / COUNT(pairs) + i) % 3) {
            continue; /* a third of them, every pair and every option */
        }
        snprintf(text, sizeof text,
                 "roughconductor:material=none,%s,alpha_u=%g,alpha_v=%g,multiscatter=kullaconty",
                 option, pair[0], pair[1]);
        worst =
            fmax(worst, worst_of(text, 1.0, 1.0, strstr(option, "vcavity") ? 1 << 16 : 1 << 15));
    }
    print_message("albedo 1 to %.1e\n", worst);
    assert_true(worst <= 2e-3);
}

/* What a material reflects, over azimuths and angles up to 73 degrees. */
struct spread {
    double least, most;
    double mean; /* over diffuse light */
};

static struct spread spread_of(const char *name, const struct brdf_bsdf *bsdf, double side,
                               double eta)
{
    enum { ANGLES = 6, TURNS = 5, SAMPLES = 2048 };
    struct spread spread = {HUGE_VAL, -HUGE_VAL, 0.0};
    for (int i = 0; i < ANGLES * TURNS; ++i) {
        /* The squares of the cosines are even: the plain mean is that over diffuse light. */
        double cosine = side * sqrt((i / TURNS + 0.5) / ANGLES);
        double turn = (i % TURNS + 0.5) / TURNS * pi / 2.0;
        double albedo = energy_of_both_sides(bsdf, energy_direction(cosine, turn), eta, SAMPLES);
        spread.least = fmin(spread.least, albedo);
        spread.most = fmax(spread.most, albedo);
        spread.mean += albedo / (ANGLES * TURNS);
    }
    print_message("%s: %.3f to %.3f, mean %.3f\n", name, spread.least, spread.most, spread.mean);
    return spread;
}

struct brushed {
    double alpha_u, alpha_v;
    double each; /* how far from 1 a direction may be, and the mean */
    double mean;
};

/* With roughness that may vary: as near to 1 as docs/models/roughconductor.md says, whichever
   tangent is the smoother. */
static void varying_mirrors_reflect_nearly_everything(void **state)
{
    (void)state;
    static const char *const options[][2] = {{"ggx", "correlated"},
                                             {"ggx", "separable"},
                                             {"ggx", "vcavity"},
                                             {"beckmann", "correlated"}};
    static const struct brushed rows[] = {{0.2, 0.1, 0.01, 0.003},
                                          {0.1, 0.4, 0.02, 0.01},
                                          {0.05, 0.5, 0.03, 0.017},
                                          {1.0, 0.05, 0.06, 0.013}};
    for (size_t i = 0; i < COUNT(rows) * COUNT(options); ++i) {
        const struct brushed *row = &rows[i % COUNT(rows)];
        const char *const *option = options[i / COUNT(rows)];
        struct brdf_setting settings[] = {
            brdf_setting_text("material", "none"),
            brdf_setting_text("distribution", option[0]),
            brdf_setting_text("masking", option[1]),
            brdf_setting_text("multiscatter", "kullaconty"),
            brdf_setting_real("alpha_u", (float)row->alpha_u),
            brdf_setting_real("alpha_v", (float)row->alpha_v),
        };
        struct brdf_bsdf *bsdf;
        size_t words;
        settings[4 + i % 2].varies = 1;
        assert_int_equal(
            brdf_bsdf_create_from("roughconductor", settings, COUNT(settings), &bsdf, NULL),
            BRDF_OK);
        assert_null(brdf_bsdf_table(bsdf, &words));
        struct spread spread = spread_of(option[0], bsdf, 1.0, 1.0);
        assert_true(spread.least >= 1.0 - row->each && spread.most <= 1.0 + row->each);
        assert_true(fabs(spread.mean - 1.0) <= row->mean);
        brdf_bsdf_destroy(bsdf);
    }
}

/* From both sides. With an alpha of 2 a kink that tables do not follow is left, from the denser
   side. */
static void brushed_glass_loses_nothing(void **state)
{
    (void)state;
    static const char *const options[] = {
        "distribution=beckmann,masking=correlated", "distribution=ggx,masking=correlated",
        "distribution=beckmann,masking=separable", "distribution=ggx,masking=separable"};
    static const double ratios[] = {1.5, 1.33, 1.0 / 1.5, 2.5, 1.05};
    double worst = 0.0, worst_rough = 0.0;
    for (size_t i = 0; i < COUNT(pairs) * (models_long() ? COUNT(ratios) : 1); ++i) {
        const double *pair = pairs[i % COUNT(pairs)];
        double ratio = ratios[(i + i / COUNT(pairs)) % COUNT(ratios)];
        char text[160];
        snprintf(text, sizeof text,
                 "roughdielectric:int_ior=%.9g,ext_ior=1,%s,alpha_u=%g,alpha_v=%g,"
                 "multiscatter=kullaconty",
                 ratio, options[i % COUNT(options)], pair[0], pair[1]);
        double found =
            fmax(worst_of(text, 1.0, ratio, 1 << 15), worst_of(text, -1.0, 1.0 / ratio, 1 << 15));
        double *to = fmax(pair[0], pair[1]) > 1.0 ? &worst_rough : &worst;
        *to = fmax(*to, found);
    }
    print_message("reflection and transmission 1 to %.1e, with an alpha of 2 %.1e\n", worst,
                  worst_rough);
    assert_true(worst <= 2e-3 && worst_rough <= 5e-3);
}

static struct brdf_bsdf *varying_glass(const char *distribution, const struct brushed *row)
{
    struct brdf_setting settings[] = {
        brdf_setting_real("int_ior", 1.5f),
        brdf_setting_real("ext_ior", 1.0f),
        brdf_setting_text("distribution", distribution),
        brdf_setting_text("multiscatter", "kullaconty"),
        brdf_setting_real("alpha_u", (float)row->alpha_u),
        brdf_setting_real("alpha_v", (float)row->alpha_v),
    };
    struct brdf_bsdf *bsdf;
    settings[4].varies = settings[5].varies = 1;
    assert_int_equal(
        brdf_bsdf_create_from("roughdielectric", settings, COUNT(settings), &bsdf, NULL), BRDF_OK);
    return bsdf;
}

/* Glass whose roughness may vary has no azimuth in what it brings back: right over diffuse light.
 */
static void varying_glass_is_right_on_average(void **state)
{
    (void)state;
    static const char *const distributions[] = {"ggx", "beckmann"};
    static const struct brushed rows[] = {{0.1, 0.4, 0.1, 0.01}, {1.0, 0.05, 0.23, 0.025}};
    for (size_t i = 0; i < COUNT(rows) * COUNT(distributions) * 2; ++i) {
        const struct brushed *row = &rows[i / 2 % COUNT(rows)];
        const char *distribution = distributions[i / 2 / COUNT(rows)];
        struct brdf_bsdf *bsdf = varying_glass(distribution, row);
        struct spread spread =
            spread_of(distribution, bsdf, i % 2 ? -1.0 : 1.0, i % 2 ? 1.0 / 1.5 : 1.5);
        assert_true(spread.least >= 1.0 - row->each && spread.most <= 1.0 + row->each);
        assert_true(fabs(spread.mean - 1.0) <= row->mean);
        brdf_bsdf_destroy(bsdf);
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
        cmocka_unit_test(brushed_mirrors_reflect_everything),
        cmocka_unit_test(varying_mirrors_reflect_nearly_everything),
        cmocka_unit_test(brushed_glass_loses_nothing),
        cmocka_unit_test(varying_glass_is_right_on_average),
        cmocka_unit_test(round_surfaces_stay_as_they_are),
    };
    return cmocka_run_group_tests_name("energy compensation of brushed surfaces", tests, NULL,
                                       NULL);
}
