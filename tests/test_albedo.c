/*
 * test_albedo.c - albedos by direction and averaged, against closed forms.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "albedo.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_matte.h"

static void assert_all(const double found[3], double known, double tolerance)
{
    for (int channel = 0; channel < 3; ++channel) {
        if (!(fabs(found[channel] - known) <= tolerance)) {
            fail_msg("%.6f is not %.6f", found[channel], known);
        }
    }
}

/* Every sample of a Lambertian surface weighs its reflectance. */
static void diffuse_is_its_reflectance(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("diffuse:reflectance=0.2/0.4/0.6");
    struct lab_albedo at = lab_albedo_at(bsdf, energy_direction(0.3, 1.0), 1000);
    struct lab_albedo average = lab_albedo_average(bsdf, 0, 1000);
    struct lab_albedo below = lab_albedo_average(bsdf, 1, 1000);
    for (int channel = 0; channel < 3; ++channel) {
        assert_true(fabs(at.reflection[channel] - 0.2 * (channel + 1)) < 1e-6);
        assert_true(fabs(average.reflection[channel] - 0.2 * (channel + 1)) < 1e-6);
    }
    assert_true(at.error < 1e-7);
    assert_all(at.transmission, 0.0, 0.0);
    assert_all(below.reflection, 0.0, 0.0);
    brdf_bsdf_destroy(bsdf);
}

/* Of unpolarised light, for the index n of the other side over this one's. */
static double fresnel(double cosine, double n)
{
    double root = n * n - 1.0 + cosine * cosine;
    if (root <= 0.0) {
        return 1.0;
    }
    double g = sqrt(root);
    double s = (cosine - g) / (cosine + g);
    double p = (n * n * cosine - g) / (n * n * cosine + g);
    return 0.5 * (s * s + p * p);
}

/* Glass from above and from inside: what is not reflected goes through, as power. */
static void glass_follows_fresnel(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("dielectric:int_ior=1.5,ext_ior=1");
    for (int inside = 0; inside < 2; ++inside) {
        double n = inside ? 1.0 / 1.5 : 1.5;
        double average = 0.0;
        for (int i = 0; i < 20000; ++i) {
            double cosine = (i + 0.5) / 20000.0;
            average += 2.0 * cosine * fresnel(cosine, n) / 20000.0;
        }
        for (int i = 0; i < ENERGY_COSINES; ++i) {
            double cosine = energy_cosines[i];
            brdf_vec3 wo = energy_direction(cosine, 0.7);
            wo.z = inside ? -wo.z : wo.z;
            struct lab_albedo albedo = lab_albedo_at(bsdf, wo, LAB_ALBEDO_SAMPLES);
            double known = fresnel(cosine, n);
            assert_all(albedo.reflection, known, 1e-5 + 5.0 * albedo.error);
            assert_all(albedo.transmission, 1.0 - known, 1e-5 + 5.0 * albedo.error);
            assert_true(albedo.error < 1e-3);
        }
        struct lab_albedo albedo = lab_albedo_average(bsdf, inside, LAB_ALBEDO_SAMPLES);
        assert_all(albedo.reflection, average, 1e-5 + 5.0 * albedo.error);
        assert_all(albedo.transmission, 1.0 - average, 1e-5 + 5.0 * albedo.error);
    }
    brdf_bsdf_destroy(bsdf);
}

/* GGX with alpha = 1 reflects 1 - mu ln((1 + mu) / mu) [Heitz 2014, eq. 72, 98, 99]. */
static void rough_conductor_has_its_closed_form(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf =
        bsdf_make("roughconductor:material=none,distribution=ggx,masking=correlated,alpha=1");
    double average = 0.0;
    for (int i = 0; i < 20000; ++i) {
        double mu = (i + 0.5) / 20000.0;
        average += 2.0 * mu * (1.0 - mu * log((1.0 + mu) / mu)) / 20000.0;
    }
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        double mu = energy_cosines[i];
        struct lab_albedo albedo =
            lab_albedo_at(bsdf, energy_direction(mu, 0.7), LAB_ALBEDO_SAMPLES);
        assert_all(albedo.reflection, 1.0 - mu * log((1.0 + mu) / mu), 1e-5 + 5.0 * albedo.error);
        assert_true(albedo.error < 2e-4);
    }
    struct lab_albedo albedo = lab_albedo_average(bsdf, 0, LAB_ALBEDO_SAMPLES);
    assert_all(albedo.reflection, average, 1e-5 + 5.0 * albedo.error);
    assert_true(albedo.error < 5e-4);
    brdf_bsdf_destroy(bsdf);
}

/* More samples, less error, and the same bits from the same call. */
static void errors_shrink(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("roughconductor:alpha=0.5");
    brdf_vec3 wo = energy_direction(0.5, 0.0);
    struct lab_albedo few = lab_albedo_at(bsdf, wo, 1024);
    struct lab_albedo again = lab_albedo_at(bsdf, wo, 1024);
    struct lab_albedo many = lab_albedo_at(bsdf, wo, 1 << 18);
    assert_memory_equal(&few, &again, sizeof few);
    assert_true(many.error < 0.2 * few.error);
    assert_true(fabs(few.reflection[0] - many.reflection[0]) < 5.0 * few.error);
    brdf_bsdf_destroy(bsdf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diffuse_is_its_reflectance),
        cmocka_unit_test(glass_follows_fresnel),
        cmocka_unit_test(rough_conductor_has_its_closed_form),
        cmocka_unit_test(errors_shrink),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
