/*
 * test_models_lobes.c - the classic glossy models: known albedos, and what their sample weights
 * stay below.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

#define LOBE ",specular_reflectance=1,diffuse_reflectance=0"
#define BALANCED "ward:variant=balanced" LOBE ",alpha="
#define WARD "ward:variant=ward" LOBE ",alpha="
#define DUER "ward:variant=ward-duer" LOBE ",alpha="
#define BLINNPHONG "blinnphong:normalisation=energy" LOBE ",exponent="
#define BLINN "torrancesparrow:material=none,distribution=blinn,exponent="
#define BECKMANN "torrancesparrow:material=none,distribution=beckmann,alpha="
#define COOK "cooktorrance:material=none,denominator=four" LOBE ",alpha="
#define SHIRLEY "ashikhminshirley:specular_reflectance=0.25,exponent=20,diffuse_reflectance="

/*
 * By quadratures made apart from this project's code, to about 1e-4; worse only near the horizon
 * for the narrowest lobes.
 */
static const struct energy_known known[] = {
    {BLINNPHONG "10", {.14061, .21874, .40033, .65683, 1.}, 1e-3, 1e-3},
    {BLINNPHONG "50", {.04216, .10000, .28065, .58004, 1.}, 1e-3, 1e-3},
    {WARD "0.1", {.12764, .25134, .48899, .72966, .97105}, 1e-3, 1e-3},
    {WARD "0.2", {.18449, .26320, .45885, .67563, .89492}, 1e-3, 1e-3},
    {DUER "0.1", {.95856, .96653, .98055, .98058, .98058}, 1e-3, 5e-3},
    {DUER "0.3", {1.16087, .84231, .82402, .84951, .85632}, 1e-3, 1e-3},
    {DUER "0.5", {1.21389, .75492, .65718, .66663, .69474}, 1e-3, 1e-3},
    {BALANCED "0.1", {.81883, .91322, .97396, .98599, .99000}, 1e-3, 1e-3},
    {BALANCED "0.2", {.80092, .81841, .89758, .94249, .96000}, 1e-3, 1e-3},
    {BALANCED "0.5", {.81321, .73730, .70826, .72058, .75458}, 1e-3, 1e-3},
    {BALANCED "1", {.80294, .66898, .53965, .44856, .36788}, 1e-3, 1e-3},
    {BLINN "10", {.97154, .93375, .89744, .89920, .92819}, 1e-3, 1e-3},
    {BLINN "50", {.95439, .92813, .96608, .99441, .99995}, 1e-3, 1e-3},
    {BLINN "200", {.93426, .96733, .99902, 1., 1.}, 1e-3, 5e-3},
    {BECKMANN "0.25", {.96148, .92649, .94298, .98260, .99938}, 1e-3, 1e-3},
    {COOK "0.1", {.93420, .96717, .99907, 1., 1.}, 1e-3, 5e-3},
    {COOK "0.25", {.96148, .92649, .94298, .98260, .99938}, 1e-3, 1e-3},
    {COOK "0.5", {.97387, .93645, .88688, .86867, .89242}, 1e-3, 1e-3},
    {COOK "1", {.96496, .90969, .79172, .60766, .45345}, 1e-3, 1e-3},
};

static void known_albedos(void **state)
{
    (void)state;
    assert_int_equal(energy_check_known(known, sizeof known / sizeof known[0]), 0);
}

/* The albedo at one cosine, both ways. */
static void expect_albedo(const char *description, double cosine, double expected, double tolerance)
{
    struct brdf_bsdf *bsdf = bsdf_make(description);
    brdf_vec3 wo = energy_direction(cosine, 1.9);
    double sampled = energy_by_sampling(bsdf, wo).value;
    double integral = energy_by_quadrature(bsdf, wo).value;
    if (!(fabs(sampled - expected) <= tolerance && fabs(integral - expected) <= tolerance)) {
        fail_msg("%s at cos = %g: %.6f by sampling, %.6f by quadrature, expected %.6f", description,
                 cosine, sampled, integral, expected);
    }
    brdf_bsdf_destroy(bsdf);
}

/* Seen along the normal: 1 - alpha^2 + alpha^2 exp(-1 / alpha^2), from the weight 2 cos(wi) /
 * (1 + cos(wi)). */
static void closed_form_of_ward(void **state)
{
    (void)state;
    static const double alphas[] = {0.03, 0.3, 0.7, 1.0, 2.0};
    for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; ++i) {
        char text[128];
        double a2 = alphas[i] * alphas[i];
        snprintf(text, sizeof text, BALANCED "%g", alphas[i]);
        expect_albedo(text, 1.0, 1.0 - a2 + a2 * exp(-1.0 / a2), 2e-4);
    }
}

/* Seen along the normal: 1 for `energy`, by its definition, and for the other the ratio of both. */
static void closed_forms_of_blinnphong(void **state)
{
    (void)state;
    static const double exponents[] = {0.0, 1.0, 7.0, 300.0, 20000.0};
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; ++i) {
        char text[128];
        double n = exponents[i];
        snprintf(text, sizeof text, BLINNPHONG "%g", n);
        expect_albedo(text, 1.0, 1.0, 3e-4);
        snprintf(text, sizeof text, "blinnphong:normalisation=distribution" LOBE ",exponent=%g", n);
        expect_albedo(text, 1.0, 4.0 * (exp2(-0.5 * n) + n) / (n + 4.0), 1e-3);
    }
}

/*
 * The base adds R_d (1 - R_s) (1 - (1 - cos / 2)^5). The lobe alone, with F = 1 and seen along the
 * normal, reflects the mean of cos(wi) = 2 cos^2(h) - 1 where that is positive, and cos(h) has the
 * density (n + 1) cos^n(h).
 */
static void closed_forms_of_ashikhminshirley(void **state)
{
    (void)state;
    struct brdf_bsdf *lobe = bsdf_make(SHIRLEY "0");
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        double base = 0.8 * 0.75 * (1.0 - pow(1.0 - 0.5 * energy_cosines[i], 5.0));
        double rest = energy_by_quadrature(lobe, energy_direction(energy_cosines[i], 0.2)).value;
        expect_albedo(SHIRLEY "0.8", energy_cosines[i], base + rest, 5e-4);
    }
    brdf_bsdf_destroy(lobe);
    static const double exponents[] = {0.0, 1.0, 10.0, 500.0};
    for (size_t i = 0; i < sizeof exponents / sizeof exponents[0]; ++i) {
        char text[128];
        double n = exponents[i];
        snprintf(text, sizeof text, "ashikhminshirley:specular_reflectance=1,exponent=%g", n);
        double whole = 1.0 - exp2(-0.5 * (n + 1.0));
        double square = (n + 1.0) / (n + 3.0) * (1.0 - exp2(-0.5 * (n + 3.0)));
        expect_albedo(text, 1.0, 2.0 * square - whole, 3e-4);
    }
}

/* Weights of lobes alone, anywhere: visible normals give at most F, Ward's balanced form 2. */
static const struct {
    const char *description;
    double bound;
} bounds[] = {
    {BALANCED "0.001", 2.0},
    {BALANCED "0.3", 2.0},
    {BALANCED "2", 2.0},
    {"ashikhminshirley:specular_reflectance=1,exponent_u=3,exponent_v=2000", 1.0},
    {BLINN "0", 1.0},
    {BLINN "3000", 1.0},
    {BECKMANN "0.001", 1.0},
    {BECKMANN "2", 1.0},
    {COOK "0.5", 1.0},
};

static void weights_are_bounded(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof bounds / sizeof bounds[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(bounds[k].description);
        struct brdfcl_random random = {22};
        for (int n = 0; n < 200000; ++n) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            double weight = (double)brdf_sample(bsdf, in.wo, in.u).weight.g;
            if (!(weight <= bounds[k].bound * (1.0 + 1e-6))) {
                fail_msg("%s: weight %.9g > %g; wo %.9g/%.9g/%.9g u %.9g/%.9g/%.9g",
                         bounds[k].description, weight, bounds[k].bound, (double)in.wo.x,
                         (double)in.wo.y, (double)in.wo.z, (double)in.u.x, (double)in.u.y,
                         (double)in.u.z);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_albedos),
        cmocka_unit_test(closed_form_of_ward),
        cmocka_unit_test(closed_forms_of_blinnphong),
        cmocka_unit_test(closed_forms_of_ashikhminshirley),
        cmocka_unit_test(weights_are_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
