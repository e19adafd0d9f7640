/*
 * test_measuredmix.c - the model measuredmix against the two materials that it is made of.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <brdf/warp.h>

#include "lab_files.h"
#include "lattice.h"

/* Two materials, and mixtures of them with the weights 0, 0.3 and 1. */
struct trio {
    struct brdf_bsdf *part[2];
    struct brdf_bsdf *mix[3];
};

static const float shares[3] = {0.0f, 0.3f, 1.0f};
static const char *const descriptions[2] = {"roughconductor:material=Cu,alpha=0.15",
                                            "diffuse:reflectance=0.1/0.4/0.7"};

static struct brdf_bsdf *create(const char *model, const struct brdf_setting *settings,
                                size_t count)
{
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    if (brdf_bsdf_create_from(model, settings, count, &bsdf, &error)) {
        print_error("%s\n", error.message);
    }
    return bsdf;
}

static int trio_make(void **state)
{
    struct trio *trio = calloc(1, sizeof *trio);
    struct place place[2];
    *state = trio;
    for (int k = 0; k < 2; ++k) {
        struct brdf_merl_file file = lab_test_bake(descriptions[k]);
        assert_int_equal(place_make(&place[k], k ? "1" : "0"), 0);
        assert_int_equal(brdf_merl_write(place[k].path, &file, NULL), BRDF_OK);
        brdf_merl_free(&file);
        struct brdf_setting setting = brdf_setting_text("filename", place[k].path);
        trio->part[k] = create("merl", &setting, 1);
    }
    for (int k = 0; k < 3; ++k) {
        const struct brdf_setting settings[] = {brdf_setting_text("filename_a", place[0].path),
                                                brdf_setting_text("filename_b", place[1].path),
                                                brdf_setting_real("weight", shares[k])};
        trio->mix[k] = create("measuredmix", settings, 3);
    }
    place_remove(&place[0]);
    place_remove(&place[1]);
    return trio->part[0] && trio->part[1] && trio->mix[0] && trio->mix[1] && trio->mix[2] ? 0 : -1;
}

static int trio_free(void **state)
{
    struct trio *trio = *state;
    for (int k = 0; k < 2; ++k) {
        brdf_bsdf_destroy(trio->part[k]);
    }
    for (int k = 0; k < 3; ++k) {
        brdf_bsdf_destroy(trio->mix[k]);
    }
    free(trio);
    return 0;
}

enum { PAIRS = 20000 };

static brdf_vec3 direction(const struct lab_lattice *lattice, size_t i, int first)
{
    return brdf_warp_cosine(lab_lattice_at(lattice, i, first),
                            lab_lattice_at(lattice, i, first + 1));
}

static void ends_are_the_parts(void **state)
{
    const struct trio *trio = *state;
    struct lab_lattice lattice = lab_lattice_make(4, 1);
    for (size_t i = 0; i < PAIRS; ++i) {
        brdf_vec3 wo = direction(&lattice, i, 0), wi = direction(&lattice, i, 2);
        for (int k = 0; k < 2; ++k) {
            brdf_rgb part = brdf_eval(trio->part[k], wo, wi);
            brdf_rgb mix = brdf_eval(trio->mix[2 * k], wo, wi);
            float pdf = brdf_pdf(trio->part[k], wo, wi);
            float mix_pdf = brdf_pdf(trio->mix[2 * k], wo, wi);
            assert_memory_equal(&part, &mix, sizeof part);
            assert_memory_equal(&pdf, &mix_pdf, sizeof pdf);
        }
    }
}

static void between_them_it_is_their_mean(void **state)
{
    const struct trio *trio = *state;
    struct lab_lattice lattice = lab_lattice_make(4, 2);
    for (size_t i = 0; i < PAIRS; ++i) {
        brdf_vec3 wo = direction(&lattice, i, 0), wi = direction(&lattice, i, 2);
        double a = (double)brdf_eval(trio->part[0], wo, wi).b;
        double b = (double)brdf_eval(trio->part[1], wo, wi).b;
        double mix = (double)brdf_eval(trio->mix[1], wo, wi).b;
        assert_true(fabs(mix - (0.7 * a + 0.3 * b)) <= 1e-6 * (a + b));
        double pdf = 0.7 * (double)brdf_pdf(trio->part[0], wo, wi) +
                     0.3 * (double)brdf_pdf(trio->part[1], wo, wi);
        assert_true(fabs((double)brdf_pdf(trio->mix[1], wo, wi) - pdf) <= 1e-6 * pdf);
    }
}

/* The mean weight is the mean of the parts' albedos, and no weight exceeds those of the parts. */
static void samples_have_the_weights_of_the_parts(void **state)
{
    const struct trio *trio = *state;
    struct lab_lattice lattice = lab_lattice_make(3, 3);
    const brdf_vec3 wo = {0.6f, 0.0f, 0.8f};
    double sum[3] = {0.0}, most[3] = {0.0};
    const struct brdf_bsdf *bsdfs[3] = {trio->part[0], trio->part[1], trio->mix[1]};
    for (size_t i = 0; i < PAIRS; ++i) {
        brdf_vec3 u = lab_lattice_cube(&lattice, i);
        for (int k = 0; k < 3; ++k) {
            double weight = (double)brdf_sample(bsdfs[k], wo, u).weight.g;
            sum[k] += weight / PAIRS;
            most[k] = fmax(most[k], weight);
        }
    }
    assert_true(fabs(sum[2] - (0.7 * sum[0] + 0.3 * sum[1])) < 2e-3);
    assert_true(most[2] <= 1.05 * fmax(most[0], most[1]));
}

static void both_files_are_needed(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(brdf_bsdf_create("measuredmix:filename_a=a.binary", &bsdf, &error),
                     BRDF_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "filename_b is missing"));
    assert_int_equal(
        brdf_bsdf_create("measuredmix:filename_a=/no/a,filename_b=/no/b", &bsdf, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "/no/a"));
}

/* A description of the mixture names each file at its place. */
static void descriptions_name_both_files(void **state)
{
    const struct trio *trio = *state;
    char text[9000];
    assert_true(brdf_bsdf_describe(trio->mix[1], text, sizeof text) < sizeof text);
    const char *a = strstr(text, "filename_a=\"/"), *b = strstr(text, "filename_b=\"/");
    assert_true(a && b && a < b);
    assert_true(strstr(a, "/0\"") < b && strstr(b, "/1\"") != NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_the_parts),
        cmocka_unit_test(between_them_it_is_their_mean),
        cmocka_unit_test(samples_have_the_weights_of_the_parts),
        cmocka_unit_test(both_files_are_needed),
        cmocka_unit_test(descriptions_name_both_files),
    };
    return cmocka_run_group_tests(tests, trio_make, trio_free);
}
