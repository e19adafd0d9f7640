/*
 * test_models_energy.c - how much light the models reflect: against known values, and by sampling
 * against by quadrature.
 *
 * Known albedos of single scattering are from quadratures made apart from this project's code, to
 * about 1e-4; those of GGX with alpha = 1 are closed forms that follow from Heitz 2014, eq. 72, 98
 * and 99.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_models.h"
#include "support_sphere.h"

enum { COSINES = 5, PILOT = 8192 };

static const double cosines[COSINES] = {0.1, 0.25, 0.5, 0.75, 1.0};

struct known {
    const char *description;
    double albedo[COSINES]; /* of the cosines above */
    double tolerance;
    double tolerance_grazing; /* of the first cosine */
};

#define GGX "roughconductor:material=none,distribution=ggx,"
#define BECKMANN "roughconductor:material=none,distribution=beckmann,"
#define PHONG "phong:specular_reflectance=1,diffuse_reflectance=0,"

static const struct known known[] = {
    {GGX "masking=correlated,alpha=0.1", {.88345, .92162, .96920, .98314, .98831}, 1e-3, 5e-3},
    {GGX "masking=correlated,alpha=0.25", {.89162, .84008, .85726, .89153, .91581}, 1e-3, 1e-3},
    {GGX "masking=correlated,alpha=0.5", {.86010, .76520, .69825, .68208, .68785}, 1e-3, 1e-3},
    {GGX "masking=correlated,alpha=1", {.76021, .59764, .45069, .36453, .30685}, 1e-3, 1e-3},
    {GGX "masking=separable,alpha=0.1", {.87275, .92031, .96911, .98314, .98831}, 1e-3, 5e-3},
    {GGX "masking=separable,alpha=0.25", {.85430, .82851, .85510, .89116, .91581}, 1e-3, 1e-3},
    {GGX "masking=separable,alpha=0.5", {.77228, .72555, .68601, .67873, .68785}, 1e-3, 1e-3},
    {GGX "masking=separable,alpha=1", {.55791, .49096, .40914, .35069, .30685}, 1e-3, 1e-3},
    {BECKMANN "masking=correlated,alpha=0.1", {.91291, .97200, .99985, 1., 1.}, 1e-3, 5e-3},
    {BECKMANN "masking=correlated,alpha=0.25",
     {.93512, .90516, .94655, .99073, .99999},
     1e-3,
     1e-3},
    {BECKMANN "masking=correlated,alpha=0.5", {.95503, .90742, .86936, .88012, .94300}, 1e-3, 1e-3},
    {BECKMANN "masking=correlated,alpha=1", {.95280, .88483, .76657, .62406, .46159}, 1e-3, 1e-3},
    {BECKMANN "masking=separable,alpha=0.1", {.91233, .97200, .99985, 1., 1.}, 1e-3, 5e-3},
    {BECKMANN "masking=separable,alpha=0.25", {.92753, .90461, .94655, .99073, .99999}, 1e-3, 1e-3},
    {BECKMANN "masking=separable,alpha=0.5", {.93609, .90177, .86894, .88012, .94300}, 1e-3, 1e-3},
    {BECKMANN "masking=separable,alpha=1", {.90193, .85493, .75630, .62284, .46159}, 1e-3, 1e-3},
    {PHONG "exponent=10", {.17916, .28496, .50474, .75011, 1.}, 1e-3, 1e-3},
    {PHONG "exponent=50", {.11963, .25195, .50000, .75000, 1.}, 1e-3, 1e-3},
    {"diffuse:reflectance=1", {1., 1., 1., 1., 1.}, 1e-5, 1e-5},
    {"diffuse:reflectance=0.3", {.3, .3, .3, .3, .3}, 1e-5, 1e-5},
    {"phong:specular_reflectance=0,diffuse_reflectance=0.7", {.7, .7, .7, .7, .7}, 1e-5, 1e-5},
};

struct view {
    const struct brdf_bsdf *bsdf;
    brdf_vec3 wo;
};

static double mean(brdf_rgb c)
{
    return ((double)c.r + (double)c.g + (double)c.b) / 3.0;
}

static double f_cos(brdf_vec3 wi, void *data)
{
    const struct view *view = data;
    return mean(brdf_eval(view->bsdf, view->wo, wi)) * fabs((double)wi.z);
}

/*
 * The mean weight of samples that are no deltas: what the integral of f |cos| must be. Samples of
 * weight up to 1 are many and even; `error` is what the rare ones above it (into a thinner medium)
 * leave uncertain.
 */
static double albedo_by_sampling(const struct view *view, double *error)
{
    size_t count = models_long() ? 1 << 20 : 1 << 15;
    double sum = 0.0;
    double heavy = 0.0;
    for (size_t i = 0; i < count; ++i) {
        struct brdf_sample s = brdf_sample(view->bsdf, view->wo, models_even_point(i, count));
        double weight = s.delta ? 0.0 : mean(s.weight);
        sum += weight;
        heavy += pow(fmax(weight - 1.0, 0.0), 2.0);
    }
    *error = sqrt(heavy) / (double)count;
    return sum / (double)count;
}

static struct sphere_sum albedo_by_quadrature(struct view *view)
{
    brdf_vec3 *pilot = calloc(PILOT, sizeof *pilot);
    assert_non_null(pilot);
    size_t count = 0;
    for (size_t i = 0; i < PILOT; ++i) {
        struct brdf_sample s = brdf_sample(view->bsdf, view->wo, models_even_point(i, PILOT));
        if (s.pdf > 0.0f && !s.delta) {
            pilot[count++] = s.wi;
        }
    }
    struct sphere *sphere = sphere_create(pilot, count);
    struct sphere_sum sum = sphere_integrate(sphere, f_cos, view, 1e-4, 1e-3);
    sphere_destroy(sphere);
    free(pilot);
    return sum;
}

static brdf_vec3 direction_of(double cosine, double phi)
{
    double radius = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    return brdf_normalize(
        brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cosine));
}

/* One row of the table, both ways; returns the number of failures. */
static int check_known(const struct known *row)
{
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    if (brdf_bsdf_create(row->description, &bsdf, &error)) {
        print_error("%s\n", error.message);
        return 1;
    }
    int failures = 0;
    for (int i = 0; i < COSINES; ++i) {
        struct view view = {bsdf, direction_of(cosines[i], 0.7)};
        double tolerance = i == 0 ? row->tolerance_grazing : row->tolerance;
        double uncertain;
        double sampled = albedo_by_sampling(&view, &uncertain);
        struct sphere_sum integral = albedo_by_quadrature(&view);
        if (!(fabs(sampled - row->albedo[i]) <= tolerance) ||
            !(fabs(integral.value - row->albedo[i]) <= tolerance)) {
            print_error("%s at cos = %.2f: %.5f by sampling, %.5f by quadrature, known %.5f\n",
                        row->description, cosines[i], sampled, integral.value, row->albedo[i]);
            ++failures;
        }
    }
    brdf_bsdf_destroy(bsdf);
    return failures;
}

static void known_albedos(void **state)
{
    (void)state;
    int failures = 0;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        failures += check_known(&known[i]);
    }
    assert_int_equal(failures, 0);
}

/* 1 - mu ln((1 + mu) / mu), and 2 (1 - ln 2) / (1 + mu): to more digits than the table has. */
static void closed_forms_of_ggx(void **state)
{
    (void)state;
    struct known correlated = {GGX "masking=correlated,alpha=1", {0.0}, 2e-4, 2e-4};
    struct known separable = {GGX "masking=separable,alpha=1", {0.0}, 2e-4, 2e-4};
    for (int i = 0; i < COSINES; ++i) {
        double mu = cosines[i];
        correlated.albedo[i] = 1.0 - mu * log((1.0 + mu) / mu);
        separable.albedo[i] = 2.0 * (1.0 - log(2.0)) / (1.0 + mu);
    }
    assert_int_equal(check_known(&correlated) + check_known(&separable), 0);
}

/* Any model, any parameters: light by sampling is light by quadrature. */
static void sampled_albedo_is_integrated_albedo(void **state)
{
    static const double some[] = {0.95, 0.4, -0.6};
    struct model_cases *cases = *state;
    size_t unresolved = 0;
    for (size_t i = 0; i < cases->count; ++i) {
        const struct model_case *one = &cases->items[i];
        for (size_t k = 0; k < sizeof some / sizeof some[0]; ++k) {
            struct view view = {&one->bsdf, direction_of(some[k], 0.3 + (double)i)};
            double uncertain;
            double sampled = albedo_by_sampling(&view, &uncertain);
            double allowed = 1e-3 + 3.0 * uncertain;
            struct sphere_sum integral = albedo_by_quadrature(&view);
            if (integral.error > 5e-4) {
                ++unresolved;
            } else if (!(fabs(sampled - integral.value) <= allowed + 2e-3 * integral.value)) {
                models_fail(cases, one, "cos = %.2f: %.5f by sampling, %.5f by quadrature", some[k],
                            sampled, integral.value);
            }
        }
    }
    if (2 * unresolved > 3 * cases->count) {
        models_fail(cases, &cases->items[0], "too little could be checked");
    }
    models_verdict(cases);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_albedos),
        cmocka_unit_test(closed_forms_of_ggx),
    };
    const struct model_check checks[] = {
        {"sampled albedo is integrated albedo", sampled_albedo_is_integrated_albedo, 0, BRDF_DELTA},
    };
    int failures = cmocka_run_group_tests_name("known albedos", tests, NULL, NULL);
    return failures + models_run(checks, sizeof checks / sizeof checks[0]);
}
