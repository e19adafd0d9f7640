/*
 * test_lab_bake.c - materials baked into MERL tables and read back: what the grid costs.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "compare.h"
#include "complete.h"
#include "lab_files.h"
#include "open.h"
#include "support_bsdf.h"

static void diffuse_comes_back_to_a_millionth(void **state)
{
    (void)state;
    struct brdf_bsdf *matte = bsdf_make("diffuse:reflectance=0.2/0.4/0.6");
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.2/0.4/0.6");
    struct brdf_bsdf *baked = lab_test_load(&file, "interpolation=linear");
    struct lab_difference d = lab_compare(matte, baked);
    assert_true(d.rms < 1e-6 && d.mean < 1e-6 && d.worst.relative < 1e-6 &&
                d.grazing.relative < 1e-6 && d.albedo < 1e-6);
    brdf_merl_free(&file);
    brdf_bsdf_destroy(baked);
    brdf_bsdf_destroy(matte);
}

/*
 * The grid has bins of one degree in theta_d: towards grazing f changes within one, and that is
 * what is left. In the mean it is a few parts in a thousand, and shrinks with the lobe's width.
 */
static void rough_metals_come_back_to_the_grid(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double rms, mean, albedo;
    } cases[] = {
        {"roughconductor:material=Au,alpha=0.1,distribution=ggx", 0.01, 0.004, 0.012},
        {"roughconductor:material=Au,alpha=0.2,distribution=ggx", 0.004, 0.002, 0.005},
        {"roughconductor:material=Au,alpha=0.4,distribution=beckmann", 0.002, 0.001, 0.002},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdf_bsdf *metal = bsdf_make(cases[i].description);
        struct brdf_merl_file file = lab_test_bake(cases[i].description);
        struct brdf_bsdf *linear = lab_test_load(&file, "interpolation=linear");
        struct brdf_bsdf *nearest = lab_test_load(&file, "interpolation=nearest");
        struct lab_difference d = lab_compare(metal, linear);
        struct lab_difference n = lab_compare(metal, nearest);
        print_message("%s: rms %.4f mean %.5f albedo %.4f; nearest: rms %.4f mean %.5f\n",
                      cases[i].description, d.rms, d.mean, d.albedo, n.rms, n.mean);
        assert_true(d.rms < cases[i].rms && d.mean < cases[i].mean && d.albedo < cases[i].albedo);
        assert_true(n.mean > 8.0 * d.mean);
        assert_true(n.rms > 8.0 * d.rms);
        brdf_merl_free(&file);
        brdf_bsdf_destroy(nearest);
        brdf_bsdf_destroy(linear);
        brdf_bsdf_destroy(metal);
    }
}

/* The same into the other format, whose grid follows the lobe; and what only it can hold. */
static void rough_metals_come_back_from_rgl(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        int phis, symmetry;
        double rms, mean, albedo;
    } cases[] = {
        {"diffuse:reflectance=0.2/0.4/0.6", 1, 4, 0.015, 0.008, 0.003},
        {"roughconductor:material=Au,alpha=0.2", 1, 4, 0.006, 0.006, 0.006},
        {"roughconductor:material=Au,alpha_u=0.1,alpha_v=0.3", 9, 4, 0.012, 0.01, 0.01},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdf_bsdf *metal = bsdf_make(cases[i].description);
        struct brdf_rgl_grid grid = {0};
        struct brdf_rgl_file file;
        struct brdf_error error = {BRDF_OK, ""};
        if (lab_bake_rgl(metal, &grid, &file, &error)) {
            fail_msg("%s", error.message);
        }
        assert_int_equal(file.phi_count, cases[i].phis);
        assert_int_equal(lab_symmetry(metal), cases[i].symmetry);
        struct brdf_bsdf *baked = lab_test_through(NULL, &file, "scale=1");
        struct lab_difference d = lab_compare(metal, baked);
        print_message("%s: rms %.4f mean %.4f albedo %.4f\n", cases[i].description, d.rms, d.mean,
                      d.albedo);
        assert_true(d.rms < cases[i].rms && d.mean < cases[i].mean && d.albedo < cases[i].albedo);
        brdf_rgl_free(&file);
        brdf_bsdf_destroy(baked);
        brdf_bsdf_destroy(metal);
    }
}

/* Both orders of the directions share a bin, which holds their mean. */
static void bins_hold_both_orders(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("lommelseeliger");
    struct brdf_bsdf *moon = bsdf_make("lommelseeliger");
    for (int p = 0; p < 180; p += 7) {
        double o[3], i[3];
        assert_true(brdf_merl_directions(40, 20, p, o, i));
        brdf_vec3 wo = brdf_vec3_make((float)o[0], (float)o[1], (float)o[2]);
        brdf_vec3 wi = brdf_vec3_make((float)i[0], (float)i[1], (float)i[2]);
        double wanted =
            0.5 * ((double)brdf_eval(moon, wo, wi).g + (double)brdf_eval(moon, wi, wo).g);
        double found = (double)file.rgb[3 * ((40 * 90 + 20) * 180 + p) + 1];
        assert_true(fabs(found - wanted) <= 1e-7 * wanted);
    }
    brdf_bsdf_destroy(moon);
    brdf_merl_free(&file);
}

static void what_no_table_holds_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *description, *word;
    } cases[] = {
        {"conductor", "mirror direction"},
        {"plastic", "mirror direction"},
        {"dielectric", "lets light through"},
        {"roughdielectric", "lets light through"},
        {"roughconductor:alpha_u=0.1,alpha_v=0.4", "turned about its normal"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdf_bsdf *bsdf = bsdf_make(cases[i].description);
        struct brdf_merl_file file;
        struct brdf_error error = {BRDF_OK, ""};
        assert_int_equal(lab_bake_merl(bsdf, &file, &error), BRDF_UNSUPPORTED);
        assert_non_null(strstr(error.message, cases[i].word));
        brdf_bsdf_destroy(bsdf);
    }
    struct brdf_bsdf *round = bsdf_make("ward:alpha_u=0.2,alpha_v=0.2");
    assert_true(lab_anisotropy(round) < 1e-3); /* a model that could be anisotropic, and is not */
    assert_false(lab_has_delta(round));
    brdf_bsdf_destroy(round);
}

/* Half as bright: every number of the comparison is known. */
static void comparisons_of_matte_with_matte(void **state)
{
    (void)state;
    struct brdf_bsdf *a = bsdf_make("diffuse:reflectance=0.5");
    struct brdf_bsdf *b = bsdf_make("diffuse:reflectance=0.25");
    struct lab_difference d = lab_compare(a, b);
    assert_true(fabs(d.rms - 0.5) < 1e-6 && fabs(d.mean - 0.5) < 1e-6);
    assert_true(fabs(d.worst.relative - 0.5) < 1e-6 && fabs(d.albedo - 0.25) < 1e-6);
    d = lab_compare(a, a);
    assert_true(d.rms == 0.0 && d.mean == 0.0 && d.worst.relative == 0.0 && d.most == 0.0 &&
                d.albedo == 0.0);
    brdf_bsdf_destroy(b);
    brdf_bsdf_destroy(a);
}

static void texts_are_files_or_descriptions(void **state)
{
    (void)state;
    enum lab_format format;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(lab_format_of("diffuse:reflectance=0.5", &format, &error), BRDF_OK);
    assert_int_equal(format, LAB_FORMAT_NONE);
    assert_int_equal(lab_format_of("difuse", &format, &error), BRDF_UNKNOWN_NAME);
    assert_non_null(strstr(error.message, "did you mean \"diffuse\""));
    assert_int_equal(lab_format_of("/nowhere/gold.binary", &format, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "/nowhere/gold.binary"));
    assert_int_equal(lab_format_of("/", &format, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "a folder"));
}

/* A hole above the surface gets a value, and what is below stays unmeasured. */
static void holes_are_completed_above_only(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse:reflectance=0.5");
    size_t hole = 3 * (size_t)((30 * 90 + 20) * 180 + 90), below = file.invalid;
    float value = file.rgb[hole];
    file.rgb[hole] = file.rgb[hole + 1] = file.rgb[hole + 2] = -1.0f;
    ++file.invalid;
    assert_int_equal(lab_complete_merl(&file, 0, NULL), BRDF_OK);
    assert_true(file.rgb[hole] == 0.0f && file.invalid == below);
    file.rgb[hole] = file.rgb[hole + 1] = file.rgb[hole + 2] = -1.0f;
    ++file.invalid;
    assert_int_equal(lab_complete_merl(&file, 1, NULL), BRDF_OK);
    assert_true(fabs((double)file.rgb[hole] - (double)value) < 1e-7 && file.invalid == below);
    for (size_t i = 0; i < 3 * file.bins; ++i) {
        file.rgb[i] = -1.0f;
    }
    file.invalid = file.bins;
    assert_int_equal(lab_complete_merl(&file, 1, NULL), BRDF_BAD_ARGUMENT);
    brdf_merl_free(&file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_comes_back_to_a_millionth),
        cmocka_unit_test(rough_metals_come_back_to_the_grid),
        cmocka_unit_test(rough_metals_come_back_from_rgl),
        cmocka_unit_test(bins_hold_both_orders),
        cmocka_unit_test(what_no_table_holds_is_refused),
        cmocka_unit_test(comparisons_of_matte_with_matte),
        cmocka_unit_test(texts_are_files_or_descriptions),
        cmocka_unit_test(holes_are_completed_above_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
