/*
 * test_models_conductor.c - roughconductor's distributions, maskings and Fresnel, each against its
 * formula or against known albedos.
 *
 * Albedos of V-cavities are from quadratures made apart from this project's code, to about 1e-4.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/facets.h>

#include "angle.h"
#include "random_vectors.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

#define MIRRORS "roughconductor:material=none,masking=vcavity,"

enum { PAIRS = 2000 };

static const struct {
    const char *description;
    double albedo[ENERGY_COSINES];
} known[] = {
    {MIRRORS "distribution=ggx,alpha=0.1", {.94496, .95513, .97534, .98068, .98261}},
    {MIRRORS "distribution=ggx,alpha=0.25", {.96028, .92359, .90669, .90102, .90114}},
    {MIRRORS "distribution=ggx,alpha=0.5", {.95966, .90158, .81473, .73929, .69924}},
    {MIRRORS "distribution=ggx,alpha=1", {.93105, .82734, .65306, .48435, .37500}},
    {MIRRORS "distribution=beckmann,alpha=0.1", {.93420, .96717, .99907, 1., 1.}},
    {MIRRORS "distribution=beckmann,alpha=0.5", {.97387, .93645, .88688, .86867, .89242}},
    {MIRRORS "distribution=beckmann,alpha=1", {.96496, .90969, .79172, .60766, .45345}},
    /* exponents 10, 50 and 200 */
    {MIRRORS "distribution=blinn,alpha=0.408248290", {.97154, .93375, .89744, .89920, .92819}},
    {MIRRORS "distribution=blinn,alpha=0.196116135", {.95439, .92813, .96608, .99441, .99995}},
    {MIRRORS "distribution=blinn,alpha=0.0995037190", {.93426, .96733, .99902, 1., 1.}},
};

/* By sampling alone: that it agrees with the integral of f is checked for every model. */
static void known_albedos(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        struct brdf_bsdf *bsdf = bsdf_make(known[i].description);
        for (int k = 0; k < ENERGY_COSINES; ++k) {
            brdf_vec3 wo = energy_direction(energy_cosines[k], 0.7);
            double albedo = energy_by_sampling(bsdf, wo).value;
            if (!(fabs(albedo - known[i].albedo[k]) <= 1e-3)) {
                fail_msg("%s at cos = %.2f: %.5f, known %.5f", known[i].description,
                         energy_cosines[k], albedo, known[i].albedo[k]);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* For pairs of directions, what f of one bsdf is over f of another. */
static void ratio_of_f(const char *over, const char *under, double (*ratio)(brdf_vec3, brdf_vec3),
                       double tolerance)
{
    struct brdf_bsdf *a = bsdf_make(over);
    struct brdf_bsdf *b = bsdf_make(under);
    struct brdfcl_random random = {3};
    int compared = 0;
    for (int i = 0; i < PAIRS; ++i) {
        brdf_vec3 wo = random_above(&random);
        brdf_vec3 wi = random_above(&random);
        double f = (double)brdf_eval(a, wo, wi).g;
        double g = (double)brdf_eval(b, wo, wi).g;
        double expected = ratio(wo, wi);
        if (g > 1e-12) {
            ++compared;
            if (!(fabs(f / g - expected) <= tolerance * expected)) {
                fail_msg("%s: ratio %.7g, expected %.7g", over, f / g, expected);
            }
        }
    }
    assert_true(compared > PAIRS / 2);
    brdf_bsdf_destroy(a);
    brdf_bsdf_destroy(b);
}

static double one(brdf_vec3 wo, brdf_vec3 wi)
{
    (void)wo;
    (void)wi;
    return 1.0;
}

/* F0 + (1 - F0) (1 - cos)^5 with F0 of eta = 0.2, k = 3. */
static double schlick(brdf_vec3 wo, brdf_vec3 wi)
{
    double normal = (0.8 * 0.8 + 9.0) / (1.2 * 1.2 + 9.0);
    double cosine = sqrt(0.5 * (1.0 + (double)brdf_dot(wo, wi)));
    return normal + (1.0 - normal) * pow(1.0 - cosine, 5.0);
}

static void schlick_is_schlick(void **state)
{
    (void)state;
    ratio_of_f("roughconductor:distribution=ggx,alpha=0.7,fresnel=schlick,eta=0.2,k=3",
               "roughconductor:distribution=ggx,alpha=0.7,material=none", schlick, 1e-4);
}

#define ALPHA 0.6

static double tangent(brdf_vec3 w)
{
    return hypot((double)w.x, (double)w.y) / (double)w.z;
}

/* As the lecture has both forms of G1. */
static double rational_over_exact(brdf_vec3 w)
{
    double s = 1.0 / (ALPHA * tangent(w));
    double rational =
        s < 1.6 ? (3.535 * s + 2.181 * s * s) / (1.0 + 2.276 * s + 2.577 * s * s) : 1.0;
    double exact = 2.0 / (1.0 + erf(s) + exp(-s * s) / (s * sqrt(pi)));
    return fmin(rational, 1.0) / exact;
}

static double rational_over_exact_of_both(brdf_vec3 wo, brdf_vec3 wi)
{
    return rational_over_exact(wo) * rational_over_exact(wi);
}

static void rational_masking_is_that_of_the_lecture(void **state)
{
    (void)state;
    ratio_of_f("roughconductor:masking=rational,alpha=0.6,material=none",
               "roughconductor:masking=separable,alpha=0.6,material=none",
               rational_over_exact_of_both, 2e-5);
}

/* One model by two ways: the exponent 18 is alpha = sqrt(0.1). */
static void blinn_in_grooves_is_torrancesparrow(void **state)
{
    (void)state;
    ratio_of_f("roughconductor:distribution=blinn,masking=vcavity,alpha=0.316227766,material=Al",
               "torrancesparrow:distribution=blinn,exponent=18,material=Al", one, 1e-4);
}

static void sampling_does_not_change_f(void **state)
{
    (void)state;
    ratio_of_f("roughconductor:alpha_u=0.3,alpha_v=0.7,sample_visible=false",
               "roughconductor:alpha_u=0.3,alpha_v=0.7,sample_visible=true", one, 0.0);
}

/* The integral of D cos over the hemisphere, whose cosines go by the square of a number. */
static double projected_area(int distribution, float alpha_u, float alpha_v)
{
    enum { RINGS = 2000, SPOKES = 64 };
    double sum = 0.0;
    for (int i = 0; i < RINGS; ++i) {
        double v = (i + 0.5) / RINGS;
        double z = v * v;
        double radius = sqrt(1.0 - z * z);
        for (int k = 0; k < SPOKES; ++k) {
            double phi = 2.0 * pi * (k + 0.5) / SPOKES;
            brdf_vec3 h =
                brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)z);
            double d = (double)brdf_microfacet_d(distribution, h, alpha_u, alpha_v);
            sum += d * z * 2.0 * v;
        }
    }
    return sum * 2.0 * pi / ((double)RINGS * SPOKES);
}

static void normals_cover_the_surface_once(void **state)
{
    (void)state;
    static const float alphas[][2] = {{0.3f, 0.3f}, {0.2f, 0.9f}, {1.0f, 1.0f}, {1.5f, 0.6f}};
    for (int distribution = BRDF_BECKMANN; distribution <= BRDF_BLINN; ++distribution) {
        for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; ++i) {
            double area = projected_area(distribution, alphas[i][0], alphas[i][1]);
            if (!(fabs(area - 1.0) < 1e-3)) {
                fail_msg("distribution %d, alpha %g and %g: %.5f", distribution,
                         (double)alphas[i][0], (double)alphas[i][1], area);
            }
        }
    }
}

static void refused(const char *description, const char *reason)
{
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    assert_int_equal(brdf_bsdf_create(description, &bsdf, &error), BRDF_BAD_ARGUMENT);
    assert_null(bsdf);
    assert_non_null(strstr(error.message, reason));
}

static void combinations_that_do_not_exist_are_refused(void **state)
{
    (void)state;
    refused("roughconductor:distribution=ggx,masking=rational", "Beckmann");
    refused("roughconductor:distribution=blinn", "closed form");
    refused("roughconductor:distribution=blinn,masking=separable", "take rational");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_albedos),
        cmocka_unit_test(schlick_is_schlick),
        cmocka_unit_test(rational_masking_is_that_of_the_lecture),
        cmocka_unit_test(blinn_in_grooves_is_torrancesparrow),
        cmocka_unit_test(sampling_does_not_change_f),
        cmocka_unit_test(normals_cover_the_surface_once),
        cmocka_unit_test(combinations_that_do_not_exist_are_refused),
    };
    return cmocka_run_group_tests_name("rough conductors", tests, NULL, NULL);
}
