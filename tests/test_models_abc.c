/*
 * test_models_abc.c - the ABC model against its formula, written down once more in doubles.
 */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdio.h>

#include <brdf/material.h>

#include "angle.h"
#include "support_bsdf.h"

struct abc {
    double diffuse, a, b, c, ior;
};

static double fresnel(double cosine, double ior)
{
    double g = sqrt(ior * ior - 1.0 + cosine * cosine);
    double first = (g - cosine) / (g + cosine);
    double second = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 0.5 * first * first * (1.0 + second * second); /* Cook and Torrance 1982 */
}

static double expected(struct abc p, const double wo[3], const double wi[3])
{
    double h[3], length = 0.0, cosine = 0.0;
    for (int i = 0; i < 3; ++i) {
        h[i] = wo[i] + wi[i];
        length += h[i] * h[i];
    }
    for (int i = 0; i < 3; ++i) {
        h[i] /= sqrt(length);
        cosine += h[i] * wo[i];
    }
    double g = fmin(1.0, 2.0 * h[2] * fmin(wo[2], wi[2]) / cosine);
    double d = p.a / pow(1.0 + p.b * (1.0 - h[2]), p.c);
    return p.diffuse / pi + fresnel(cosine, p.ior) * d * g / (pi * wo[2] * wi[2]);
}

static brdf_vec3 direction(double theta, double phi, double w[3])
{
    w[0] = sin(theta) * cos(phi);
    w[1] = sin(theta) * sin(phi);
    w[2] = cos(theta);
    return brdf_vec3_make((float)w[0], (float)w[1], (float)w[2]);
}

/* Published parameters of alum-bronze, alumina-oxide, black-fabric: red [Loew et al. 2012]. */
static void test_formula(void **state)
{
    (void)state;
    static const struct abc materials[] = {
        {0.024514, 51.714554, 10482.133789, 0.816737, 2.236525},
        {0.310854, 2191.683838, 97381.554688, 1.39385, 1.437706},
        {0.014945, 3.109159, 871444.875, 0.2923, 1.057058},
        {0.1, 2.0, 30.0, 1.0, 1.5}, /* C = 1: the integral is a logarithm */
    };
    for (size_t m = 0; m < sizeof materials / sizeof materials[0]; ++m) {
        char text[256];
        snprintf(text, sizeof text, "abc:diffuse_reflectance=%.9g,A=%.9g,B=%.9g,C=%.9g,ior=%.9g",
                 materials[m].diffuse, materials[m].a, materials[m].b, materials[m].c,
                 materials[m].ior);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        for (int i = 0; i < 200; ++i) {
            double wo[3], wi[3];
            brdf_vec3 o = direction(0.007 * i, 0.3, wo);
            brdf_vec3 in = direction(1.5 - 0.0071 * i, 3.0 + 0.01 * i, wi);
            double want = expected(materials[m], wo, wi);
            double have = (double)brdf_eval(bsdf, o, in).r;
            if (!(fabs(have - want) <= 2e-4 * want)) {
                fail_msg("%s: %g, not %g, pair %d", text, have, want, i);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_formula)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
