/*
 * test_models_wood.c - wood: against its formula in double precision, with vectors refracted as in
 * the paper, against closed forms of its fibres' highlight, and against a coat's own model.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <brdf/fiber.h>

#include "angle.h"
#include "check_cases.h"
#include "random_vectors.h"
#include "support_bsdf.h"
#include "support_energy.h"
#include "support_models.h"

static int differs(double a, double b, double tolerance)
{
    return !(fabs(a - b) <= tolerance * fmax(fabs(a), fabs(b)) + 1e-6);
}

/* 1 - F of a smooth interface [Fresnel]. */
static double passes(double cosine, double eta)
{
    double inside = sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    double s = (cosine - eta * inside) / (cosine + eta * inside);
    double p = (eta * cosine - inside) / (eta * cosine + inside);
    return 1.0 - 0.5 * (s * s + p * p);
}

/* Inclination to the plane across the unit axis, after refraction. */
static double inclination(brdf_vec3 w, const double axis[3], double eta)
{
    double x = (double)w.x / eta;
    double y = (double)w.y / eta;
    double z = sqrt((1.0 - 1.0 / (eta * eta)) + pow((double)w.z / eta, 2.0));
    return asin(fmin(fmax(x * axis[0] + y * axis[1] + z * axis[2], -1.0), 1.0));
}

/* The part below the coat, with white fibres over nothing, or with a diffuse white. */
static double below(brdf_vec3 wo, brdf_vec3 wi, const double axis[3], double eta, double beta,
                    int fibers)
{
    double through = passes((double)wo.z, eta) * passes((double)wi.z, eta);
    double o = inclination(wo, axis, eta);
    double i = inclination(wi, axis, eta);
    double half = (o + i) / beta;
    double gauss = exp(-0.5 * half * half) / (beta * sqrt(2.0 * pi));
    double lobe = gauss / (2.0 * eta) / pow(cos(0.5 * (o - i)), 2.0);
    return through * (fibers ? lobe : 1.0 / pi);
}

static void as_the_formula_has_it(void **state)
{
    (void)state;
    /* fiber_axis = (axis + 1) / 2; without a direction it is that of the tangent */
    static const struct {
        const char *text;
        double axis[3];
        double eta;
        double beta;
    } rows[] = {
        {"fiber_axis=0.8/0.9/0.5,eta=1.5,beta=0.3", {0.6, 0.8, 0.0}, 1.5, 0.3},
        {"fiber_axis=0.642857143/0.071428571/0.714285714,eta=1.33,beta=0.15",
         {2.0 / 7.0, -6.0 / 7.0, 3.0 / 7.0},
         1.33,
         0.15},
        {"fiber_axis=0.5/0.5/0.5,eta=1,beta=1", {1.0, 0.0, 0.0}, 1.0, 1.0},
        {"fiber_axis=0.5/0.5/0,eta=2.5,beta=0.5", {0.0, 0.0, -1.0}, 2.5, 0.5},
    };
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
        char text[256];
        struct brdf_bsdf *bsdf[2];
        for (int fibers = 0; fibers < 2; ++fibers) {
            snprintf(text, sizeof text,
                     "wood:%s,specular_reflectance=0,fiber_reflectance=%d,diffuse_reflectance=%d",
                     rows[k].text, fibers, !fibers);
            bsdf[fibers] = bsdf_make(text);
        }
        double length = sqrt(rows[k].axis[0] * rows[k].axis[0] + rows[k].axis[1] * rows[k].axis[1] +
                             rows[k].axis[2] * rows[k].axis[2]);
        double axis[3];
        for (int i = 0; i < 3; ++i) {
            axis[i] = rows[k].axis[i] / length;
        }
        struct brdfcl_random random = {31};
        for (int i = 0; i < 10000; ++i) {
            brdf_vec3 wo = random_above(&random);
            brdf_vec3 wi = random_above(&random);
            for (int fibers = 0; fibers < 2; ++fibers) {
                double f = (double)brdf_eval(bsdf[fibers], wo, wi).g;
                double known = below(wo, wi, axis, rows[k].eta, rows[k].beta, fibers);
                if (differs(f, known, 2e-4)) {
                    fail_msg("%s: %.7g, known %.7g; wo.z = %g, wi.z = %g", rows[k].text, f, known,
                             (double)wo.z, (double)wi.z);
                }
            }
        }
        brdf_bsdf_destroy(bsdf[0]);
        brdf_bsdf_destroy(bsdf[1]);
    }
}

/* Divided by beta, not multiplied: then its integral does not depend on beta. */
static void gaussian_is_normalised(void **state)
{
    (void)state;
    static const float betas[] = {0.01f, 0.05f, 0.2f, 1.0f};
    for (size_t k = 0; k < sizeof betas / sizeof betas[0]; ++k) {
        double sum = 0.0;
        double step = (double)betas[k] / 50.0;
        for (int i = -500; i <= 500; ++i) {
            sum += step * (double)brdf_fiber_gauss(betas[k], (float)(i * step));
        }
        if (!(fabs(sum - 1.0) <= 1e-5)) {
            fail_msg("beta = %g: integral %.7f", (double)betas[k], sum);
        }
    }
}

/* Samples of a narrow highlight lie on the cone, on both sides of the plane of light and fibre. */
static void samples_lie_on_the_cone(void **state)
{
    (void)state;
    static const double axis[3] = {0.96, 0.0, 0.28};
    struct brdf_bsdf *bsdf =
        bsdf_make("wood:fiber_axis=0.98/0.5/0.64,beta=0.01,fiber_reflectance=1,"
                  "diffuse_reflectance=0,specular_reflectance=0,eta=1.5");
    brdf_vec3 wo = energy_direction(0.6, 2.5);
    double cone = -inclination(wo, axis, 1.5);
    int left = 0;
    int count = 0;
    for (size_t i = 0; i < 1000; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, 1000));
        if (s.pdf > 0.0f) {
            double psi = inclination(s.wi, axis, 1.5);
            if (!(fabs(psi - cone) < 5.0 * 0.01)) {
                fail_msg("inclination %.4f, that of the cone %.4f", psi, cone);
            }
            ++count;
            left += s.wi.y > 0.0f;
        }
    }
    assert_true(count > 990);
    assert_in_range(left, 450, 550);
    brdf_bsdf_destroy(bsdf);
}

/*
 * Lying fibres with a narrow highlight. Without a step of the index the cone is whole: all light
 * comes back, from everywhere. With it, light from the normal is spread over the plane across the
 * fibres, of which the coat lets through T: T(1) times the integral of T over the sine.
 */
static void lying_fibers_return_their_reflectance(void **state)
{
    (void)state;
    static const double etas[] = {1.0, 1.2, 1.5, 2.0};
    for (size_t k = 0; k < sizeof etas / sizeof etas[0]; ++k) {
        double mean = 0.0;
        for (int i = 0; i < 4000; ++i) {
            double sine = (i + 0.5) / 4000.0;
            mean += passes(sqrt(1.0 - sine * sine), etas[k]) / 4000.0;
        }
        char text[192];
        snprintf(text, sizeof text,
                 "wood:fiber_axis=0.8/0.9/0.5,beta=0.01,fiber_reflectance=0.7,"
                 "diffuse_reflectance=0,specular_reflectance=0,eta=%g",
                 etas[k]);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        for (int i = 0; i < (k == 0 ? ENERGY_COSINES : 1); ++i) {
            double cosine = energy_cosines[ENERGY_COSINES - 1 - i];
            double known = 0.7 * passes(cosine, etas[k]) * mean;
            double found = energy_by_sampling(bsdf, energy_direction(cosine, 0.3)).value;
            if (!(fabs(found - known) <= 1e-3)) {
                fail_msg("%s, cos = %g: %.5f, known %.5f", text, cosine, found, known);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/*
 * Only inclinations and arcs that get out are sampled, so a weight is the arc's length times what
 * changes slowly along it. With no step of the index and along the fibres the blur counts too: 2
 * pi.
 */
static void weights_are_bounded(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double most;
    } rows[] = {{"eta=1,beta=0.05", 6.3}, {"eta=1.5,beta=0.2", 1.6}, {"eta=2.5,beta=0.5", 1.6}};
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; ++k) {
        char text[192];
        snprintf(text, sizeof text,
                 "wood:%s,fiber_reflectance=1,diffuse_reflectance=0,specular_reflectance=0",
                 rows[k].text);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        struct brdfcl_random random = {32};
        for (size_t i = 0; i < 20000; ++i) {
            struct brdf_sample s =
                brdf_sample(bsdf, random_above(&random), models_even_point(i, 20000));
            if (!((double)s.weight.g <= rows[k].most)) {
                fail_msg("%s: a weight of %g", text, (double)s.weight.g);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* Without fibres and base, what is left is the reflection of a rough dielectric. */
static void coat_is_a_rough_dielectric(void **state)
{
    (void)state;
    struct brdf_bsdf *coat =
        bsdf_make("wood:distribution=ggx,alpha=0.3,eta=1.6,fiber_reflectance=0,"
                  "diffuse_reflectance=0");
    struct brdf_bsdf *glass = bsdf_make(
        "roughdielectric:distribution=ggx,masking=correlated,alpha=0.3,int_ior=1.6,ext_ior=1");
    struct brdfcl_random random = {33};
    for (int i = 0; i < 10000; ++i) {
        brdf_vec3 wo = random_above(&random);
        brdf_vec3 wi = random_above(&random);
        double f = (double)brdf_eval(coat, wo, wi).g;
        double g = (double)brdf_eval(glass, wo, wi).g;
        if (differs(f, g, 1e-4)) {
            fail_msg("%.7g, of glass %.7g", f, g);
        }
    }
    brdf_bsdf_destroy(coat);
    brdf_bsdf_destroy(glass);
}

/* The same bits there and back; an axis and its opposite are one to rounding. */
static void reciprocal_and_without_arrow(void **state)
{
    (void)state;
    struct brdf_bsdf *one = bsdf_make("wood:fiber_axis=0.9/0.3/0.6,fiber_reflectance=0.1/0.5/0.9");
    struct brdf_bsdf *other =
        bsdf_make("wood:fiber_axis=0.1/0.7/0.4,fiber_reflectance=0.1/0.5/0.9");
    struct brdfcl_random random = {34};
    for (int i = 0; i < 10000; ++i) {
        brdf_vec3 wo = random_above(&random);
        brdf_vec3 wi = random_above(&random);
        brdf_rgb there = brdf_eval(one, wo, wi);
        brdf_rgb back = brdf_eval(one, wi, wo);
        assert_true(there.r == back.r && there.g == back.g && there.b == back.b);
        assert_false(differs((double)there.g, (double)brdf_eval(other, wo, wi).g, 1e-4));
    }
    brdf_bsdf_destroy(one);
    brdf_bsdf_destroy(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_the_formula_has_it),
        cmocka_unit_test(gaussian_is_normalised),
        cmocka_unit_test(samples_lie_on_the_cone),
        cmocka_unit_test(lying_fibers_return_their_reflectance),
        cmocka_unit_test(weights_are_bounded),
        cmocka_unit_test(coat_is_a_rough_dielectric),
        cmocka_unit_test(reciprocal_and_without_arrow),
    };
    return cmocka_run_group_tests_name("wood", tests, NULL, NULL);
}
