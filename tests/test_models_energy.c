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

#include "support_energy.h"
#include "support_models.h"

#define GGX "roughconductor:material=none,distribution=ggx,"
#define BECKMANN "roughconductor:material=none,distribution=beckmann,"
#define PHONG "phong:specular_reflectance=1,diffuse_reflectance=0,"

static const struct energy_known known[] = {
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

static void known_albedos(void **state)
{
    (void)state;
    assert_int_equal(energy_check_known(known, sizeof known / sizeof known[0]), 0);
}

/* 1 - mu ln((1 + mu) / mu), and 2 (1 - ln 2) / (1 + mu): to more digits than the table has. */
static void closed_forms_of_ggx(void **state)
{
    (void)state;
    struct energy_known rows[] = {
        {GGX "masking=correlated,alpha=1", {0.0}, 2e-4, 2e-4},
        {GGX "masking=separable,alpha=1", {0.0}, 2e-4, 2e-4},
    };
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        double mu = energy_cosines[i];
        rows[0].albedo[i] = 1.0 - mu * log((1.0 + mu) / mu);
        rows[1].albedo[i] = 2.0 * (1.0 - log(2.0)) / (1.0 + mu);
    }
    assert_int_equal(energy_check_known(rows, 2), 0);
}

/* Any model, any parameters: light by sampling is light by quadrature. */
static void sampled_albedo_is_integrated_albedo(void **state)
{
    static const double some[] = {0.95, 0.4, -0.6};
    struct model_cases *cases = *state;
    size_t samples = models_long() ? 1 << 20 : 1 << 15;
    size_t unresolved = 0;
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        for (size_t k = 0; k < sizeof some / sizeof some[0]; ++k) {
            brdf_vec3 wo = energy_direction(some[k], 0.3 + (double)i);
            struct lab_finding finding;
            assert_int_equal(lab_try_albedo(&one->bsdf, wo, samples, &finding, NULL), BRDF_OK);
            unresolved += finding.verdict == LAB_OPEN;
            models_expect(cases, one, &finding);
        }
    }
    if (2 * unresolved > 3 * cases->set.count) {
        models_fail(cases, &cases->set.items[0], "too little could be checked");
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
