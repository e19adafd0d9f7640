/*
 * test_lab_survey.c - what is said of measured materials, on tables whose faults are known.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "lab_files.h"
#include "support_bsdf.h"
#include "survey.h"

static size_t bin_at(int theta_h, int theta_d, int phi_d)
{
    return 3 * (size_t)((theta_h * 90 + theta_d) * 180 + phi_d);
}

/* Is there a doubt with this word, and how many are there in all? */
static int doubts(const struct lab_survey *survey, const struct lab_merl_survey *merl,
                  const char *word, int *count)
{
    struct lab_findings findings = {survey, merl, NULL, 1};
    char text[300];
    int found = 0;
    for (*count = 0; lab_survey_doubt(&findings, *count, text, sizeof text); ++*count) {
        found |= strstr(text, word) != NULL;
    }
    return found;
}

static void a_flawless_table_has_no_doubts(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.2/0.4/0.6");
    struct brdf_bsdf *bsdf = lab_test_load(&file, "interpolation=linear");
    struct lab_survey survey;
    struct lab_merl_survey merl;
    int count;
    lab_survey_make(bsdf, &survey);
    lab_survey_merl(&file, &merl);
    assert_int_equal(doubts(&survey, &merl, "", &count), 0);
    assert_int_equal(count, 0);
    for (int k = 0; k < LAB_SURVEY_ANGLES; ++k) {
        assert_true(fabs(survey.albedo[k][2] - 0.6) < 1e-5);
    }
    assert_true(fabs(survey.albedo_diffuse[0] - 0.2) < 1e-5);
    assert_true(survey.reciprocity == 0.0 && survey.energy_from == 90.0);
    assert_true(merl.bins == 90 * 90 * 180 && merl.valid == merl.above && merl.above_invalid == 0);
    assert_true(merl.valid + file.invalid == merl.bins && merl.zero == 0);
    assert_true(fabs(merl.least * pi - 0.2) < 1e-6 && fabs(merl.most * pi - 0.6) < 1e-6);
    assert_true(merl.noise < 1e-6);
    brdf_bsdf_destroy(bsdf);
    brdf_merl_free(&file);
}

static void faults_are_found_where_they_are(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.5");
    struct lab_survey survey = {.energy_from = 90.0};
    struct lab_merl_survey merl;
    int count;
    float *hole = file.rgb + bin_at(45, 10, 90); /* theta_h 23 degrees */
    hole[0] = hole[1] = hole[2] = -1.0f;
    file.rgb[bin_at(3, 4, 5) + 1] = 0.0f;
    file.rgb[bin_at(80, 10, 90) + 2] = 40.0f;
    lab_survey_merl(&file, &merl);
    assert_true(merl.above_invalid == 1 && merl.zero == 1);
    assert_true(merl.invalid_from > 23.0 && merl.invalid_from < 36.0);
    assert_true(merl.least == 0.0 && fabs(merl.most - 40.0) < 1e-5);
    assert_true(fabs(merl.most_at.theta_h - 90.0 * (80.5 / 90.0) * (80.5 / 90.0)) < 1e-9);
    assert_true(fabs(merl.least_at.theta_d - 4.5) < 1e-9 && fabs(merl.least_at.phi_d - 5.5) < 1e-9);
    assert_true(doubts(&survey, &merl, "not measured", &count));
    assert_true(doubts(&survey, &merl, "exactly 0", &count));
    assert_true(doubts(&survey, &merl, "far from the highlight", &count));
    brdf_merl_free(&file);
}

/* Independent errors of a known size are measured as such. */
static void noise_is_measured(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.5");
    struct lab_survey survey = {.energy_from = 90.0};
    struct lab_merl_survey merl;
    uint64_t random = 1;
    int count;
    for (size_t i = 0; i < 3 * file.bins; ++i) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        double u = (double)(random >> 40) * 0x1p-24;
        if (file.rgb[i] > 0.0f) {
            file.rgb[i] *= (float)(1.0 + 0.2 * (u - 0.5) * sqrt(12.0)); /* sigma 0.2 */
        }
    }
    lab_survey_merl(&file, &merl);
    assert_true(merl.noise > 0.19 && merl.noise < 0.22);
    assert_true(merl.noise_grazing > 0.19 && merl.noise_grazing < 0.22);
    assert_true(doubts(&survey, &merl, "noise", &count));
    brdf_merl_free(&file);
}

/* A material that makes light: where from, and how much. */
static void light_from_nowhere_is_found(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.5");
    struct brdf_bsdf *bsdf = lab_test_load(&file, "scale=3");
    struct lab_survey survey;
    int count;
    lab_survey_make(bsdf, &survey);
    assert_true(survey.energy_from == 0.0 && fabs(survey.energy - 1.5) < 1e-5);
    assert_true(doubts(&survey, NULL, "more than it receives", &count));
    brdf_bsdf_destroy(bsdf);
    brdf_merl_free(&file);
}

/* A model whose two orders differ by rounding only; and what is said where they differ. */
static void one_way_materials_are_doubted(void **state)
{
    (void)state;
    struct brdf_bsdf *rough = bsdf_make("orennayar:variant=qualitative,sigma=30");
    struct lab_survey survey;
    int count;
    lab_survey_make(rough, &survey);
    assert_true(survey.reciprocity < 1e-5);
    assert_false(doubts(&survey, NULL, "exchanging", &count));
    survey.reciprocity = 0.3;
    assert_true(doubts(&survey, NULL, "exchanging viewer and light changes f by 30.0 %", &count));
    brdf_bsdf_destroy(rough);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_flawless_table_has_no_doubts),
        cmocka_unit_test(faults_are_found_where_they_are),
        cmocka_unit_test(noise_is_measured),
        cmocka_unit_test(light_from_nowhere_is_found),
        cmocka_unit_test(one_way_materials_are_doubted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
