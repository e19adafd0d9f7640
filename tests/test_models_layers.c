/*
 * test_models_layers.c - conductor, thindielectric, roughdielectric, plastic: what is known of
 * them.
 *
 * Albedos of the rough dielectric (GGX, exact Fresnel, both indices' scaling of radiance undone)
 * are from a quadrature over slopes made apart from this project's code, converged to 1e-5.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_bsdf.h"
#include "support_models.h"

enum { COSINES = 5 };

static const double cosines[COSINES] = {0.1, 0.25, 0.5, 0.75, 1.0};

static brdf_vec3 direction_at(double cosine)
{
    double radius = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    return brdf_vec3_make((float)(0.6 * radius), (float)(0.8 * radius), (float)cosine);
}

/* What is sent to wo of light from everywhere, by sampling: to wo's side, and through. */
struct albedo {
    double reflected;
    double passed; /* with the scaling of radiance undone */
};

static struct albedo albedo_of(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    size_t count = models_long() ? 1 << 21 : 1 << 16;
    struct albedo sum = {0.0, 0.0};
    for (size_t i = 0; i < count; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, count));
        double weight = (double)s.weight.g / (double)count;
        if ((s.wi.z > 0.0f) == (wo.z > 0.0f)) {
            sum.reflected += weight;
        } else {
            sum.passed += weight * (double)(s.eta * s.eta);
        }
    }
    return sum;
}

struct known {
    const char *description;
    int outside; /* 0: seen from below */
    double reflected[COSINES];
    double both[COSINES];
};

#define ROUGH "roughdielectric:distribution=ggx,int_ior=1.5,ext_ior=1,"

static const struct known known[] = {
    {ROUGH "masking=correlated,alpha=0.1",
     1,
     {.31161, .20170, .08588, .04727, .03964},
     {.92231, .96557, .99225, .99727, .99884}},
    {ROUGH "masking=correlated,alpha=0.25",
     1,
     {.17184, .11876, .06690, .04369, .03705},
     {.91609, .92170, .96077, .98241, .99204}},
    {ROUGH "masking=correlated,alpha=0.5",
     1,
     {.09962, .06969, .04394, .03247, .02817},
     {.85255, .84523, .89263, .93829, .96811}},
    {ROUGH "masking=correlated,alpha=1",
     1,
     {.05847, .03841, .02339, .01645, .01270},
     {.74091, .70134, .74184, .81624, .89334}},
    {ROUGH "masking=separable,alpha=0.1",
     1,
     {.30586, .20128, .08587, .04727, .03964},
     {.91572, .96506, .99222, .99727, .99884}},
    {ROUGH "masking=separable,alpha=0.25",
     1,
     {.15886, .11597, .06664, .04367, .03705},
     {.87800, .91429, .95997, .98233, .99204}},
    {ROUGH "masking=separable,alpha=0.5",
     1,
     {.08352, .06407, .04285, .03228, .02817},
     {.70370, .79242, .88262, .93688, .96811}},
    {ROUGH "masking=separable,alpha=1",
     1,
     {.03939, .03017, .02092, .01577, .01270},
     {.40042, .51446, .67233, .79906, .89334}},
    {ROUGH "masking=correlated,alpha=0.1",
     0,
     {.85729, .90331, .94034, .54807, .04254},
     {.86336, .91323, .96339, .97264, .98896}},
    {ROUGH "masking=correlated,alpha=0.25",
     0,
     {.79146, .75087, .72430, .43317, .04792},
     {.81075, .79375, .82708, .87489, .92922}},
    {ROUGH "masking=correlated,alpha=0.5",
     0,
     {.64868, .55663, .43448, .26043, .04616},
     {.68900, .65785, .65975, .69455, .75387}},
    {ROUGH "masking=correlated,alpha=1",
     0,
     {.43070, .30479, .18012, .09789, .02573},
     {.51061, .49522, .51278, .48403, .41706}},
    {ROUGH "masking=separable,alpha=0.1",
     0,
     {.84671, .90201, .94025, .54807, .04254},
     {.85251, .91189, .96328, .97261, .98896}},
    {ROUGH "masking=separable,alpha=0.25",
     0,
     {.75741, .74004, .72228, .43287, .04792},
     {.77219, .78106, .82437, .87425, .92922}},
    {ROUGH "masking=separable,alpha=0.5",
     0,
     {.58259, .52586, .42509, .25823, .04616},
     {.60397, .61049, .64271, .69029, .75387}},
    {ROUGH "masking=separable,alpha=1",
     0,
     {.31684, .24726, .15977, .09227, .02573},
     {.34238, .36639, .45339, .46923, .41706}},
};

static void rough_dielectric_sends_what_is_known(void **state)
{
    (void)state;
    int failures = 0;
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(known[k].description);
        for (int i = 0; i < COSINES; ++i) {
            brdf_vec3 wo = direction_at(known[k].outside ? cosines[i] : -cosines[i]);
            struct albedo found = albedo_of(bsdf, wo);
            double both = found.reflected + found.passed;
            if (!(fabs(found.reflected - known[k].reflected[i]) <= 1e-3) ||
                !(fabs(both - known[k].both[i]) <= 1e-3)) {
                print_error("%s, cos %g: R = %.5f (known %.5f), R + T = %.5f (known %.5f)\n",
                            known[k].description, (double)wo.z, found.reflected,
                            known[k].reflected[i], both, known[k].both[i]);
                ++failures;
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* Of diffuse light as much passes one way as the other, for the same radiance. */
static void rough_dielectric_passes_as_much_both_ways(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make(ROUGH "masking=correlated,alpha=0.5");
    double passed[2] = {0.0, 0.0};
    int count = 24;
    for (int i = 0; i < count; ++i) {
        double cosine = (i + 0.5) / count;
        passed[0] += 2.0 * cosine * albedo_of(bsdf, direction_at(cosine)).passed / count;
        passed[1] += 2.0 * cosine * albedo_of(bsdf, direction_at(-cosine)).passed / count;
    }
    if (!(fabs(passed[0] - 2.25 * passed[1]) <= 2e-3)) {
        fail_msg("%.5f from above, %.5f from below, times 2.25 %.5f", passed[0], passed[1],
                 2.25 * passed[1]);
    }
    brdf_bsdf_destroy(bsdf);
}

/* A base of albedo 1 reflects everything, whatever the index and however its colours shift. */
static void white_plastic_loses_nothing(void **state)
{
    (void)state;
    static const char *const descriptions[] = {
        "plastic:diffuse_reflectance=1,nonlinear=true,ext_ior=1,int_ior=1.33",
        "plastic:diffuse_reflectance=1,nonlinear=true,ext_ior=1,int_ior=1.5",
        "plastic:diffuse_reflectance=1,nonlinear=false,ext_ior=1,int_ior=1.5",
        "plastic:diffuse_reflectance=1,nonlinear=true,ext_ior=1,int_ior=2.419",
        "plastic:diffuse_reflectance=1,nonlinear=true,ext_ior=1.33,int_ior=1.31",
        "plastic:diffuse_reflectance=1,nonlinear=true,ext_ior=1,int_ior=10",
    };
    for (size_t k = 0; k < sizeof descriptions / sizeof descriptions[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(descriptions[k]);
        for (int i = 1; i <= 40; ++i) {
            double cosine = i == 1 ? 1e-3 : i / 40.0;
            double all = albedo_of(bsdf, direction_at(cosine)).reflected;
            if (!(fabs(all - 1.0) <= 5e-4)) {
                fail_msg("%s reflects %.6f at cos = %g", descriptions[k], all, cosine);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* F + (1 - F) rho (1 - K) / (1 - rho K), and with K in the place of rho K. */
static void grey_plastic_is_the_series(void **state)
{
    (void)state;
    const double eta = 1.5;
    const double k = .596346;
    const double rho = 0.5;
    for (int shift = 0; shift < 2; ++shift) {
        struct brdf_bsdf *bsdf = bsdf_make(shift ? "plastic:ext_ior=1,int_ior=1.5,nonlinear=true"
                                                 : "plastic:ext_ior=1,int_ior=1.5,nonlinear=false");
        for (int i = 0; i < COSINES; ++i) {
            double f = (double)brdf_fresnel_dielectric((float)cosines[i], (float)eta).reflectance;
            double base = shift ? rho * (1.0 - k) / (1.0 - rho * k) : rho;
            double all = albedo_of(bsdf, direction_at(cosines[i])).reflected;
            if (!(fabs(all - (f + (1.0 - f) * base)) <= 5e-4)) {
                fail_msg("nonlinear %d, cos = %g: %.6f, should be %.6f", shift, cosines[i], all,
                         f + (1.0 - f) * base);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* Between the interfaces light goes to and fro: the series, added up term by term. */
static void pane_is_the_series(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("thindielectric:int_ior=1.5,ext_ior=1");
    for (int i = 0; i < COSINES; ++i) {
        double f = (double)brdf_fresnel_dielectric((float)cosines[i], 1.5f).reflectance;
        double inside = (1.0 - f);
        double reflected = f;
        double passed = 0.0;
        for (int bounce = 0; bounce < 200; ++bounce) {
            (bounce % 2 ? (reflected += inside * (1.0 - f)) : (passed += inside * (1.0 - f)));
            inside *= f;
        }
        for (int side = -1; side <= 1; side += 2) {
            struct albedo found = albedo_of(bsdf, direction_at(side * cosines[i]));
            if (!(fabs(found.reflected - reflected) <= 1e-4) ||
                !(fabs(found.passed - passed) <= 1e-4)) {
                fail_msg("cos = %g: R = %.6f, should be %.6f; T = %.6f, should be %.6f",
                         side * cosines[i], found.reflected, reflected, found.passed, passed);
            }
        }
    }
    brdf_bsdf_destroy(bsdf);
}

/* At normal incidence a metal reflects ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2). */
static void mirror_reflects_as_its_metal(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("conductor:eta=0.2/1.5/2.9,k=3.9/0/3.1");
    struct brdf_sample s = brdf_sample(bsdf, direction_at(1.0), brdf_vec3_make(0.5f, 0.5f, 0.5f));
    assert_true(s.delta && s.pdf == 1.0f && s.wi.z == 1.0f);
    assert_true(fabs((double)s.weight.r - (0.64 + 15.21) / (1.44 + 15.21)) < 1e-6);
    assert_true(fabs((double)s.weight.g - 0.04) < 1e-6);
    assert_true(fabs((double)s.weight.b - (3.61 + 9.61) / (15.21 + 9.61)) < 1e-6);
    s = brdf_sample(bsdf, direction_at(-1.0), brdf_vec3_make(0.5f, 0.5f, 0.5f));
    assert_true(s.pdf == 0.0f);
    brdf_bsdf_destroy(bsdf);
}

/* Without a difference of indices there is nothing to see: straight on, and all of it. */
static void no_interface_without_a_difference(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("roughdielectric:int_ior=1.33,ext_ior=1.33,alpha=0.4");
    brdf_vec3 wo = direction_at(0.3);
    struct brdf_sample s = brdf_sample(bsdf, wo, brdf_vec3_make(0.2f, 0.9f, 0.01f));
    assert_true(s.delta && s.pdf == 1.0f && s.eta == 1.0f && s.weight.g == 1.0f);
    assert_true(s.wi.x == -wo.x && s.wi.y == -wo.y && s.wi.z == -wo.z);
    assert_true(brdf_pdf(bsdf, wo, s.wi) == 0.0f);
    brdf_bsdf_destroy(bsdf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirror_reflects_as_its_metal),
        cmocka_unit_test(pane_is_the_series),
        cmocka_unit_test(rough_dielectric_sends_what_is_known),
        cmocka_unit_test(rough_dielectric_passes_as_much_both_ways),
        cmocka_unit_test(no_interface_without_a_difference),
        cmocka_unit_test(white_plastic_loses_nothing),
        cmocka_unit_test(grey_plastic_is_the_series),
    };
    return cmocka_run_group_tests_name("layers", tests, NULL, NULL);
}
