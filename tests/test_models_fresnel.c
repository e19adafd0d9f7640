/*
 * test_models_fresnel.c - what exact Fresnel says of a smooth dielectric, and of its mean over the
 * hemisphere, which layers are computed with.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <brdf/interface.h>
#include <brdf/material.h>
#include <brdf/real.h>

/* Means of R over the hemisphere, 2 R cos dcos, from outside and inside: from quadratures made
   apart from this project's code, known to six digits. */
static const struct {
    double eta;
    double outside;
    double inside;
} means[] = {{1.33, .065931, .471949}, {1.49, .090306, .590246}, {1.5, .091778, .596346},
             {1.6, .106246, .650877},  {1.8, .134054, .732733},  {2.0, .160597, .790149},
             {2.419, .212423, .865407}};

/* Fresnel's equations in angles, another form than that of the library [Born and Wolf, 1.5.2]. */
static double fresnel(double cosine, double eta)
{
    double incident = acos(cosine);
    double sine = sin(incident) / eta;
    if (sine >= 1.0) {
        return 1.0;
    }
    if (incident < 1e-6) {
        return pow((eta - 1.0) / (eta + 1.0), 2.0);
    }
    double refracted = asin(sine);
    double s = sin(incident - refracted) / sin(incident + refracted);
    double p = tan(incident - refracted) / tan(incident + refracted);
    return 0.5 * (s * s + p * p);
}

static struct brdf_bsdf *glass(double eta)
{
    struct brdf_setting settings[] = {brdf_setting_real("int_ior", (float)eta),
                                      brdf_setting_real("ext_ior", 1.0f)};
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    if (brdf_bsdf_create_from("dielectric", settings, 2, &bsdf, &error)) {
        fail_msg("%s", error.message);
    }
    return bsdf;
}

/* What the lobe that comes up for u.z does to radiance [1]; its side and index in *s. */
static double coefficient(const struct brdf_bsdf *bsdf, brdf_vec3 wo, float u,
                          struct brdf_sample *s)
{
    *s = brdf_sample(bsdf, wo, brdf_vec3_make(0.5f, 0.5f, u));
    return (double)s->weight.g * (double)s->pdf;
}

static void dielectric_is_fresnel_and_loses_nothing(void **state)
{
    (void)state;
    static const double etas[] = {1.33, 1.5, 2.419, 0.7};
    for (size_t k = 0; k < sizeof etas / sizeof etas[0]; ++k) {
        struct brdf_bsdf *bsdf = glass(etas[k]);
        for (int i = -50; i <= 50; ++i) {
            double cosine = i / 50.0;
            float radius = (float)sqrt(1.0 - cosine * cosine);
            brdf_vec3 wo = brdf_vec3_make(0.6f * radius, 0.8f * radius, (float)cosine);
            struct brdf_sample s;
            if (i == 0) {
                continue;
            }
            double exact = fresnel(fabs(cosine), cosine > 0.0 ? etas[k] : 1.0 / etas[k]);
            double reflected = coefficient(bsdf, wo, 0.0f, &s);
            assert_true((s.wi.z > 0.0f) == (wo.z > 0.0f));
            double last = coefficient(bsdf, wo, BRDF_ONE_MINUS_ULP, &s);
            /* Radiance that passes is scaled, which is undone here; all of it may be reflected. */
            int passes = (s.wi.z > 0.0f) != (wo.z > 0.0f);
            double passed = passes ? last * (double)s.eta * (double)s.eta : 0.0;
            assert_true(passes == (exact < 1.0));
            if (!(fabs(reflected - exact) <= 2e-5) || !(fabs(reflected + passed - 1.0) <= 1e-6)) {
                fail_msg("eta %g, cos %g: R = %.6f, T = %.6f, exact R = %.6f", etas[k], cosine,
                         reflected, passed, exact);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

static void dielectric_has_its_mean_reflectance(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof means / sizeof means[0]; ++k) {
        struct brdf_bsdf *bsdf = glass(means[k].eta);
        double mean[2] = {0.0, 0.0};
        int count = 20000;
        for (int i = 0; i < count; ++i) {
            float cosine = ((float)i + 0.5f) / (float)count;
            float radius = sqrtf(1.0f - cosine * cosine);
            for (int side = 0; side < 2; ++side) {
                brdf_vec3 wo = brdf_vec3_make(radius, 0.0f, side ? -cosine : cosine);
                struct brdf_sample s;
                mean[side] += 2.0 * coefficient(bsdf, wo, 0.0f, &s) * (double)cosine / count;
                assert_true(s.eta == 1.0f); /* it reflects */
            }
        }
        if (!(fabs(mean[0] - means[k].outside) <= 3e-6) ||
            !(fabs(mean[1] - means[k].inside) <= 3e-6)) {
            fail_msg("eta %g: %.6f outside (known %.6f), %.6f inside (known %.6f)", means[k].eta,
                     mean[0], means[k].outside, mean[1], means[k].inside);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

static void mean_reflectance_is_known(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof means / sizeof means[0]; ++k) {
        float eta = (float)means[k].eta;
        double outside = 1.0 - (double)brdf_interface_pass(eta);
        double inside = 1.0 - (double)brdf_interface_pass(1.0f / eta);
        if (!(fabs(outside - means[k].outside) <= 2e-6) ||
            !(fabs(inside - means[k].inside) <= 2e-6)) {
            fail_msg("eta %g: %.6f outside (known %.6f), %.6f inside (known %.6f)", means[k].eta,
                     outside, means[k].outside, inside, means[k].inside);
        }
    }
}

/* The closed form against the mean of Fresnel's equations, where its terms would cancel as well. */
static void mean_reflectance_is_the_mean(void **state)
{
    (void)state;
    static const float etas[] = {0.01f, 0.5f,  0.99f, 1.0f, 1.001f,
                                 1.05f, 2.07f, 2.08f, 4.0f, 100.0f};
    int count = 1 << 18;
    for (size_t k = 0; k < sizeof etas / sizeof etas[0]; ++k) {
        double mean = 0.0;
        for (int i = 0; i < count; ++i) {
            float cosine = ((float)i + 0.5f) / (float)count;
            double one = (double)brdf_fresnel_dielectric(cosine, etas[k]).reflectance;
            mean += 2.0 * one * (double)cosine / count;
        }
        double closed = 1.0 - (double)brdf_interface_pass(etas[k]);
        if (!(fabs(closed - mean) <= 5e-6)) {
            fail_msg("eta %g: closed form %.7f, mean %.7f", (double)etas[k], closed, mean);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dielectric_is_fresnel_and_loses_nothing),
        cmocka_unit_test(dielectric_has_its_mean_reflectance),
        cmocka_unit_test(mean_reflectance_is_known),
        cmocka_unit_test(mean_reflectance_is_the_mean),
    };
    return cmocka_run_group_tests_name("fresnel", tests, NULL, NULL);
}
