/*
 * test_models_multiscatter.c - energy compensation: mirrors of any roughness reflect everything,
 * and less than perfect ones what Kulla and Conty say.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/fresnel.h>

#include "angle.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

static struct brdf_bsdf *make(const char *format, const char *options, double alpha,
                              const char *multiscatter)
{
    char text[256];
    snprintf(text, sizeof text, format, options, alpha, multiscatter);
    return bsdf_make(text);
}

/* A material with and without compensation. */
struct pair {
    struct brdf_bsdf *without;
    struct brdf_bsdf *with;
};

static struct pair pair_make(const char *format, const char *options, double alpha)
{
    struct pair pair = {make(format, options, alpha, "none"),
                        make(format, options, alpha, "kullaconty")};
    return pair;
}

static void pair_destroy(struct pair pair)
{
    brdf_bsdf_destroy(pair.without);
    brdf_bsdf_destroy(pair.with);
}

/* The added lobe f, green, which depends on cosines only: seen where wi is on wo's side. */
static double lobe(struct pair pair, double cos_o, double cos_i)
{
    brdf_vec3 wo = energy_direction(cos_o, 0.7);
    brdf_vec3 wi = energy_direction(cos_i, cos_i > 0.0 ? 0.7 : 0.7 + pi);
    return (double)brdf_eval(pair.with, wo, wi).g - (double)brdf_eval(pair.without, wo, wi).g;
}

/* What it reflects; `side` is 1, or -1 for what it lets through. Cosines are squares. */
static double lobe_albedo(struct pair pair, double cos_o, double side)
{
    enum { STEPS = 400 };
    double sum = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        double v = (i + 0.5) / STEPS;
        double mu = v * v * v;
        sum += lobe(pair, cos_o, side * mu) * mu * 3.0 * v * v;
    }
    return 2.0 * pi * sum / STEPS;
}

static const double alphas[] = {0.01, 0.1, 0.4, 1.0, 2.0};
static const double degrees[] = {0.0, 45.0, 75.0, 85.0, 89.0};

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* The lecture's first strip of spheres in a furnace becomes flat. */
static void mirrors_reflect_everything(void **state)
{
    (void)state;
    static const char *const options[] = {
        "distribution=beckmann,masking=correlated", "distribution=beckmann,masking=separable",
        "distribution=beckmann,masking=rational",   "distribution=beckmann,masking=vcavity",
        "distribution=ggx,masking=correlated",      "distribution=ggx,masking=separable",
        "distribution=ggx,masking=vcavity"};
    double worst = 0.0;
    for (size_t k = 0; k < COUNT(options); ++k) {
        for (size_t i = 0; i < COUNT(alphas); ++i) {
            struct pair pair = pair_make("roughconductor:material=none,%s,alpha=%g,multiscatter=%s",
                                         options[k], alphas[i]);
            for (size_t j = 0; j < COUNT(degrees); ++j) {
                double cosine = cos(degrees[j] * pi / 180.0);
                double once = energy_by_sampling(pair.without, energy_direction(cosine, 0.7)).value;
                double albedo = once + lobe_albedo(pair, cosine, 1.0);
                worst = fmax(worst, fabs(albedo - 1.0));
                if (!(fabs(albedo - 1.0) <= 2e-3)) {
                    print_error("%s, alpha %g, %g degrees: albedo %.5f\n", options[k], alphas[i],
                                degrees[j], albedo);
                }
            }
            pair_destroy(pair);
        }
    }
    print_message("albedo 1 to %.1e\n", worst);
    assert_true(worst <= 2e-3);
}

/* F^2 (1 - L) / (1 - F L) of what a mirror's lobe has, with F the mean of 400 steps. */
static void metals_colour_what_comes_back(void **state)
{
    (void)state;
    static const double eta_k[][2] = {{0.2, 3.9}, {1.1, 2.6}, {3.1, 3.3}, {1.5, 1.0}};
    struct pair mirror =
        pair_make("roughconductor:eta=0,k=1,%s,alpha=%g,multiscatter=%s", "distribution=ggx", 1.0);
    /* L, for l(wo) = f's integral. */
    double loss = 4.0 / 3.0 * (1.0 - log(2.0));
    loss = 1.0 - loss;
    for (size_t i = 0; i < COUNT(eta_k); ++i) {
        char options[64];
        double mean = 0.0;
        snprintf(options, sizeof options, "distribution=ggx,eta=%g,k=%g", eta_k[i][0], eta_k[i][1]);
        struct pair metal = pair_make("roughconductor:%s,alpha=%g,multiscatter=%s", options, 1.0);
        for (int k = 0; k < 400; ++k) {
            double cosine = (k + 0.5) / 400.0;
            mean += 2.0 * cosine / 400.0 *
                    (double)brdf_fresnel_conductor_one((float)cosine, (float)eta_k[i][0],
                                                       (float)eta_k[i][1]);
        }
        double expected = mean * mean * (1.0 - loss) / (1.0 - mean * loss);
        double ratio = lobe(metal, 0.6, 0.3) / lobe(mirror, 0.6, 0.3);
        if (!(fabs(ratio - expected) <= 2e-3)) {
            fail_msg("%s: %.5f of the mirror's, expected %.5f", options, ratio, expected);
        }
        pair_destroy(metal);
    }
    pair_destroy(mirror);
}

/* Indices below over those above, and where the angle of total reflection is near one direction. */
static const double ratios[] = {1.0 / 1.5, 1.05, 1.33, 1.5, 2.5};

/* Pairs of a ratio and an alpha, in turns; some of them unless there is time for all. */
static size_t sweep(void)
{
    return COUNT(ratios) * (models_long() ? COUNT(alphas) : 2);
}

/* The worst of a material's albedos, of both sides, from above or from below. */
static double worst_of(const char *text, double eta, double side)
{
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    double worst = 0.0;
    if (brdf_bsdf_create(text, &bsdf, &error)) {
        fail_msg("%s", error.message);
    }
    for (size_t j = 0; j < COUNT(degrees); ++j) {
        worst = fmax(worst, energy_missing(bsdf, text, degrees[j], side, 0.7, eta,
                                           models_long() ? 1 << 18 : 1 << 15, 2e-3));
    }
    brdf_bsdf_destroy(bsdf);
    return worst;
}

/* The second strip: glass, from outside and from inside. */
static void glass_loses_nothing(void **state)
{
    (void)state;
    static const char *const options[] = {
        "distribution=beckmann,masking=correlated", "distribution=beckmann,masking=separable",
        "distribution=ggx,masking=correlated", "distribution=ggx,masking=separable"};
    double worst = 0.0;
    for (size_t k = 0; k < sweep(); ++k) {
        char text[160];
        double ratio = ratios[k % COUNT(ratios)];
        snprintf(text, sizeof text,
                 "roughdielectric:int_ior=%.9g,ext_ior=1,%s,alpha=%g,multiscatter=kullaconty",
                 ratio, options[k % COUNT(options)],
                 alphas[(k % COUNT(ratios) + k / COUNT(ratios)) % COUNT(alphas)]);
        worst = fmax(worst, worst_of(text, ratio, 1.0));
        worst = fmax(worst, worst_of(text, 1.0 / ratio, -1.0));
    }
    print_message("reflection and transmission 1 to %.1e\n", worst);
    assert_true(worst <= 2e-3);
}

/* A white base under any interface, even one with less above it than below. */
static void white_plastic_loses_nothing(void **state)
{
    (void)state;
    static const char *const options[] = {"beckmann", "ggx"};
    double worst = 0.0;
    for (size_t k = 0; k < sweep(); ++k) {
        char text[160];
        double ratio = ratios[k % COUNT(ratios)];
        snprintf(text, sizeof text,
                 "roughplastic:int_ior=%.9g,ext_ior=%.9g,distribution=%s,alpha=%g,"
                 "diffuse_reflectance=1,multiscatter=kullaconty",
                 fmax(ratio, 1.0), fmax(1.0 / ratio, 1.0), options[k % 2],
                 alphas[(k % COUNT(ratios) + k / COUNT(ratios)) % COUNT(alphas)]);
        worst = fmax(worst, worst_of(text, 1.0, 1.0));
    }
    print_message("white plastic 1 to %.1e\n", worst);
    assert_true(worst <= 2e-3);
}

static void blinn_is_refused(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    assert_int_equal(brdf_bsdf_create("roughconductor:distribution=blinn,masking=vcavity,"
                                      "multiscatter=kullaconty",
                                      &bsdf, &error),
                     BRDF_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "beckmann"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mirrors_reflect_everything),
        cmocka_unit_test(metals_colour_what_comes_back),
        cmocka_unit_test(glass_loses_nothing),
        cmocka_unit_test(white_plastic_loses_nothing),
        cmocka_unit_test(blinn_is_refused),
    };
    return cmocka_run_group_tests_name("energy compensation", tests, NULL, NULL);
}
