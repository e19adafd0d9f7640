/* test_material.c - bsdfs from text and values: what is accepted, what is refused, what comes back.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/brdf.h>
#include <brdf/model.h>

#include "support_bsdf.h"

static void assert_words(const char *description, int count, const float *expected)
{
    struct brdf_bsdf *bsdf = bsdf_make(description);
    for (int i = 0; i < count; ++i) {
        float word = brdf_bsdf_material(bsdf)->word[i];
        if (fabsf(word - expected[i]) > 1e-6f * fabsf(expected[i])) {
            fail_msg("%s: word %d is %g, not %g", description, i, (double)word,
                     (double)expected[i]);
        }
    }
    brdf_bsdf_destroy(bsdf);
}

static void values_of_every_kind(void **state)
{
    (void)state;
    assert_words("diffuse", 3, (const float[]){0.5f, 0.5f, 0.5f});
    assert_words("diffuse:reflectance=0.2/0.4/0.6", 3, (const float[]){0.2f, 0.4f, 0.6f});
    assert_words("diffuse:reflectance=0.2 0.4  0.6 ", 3, (const float[]){0.2f, 0.4f, 0.6f});
    assert_words("diffuse:reflectance=\"0.2, 0.4, 0.6\"", 3, (const float[]){0.2f, 0.4f, 0.6f});
    assert_words(" diffuse : reflectance = .25 ", 3, (const float[]){0.25f, 0.25f, 0.25f});
    /* IEC 61966-2-1: byte 0x80 is 0.2158605 linear. */
    assert_words("diffuse:reflectance=#FF8000", 3, (const float[]){1.0f, 0.2158605f, 0.0f});
    assert_words("dielectric:int_ior=water,ext_ior=air", 2, (const float[]){1.333f, 1.000277f});
    assert_words("dielectric:int_ior=1.7", 2, (const float[]){1.7f, 1.000277f});
    assert_words("roughconductor:eta=0.2/0.9/1.1,k=3.9/2.4/2.1,alpha=0.25", 8,
                 (const float[]){0.2f, 0.9f, 1.1f, 3.9f, 2.4f, 2.1f, 0.25f, 0.25f});
    assert_words("roughconductor:alpha_v=0.3,material=none", 8,
                 (const float[]){0.0f, 0.0f, 0.0f, 1.0f, 1.0f, 1.0f, 0.1f, 0.3f});
}

static void choices_and_flags(void **state)
{
    (void)state;
    struct brdf_bsdf *plain = bsdf_make("roughconductor:distribution=beckmann,masking=separable");
    struct brdf_bsdf *both =
        bsdf_make("roughconductor:distribution=ggx,masking=separable,twosided");
    assert_int_equal(brdf_bsdf_material(plain)->choices, 0x1010);
    assert_int_equal(brdf_bsdf_material(both)->choices, 0x1011);
    assert_int_equal(brdf_bsdf_material(both)->model, BRDF_MODEL_ROUGHCONDUCTOR);
    assert_int_equal(brdf_bsdf_material(both)->flags,
                     brdf_model_info(BRDF_MODEL_ROUGHCONDUCTOR)->flags | BRDF_TWOSIDED);
    assert_int_equal(brdf_bsdf_material(plain)->flags & BRDF_TWOSIDED, 0);
    struct brdf_bsdf *opaque = bsdf_make("principled:twosided,spec_trans=0,metallic=1");
    assert_int_equal(brdf_bsdf_material(opaque)->flags & BRDF_TWOSIDED, BRDF_TWOSIDED);
    brdf_bsdf_destroy(opaque);
    brdf_bsdf_destroy(plain);
    brdf_bsdf_destroy(both);
}

static void initial_metal_unless_eta_and_k(void **state)
{
    (void)state;
    const struct brdf_metal *copper = brdf_metal_find("Cu");
    float words[6];
    memcpy(words, copper->eta, sizeof copper->eta);
    memcpy(words + 3, copper->k, sizeof copper->k);
    assert_words("roughconductor", 6, words);
    assert_words("roughconductor:material=Cu", 6, words);
}

/* What is refused, with what status, and what the sentence must contain. */
static const struct {
    const char *description;
    brdf_status status;
    const char *words[3];
} refused[] = {
    {"", BRDF_UNKNOWN_NAME, {"\"\"", "known: diffuse"}},
    {"difuse", BRDF_UNKNOWN_NAME, {"did you mean \"diffuse\""}},
    {"roughconducter", BRDF_UNKNOWN_NAME, {"did you mean \"roughconductor\""}},
    {"xyzzy", BRDF_UNKNOWN_NAME, {"known: diffuse, phong"}},
    {"diffuse:", BRDF_BAD_ARGUMENT, {"byte 9", "missing"}},
    {"diffuse:reflectance=0.5,", BRDF_BAD_ARGUMENT, {"byte 25", "missing"}},
    {"diffuse:,reflectance=0.5", BRDF_BAD_ARGUMENT, {"byte 9", "missing"}},
    {"diffuse:=0.5", BRDF_BAD_ARGUMENT, {"byte 9", "missing"}},
    {"diffuse:reflectance", BRDF_BAD_ARGUMENT, {"byte 9", "name=value"}},
    {"diffuse:reflectance=", BRDF_BAD_ARGUMENT, {"reflectance", "number"}},
    {"diffuse:reflectance=red", BRDF_BAD_ARGUMENT, {"\"red\"", "#rrggbb"}},
    {"diffuse:reflectance=0.1/0.2", BRDF_BAD_ARGUMENT, {"\"0.1/0.2\""}},
    {"diffuse:reflectance=0.1/0.2/0.3/0.4", BRDF_BAD_ARGUMENT, {"three"}},
    {"diffuse:reflectance=0.1/0.2/0.3/", BRDF_BAD_ARGUMENT, {"three"}},
    {"diffuse:reflectance=0.1//0.3", BRDF_BAD_ARGUMENT, {"three"}},
    {"diffuse:reflectance=0.1x", BRDF_BAD_ARGUMENT, {"\"0.1x\""}},
    {"diffuse:reflectance=#12345", BRDF_BAD_ARGUMENT, {"#12345"}},
    {"diffuse:reflectance=#1234567", BRDF_BAD_ARGUMENT, {"#1234567"}},
    {"diffuse:reflectance=#12345g", BRDF_BAD_ARGUMENT, {"#12345g"}},
    {"diffuse:reflectance=1.5", BRDF_OUT_OF_RANGE, {"1.5", "0 to 1", "fraction of the light"}},
    {"diffuse:reflectance=0.5/0.5/-0.1", BRDF_OUT_OF_RANGE, {"-0.1", "0 to 1"}},
    {"diffuse:reflectance=nan", BRDF_OUT_OF_RANGE, {"nan"}},
    {"diffuse:reflectance=0/inf/0", BRDF_OUT_OF_RANGE, {"inf"}},
    {"diffuse:reflectance=1e99", BRDF_OUT_OF_RANGE, {"inf"}},
    {"diffuse:reflectence=0.5", BRDF_UNKNOWN_NAME, {"byte 9", "did you mean \"reflectance\""}},
    {"diffuse:tosided", BRDF_BAD_ARGUMENT, {"name=value"}},
    {"diffuse:tosided=true", BRDF_UNKNOWN_NAME, {"did you mean \"twosided\""}},
    {"diffuse:colour=0.5", BRDF_UNKNOWN_NAME, {"known: reflectance, twosided"}},
    {"diffuse:reflectance=0.1,reflectance=0.2", BRDF_BAD_ARGUMENT, {"byte 25", "twice"}},
    {"diffuse:twosided,twosided=false", BRDF_BAD_ARGUMENT, {"byte 18", "twice"}},
    {"diffuse:twosided=yes", BRDF_BAD_ARGUMENT, {"true or false"}},
    {"dielectric:twosided", BRDF_BAD_ARGUMENT, {"twosided", "below"}},
    {"principled:twosided,spec_trans=0.1", BRDF_BAD_ARGUMENT, {"twosided", "spec_trans"}},
    {"dielectric:int_ior=daimond", BRDF_UNKNOWN_NAME, {"did you mean \"diamond\""}},
    {"dielectric:int_ior=-1.5", BRDF_OUT_OF_RANGE, {"-1.5", "refractive index below"}},
    {"roughconductor:alpha=0", BRDF_OUT_OF_RANGE, {"alpha = 0", "conductor,", "0.0001"}},
    {"roughconductor:alpha=0.1 0.2", BRDF_BAD_ARGUMENT, {"one number", "\"0.1 0.2\""}},
    {"roughconductor:alpha=0.1,alpha_v=0.2",
     BRDF_BAD_ARGUMENT,
     {"alpha_v", "by alpha and alpha_v"}},
    {"roughconductor:alpha_u=0.1,alpha=0.2", BRDF_BAD_ARGUMENT, {"alpha_u", "second time"}},
    {"roughconductor:distribution=gxg", BRDF_UNKNOWN_NAME, {"did you mean \"ggx\""}},
    {"roughconductor:distribution=blinn", BRDF_BAD_ARGUMENT, {"closed form", "take rational"}},
    {"roughconductor:distribution=phong", BRDF_UNKNOWN_NAME, {"known: beckmann, ggx, blinn"}},
    {"roughconductor:material=cu", BRDF_UNKNOWN_NAME, {"did you mean \"Cu\""}},
    {"roughconductor:material=unobtanium", BRDF_UNKNOWN_NAME, {"known: Ag, Al, Au"}},
    {"roughconductor:material=Cu,eta=1", BRDF_BAD_ARGUMENT, {"by material and eta"}},
    {"roughconductor:eta=1", BRDF_BAD_ARGUMENT, {"eta is set without k"}},
    {"roughconductor:k=1", BRDF_BAD_ARGUMENT, {"k is set without eta"}},
    {"merl", BRDF_BAD_ARGUMENT, {"filename is missing"}},
    {"merl:filename=", BRDF_BAD_ARGUMENT, {"empty"}},
    {"merl:filename=/no/such.binary", BRDF_IO, {"/no/such.binary"}},
    {"merl:filename=\"/no", BRDF_BAD_ARGUMENT, {"byte 15", "quote"}},
    {"merl:filename=\"/no\"x", BRDF_BAD_ARGUMENT, {"byte 20", "comma"}},
    {"merl:filename=\"/a \"\"b\"\", c\"", BRDF_IO, {"/a \"b\", c"}},
};

static void bad_descriptions_are_refused(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refused / sizeof refused[0]; ++i) {
        struct brdf_bsdf *bsdf = (struct brdf_bsdf *)&refused;
        struct brdf_error error = {0};
        brdf_status status = brdf_bsdf_create(refused[i].description, &bsdf, &error);
        assert_null(bsdf);
        assert_int_equal(brdf_bsdf_create(refused[i].description, &bsdf, NULL), status);
        if (status != refused[i].status || error.status != status) {
            fail_msg("%s: status %d (%s)", refused[i].description, status, error.message);
        }
        for (int k = 0; k < 3 && refused[i].words[k]; ++k) {
            if (!strstr(error.message, refused[i].words[k])) {
                fail_msg("%s: \"%s\" does not say \"%s\"", refused[i].description, error.message,
                         refused[i].words[k]);
            }
        }
    }
}

static void settings_by_value(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf;
    const struct brdf_setting settings[] = {
        brdf_setting_real("alpha", 0.3f),
        brdf_setting_color("eta", 0.1f, 0.2f, 0.3f),
        brdf_setting_text("k", "3, 2, 1"),
        brdf_setting_text("distribution", "ggx"),
    };
    assert_int_equal(brdf_bsdf_create_from("roughconductor", settings, 4, &bsdf, NULL), BRDF_OK);
    const float *word = brdf_bsdf_material(bsdf)->word;
    const float expected[] = {0.1f, 0.2f, 0.3f, 3.0f, 2.0f, 1.0f, 0.3f, 0.3f, 1.0f};
    assert_memory_equal(word, expected, sizeof expected);
    brdf_bsdf_destroy(bsdf);
}

static void bad_settings_are_refused(void **state)
{
    (void)state;
    const struct {
        struct brdf_setting setting;
        brdf_status status;
        const char *word;
    } bad[] = {
        {brdf_setting_real("alpha", NAN), BRDF_OUT_OF_RANGE, "nan"},
        {brdf_setting_real("alpha", INFINITY), BRDF_OUT_OF_RANGE, "inf"},
        {brdf_setting_color("alpha", 0.1f, 0.1f, 0.1f), BRDF_BAD_ARGUMENT, "one number"},
        {brdf_setting_real("material", 1.0f), BRDF_BAD_ARGUMENT, "not a number"},
        {brdf_setting_real("distribution", 1.0f), BRDF_BAD_ARGUMENT, "not a number"},
        {brdf_setting_real("twosided", 0.5f), BRDF_BAD_ARGUMENT, "true or false"},
        {brdf_setting_text("alpha", NULL), BRDF_BAD_ARGUMENT, "no value"},
        {brdf_setting_text(NULL, "1"), BRDF_BAD_ARGUMENT, "no name"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        struct brdf_bsdf *bsdf;
        struct brdf_error error = {0};
        brdf_status status =
            brdf_bsdf_create_from("roughconductor", &bad[i].setting, 1, &bsdf, &error);
        assert_int_equal(status, bad[i].status);
        assert_null(bsdf);
        assert_non_null(strstr(error.message, bad[i].word));
    }
}

static void descriptions_come_back(void **state)
{
    (void)state;
    const char *const descriptions[] = {
        "diffuse:reflectance=0.1/0.123456789/0.333333333,twosided",
        "phong:exponent=12345.678,specular_reflectance=1e-30,diffuse_reflectance=#102030",
        "roughconductor:material=Au,alpha_u=0.017,distribution=ggx",
        "roughconductor:material=none,masking=separable",
        "dielectric:int_ior=diamond,ext_ior=water",
    };
    for (size_t i = 0; i < sizeof descriptions / sizeof descriptions[0]; ++i) {
        char first[512], second[512], cut[8];
        struct brdf_bsdf *a = bsdf_make(descriptions[i]);
        size_t length = brdf_bsdf_describe(a, first, sizeof first);
        assert_int_equal(length, strlen(first));
        struct brdf_bsdf *b = bsdf_make(first);
        brdf_bsdf_describe(b, second, sizeof second);
        assert_string_equal(first, second);
        assert_memory_equal(brdf_bsdf_material(a), brdf_bsdf_material(b),
                            sizeof(struct brdf_material));
        assert_int_equal(brdf_bsdf_describe(a, cut, sizeof cut), length);
        assert_int_equal(strlen(cut), sizeof cut - 1);
        assert_memory_equal(cut, first, sizeof cut - 1);
        assert_int_equal(brdf_bsdf_describe(a, NULL, 0), length);
        brdf_bsdf_destroy(a);
        brdf_bsdf_destroy(b);
    }
}

/* A locale with a decimal comma changes neither reading nor writing; skipped where there is none.
 */
static void locales_do_not_matter(void **state)
{
    (void)state;
    const char *const commas[] = {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "fr_FR", "pt_BR.UTF-8"};
    int found = 0;
    for (size_t i = 0; i < sizeof commas / sizeof commas[0] && !found; ++i) {
        found = setlocale(LC_ALL, commas[i]) != NULL;
    }
    if (!found) {
        skip();
    }
    char text[128];
    struct brdf_bsdf *bsdf = bsdf_make("diffuse:reflectance=0.25");
    brdf_bsdf_describe(bsdf, text, sizeof text);
    setlocale(LC_ALL, "C");
    assert_string_equal(text, "diffuse:reflectance=0.25");
    brdf_bsdf_destroy(bsdf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_of_every_kind),
        cmocka_unit_test(choices_and_flags),
        cmocka_unit_test(initial_metal_unless_eta_and_k),
        cmocka_unit_test(bad_descriptions_are_refused),
        cmocka_unit_test(settings_by_value),
        cmocka_unit_test(bad_settings_are_refused),
        cmocka_unit_test(descriptions_come_back),
        cmocka_unit_test(locales_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
