/*
 * test_models_principled.c - principled: against Mitsuba 3, against the models that it contains,
 * and against closed forms.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <brdf/disney.h>

#include "angle.h"
#include "check_cases.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

static brdf_vec3 direction_of(const int degrees[2])
{
    double theta = degrees[0] * pi / 180.0;
    return energy_direction(cos(theta), degrees[1] * pi / 180.0);
}

static int differs(double a, double b, double tolerance)
{
    return !(fabs(a - b) <= tolerance * fmax(fabs(a), fabs(b)) + 1e-6);
}

/* f and pdf as Mitsuba 3.9.1 has them (scalar_rgb, its eval over the cosine); degrees. */
static const struct {
    const char *parameters;
    int wo[2];
    int wi[2];
    double f[3];
    double pdf;
} mitsuba[] = {
    {"twosided=false", {30, 0}, {45, 140}, {0.177937, 0.177937, 0.177937}, 0.268611},
    {"base_color=0.9/0.5/0.1,roughness=0.9",
     {70, 20},
     {75, 35},
     {0.432317, 0.243284, 0.0542508},
     0.0885132},
    {"base_color=0.9/0.5/0.1,roughness=0.8,flatness=0.6",
     {50, 0},
     {65, 100},
     {0.323338, 0.182852, 0.0423651},
     0.111955},
    {"base_color=0.8/0.6/0.4,sheen=0.7,sheen_tint=0.5",
     {70, 0},
     {80, 170},
     {0.89059, 0.817394, 0.744197},
     0.290899},
    {"base_color=0.8/0.6/0.4,metallic=0.7,roughness=0.3,anisotropic=0.8",
     {40, 10},
     {45, 200},
     {0.602525, 0.455351, 0.308176},
     0.553369},
    {"base_color=0.8/0.6/0.4,spec_tint=0.9,specular=0.9,roughness=0.4",
     {60, 0},
     {55, 175},
     {0.998615, 0.799756, 0.600897},
     2.04639},
    {"base_color=0.2/0.3/0.4,clearcoat=1,clearcoat_gloss=0,roughness=0.6",
     {35, 0},
     {33, 178},
     {0.165365, 0.1972, 0.229034},
     0.664304},
    {"base_color=0.2/0.3/0.4,clearcoat=0.5,clearcoat_gloss=0.6,eta=0.8",
     {35, 0},
     {33, 178},
     {0.217452, 0.249285, 0.281118},
     1.26266},
    {"base_color=0.9/0.8/0.7,spec_trans=0.8,eta=1.33,roughness=0.5",
     {30, 0},
     {150, 190},
     {1.17603, 1.10877, 1.03716},
     1.59072},
    {"base_color=0.9/0.8/0.7,spec_trans=1,eta=1.5,roughness=0.4,anisotropic=0.5",
     {160, 0},
     {30, 170},
     {10.7992, 10.1816, 9.52398},
     4.39802},
    {"base_color=0.9/0.8/0.7,spec_trans=0.6,metallic=0.3,eta=1.5",
     {130, 0},
     {135, 175},
     {1.00502, 1.00502, 1.00502},
     1.71807},
    {"base_color=0.6/0.5/0.7,spec_trans=0.4,metallic=0.2,spec_tint=0.3,sheen=0.5,flatness=0.2,"
     "clearcoat=0.8,clearcoat_gloss=0.3,roughness=0.45,specular=0.7,anisotropic=0.3,"
     "main_specular_sampling_rate=0.5,clearcoat_sampling_rate=0.7,"
     "diffuse_reflectance_sampling_rate=0.9",
     {20, 30},
     {40, 230},
     {0.191586, 0.164488, 0.218683},
     0.289915},
};

static void as_mitsuba_has_it(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof mitsuba / sizeof mitsuba[0]; ++k) {
        char text[512];
        snprintf(text, sizeof text, "principled:%s", mitsuba[k].parameters);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        brdf_vec3 wo = direction_of(mitsuba[k].wo);
        brdf_vec3 wi = direction_of(mitsuba[k].wi);
        brdf_rgb f = brdf_eval(bsdf, wo, wi);
        double pdf = (double)brdf_pdf(bsdf, wo, wi);
        if (differs((double)f.r, mitsuba[k].f[0], 1e-4) ||
            differs((double)f.g, mitsuba[k].f[1], 1e-4) ||
            differs((double)f.b, mitsuba[k].f[2], 1e-4) || differs(pdf, mitsuba[k].pdf, 1e-4)) {
            fail_msg("%s: f = %.6g %.6g %.6g, pdf %.6g", text, (double)f.r, (double)f.g,
                     (double)f.b, pdf);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* Materials that are another model's: f and pdf agree everywhere, from both sides. */
static void contains_other_models(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"principled:metallic=1,base_color=1,roughness=0.6",
         "roughconductor:material=none,distribution=ggx,masking=separable,alpha=0.36"},
        /* aspect = sqrt(1 - 0.9 * 0.4) = 0.8: alpha is 0.64 / 0.8 and 0.64 * 0.8 */
        {"principled:metallic=1,base_color=1,roughness=0.8,anisotropic=0.4",
         "roughconductor:material=none,distribution=ggx,masking=separable,alpha_u=0.8,"
         "alpha_v=0.512"},
        {"principled:spec_trans=1,base_color=1,eta=1.5,roughness=0.5",
         "roughdielectric:distribution=ggx,masking=separable,int_ior=1.5,ext_ior=1,alpha=0.25"},
        {"principled:spec_trans=1,base_color=1,eta=0.7,roughness=1",
         "roughdielectric:distribution=ggx,masking=separable,int_ior=0.7,ext_ior=1,alpha=1"},
        {"principled:spec_trans=1,base_color=0.49/0.25/0.04,eta=1.5,roughness=0.7",
         "roughdielectric:distribution=ggx,masking=separable,int_ior=1.5,ext_ior=1,alpha=0.49,"
         "specular_transmittance=0.7/0.5/0.2"},
    };
    for (size_t k = 0; k < sizeof pairs / sizeof pairs[0]; ++k) {
        struct brdf_bsdf *a = bsdf_make(pairs[k][0]);
        struct brdf_bsdf *b = bsdf_make(pairs[k][1]);
        struct brdfcl_random random = {21};
        for (int i = 0; i < 20000; ++i) {
            brdf_vec3 wo = brdfcl_random_direction(&random);
            brdf_vec3 wi = brdfcl_random_direction(&random);
            brdf_rgb f = brdf_eval(a, wo, wi);
            brdf_rgb g = brdf_eval(b, wo, wi);
            if (differs((double)f.r, (double)g.r, 1e-4) ||
                differs((double)f.b, (double)g.b, 1e-4) ||
                differs((double)brdf_pdf(a, wo, wi), (double)brdf_pdf(b, wo, wi), 1e-4)) {
                fail_msg("%s: f = %.9g, %s: %.9g; wo.z = %g, wi.z = %g", pairs[k][0], (double)f.r,
                         pairs[k][1], (double)g.r, (double)wo.z, (double)wi.z);
            }
        }
        brdf_bsdf_destroy(a);
        brdf_bsdf_destroy(b);
    }
}

/* At the normal with alpha = 1 facets have D G / 4 = 1 / (4 pi), a dielectric F = 0.08 specular. */
static void specular_is_the_reflectance(void **state)
{
    (void)state;
    brdf_vec3 normal = brdf_vec3_make(0.0f, 0.0f, 1.0f);
    for (int i = 0; i <= 10; ++i) {
        char text[128];
        snprintf(text, sizeof text, "principled:base_color=0,roughness=1,specular=%g", i / 10.0);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        double f = (double)brdf_eval(bsdf, normal, normal).g;
        double known = 0.08 * i / 10.0 / (4.0 * pi);
        if (!(fabs(f - known) <= 1e-5 * known + 1e-9)) {
            fail_msg("%s: f = %.9g, known %.9g", text, f, known);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* The diffuse base as Burley has it in 2012, where the two terms of 2015 are one product. */
static void base_is_the_product(void **state)
{
    (void)state;
    for (int i = 0; i < 1000; ++i) {
        brdf_vec3 p = models_even_point((size_t)i, 1000);
        float roughness = (float)(i % 11) / 10.0f;
        double o = pow(1.0 - (double)p.x, 5.0);
        double t = pow(1.0 - (double)p.y, 5.0);
        double f90 = 0.5 + 2.0 * (double)roughness * (double)(p.z * p.z);
        double known = (1.0 + (f90 - 1.0) * o) * (1.0 + (f90 - 1.0) * t) / pi;
        double found = (double)brdf_disney_diffuse(p.x, p.y, p.z, roughness, 0.0f);
        if (!(fabs(found - known) <= 1e-5 * known)) {
            fail_msg("cosines %g, %g, %g, roughness %g: %.7g, known %.7g", (double)p.x, (double)p.y,
                     (double)p.z, (double)roughness, found, known);
        }
    }
}

/* GTR of exponent 1: D cos integrates to 1, and what is sampled below an angle is its integral. */
static void gtr1_is_normalised(void **state)
{
    (void)state;
    static const float alphas[] = {0.001f, 0.01f, 0.1f, 0.5f};
    enum { STEPS = 20000, SAMPLES = 20000 };
    for (size_t k = 0; k < sizeof alphas / sizeof alphas[0]; ++k) {
        double below = 0.0; /* angles with sin^2 < alpha */
        double all = 0.0;
        for (int i = 0; i < STEPS; ++i) {
            /* sin^2 evenly in its logarithm, from 1e-9 */
            double step = log(1e9) / STEPS;
            double sin2 = 1e-9 * exp((i + 0.5) * step);
            brdf_vec3 h = brdf_vec3_make((float)sqrt(sin2), 0.0f, (float)sqrt(1.0 - sin2));
            double part = pi * (double)brdf_gtr1_d(h, alphas[k]) * sin2 * step;
            all += part;
            below += sin2 < (double)alphas[k] ? part : 0.0;
        }
        int found = 0;
        for (size_t i = 0; i < SAMPLES; ++i) {
            brdf_vec3 u = models_even_point(i, SAMPLES);
            brdf_vec3 h = brdf_gtr1_sample(alphas[k], u.y, u.x);
            found += (double)(h.x * h.x + h.y * h.y) < (double)alphas[k];
        }
        if (!(fabs(all - 1.0) <= 1e-3) || !(fabs((double)found / SAMPLES - below) <= 2e-3)) {
            fail_msg("alpha = %g: integral %.5f; %.4f sampled below, of %.4f", (double)alphas[k],
                     all, (double)found / SAMPLES, below);
        }
    }
}

/* What a clearcoat adds is F D G in Mitsuba's form and that over 4 cos cos in Burley's. */
static void coats_differ_by_the_cosines(void **state)
{
    (void)state;
    struct brdf_bsdf *none = bsdf_make("principled:base_color=0");
    struct brdf_bsdf *plain = bsdf_make("principled:base_color=0,clearcoat=1,coat=mitsuba");
    struct brdf_bsdf *over = bsdf_make("principled:base_color=0,clearcoat=1,coat=burley");
    for (int i = 0; i < 9; ++i) {
        const int to[2] = {10 * i, 0};
        const int from[2] = {10 * i, 177};
        brdf_vec3 wo = direction_of(to);
        brdf_vec3 wi = direction_of(from);
        double base = (double)brdf_eval(none, wo, wi).g;
        double a = (double)brdf_eval(plain, wo, wi).g - base;
        double b = (double)brdf_eval(over, wo, wi).g - base;
        if (differs(a, b * 4.0 * (double)wo.z * (double)wi.z, 1e-3) || !(a > 0.0)) {
            fail_msg("%d degrees: %.7g and %.7g", 10 * i, a, b);
        }
    }
    brdf_bsdf_destroy(none);
    brdf_bsdf_destroy(plain);
    brdf_bsdf_destroy(over);
}

/* White metal is a white GGX surface: albedos of alpha = 0.25 and 1, separable masking. */
static void white_metal_has_the_albedo_of_ggx(void **state)
{
    (void)state;
    static const struct energy_known known[] = {
        {"principled:metallic=1,base_color=1,roughness=0.5",
         {.85430, .82851, .85510, .89116, .91581},
         1e-3,
         1e-3},
        {"principled:metallic=1,base_color=1,roughness=1",
         {.55791, .49096, .40914, .35069, .30685},
         1e-3,
         1e-3},
    };
    assert_int_equal(energy_check_known(known, sizeof known / sizeof known[0]), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_mitsuba_has_it),
        cmocka_unit_test(contains_other_models),
        cmocka_unit_test(specular_is_the_reflectance),
        cmocka_unit_test(base_is_the_product),
        cmocka_unit_test(gtr1_is_normalised),
        cmocka_unit_test(coats_differ_by_the_cosines),
        cmocka_unit_test(white_metal_has_the_albedo_of_ggx),
    };
    return cmocka_run_group_tests_name("principled", tests, NULL, NULL);
}
