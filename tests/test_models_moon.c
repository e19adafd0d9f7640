/*
 * test_models_moon.c - regolith: what is known of lommelseeliger and hapke.
 *
 * A closed form of the one; of the other, Hapke's equations once more, in double precision and as
 * his papers write them.
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

#include "angle.h"
#include "support_bsdf.h"
#include "support_matte.h"
#include "support_models.h"

/* w / 2 (1 - mu ln(1 + 1 / mu)). */
static void lommel_seeliger_albedos(void **state)
{
    (void)state;
    double known[ENERGY_COSINES];
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        known[i] = 0.5 * (1.0 - energy_cosines[i] * log(1.0 + 1.0 / energy_cosines[i]));
    }
    assert_int_equal(matte_expect_albedos("lommelseeliger:albedo=1", known, 1e-4), 0);
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
        struct brdf_bsdf *bsdf = bsdf_make(description);
        for (size_t n = 0; n < 4000; ++n) {
            brdf_vec3 u = models_even_point(n, 4000);
            double i = 1.55 * (double)u.x + 0.01;
            double e = 1.55 * (double)u.y + 0.01;
            double psi = pi * (double)u.z;
            brdf_vec3 wo = energy_direction(cos(e), 0.4);
            brdf_vec3 wi = energy_direction(cos(i), n % 2 ? 0.4 + psi : 0.4 - psi);
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
    struct brdf_bsdf *hapke = bsdf_make("hapke:w=0.001,b=0,theta=0,B_0=0");
    struct brdf_bsdf *lommel = bsdf_make("lommelseeliger:albedo=0.001");
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
        struct brdf_bsdf *bsdf = bsdf_make(some[k].description);
        brdf_vec3 up = energy_direction(1.0, 0.0);
        double h = sqrt(8.0 * pi * (double)brdf_eval(bsdf, up, up).g);
        failures += matte_expect("H", 1.0, h, 2.9078, 2.9078 * some[k].error);
        for (int i = 0; i < ENERGY_COSINES; ++i) {
            double found = matte_albedo(bsdf, energy_cosines[i], 64);
            failures += matte_expect(some[k].description, energy_cosines[i], found, 1.0,
                                     2.0 * some[k].error);
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
    struct brdf_bsdf *flat = bsdf_make("hapke:w=1e-4,b=0,theta=0,B_0=0");
    struct brdf_bsdf *surge = bsdf_make("hapke:w=1e-4,b=0,theta=0,B_0=0.6,h=0.1");
    brdf_vec3 up = energy_direction(1.0, 0.0);
    brdf_vec3 off = energy_direction(cos(2.0 * atan(0.1)), 1.0);
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
        cmocka_unit_test(lommel_seeliger_albedos),
        cmocka_unit_test(hapke_as_in_the_papers),
        cmocka_unit_test(hapke_of_dark_grains),
        cmocka_unit_test(hapke_of_white_grains),
        cmocka_unit_test(hapke_surge),
    };
    return cmocka_run_group_tests_name("the moon", tests, NULL, NULL);
}
