/*
 * test_lab_edit.c - measured materials taken apart and edited, against materials whose parts are
 * known.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "compare.h"
#include "edit.h"
#include "lab_files.h"
#include "oklab.h"
#include "separate.h"
#include "support_bsdf.h"

static const char painted[] =
    "ward:variant=ward-duer,alpha=0.15,diffuse_reflectance=0.3/0.2/0.1,specular_reflectance=0.2";

/* A table edited, as a bsdf. */
static struct brdf_bsdf *edited(const char *description, struct lab_edit edit)
{
    struct brdf_merl_file file = lab_test_bake(description), out;
    struct brdf_error error = {BRDF_OK, ""};
    if (lab_edit_merl(&file, &edit, &out, &error)) {
        fail_msg("%s", error.message);
    }
    assert_int_equal(out.invalid, file.invalid);
    struct brdf_bsdf *bsdf = lab_test_load(&out, "interpolation=linear");
    brdf_merl_free(&out);
    brdf_merl_free(&file);
    return bsdf;
}

static struct lab_difference edited_against(const char *description, struct lab_edit edit,
                                            const char *wanted)
{
    struct brdf_bsdf *a = bsdf_make(wanted), *b = edited(description, edit);
    struct lab_difference difference = lab_compare(a, b);
    print_message("  %s: rms %.4f mean %.4f albedo %.4f\n", wanted, difference.rms, difference.mean,
                  difference.albedo);
    brdf_bsdf_destroy(a);
    brdf_bsdf_destroy(b);
    return difference;
}

static void an_edit_of_nothing_changes_no_bit(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake(painted), out;
    struct lab_edit nothing = lab_edit_nothing();
    assert_true(lab_edit_is_nothing(&nothing));
    assert_int_equal(lab_edit_merl(&file, &nothing, &out, NULL), BRDF_OK);
    assert_memory_equal(file.rgb, out.rgb, 3 * file.bins * sizeof(float));
    brdf_merl_free(&out);
    /* Taken apart and put together again without a change, it is the same but for rounding. */
    nothing.part = LAB_EDIT_DIFFUSE;
    nothing.hue = 8.0 * atan(1.0);
    assert_int_equal(lab_edit_merl(&file, &nothing, &out, NULL), BRDF_OK);
    for (size_t i = 0; i < 3 * file.bins; ++i) {
        assert_true(fabs((double)file.rgb[i] - (double)out.rgb[i]) <=
                    1e-5 * fabs((double)file.rgb[i]));
    }
    brdf_merl_free(&out);
    brdf_merl_free(&file);
}

/* Lambert under a lobe of slopes: the level is Lambert's, until the lobe is everywhere. */
static void the_diffuse_part_is_found(void **state)
{
    (void)state;
    const double wanted[3] = {0.3, 0.2, 0.1};
    struct brdf_merl_file file = lab_test_bake(painted);
    struct lab_diffuse diffuse;
    assert_int_equal(lab_separate(&file, &diffuse, NULL), BRDF_OK);
    for (int d = 0; d < LAB_SEPARATE_BINS; ++d) {
        for (int c = 0; c < 3; ++c) {
            assert_true(fabs(diffuse.level[d][c] * pi - wanted[c]) < 0.01 * wanted[c]);
        }
    }
    brdf_merl_free(&file);
}

static void parts_are_scaled_apart(void **state)
{
    (void)state;
    struct lab_edit edit = lab_edit_nothing();
    edit.specular = 0.0;
    assert_true(edited_against(painted, edit, "diffuse:reflectance=0.3/0.2/0.1").rms < 0.01);
    edit.specular = 0.5;
    edit.diffuse = 2.0;
    struct lab_difference d =
        edited_against(painted, edit,
                       "ward:variant=ward-duer,alpha=0.15,diffuse_reflectance="
                       "0.6/0.4/0.2,specular_reflectance=0.1");
    assert_true(d.mean < 0.01 && d.albedo < 0.03);
}

/*
 * The lobe of a metal, narrower and wider: alpha / gloss; exactly so, up to the grid, in V-shaped
 * grooves. Smith's masking depends on alpha, which shows at 85 degrees, where the largest
 * difference of albedos is.
 */
static void gloss_scales_the_width_of_a_lobe(void **state)
{
    (void)state;
    static const struct {
        const char *narrow, *wide;
        double gloss, mean, albedo;
    } cases[] = {
        {"torrancesparrow:distribution=beckmann,alpha=0.1",
         "torrancesparrow:distribution=beckmann,alpha=0.2", 0.5, 0.01, 0.02},
        {"roughconductor:material=Cu,distribution=beckmann,alpha=0.1",
         "roughconductor:material=Cu,distribution=beckmann,alpha=0.15", 2.0 / 3.0, 0.05, 0.3},
        {"roughconductor:material=Cu,distribution=ggx,alpha=0.1",
         "roughconductor:material=Cu,distribution=ggx,alpha=0.2", 0.5, 0.15, 0.3},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct lab_edit edit = lab_edit_nothing();
        edit.gloss = cases[i].gloss;
        edit.metal = 1;
        struct lab_difference d = edited_against(cases[i].narrow, edit, cases[i].wide);
        assert_true(d.mean < cases[i].mean && d.albedo < cases[i].albedo);
        edit.gloss = 1.0 / cases[i].gloss;
        d = edited_against(cases[i].wide, edit, cases[i].narrow);
        assert_true(d.mean < cases[i].mean && d.albedo < cases[i].albedo);
    }
}

static void hue_and_saturation_keep_lightness(void **state)
{
    (void)state;
    double gray[3] = {0.5, 0.2, 0.1}, there[3] = {0.3, 0.25, 0.2},
           bright[3] = {300.0, 250.0, 200.0};
    lab_color_change(gray, 0.0, 0.0);
    assert_true(fabs(gray[0] - gray[1]) < 1e-6 && fabs(gray[1] - gray[2]) < 1e-6);
    assert_true(gray[0] > 0.2 && gray[0] < 0.3); /* as light as it was */
    lab_color_change(there, 1.0, 1.0);
    assert_true(fabs(there[0] - 0.3) > 0.01);
    lab_color_change(bright, 1.0, 1.0);
    for (int c = 0; c < 3; ++c) {
        assert_true(fabs(bright[c] - 1000.0 * there[c]) < 1e-3); /* the same, however bright */
    }
    lab_color_change(there, -1.0, 1.0);
    assert_true(fabs(there[0] - 0.3) < 1e-5 && fabs(there[2] - 0.2) < 1e-5);
    double red[3] = {0.8, 0.0, 0.0};
    lab_color_change(red, 2.0, 5.0); /* far out of what can be shown */
    assert_true(red[0] >= 0.0 && red[1] >= 0.0 && red[2] >= 0.0);
    double black[3] = {0.0, 0.0, 0.0};
    lab_color_change(black, 1.0, 2.0);
    assert_true(black[0] == 0.0 && black[1] == 0.0 && black[2] == 0.0);
}

/* The diffuse colour changes, and the highlight stays white. */
static void one_part_is_coloured(void **state)
{
    (void)state;
    struct lab_edit edit = lab_edit_nothing();
    edit.saturation = 0.0;
    edit.part = LAB_EDIT_DIFFUSE;
    struct brdf_bsdf *before = bsdf_make(painted), *after = edited(painted, edit);
    const brdf_vec3 wo = {0.6f, 0.0f, 0.8f}, mirror = {-0.6f, 0.0f, 0.8f};
    brdf_rgb away = brdf_eval(after, wo, wo);
    assert_true(fabs((double)away.r - (double)away.b) < 1e-4);
    double peak = (double)brdf_eval(before, wo, mirror).g;
    assert_true(fabs((double)brdf_eval(after, wo, mirror).g - peak) < 0.02 * peak);
    brdf_bsdf_destroy(before);
    brdf_bsdf_destroy(after);
}

static void bad_factors_are_refused(void **state)
{
    (void)state;
    struct brdf_merl_file file = lab_test_bake("diffuse"), out;
    const struct lab_edit bad[] = {{0.0, 1.0, 1.0, 0.0, 1.0, LAB_EDIT_ALL, 0},
                                   {1.0, -1.0, 1.0, 0.0, 1.0, LAB_EDIT_ALL, 0},
                                   {1.0, 1.0, (double)NAN, 0.0, 1.0, LAB_EDIT_ALL, 0},
                                   {1.0, 1.0, 1.0, HUGE_VAL, 1.0, LAB_EDIT_ALL, 0},
                                   {1.0, 1.0, 1.0, 0.0, -2.0, LAB_EDIT_ALL, 0}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        assert_int_equal(lab_edit_merl(&file, &bad[i], &out, NULL), BRDF_BAD_ARGUMENT);
        assert_null(out.rgb);
    }
    brdf_merl_free(&file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edit_of_nothing_changes_no_bit),
        cmocka_unit_test(the_diffuse_part_is_found),
        cmocka_unit_test(parts_are_scaled_apart),
        cmocka_unit_test(gloss_scales_the_width_of_a_lobe),
        cmocka_unit_test(hue_and_saturation_keep_lightness),
        cmocka_unit_test(one_part_is_coloured),
        cmocka_unit_test(bad_factors_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
