/*
 * test_fit.c - fits find the parameters that their targets were made with, and say what they
 * cannot.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/model.h>

#include "fit.h"
#include "fit_space.h"
#include "lab_files.h"
#include "scene_text.h"
#include "support_bsdf.h"

/* The light that comes back along the normal: what eta and k of a metal are seen by. */
static double normal_reflectance(const struct brdf_material *material, int eta, int k, int channel)
{
    double n = (double)material->word[eta + channel];
    double m = (double)material->word[k + channel];
    return ((n - 1.0) * (n - 1.0) + m * m) / ((n + 1.0) * (n + 1.0) + m * m);
}

/* Every searched number of the model within 2 % (or 0.002), metals by their reflectance. */
static void assert_recovered(const struct brdf_bsdf *target, const struct brdf_bsdf *fit)
{
    const struct brdf_material *wanted = brdf_bsdf_material(target);
    const struct brdf_material *found = brdf_bsdf_material(fit);
    const struct brdf_model_info *model = brdf_model_info((int)wanted->model);
    const struct brdf_parameter_info *eta = brdf_parameter_find(model, "eta");
    assert_int_equal(found->model, wanted->model);
    for (size_t i = 0; i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        int place = brdf_parameter_place(model, parameter);
        int channels = parameter->kind == BRDF_KIND_COLOR ? 3 : 1;
        if (parameter->kind != BRDF_KIND_REAL && parameter->kind != BRDF_KIND_COLOR) {
            continue;
        }
        for (int c = 0; c < channels; ++c) {
            double want = (double)wanted->word[place + c];
            double have = (double)found->word[place + c];
            if (eta && (parameter == eta || strcmp(parameter->name, "k") == 0)) {
                int n = brdf_parameter_place(model, eta);
                int k = brdf_parameter_place(model, brdf_parameter_find(model, "k"));
                want = normal_reflectance(wanted, n, k, c);
                have = normal_reflectance(found, n, k, c);
            }
            if (!(fabs(have - want) <= fmax(0.02 * fabs(want), 0.002))) {
                fail_msg("%s: %s[%d] is %g, not %g", model->name, parameter->name, c, have, want);
            }
        }
    }
}

static void recovers(const char *target_text, const char *model, const char *free_names)
{
    struct brdf_bsdf *target = bsdf_make(target_text);
    struct lab_fit_options options = lab_fit_defaults(model);
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    options.free = free_names;
    options.starts = 1;
    options.evaluations_max = 1000;
    if (lab_fit(target, &options, &fit, &error)) {
        fail_msg("%s: %s", target_text, error.message);
    }
    assert_int_equal(fit.part_count, 1);
    assert_true(fit.error < 1e-3 * fit.error_black);
    assert_recovered(target, fit.parts[0]);
    lab_fit_free(&fit);
    brdf_bsdf_destroy(target);
}

static void test_parameters_come_back(void **state)
{
    (void)state;
    recovers("ward:alpha=0.15,specular_reflectance=0.1/0.2/0.3,diffuse_reflectance=0.3/0.2/0.1",
             "ward", NULL);
    recovers("ward:variant=ward,alpha=0.4,specular_reflectance=0.3,diffuse_reflectance=0.05",
             "ward:variant=ward", NULL);
    recovers("phong:exponent=60,specular_reflectance=0.3,diffuse_reflectance=0.1/0.3/0.5", "phong",
             NULL);
    recovers("blinnphong:exponent=300,specular_reflectance=0.3/0.2/0.2,diffuse_reflectance=0.1",
             "blinnphong", NULL);
    recovers("ashikhminshirley:exponent=200,specular_reflectance=0.1/0.05/0.3", "ashikhminshirley",
             NULL);
    recovers("roughconductor:alpha=0.1,distribution=ggx,material=Cu",
             "roughconductor:distribution=ggx", NULL);
    recovers("orennayar:roughness=0.4,reflectance=0.3/0.6/0.9", "orennayar", NULL);
    recovers("cooktorrance:alpha=0.2,eta=1.5,k=0,specular_reflectance=0.5/0.4/0.3,"
             "diffuse_reflectance=0.3/0.1/0.05",
             "cooktorrance", NULL);
    recovers("cooktorrance:alpha=0.2,eta=1.5,k=0,diffuse_reflectance=0.3/0.1/0.05",
             "cooktorrance:eta=2,k=0,specular_reflectance=1", "eta");
    recovers("torrancesparrow:distribution=beckmann,alpha=0.3,eta=1.8,k=0",
             "torrancesparrow:distribution=beckmann,eta=2,k=0", "eta");
    recovers("lommelseeliger:albedo=0.2/0.4/0.6", "lommelseeliger", NULL);
}

/* Through a measured file: interpolating between its bins costs some precision. */
static void test_baked_file(void **state)
{
    (void)state;
    struct brdf_merl_file file =
        lab_test_bake("ward:alpha=0.25,specular_reflectance=0.1,diffuse_reflectance=0.3/0.2/0.1");
    struct brdf_bsdf *target = lab_test_load(&file, "interpolation=linear");
    struct brdf_bsdf *wanted =
        bsdf_make("ward:alpha=0.25,specular_reflectance=0.1,diffuse_reflectance=0.3/0.2/0.1");
    struct lab_fit_options options = lab_fit_defaults("ward");
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    options.starts = 1;
    options.evaluations_max = 500;
    assert_int_equal(lab_fit(target, &options, &fit, &error), BRDF_OK);
    assert_true(fit.error > 0.0 && fit.error < 0.01 * fit.error_black);
    assert_recovered(wanted, fit.parts[0]);
    lab_fit_free(&fit);
    brdf_bsdf_destroy(wanted);
    brdf_bsdf_destroy(target);
    brdf_merl_free(&file);
}

/* Roughness along both tangents, which an isotropic fit would have to take as one. */
static void test_anisotropy_comes_back(void **state)
{
    (void)state;
    struct brdf_bsdf *target = bsdf_make("ward:alpha_u=0.1,alpha_v=0.4");
    struct lab_fit_options options = lab_fit_defaults("ward");
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    options.starts = 1;
    options.anisotropic = 1;
    options.evaluations_max = 800;
    assert_int_equal(lab_fit(target, &options, &fit, &error), BRDF_OK);
    assert_recovered(target, fit.parts[0]);
    lab_fit_free(&fit);
    brdf_bsdf_destroy(target);
}

/* A blend of a diffuse part and a lobe: weights sum to 1, and the error is that of the parts. */
static void test_blend(void **state)
{
    (void)state;
    struct brdf_bsdf *target =
        bsdf_make("cooktorrance:alpha=0.3,eta=1.5,k=0,"
                  "diffuse_reflectance=0.2/0.1/0.05,specular_reflectance=0.5");
    struct lab_fit_options options =
        lab_fit_defaults("torrancesparrow:distribution=beckmann,eta=2,k=0");
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    double again = 0.0;
    options.starts = 1;
    options.free = "eta";
    options.diffuse = 1;
    assert_int_equal(lab_fit(target, &options, &fit, &error), BRDF_OK);
    assert_int_equal(fit.part_count, 2);
    assert_true(fabs(fit.weights[0] + fit.weights[1] - 1.0) < 1e-12);
    assert_true(fit.error < 0.01 * fit.error_black);
    assert_int_equal(lab_fit_error(target, &options, (const struct brdf_bsdf *const *)fit.parts,
                                   fit.weights, fit.part_count, &again, &error),
                     BRDF_OK);
    assert_true(fabs(again - fit.error) < 1e-6);
    lab_fit_free(&fit);
    brdf_bsdf_destroy(target);
}

static void fails(const char *target_text, struct lab_fit_options options, brdf_status expected,
                  const char *part)
{
    struct brdf_bsdf *target = bsdf_make(target_text);
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(lab_fit(target, &options, &fit, &error), expected);
    if (!strstr(error.message, part)) {
        fail_msg("'%s' does not say '%s'", error.message, part);
    }
    lab_fit_free(&fit);
    brdf_bsdf_destroy(target);
}

static int stop_at_once(const struct lab_fit_progress *state, void *data)
{
    (void)state;
    (void)data;
    return 1;
}

static void test_failures(void **state)
{
    (void)state;
    struct lab_fit_options options = lab_fit_defaults("wrad");
    fails("diffuse", options, BRDF_UNKNOWN_NAME, "ward");
    options = lab_fit_defaults("dielectric");
    fails("diffuse", options, BRDF_UNSUPPORTED, "take another model");
    options = lab_fit_defaults("plastic");
    fails("diffuse", options, BRDF_UNSUPPORTED, "take another model");
    options = lab_fit_defaults("ward");
    fails("conductor", options, BRDF_UNSUPPORTED, "smooth");
    fails("plastic", options, BRDF_UNSUPPORTED, "smooth");
    fails("diffuse:reflectance=0", options, BRDF_UNSUPPORTED, "black");
    options.diffuse = 1;
    fails("diffuse", options, BRDF_BAD_ARGUMENT, "diffuse part");
    options = lab_fit_defaults("diffuse:reflectance=0.5");
    fails("diffuse", options, BRDF_UNSUPPORTED, "nothing to search");
    options = lab_fit_defaults("ward");
    options.free = "alpha_u,alhpa_v";
    fails("diffuse", options, BRDF_UNKNOWN_NAME, "alpha_v");
    options = lab_fit_defaults("ward");
    options.progress = stop_at_once;
    fails("diffuse", options, BRDF_CANCELLED, "stopped");
}

/* What a scene says is what the parts are: the blend's weights multiply out. */
static void test_scene_text(void **state)
{
    (void)state;
    struct brdf_bsdf *parts[3] = {
        bsdf_make("diffuse:reflectance=0.1/0.2/0.3"),
        bsdf_make("roughconductor:distribution=ggx,alpha=0.25,material=Au"),
        bsdf_make("diffuse:reflectance=0")};
    const double weights[3] = {0.5, 0.125, 0.375};
    char text[4096] = "";
    FILE *file = tmpfile();
    assert_non_null(file);
    lab_scene_text(file, (const struct brdf_bsdf *const *)parts, weights, 3, 0);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    const char *outer = strstr(text, "\"weight\" value=\"0.5\"");
    const char *inner = strstr(text, "\"weight\" value=\"0.75\"");
    assert_non_null(outer);
    assert_non_null(inner);
    assert_true(outer < strstr(text, "0.1"));
    assert_true(inner < strstr(text, "\"ggx\""));
    assert_non_null(strstr(text, "<float name=\"alpha_u\" value=\"0.25\"/>"));
    for (int i = 0; i < 3; ++i) {
        brdf_bsdf_destroy(parts[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parameters_come_back),
        cmocka_unit_test(test_baked_file),
        cmocka_unit_test(test_anisotropy_comes_back),
        cmocka_unit_test(test_blend),
        cmocka_unit_test(test_failures),
        cmocka_unit_test(test_scene_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
