/*
 * test_lab_mix.c - mixtures of measured tables.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "lab_files.h"
#include "logrelative.h"
#include "mix.h"

enum { MATTE, METAL, PLASTIC, PARTS };

static int parts_make(void **state)
{
    struct brdf_merl_file *parts = calloc(PARTS, sizeof *parts);
    assert_non_null(parts);
    *state = parts;
    parts[MATTE] = lab_test_bake("diffuse:reflectance=0.2/0.4/0.6");
    parts[METAL] = lab_test_bake("roughconductor:material=Cu,alpha=0.2");
    parts[PLASTIC] = lab_test_bake("roughplastic:alpha=0.3");
    return 0;
}

static int parts_free(void **state)
{
    struct brdf_merl_file *parts = *state;
    for (int k = 0; k < PARTS; ++k) {
        brdf_merl_free(&parts[k]);
    }
    free(parts);
    return 0;
}

static struct brdf_merl_file mix(const struct brdf_merl_file *files, const double *weights,
                                 size_t count, enum lab_mix_space space)
{
    struct brdf_merl_file mixture;
    struct brdf_error error = {BRDF_OK, ""};
    if (lab_mix_merl(files, weights, count, space, &mixture, &error)) {
        fail_msg("%s", error.message);
    }
    return mixture;
}

static int equal(const struct brdf_merl_file *a, const struct brdf_merl_file *b)
{
    return a->invalid == b->invalid && memcmp(a->rgb, b->rgb, 3 * a->bins * sizeof(float)) == 0;
}

static void a_mixture_with_itself_changes_no_bit(void **state)
{
    const struct brdf_merl_file *parts = *state;
    const struct brdf_merl_file twice[] = {parts[METAL], parts[METAL], parts[METAL]};
    const double weights[] = {0.3, 0.1, 0.6};
    for (int space = 0; space < 2; ++space) {
        struct brdf_merl_file m = mix(twice, weights, 3, (enum lab_mix_space)space);
        assert_true(equal(&m, &parts[METAL]));
        brdf_merl_free(&m);
    }
    assert_int_equal(lab_mix_same(twice, weights, 3), 0);
}

static void weights_of_nothing_and_all_give_the_ends(void **state)
{
    const struct brdf_merl_file *parts = *state;
    const double ends[PARTS][PARTS] = {{1.0, 0.0, 0.0}, {0.0, 0.7, 0.0}, {0.0, 0.0, 3.0}};
    for (int space = 0; space < 2; ++space) {
        for (int k = 0; k < PARTS; ++k) {
            struct brdf_merl_file m = mix(parts, ends[k], PARTS, (enum lab_mix_space)space);
            assert_true(equal(&m, &parts[k]));
            assert_int_equal(lab_mix_same(parts, ends[k], PARTS), k);
            brdf_merl_free(&m);
        }
    }
    const double both[PARTS] = {0.5, 0.5, 0.0};
    assert_int_equal(lab_mix_same(parts, both, PARTS), -1);
}

static void the_order_makes_no_difference(void **state)
{
    const struct brdf_merl_file *parts = *state;
    const struct brdf_merl_file turned[PARTS] = {parts[PLASTIC], parts[MATTE], parts[METAL]};
    const double weights[PARTS] = {0.2, 0.3, 0.5}, turned_weights[PARTS] = {0.5, 0.2, 0.3};
    for (int space = 0; space < 2; ++space) {
        struct brdf_merl_file a = mix(parts, weights, PARTS, (enum lab_mix_space)space);
        struct brdf_merl_file b = mix(turned, turned_weights, PARTS, (enum lab_mix_space)space);
        for (size_t i = 0; i < 3 * a.bins; ++i) {
            double off = fabs((double)a.rgb[i] - (double)b.rgb[i]);
            if (!(off <= 1.2e-7 * fabs((double)a.rgb[i]))) {
                fail_msg("value %zu: %.9g and %.9g", i, (double)a.rgb[i], (double)b.rgb[i]);
            }
        }
        brdf_merl_free(&b);
        brdf_merl_free(&a);
    }
}

/* By the formulas, at bins all over the table: the mean, and the geometric one of f c + epsilon. */
static void values_are_those_of_the_formulas(void **state)
{
    const struct brdf_merl_file *parts = *state;
    const double weights[] = {0.3, 0.7};
    struct brdf_merl_file linear = mix(parts, weights, 2, LAB_MIX_LINEAR);
    struct brdf_merl_file relative = mix(parts, weights, 2, LAB_MIX_LOGRELATIVE);
    int seen = 0;
    for (int bin = 0; bin < 90 * 90 * 180; bin += 1009) {
        double wo[3], wi[3];
        if (!brdf_merl_directions(bin / 180 / 90, bin / 180 % 90, bin % 180, wo, wi)) {
            assert_true(linear.rgb[3 * bin] == -1.0f && relative.rgb[3 * bin] == -1.0f);
            continue;
        }
        double a = (double)parts[0].rgb[3 * bin + 1], b = (double)parts[1].rgb[3 * bin + 1];
        double c = fmax(wo[2] * wi[2], 0.01);
        double middle = (pow(a * c + 0.001, 0.3) * pow(b * c + 0.001, 0.7) - 0.001) / c;
        assert_true(fabs((double)linear.rgb[3 * bin + 1] - (0.3 * a + 0.7 * b)) <= 1e-6 * (a + b));
        assert_true(fabs((double)relative.rgb[3 * bin + 1] - middle) <= 2e-7 * middle + 1e-9);
        ++seen;
    }
    assert_true(seen > 1000);
    brdf_merl_free(&relative);
    brdf_merl_free(&linear);
}

/* The mapping: nothing at the reference, its inverse, and black that stays finite. */
static void the_mapping_is_inverted(void **state)
{
    (void)state;
    assert_true(lab_logrelative_map(0.4, 0.5, 0.2) == 0.0);
    assert_true(fabs(lab_logrelative_map(0.0, 0.5, 0.2) - log(0.001 / 0.201)) < 1e-14);
    assert_true(lab_logrelative_cosine(0.01, 0.01) == 0.01);
    for (double f = 0.0; f < 2000.0; f = 3.0 * f + 1e-4) {
        double back = lab_logrelative_unmap(lab_logrelative_map(f, 0.3, 0.7), 0.3, 0.7);
        assert_true(fabs(back - f) <= 1e-13 * (f + 1.0));
    }
    assert_true(lab_logrelative_unmap(-50.0, 0.5, 0.2) == 0.0);
}

/* A bin that one part lacks is missing, unless that part has no weight. */
static void what_was_not_measured_stays_so(void **state)
{
    struct brdf_merl_file *parts = *state;
    size_t hole = 3 * (size_t)((10 * 90 + 20) * 180 + 30);
    const double both[] = {0.5, 0.5}, first[] = {1.0, 0.0};
    float *rgb = parts[METAL].rgb + hole, old[3];
    memcpy(old, rgb, sizeof old);
    rgb[0] = rgb[1] = rgb[2] = -1.0f;
    struct brdf_merl_file m = mix(parts, both, 2, LAB_MIX_LOGRELATIVE);
    assert_true(m.rgb[hole] == -1.0f && m.invalid == parts[MATTE].invalid + 1);
    brdf_merl_free(&m);
    m = mix(parts, first, 2, LAB_MIX_LOGRELATIVE);
    assert_true(equal(&m, &parts[MATTE]));
    brdf_merl_free(&m);
    memcpy(rgb, old, sizeof old);
}

static void bad_weights_are_refused(void **state)
{
    const struct brdf_merl_file *parts = *state;
    const double bad[][2] = {{0.0, 0.0}, {-0.1, 1.1}, {(double)NAN, 1.0}, {HUGE_VAL, 1.0}};
    struct brdf_merl_file m;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        struct brdf_error error = {BRDF_OK, ""};
        assert_int_equal(lab_mix_merl(parts, bad[i], 2, LAB_MIX_LINEAR, &m, &error),
                         BRDF_BAD_ARGUMENT);
        assert_non_null(strstr(error.message, "weight"));
        assert_null(m.rgb);
    }
    const double good[] = {0.5, 0.5};
    assert_int_equal(lab_mix_merl(parts, good, 0, LAB_MIX_LINEAR, &m, NULL), BRDF_BAD_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mixture_with_itself_changes_no_bit),
        cmocka_unit_test(weights_of_nothing_and_all_give_the_ends),
        cmocka_unit_test(the_order_makes_no_difference),
        cmocka_unit_test(values_are_those_of_the_formulas),
        cmocka_unit_test(the_mapping_is_inverted),
        cmocka_unit_test(what_was_not_measured_stays_so),
        cmocka_unit_test(bad_weights_are_refused),
    };
    return cmocka_run_group_tests(tests, parts_make, parts_free);
}
