/*
 * support_models.c - the cases of every model, and running checks over them.
 */
#include "support_models.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Cases beside the initial parameters and the random ones. */
static const char *const more_cases[] = {
    "diffuse:reflectance=1",
    "phong:exponent=1,specular_reflectance=0.5,diffuse_reflectance=0",
    "phong:exponent=1000,specular_reflectance=1,diffuse_reflectance=0",
    "blinnphong:normalisation=energy,exponent=1000,specular_reflectance=1,diffuse_reflectance=0",
    "blinnphong:normalisation=distribution,exponent=0,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=balanced,alpha=0.5,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=ward-duer,alpha_u=0.05,alpha_v=0.6,specular_reflectance=1,diffuse_reflectance=0",
    "ward:variant=ward,alpha_u=0.3,alpha_v=0.01,specular_reflectance=1,diffuse_reflectance=0",
    "ashikhminshirley:specular_reflectance=1,exponent_u=10,exponent_v=1000",
    "torrancesparrow:distribution=blinn,exponent=5",
    "torrancesparrow:distribution=beckmann,alpha=0.5",
    "torrancesparrow:distribution=beckmann,alpha=0.01",
    "cooktorrance:alpha=0.3,eta=1.5,k=0,diffuse_reflectance=0.6",
    "roughconductor:distribution=ggx,alpha=0.5",
    "roughconductor:distribution=ggx,alpha=0.01",
    "roughconductor:distribution=ggx,alpha_u=0.05,alpha_v=0.6",
    "roughconductor:distribution=beckmann,alpha=0.5",
    "roughconductor:distribution=beckmann,alpha=0.01",
    "roughconductor:distribution=beckmann,alpha_u=0.6,alpha_v=0.05",
    "dielectric:int_ior=1.33,ext_ior=1",
    "dielectric:int_ior=1,ext_ior=2.4",
};

enum {
    RANDOM_CASES = 8,   /* of each model, at least */
    SHOWN_FAILURES = 5, /* of a check */
};

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

int models_long(void)
{
    const char *value = getenv("BRDFCL_TEST_LONG");
    return value && *value && strcmp(value, "0") != 0;
}

int models_seen_from_below(const struct model_case *one)
{
    return (one->bsdf.material.flags & (BRDF_TRANSMISSION | BRDF_TWOSIDED)) != 0;
}

/* The bits of i, mirrored at the point [van der Corput 1935]. */
static double mirrored_bits(size_t i)
{
    double result = 0.0;
    for (double digit = 0.5; i; i >>= 1, digit *= 0.5) {
        result += (i & 1u) ? digit : 0.0;
    }
    return result;
}

/* Hammersley 1960; the third coordinate is Kronecker's sequence of the golden ratio. */
brdf_vec3 models_even_point(size_t i, size_t count)
{
    float x = (float)(((double)i + 0.5) / (double)count);
    float y = (float)mirrored_bits(i);
    double golden = 0.5 + (double)i * 0.61803398874989485;
    float z = (float)(golden - floor(golden));
    return brdf_vec3_make(brdf_min(x, BRDF_ONE_MINUS_ULP), brdf_min(y, BRDF_ONE_MINUS_ULP),
                          brdf_min(z, BRDF_ONE_MINUS_ULP));
}

static int is_of(const char *description, const struct brdf_model_info *model)
{
    size_t length = strlen(model->name);
    return !strncmp(description, model->name, length) &&
           (description[length] == ':' || !description[length]);
}

static size_t random_count(const struct brdf_model_info *model)
{
    size_t variants = (size_t)brdfcl_check_variant_count(model);
    return variants * ((RANDOM_CASES + variants - 1) / variants);
}

static size_t case_count(const struct brdf_model_info *model)
{
    size_t count = 1 + random_count(model);
    for (size_t i = 0; i < COUNT(more_cases); ++i) {
        count += (size_t)is_of(more_cases[i], model);
    }
    return count;
}

size_t models_case_count(void)
{
    size_t count = 0;
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        count += case_count(brdf_model_info(tag));
    }
    return count;
}

static void add_described(struct model_cases *cases, const char *description)
{
    struct model_case *one = &cases->items[cases->count];
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    if (brdfcl_check_bsdf_create(description, &bsdf, &error)) {
        print_error("%s: %s\n", description, error.message);
        exit(1);
    }
    one->bsdf = *bsdf;
    one->is_made = 1;
    free(bsdf); /* its table lives on in the case */
    snprintf(one->text, sizeof one->text, "%s", description);
    ++cases->count;
}

/* Random parameters; the table, if any, is that of the first case. */
static void add_random(struct model_cases *cases, int variant, struct brdfcl_random *random)
{
    struct model_case *one = &cases->items[cases->count++];
    one->bsdf = cases->items[0].bsdf;
    one->is_made = 0;
    struct brdf_material *material = &one->bsdf.material;
    brdfcl_check_material_vary(material, cases->model, variant);
    brdfcl_check_material_change(material, cases->model, random);
    one->bsdf.parameters = brdf_parameters_load(material->model, material->choices, material->word);
    brdfcl_check_material_describe(material, cases->model, one->text, sizeof one->text);
}

static struct model_cases *cases_create(const struct brdf_model_info *model)
{
    struct model_cases *cases = calloc(1, sizeof *cases);
    assert_non_null(cases);
    cases->model = model;
    cases->items = calloc(case_count(model), sizeof *cases->items);
    assert_non_null(cases->items);
    add_described(cases, model->name);
    for (size_t i = 0; i < COUNT(more_cases); ++i) {
        if (is_of(more_cases[i], model)) {
            add_described(cases, more_cases[i]);
        }
    }
    struct brdfcl_random random = {7};
    int variants = brdfcl_check_variant_count(model);
    for (size_t i = 0; i < random_count(model); ++i) {
        add_random(cases, (int)i % variants, &random);
    }
    return cases;
}

static void cases_destroy(struct model_cases *cases)
{
    for (size_t i = 0; i < cases->count; ++i) {
        if (cases->items[i].is_made) {
            free(cases->items[i].bsdf.table);
            for (int k = 0; k < BRDF_FILES; ++k) {
                free(cases->items[i].bsdf.file[k]);
            }
        }
    }
    free(cases->items);
    free(cases);
}

void models_fail(struct model_cases *cases, const struct model_case *one, const char *format, ...)
{
    if (cases->failures++ >= SHOWN_FAILURES) {
        return;
    }
    char message[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    print_error("%s\n    %s\n", one->text, message);
}

void models_verdict(struct model_cases *cases)
{
    if (cases->failures) {
        fail_msg("%s: %zu failures", cases->model->name, cases->failures);
    }
}

static int reset(void **state)
{
    struct model_cases *cases = *state;
    cases->failures = 0;
    return 0;
}

static int run_model(const struct brdf_model_info *model, const struct model_check *checks,
                     size_t count)
{
    struct model_cases *cases = cases_create(model);
    struct CMUnitTest *tests = calloc(count, sizeof *tests);
    char(*names)[128] = calloc(count, sizeof *names);
    assert_non_null(tests);
    assert_non_null(names);
    size_t used = 0;
    for (size_t i = 0; i < count; ++i) {
        unsigned wanted = checks[i].needs | checks[i].excludes;
        if ((model->flags & wanted) != checks[i].needs) {
            continue;
        }
        snprintf(names[used], sizeof names[used], "%s: %s", model->name, checks[i].name);
        tests[used].name = names[used];
        tests[used].test_func = checks[i].run;
        tests[used].setup_func = reset;
        tests[used].initial_state = cases;
        ++used;
    }
    int failures = used ? _cmocka_run_group_tests(model->name, tests, used, NULL, NULL) : 0;
    free(tests);
    free(names);
    cases_destroy(cases);
    return failures;
}

int models_run(const struct model_check *checks, size_t count)
{
    const char *only = getenv("BRDFCL_TEST_MODEL");
    int failures = 0;
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *model = brdf_model_info(tag);
        if (!only || !strcmp(only, model->name)) {
            failures += run_model(model, checks, count);
        }
    }
    return failures;
}
