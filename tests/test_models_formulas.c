/*
 * test_models_formulas.c - the classic glossy models against their formulas as papers have them, in
 * double precision and with angles; and reciprocity to the bit.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "angle.h"
#include "support_bsdf.h"
#include "support_models.h"

/* Angles of a pair of directions, in double precision, as papers have them. */
struct angles {
    double o;     /* cos(wo) */
    double i;     /* cos(wi) */
    double h;     /* cos(h) */
    double d;     /* cos(wi, h) */
    double tan_h; /* tangent of the angle of h */
    double phi_h;
};

static struct angles angles_of(brdf_vec3 wo, brdf_vec3 wi)
{
    double o = hypot(hypot((double)wo.x, (double)wo.y), (double)wo.z); /* 1 but for rounding */
    double i = hypot(hypot((double)wi.x, (double)wi.y), (double)wi.z);
    double x = (double)wo.x / o + (double)wi.x / i;
    double y = (double)wo.y / o + (double)wi.y / i;
    double z = (double)wo.z / o + (double)wi.z / i;
    double length = sqrt(x * x + y * y + z * z);
    struct angles a;
    a.o = (double)wo.z / o;
    a.i = (double)wi.z / i;
    a.h = z / length;
    a.d = (x * (double)wi.x + y * (double)wi.y + z * (double)wi.z) / (i * length);
    a.tan_h = hypot(x, y) / z;
    a.phi_h = atan2(y, x);
    return a;
}

typedef double formula(struct angles a);

static double blinnphong_energy(struct angles a)
{
    double n = 12.5;
    return 0.3 / pi + 0.6 * (n + 2) * (n + 4) / (8 * pi * (pow(2, -n / 2) + n)) * pow(a.h, n);
}

static double blinnphong_distribution(struct angles a)
{
    return 0.3 / pi + 0.6 * (12.5 + 2) / (2 * pi) * pow(a.h, 12.5);
}

static double ward_gauss(struct angles a)
{
    double c = cos(a.phi_h) / 0.2;
    double s = sin(a.phi_h) / 0.7;
    return exp(-a.tan_h * a.tan_h * (c * c + s * s)) / (4 * pi * 0.2 * 0.7);
}

static double ward_1992(struct angles a)
{
    return 0.3 / pi + 0.6 * ward_gauss(a) / sqrt(a.i * a.o);
}

static double ward_duer(struct angles a)
{
    return 0.3 / pi + 0.6 * ward_gauss(a) / (a.i * a.o);
}

static double ward_balanced(struct angles a)
{
    return 0.3 / pi + 0.6 * ward_gauss(a) / (a.d * a.d * pow(a.h, 4));
}

static double ashikhminshirley(struct angles a)
{
    double c = cos(a.phi_h);
    double s = sin(a.phi_h);
    double fresnel = 0.4 + 0.6 * pow(1 - a.d, 5);
    double lobe = sqrt(11.0 * 31.0) / (8 * pi) * pow(a.h, 10 * c * c + 30 * s * s) * fresnel /
                  (a.d * fmax(a.i, a.o));
    return lobe +
           28 * 0.7 / (23 * pi) * (1 - 0.4) * (1 - pow(1 - a.o / 2, 5)) * (1 - pow(1 - a.i / 2, 5));
}

static double cavity(struct angles a)
{
    return fmin(1, fmin(2 * a.h * a.o / a.d, 2 * a.h * a.i / a.d));
}

/* A dielectric of index 1.5, in the form of Cook and Torrance 1982. */
static double fresnel(double c)
{
    double g = sqrt(1.5 * 1.5 + c * c - 1);
    double ratio = (g - c) / (g + c);
    double other = (c * (g + c) - 1) / (c * (g - c) + 1);
    return 0.5 * ratio * ratio * (1 + other * other);
}

static double beckmann(struct angles a)
{
    return exp(-a.tan_h * a.tan_h / (0.35 * 0.35)) / (pi * 0.35 * 0.35 * pow(a.h, 4));
}

static double torrancesparrow_blinn(struct angles a)
{
    double d = (20.0 + 2) / (2 * pi) * pow(a.h, 20);
    return 0.9 * fresnel(a.d) * d * cavity(a) / (4 * a.i * a.o);
}

static double torrancesparrow_beckmann(struct angles a)
{
    return 0.9 * fresnel(a.d) * beckmann(a) * cavity(a) / (4 * a.i * a.o);
}

static double cooktorrance_four(struct angles a)
{
    return 0.3 / pi + torrancesparrow_beckmann(a);
}

static double cooktorrance_pi(struct angles a)
{
    return 0.3 / pi + torrancesparrow_beckmann(a) * 4 / pi;
}

#define WEIGHTS ",specular_reflectance=0.6,diffuse_reflectance=0.3"
#define ANISOTROPIC WEIGHTS ",alpha_u=0.2,alpha_v=0.7"
#define GLASS ",eta=1.5,k=0,specular_reflectance=0.9,alpha=0.35"

static const struct {
    const char *description;
    formula *formula;
} formulas[] = {
    {"blinnphong:normalisation=energy,exponent=12.5" WEIGHTS, blinnphong_energy},
    {"blinnphong:normalisation=distribution,exponent=12.5" WEIGHTS, blinnphong_distribution},
    {"ward:variant=ward" ANISOTROPIC, ward_1992},
    {"ward:variant=ward-duer" ANISOTROPIC, ward_duer},
    {"ward:variant=balanced" ANISOTROPIC, ward_balanced},
    {"ashikhminshirley:specular_reflectance=0.4,diffuse_reflectance=0.7,exponent_u=10,"
     "exponent_v=30",
     ashikhminshirley},
    {"torrancesparrow:distribution=blinn,exponent=20" GLASS, torrancesparrow_blinn},
    {"torrancesparrow:distribution=beckmann" GLASS, torrancesparrow_beckmann},
    {"cooktorrance:denominator=four,diffuse_reflectance=0.3" GLASS, cooktorrance_four},
    {"cooktorrance:denominator=pi,diffuse_reflectance=0.3" GLASS, cooktorrance_pi},
};

static void formulas_of_the_papers(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof formulas / sizeof formulas[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(formulas[k].description);
        struct brdfcl_random random = {21};
        for (int n = 0; n < 10000; ++n) {
            brdf_vec3 wo = brdfcl_random_direction(&random);
            brdf_vec3 wi = brdfcl_random_direction(&random);
            wo.z = fabsf(wo.z);
            wi.z = fabsf(wi.z);
            if (brdf_dot(wo, wi) < -0.99f) {
                continue; /* opposite directions: rounding of them turns h */
            }
            double expected = formulas[k].formula(angles_of(wo, wi));
            double f = (double)brdf_eval(bsdf, wo, wi).g;
            if (!(fabs(f - expected) <= 1e-4 * expected + 1e-30)) {
                fail_msg("%s: f = %.9g, the formula says %.9g; wo %.9g/%.9g/%.9g wi %.9g/%.9g/%.9g",
                         formulas[k].description, f, expected, (double)wo.x, (double)wo.y,
                         (double)wo.z, (double)wi.x, (double)wi.y, (double)wi.z);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* Not only nearly: the directions in the other order give the same bits. */
static void reciprocal_to_the_bit(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof formulas / sizeof formulas[0]; ++k) {
        struct brdf_bsdf *bsdf = bsdf_make(formulas[k].description);
        struct brdfcl_random random = {23};
        for (int n = 0; n < 100000; ++n) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            float there = brdf_eval(bsdf, in.wo, in.wi).g;
            float back = brdf_eval(bsdf, in.wi, in.wo).g;
            if (there != back) {
                fail_msg("%s: %.9g and %.9g", formulas[k].description, (double)there, (double)back);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas_of_the_papers),
        cmocka_unit_test(reciprocal_to_the_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
