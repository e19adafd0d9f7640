/*
 * test_fit_published.c - our fits against those of Ngan, Durand and Matusik 2005 to the materials
 * of the same names, by one metric. Needs the data folder; skipped without it.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit.h"
#include "merl_bake.h"
#include "open.h"
#include "support_bsdf.h"
#include "support_place.h"

struct published {
    const char *file;
    const char *model;
    double diffuse[3];
    double specular[3];
    double roughness;
    double f0; /* of cooktorrance and ashikhminshirley, else 0 */
};

/* The published parameters, from the tables that came with the paper. */
static const struct published ward[] = {
    {"gold-metallic-paint", "ward", {.0468, .0203, .00167}, {.279, .163, .0425}, .243, 0},
    {"blue-acrylic", "ward", {.0138, .0326, .0636}, {.00774, .00547, .00339}, .0162, 0},
    {"pink-fabric", "ward", {.235, .0593, .0357}, {.116, .0561, .0345}, .5, 0},
};
static const struct published cooktorrance[] = {
    {"gold-metallic-paint", "ct", {.0657, .0312, .00247}, {.231, .135, .0387}, .241, .663},
    {"blue-acrylic", "ct", {.0143, .033, .0639}, {.0291, .0193, .0118}, .0137, .117},
    {"pink-fabric", "ct", {.223, .0508, .0297}, {.0792, .0417, .0267}, .545, .908},
};
static const struct published ashikhmin[] = {
    {"gold-metallic-paint", "as", {.0532, .024, .000309}, {.205, .12, .0345}, 25.4, .999},
    {"blue-acrylic", "as", {.0143, .0331, .0639}, {.0366, .0241, .0147}, 11600, .0949},
    {"pink-fabric", "as", {.187, .0305, .0162}, {.242, .131, .0854}, 1.96, .999},
};

/* The published lobe as a bsdf of ours, times `factor`; with what is left of it beside the model's
   own colours, since those end at 1. */
static void published_parts(const struct published *from, struct brdf_bsdf **lobe,
                            struct brdf_bsdf **base)
{
    char text[512];
    if (strcmp(from->model, "ward") == 0) {
        snprintf(text, sizeof text,
                 "ward:variant=ward,alpha=%.9g,specular_reflectance=%.9g/%.9g/%.9g,"
                 "diffuse_reflectance=0",
                 from->roughness, from->specular[0], from->specular[1], from->specular[2]);
    } else if (strcmp(from->model, "ct") == 0) {
        /* The index whose reflectance at the normal is F0. */
        double n = (1.0 + sqrt(from->f0)) / (1.0 - sqrt(from->f0));
        snprintf(text, sizeof text,
                 "cooktorrance:denominator=pi,alpha=%.9g,eta=%.9g,k=0,"
                 "specular_reflectance=%.9g/%.9g/%.9g",
                 from->roughness, n, from->specular[0], from->specular[1], from->specular[2]);
    } else {
        snprintf(text, sizeof text,
                 "ashikhminshirley:exponent=%.9g,specular_reflectance=%.9g/%.9g/%.9g,"
                 "diffuse_reflectance=0",
                 from->roughness, from->f0 * from->specular[0], from->f0 * from->specular[1],
                 from->f0 * from->specular[2]);
    }
    *lobe = bsdf_make(text);
    snprintf(text, sizeof text, "diffuse:reflectance=%.9g/%.9g/%.9g", from->diffuse[0],
             from->diffuse[1], from->diffuse[2]);
    *base = bsdf_make(text);
}

/* The least error of the published parameters: their constants are not all known (pi or 4, albedo
   of the lobe or factor of it), so every factor from 1/8 to 8 is allowed to them. */
static double published_error(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                              const struct published *from)
{
    struct brdf_bsdf *parts[2];
    double least = HUGE_VAL;
    published_parts(from, &parts[0], &parts[1]);
    for (int step = -12; step <= 12; ++step) {
        const double weights[2] = {pow(2.0, step / 4.0), 1.0};
        double error = HUGE_VAL;
        assert_int_equal(lab_fit_error(target, options, (const struct brdf_bsdf *const *)parts,
                                       weights, 2, &error, NULL),
                         BRDF_OK);
        least = fmin(least, error);
    }
    brdf_bsdf_destroy(parts[0]);
    brdf_bsdf_destroy(parts[1]);
    return least;
}

static void compare(const struct brdf_bsdf *target, const char *model, int diffuse,
                    const struct published *from)
{
    struct lab_fit_options options = lab_fit_defaults(model);
    struct lab_fit_result fit;
    struct brdf_error error = {BRDF_OK, ""};
    options.starts = 1;
    options.diffuse = diffuse;
    options.evaluations_max = 500;
    if (lab_fit(target, &options, &fit, &error)) {
        fail_msg("%s: %s", model, error.message);
    }
    double theirs = published_error(target, &options, from);
    print_message("%-20s %-38s ours %.4f, published %.4f\n", from->file, model, fit.error, theirs);
    assert_true(fit.error <= theirs);
    lab_fit_free(&fit);
}

/* The file, unpacked into a folder of its own by xz, as a bsdf; NULL if there is none. */
static struct brdf_bsdf *target_open(const char *name)
{
    const char *data = getenv("BRDFCL_DATA") ? getenv("BRDFCL_DATA") : "../shared/data";
    char command[5000];
    struct brdf_bsdf *bsdf = NULL;
    struct place place;
    assert_int_equal(place_make(&place, "measurement.binary"), 0);
    snprintf(command, sizeof command, "xz -dc '%s/merl/%s.binary.xz' > '%s' 2>/dev/null", data,
             name, place.path);
    if (system(command) == 0) {
        assert_int_equal(lab_open(place.path, &bsdf, NULL, NULL), BRDF_OK);
    }
    place_remove(&place);
    return bsdf;
}

static void test_no_worse_than_published(void **state)
{
    (void)state;
    for (int i = 0; i < 3; ++i) {
        struct brdf_bsdf *target = target_open(ward[i].file);
        if (!target) {
            print_message("no data folder with merl/%s.binary.xz (BRDFCL_DATA)\n", ward[i].file);
            skip();
        }
        compare(target, "ward:variant=ward", 0, &ward[i]);
        compare(target, "cooktorrance", 0, &cooktorrance[i]);
        /* Published without the coupling of the two parts that the paper has. */
        compare(target, "ashikhminshirley:diffuse_reflectance=0", 1, &ashikhmin[i]);
        /* No fit with GGX was published then; it is to do what Cook-Torrance does. */
        compare(target, "roughconductor:distribution=ggx", 1, &cooktorrance[i]);
        brdf_bsdf_destroy(target);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_no_worse_than_published)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
