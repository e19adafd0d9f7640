/*
 * test_models_moon.c - rough diffuse surfaces and regolith: what is known of orennayar,
 * lommelseeliger and hapke.
 *
 * Albedos of Oren-Nayar are from quadratures made apart from this project's code; the rest are
 * closed forms, and Hapke's equations once more, in double precision and as his papers write them.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/warp.h>

#include "support_models.h"

enum { COSINES = 5 };

static const double pi = 3.14159265358979323846;
static const double cosines[COSINES] = {0.1, 0.25, 0.5, 0.75, 1.0};

static struct brdf_bsdf *make(const char *description)
{
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error;
    if (brdf_bsdf_create(description, &bsdf, &error)) {
        fail_msg("%s", error.message);
    }
    return bsdf;
}

static brdf_vec3 direction(double cosine, double phi)
{
    double radius = sqrt((1.0 - cosine) * (1.0 + cosine));
    return brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cosine);
}

/* The midpoint rule over cosines from low to high, and half a turn in two pieces: Oren-Nayar has
   creases at a quarter turn and where both cosines are equal. */
static double panel(const struct brdf_bsdf *bsdf, brdf_vec3 wo, double low, double high, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        double z = low + (high - low) * (i + 0.5) / count;
        for (int j = 0; j < 2 * count; ++j) {
            double phi = pi * (j + 0.5) / (2 * count);
            sum += z * (double)brdf_eval(bsdf, wo, direction(z, phi)).g;
        }
    }
    return sum * (high - low) / count * pi / count;
}

/* The albedo for light from the cosine mu; isotropic models only. */
static double albedo(const struct brdf_bsdf *bsdf, double mu, int count)
{
    brdf_vec3 wo = direction(mu, 0.0);
    return panel(bsdf, wo, 0.0, mu, count) + panel(bsdf, wo, mu, 1.0, count);
}

static double albedo_by_sampling(const struct brdf_bsdf *bsdf, double mu)
{
    size_t count = 1 << 14;
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        brdf_vec3 u = models_even_point(i, count);
        sum += (double)brdf_sample(bsdf, direction(mu, 0.0), u).weight.g;
    }
    return sum / (double)count;
}

static int expect(const char *what, double mu, double found, double known, double tolerance)
{
    int wrong = !(fabs(found - known) <= tolerance);
    if (wrong) {
        print_error("%s at cos = %.3f: %.6f, known %.6f\n", what, mu, found, known);
    }
    return wrong;
}

/* The albedo at all five cosines, by quadrature and by sampling. */
static int expect_albedos(const char *description, const double known[COSINES], double tolerance)
{
    struct brdf_bsdf *bsdf = make(description);
    int failures = 0;
    for (int i = 0; i < COSINES; ++i) {
        double mu = cosines[i];
        failures += expect(description, mu, albedo(bsdf, mu, 64), known[i], tolerance);
        failures += expect(description, mu, albedo_by_sampling(bsdf, mu), known[i], 1e-3);
    }
    brdf_bsdf_destroy(bsdf);
    return failures;
}

static void oren_nayar_of_1994(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double albedo[COSINES];
    } known[] = {
        {"orennayar:reflectance=1,variant=qualitative,sigma=10",
         {1.0108, 1.0041, .9917, .9783, .9577}},
        {"orennayar:reflectance=1,variant=qualitative,sigma=30",
         {.9309, .9112, .8741, .8343, .7731}},
        {"orennayar:reflectance=1,variant=full,sigma=10", {1.0225, 1.0123, 1.0006, .9931, .9900}},
        {"orennayar:reflectance=1,variant=full,sigma=20", {1.0214, .9981, .9714, .9544, .9474}},
        {"orennayar:reflectance=1,variant=full,sigma=30", {.9852, .9547, .9198, .8975, .8884}},
        {"orennayar:reflectance=1,variant=full,sigma=40", {.9446, .9104, .8713, .8463, .8361}},
    };
    int failures = 0;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        failures += expect_albedos(known[i].description, known[i].albedo, 2e-4);
    }
    assert_int_equal(failures, 0);
}

/* Portsmouth et al.: the albedo of fujii, written as they do, and its average. */
static double fujii_albedo(double mu, double r)
{
    double a = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * r);
    double s = sqrt(1.0 - mu * mu);
    double g = s * (acos(mu) - s * mu) + 2.0 / 3.0 * (s / mu * (1.0 - s * s * s) - s);
    return a + r * a / pi * g;
}

static void fujii_albedos(void **state)
{
    (void)state;
    static const double roughest[COSINES] = {.974307, .933386, .865320, .807855, .776522};
    int failures =
        expect_albedos("orennayar:reflectance=1,variant=fujii,roughness=1", roughest, 1e-4);
    for (int i = 0; i < COSINES; ++i) {
        failures +=
            expect("closed form", cosines[i], fujii_albedo(cosines[i], 1.0), roughest[i], 1e-6);
    }
    static const double averages[] = {.949786, .905890, .867188, .832811};
    for (int k = 0; k < 4; ++k) {
        char description[80];
        snprintf(description, sizeof description,
                 "orennayar:reflectance=1,variant=fujii,roughness=%.2f", 0.25 * (k + 1));
        struct brdf_bsdf *bsdf = make(description);
        double sum = 0.0;
        for (int i = 0; i < 32; ++i) {
            double mu = (i + 0.5) / 32;
            sum += 2.0 * mu * albedo(bsdf, mu, 24) / 32;
        }
        failures += expect("average", 0.0, sum, averages[k], 3e-4);
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* A surface that absorbs nothing reflects everything, whatever the angle and the roughness. */
static void eon_keeps_everything(void **state)
{
    (void)state;
    static const double mus[] = {0.003, 0.02, 0.1, 0.3, 0.6, 0.9, 1.0};
    static const char *const roughness[] = {"0", "0.1", "0.35", "0.7", "1"};
    int failures = 0;
    for (int k = 0; k < 5; ++k) {
        char description[64];
        snprintf(description, sizeof description, "orennayar:reflectance=1,roughness=%s",
                 roughness[k]);
        struct brdf_bsdf *bsdf = make(description);
        for (int i = 0; i < 7; ++i) {
            failures += expect(description, mus[i], albedo(bsdf, mus[i], 96), 1.0, 1e-4);
            failures += expect(description, mus[i], albedo_by_sampling(bsdf, mus[i]), 1.0, 1e-3);
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* rho E + rho^2 average / (1 - rho (1 - average)) (1 - E). */
static void eon_albedo_of_gray(void **state)
{
    (void)state;
    double known[COSINES];
    double rho = 0.5;
    double average = .832811;
    for (int i = 0; i < COSINES; ++i) {
        double e = fujii_albedo(cosines[i], 1.0);
        known[i] = rho * e + rho * rho * average / (1.0 - rho * (1.0 - average)) * (1.0 - e);
    }
    assert_int_equal(expect_albedos("orennayar:reflectance=0.5,roughness=1", known, 1e-4), 0);
}

/* Smooth is Lambert, and sampled as such: every weight is the reflectance. */
static void smooth_is_lambert(void **state)
{
    (void)state;
    static const char *const smooth[] = {"eon,roughness=0", "fujii,roughness=0", "full,sigma=0",
                                         "qualitative,sigma=0"};
    for (int k = 0; k < 4; ++k) {
        char description[80];
        snprintf(description, sizeof description, "orennayar:reflectance=0.6,variant=%s",
                 smooth[k]);
        struct brdf_bsdf *bsdf = make(description);
        for (size_t i = 0; i < 1000; ++i) {
            brdf_vec3 wo = brdf_warp_cosine((float)(i % 40) / 40.0f, 0.3f);
            struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, 1000));
            assert_true(s.pdf == 0.0f || fabsf(s.weight.g - 0.6f) < 1e-5f);
            assert_true(fabsf(brdf_eval(bsdf, wo, s.wi).g - 0.6f * BRDF_1_PI) < 1e-6f ||
                        s.pdf == 0.0f);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* The variance of sample weights, relative to the square of their mean; the largest in *most. */
static double variance(const struct brdf_bsdf *bsdf, double mu, int by_cosine, double *most)
{
    size_t count = 1 << 14;
    brdf_vec3 wo = direction(mu, 0.0);
    double sum = 0.0;
    double squares = 0.0;
    *most = 0.0;
    for (size_t i = 0; i < count; ++i) {
        brdf_vec3 u = models_even_point(i, count);
        double weight = by_cosine ? (double)brdf_eval(bsdf, wo, brdf_warp_cosine(u.x, u.y)).g * pi
                                  : (double)brdf_sample(bsdf, wo, u).weight.g;
        sum += weight;
        squares += weight * weight;
        *most = fmax(*most, weight);
    }
    double mean = sum / (double)count;
    return squares / (double)count / (mean * mean) - 1.0;
}

/* Better than the cosine towards grazing, never much worse, and with bounded weights. */
static void samplers_earn_their_keep(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double gain; /* at least, at grazing */
        double most; /* weight over albedo */
    } wanted[] = {
        {"orennayar:reflectance=0.8,roughness=1", 5.0, 2.0},
        {"orennayar:reflectance=0.8,roughness=0.3", 3.0, 2.0},
        {"orennayar:reflectance=0.8,variant=full,sigma=40", 2.0, 3.0},
        {"orennayar:reflectance=0.8,variant=qualitative,sigma=40", 2.0, 3.0},
        {"lommelseeliger", 20.0, 1.2},
        {"hapke", 1.8, 8.0},
        {"hapke:b=0.8,theta=0", 20.0, 4.0},
    };
    int failures = 0;
    for (size_t k = 0; k < sizeof wanted / sizeof wanted[0]; ++k) {
        struct brdf_bsdf *bsdf = make(wanted[k].description);
        for (int i = 0; i < 3; ++i) {
            static const double mus[] = {0.02, 0.3, 0.95};
            double most;
            double cosine_most;
            double own = variance(bsdf, mus[i], 0, &most);
            double cosine = variance(bsdf, mus[i], 1, &cosine_most);
            double bound = wanted[k].most * albedo(bsdf, mus[i], 64);
            double gain = i == 0 ? wanted[k].gain : 0.5;
            if (!(own * gain <= cosine + 0.02) || !(most <= bound)) {
                print_error("%s at cos = %.2f: variance %.4f, by cosine %.4f; weights to %.3f of"
                            " %.3f\n",
                            wanted[k].description, mus[i], own, cosine, most, bound);
                ++failures;
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* w / 2 (1 - mu ln(1 + 1 / mu)). */
static void lommel_seeliger_albedos(void **state)
{
    (void)state;
    double known[COSINES];
    for (int i = 0; i < COSINES; ++i) {
        known[i] = 0.5 * (1.0 - cosines[i] * log(1.0 + 1.0 / cosines[i]));
    }
    assert_int_equal(expect_albedos("lommelseeliger:albedo=1", known, 1e-4), 0);
}

struct hapke {
    double w, b, c, theta, b0, h; /* theta in degrees */
    int legendre;
};

static double hapke_h(double w, double x)
{
    double r0 = (1.0 - sqrt(1.0 - w)) / (1.0 + sqrt(1.0 - w));
    return 1.0 / (1.0 - w * x * (r0 + (1.0 - 2.0 * r0 * x) / 2.0 * log((1.0 + x) / x)));
}

static double hapke_phase(const struct hapke *p, double g)
{
    if (p->legendre) {
        return fmax(0.0, 1.0 + p->b * cos(g) + p->c * (3.0 * cos(g) * cos(g) - 1.0) / 2.0);
    }
    double top = 1.0 - p->b * p->b;
    return p->c * top / pow(1.0 - 2.0 * p->b * cos(g) + p->b * p->b, 1.5) +
           (1.0 - p->c) * top / pow(1.0 + 2.0 * p->b * cos(g) + p->b * p->b, 1.5);
}

/* The effective cosines and S of Hapke 1984: i is the angle of the light, e that of the viewer. */
static double hapke_shadow(double theta, double i, double e, double psi, double *mu_i, double *mu_e)
{
    double t = tan(theta);
    double chi = 1.0 / sqrt(1.0 + pi * t * t);
    double e1_i = exp(-2.0 / pi / t / tan(i));
    double e1_e = exp(-2.0 / pi / t / tan(e));
    double e2_i = exp(-1.0 / pi / (t * t) / (tan(i) * tan(i)));
    double e2_e = exp(-1.0 / pi / (t * t) / (tan(e) * tan(e)));
    double half = sin(psi / 2.0) * sin(psi / 2.0);
    double eta_i = chi * (cos(i) + sin(i) * t * e2_i / (2.0 - e1_i));
    double eta_e = chi * (cos(e) + sin(e) * t * e2_e / (2.0 - e1_e));
    double f = exp(-2.0 * tan(psi / 2.0));
    double lit;
    if (i <= e) {
        double below = 2.0 - e1_e - psi / pi * e1_i;
        *mu_i = chi * (cos(i) + sin(i) * t * (cos(psi) * e2_e + half * e2_i) / below);
        *mu_e = chi * (cos(e) + sin(e) * t * (e2_e - half * e2_i) / below);
        lit = cos(i) / eta_i;
    } else {
        double below = 2.0 - e1_i - psi / pi * e1_e;
        *mu_i = chi * (cos(i) + sin(i) * t * (e2_i - half * e2_e) / below);
        *mu_e = chi * (cos(e) + sin(e) * t * (cos(psi) * e2_i + half * e2_e) / below);
        lit = cos(e) / eta_e;
    }
    return *mu_e / eta_e * cos(i) / eta_i * chi / (1.0 - f + f * chi * lit);
}

static double hapke_f(const struct hapke *p, double i, double e, double psi)
{
    double mu_i = cos(i);
    double mu_e = cos(e);
    double shadow = 1.0;
    if (p->theta > 0.0) {
        shadow = hapke_shadow(p->theta * pi / 180.0, i, e, psi, &mu_i, &mu_e);
    }
    double g = acos(fmin(1.0, cos(i) * cos(e) + sin(i) * sin(e) * cos(psi)));
    double surge = p->b0 / (1.0 + tan(g / 2.0) / p->h);
    double many = hapke_h(p->w, mu_i) * hapke_h(p->w, mu_e) - 1.0;
    double r = p->w / (4.0 * pi) * mu_i / (mu_i + mu_e) *
               ((1.0 + surge) * hapke_phase(p, g) + many) * shadow;
    return r / cos(i);
}

static void hapke_as_in_the_papers(void **state)
{
    (void)state;
    static const struct hapke some[] = {
        {0.21, 0.3, 0.7, 20.0, 0.8, 0.07, 0}, {0.9, 0.6, 0.2, 35.0, 1.0, 0.3, 0},
        {0.5, 0.3, 0.4, 10.0, 0.5, 0.05, 1},  {1.0, 0.0, 0.5, 60.0, 0.0, 0.1, 0},
        {0.3, 0.9, 0.95, 0.0, 0.3, 0.02, 0},  {0.7, 1.5, 1.0, 5.0, 0.2, 0.2, 1},
    };
    double worst = 0.0;
    for (size_t k = 0; k < sizeof some / sizeof some[0]; ++k) {
        char description[256];
        const struct hapke *p = &some[k];
        snprintf(description, sizeof description,
                 p->legendre ? "hapke:phase=legendre,w=%g,legendre_1=%g,legendre_2=%g,theta=%g,"
                               "B_0=%g,h=%g"
                             : "hapke:w=%g,b=%g,c=%g,theta=%g,B_0=%g,h=%g",
                 p->w, p->b, p->c, p->theta, p->b0, p->h);
        struct brdf_bsdf *bsdf = make(description);
        for (size_t n = 0; n < 4000; ++n) {
            brdf_vec3 u = models_even_point(n, 4000);
            double i = 1.55 * (double)u.x + 0.01;
            double e = 1.55 * (double)u.y + 0.01;
            double psi = pi * (double)u.z;
            brdf_vec3 wo = direction(cos(e), 0.4);
            brdf_vec3 wi = direction(cos(i), n % 2 ? 0.4 + psi : 0.4 - psi);
            double known = hapke_f(p, i, e, psi);
            double found = (double)brdf_eval(bsdf, wo, wi).g;
            double off = fabs(found - known) / known;
            worst = fmax(worst, off);
            if (!(off < 2e-4)) {
                fail_msg("%s: %.7g, known %.7g at i %.4f e %.4f psi %.4f", description, found,
                         known, i, e, psi);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
    print_message("largest relative difference %.2g\n", worst);
}

/* Without surge, lobes, slopes and many times scattered light (a dark limit) only dark grains are
   left. */
static void hapke_of_dark_grains(void **state)
{
    (void)state;
    struct brdf_bsdf *hapke = make("hapke:w=0.001,b=0,theta=0,B_0=0");
    struct brdf_bsdf *lommel = make("lommelseeliger:albedo=0.001");
    for (size_t n = 0; n < 1000; ++n) {
        brdf_vec3 u = models_even_point(n, 1000);
        brdf_vec3 wo = brdf_warp_cosine(u.x, 0.1f);
        brdf_vec3 wi = brdf_warp_cosine(u.y, u.z);
        double known = (double)brdf_eval(lommel, wo, wi).g;
        assert_true(fabs((double)brdf_eval(hapke, wo, wi).g / known - 1.0) < 2e-3);
    }
    brdf_bsdf_destroy(hapke);
    brdf_bsdf_destroy(lommel);
}

/* Grains that absorb nothing: H(1) is 2.9078 (Chandrasekhar 1960, table XI), and everything that
   comes in goes out, as far as the approximations of H are exact. */
static void hapke_of_white_grains(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        double error; /* relative, of H(1) and of the albedo */
    } some[] = {
        {"hapke:multiple=2002,w=1,b=0,theta=0,B_0=0", 0.01},
        {"hapke:multiple=1981,w=1,b=0,theta=0,B_0=0", 0.035},
    };
    int failures = 0;
    for (int k = 0; k < 2; ++k) {
        struct brdf_bsdf *bsdf = make(some[k].description);
        brdf_vec3 up = direction(1.0, 0.0);
        double h = sqrt(8.0 * pi * (double)brdf_eval(bsdf, up, up).g);
        failures += expect("H", 1.0, h, 2.9078, 2.9078 * some[k].error);
        for (int i = 0; i < COSINES; ++i) {
            double found = albedo(bsdf, cosines[i], 64);
            failures += expect(some[k].description, cosines[i], found, 1.0, 2.0 * some[k].error);
        }
        brdf_bsdf_destroy(bsdf);
    }
    assert_int_equal(failures, 0);
}

/* The surge lifts single scattering by 1 + B_0 where the light stands behind the viewer, and by
   half of that where tan(g / 2) = h. */
static void hapke_surge(void **state)
{
    (void)state;
    struct brdf_bsdf *flat = make("hapke:w=1e-4,b=0,theta=0,B_0=0");
    struct brdf_bsdf *surge = make("hapke:w=1e-4,b=0,theta=0,B_0=0.6,h=0.1");
    brdf_vec3 up = direction(1.0, 0.0);
    brdf_vec3 off = direction(cos(2.0 * atan(0.1)), 1.0);
    double at_0 = (double)(brdf_eval(surge, up, up).g / brdf_eval(flat, up, up).g);
    double at_h = (double)(brdf_eval(surge, up, off).g / brdf_eval(flat, up, off).g);
    assert_true(fabs(at_0 - 1.6) < 1e-3);
    assert_true(fabs(at_h - 1.3) < 1e-3);
    brdf_bsdf_destroy(flat);
    brdf_bsdf_destroy(surge);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(oren_nayar_of_1994),
        cmocka_unit_test(fujii_albedos),
        cmocka_unit_test(eon_keeps_everything),
        cmocka_unit_test(eon_albedo_of_gray),
        cmocka_unit_test(smooth_is_lambert),
        cmocka_unit_test(samplers_earn_their_keep),
        cmocka_unit_test(lommel_seeliger_albedos),
        cmocka_unit_test(hapke_as_in_the_papers),
        cmocka_unit_test(hapke_of_dark_grains),
        cmocka_unit_test(hapke_of_white_grains),
        cmocka_unit_test(hapke_surge),
    };
    return cmocka_run_group_tests_name("the moon", tests, NULL, NULL);
}
