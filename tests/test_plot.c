/*
 * test_plot.c - what a plot says is where the plot says it: scales, polar places, curves, sections.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "angle.h"
#include "curve.h"
#include "lit_sphere.h"
#include "polar.h"
#include "section.h"
#include "support_bsdf.h"

static void assert_close(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance)) {
        fail_msg("%.12g is not %.12g", value, expected);
    }
}

static struct lab_section section_of(const struct brdf_bsdf *bsdf, double degrees)
{
    struct lab_section section = {bsdf, 0.0, degrees * pi / 180.0, LAB_CHANNEL_LUMINANCE};
    return section;
}

static void scales_have_round_ticks(void **state)
{
    (void)state;
    struct plot_scale linear = plot_scale_linear(8.1, 4);
    struct plot_scale decades = plot_scale_decades(1e-9, 700.0, 5);
    double value = 0.0;
    char text[32];
    assert_int_equal(plot_scale_tick(&linear, 1, &value), 1);
    assert_close(value, 5.0, 1e-12);
    assert_int_equal(plot_scale_tick(&linear, 2, &value), 0);
    assert_close(plot_scale_at(&linear, 8.1 * 1.03 / 2.0), 0.5, 1e-12);
    assert_close(decades.low, 1e-2, 1e-12);
    assert_close(decades.high, 1e3, 1e-9);
    assert_close(plot_scale_at(&decades, 1.0), 0.4, 1e-12);
    assert_close(plot_scale_at(&decades, 0.0), -1.0, 0.0);
    plot_scale_label(&linear, -0.25, text, sizeof text);
    assert_string_equal(text, "\xe2\x88\x92"
                              "0.25");
    plot_scale_label(&linear, 20000.0, text, sizeof text);
    assert_string_equal(text, "2\xc2\xb7"
                              "10^{4}");
    plot_scale_label(&decades, 1e-5, text, sizeof text);
    assert_string_equal(text, "10^{\xe2\x88\x92"
                              "5}");
}

/* A Lambertian surface: f cos at 60 degrees is half of what it is along the normal, and the lobe is
   a circle through the centre. */
static void a_known_lobe_has_its_place(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("diffuse:reflectance=0.6");
    struct lab_section section = section_of(bsdf, 30.0);
    struct plot_box cell = {100.0, 50.0, 300.0, 200.0};
    struct polar polar = polar_within(cell, 0, plot_scale_fixed(0.0, 0.6 / pi, 0.05));
    assert_close(lab_section_peak(&section, 1, lab_section_low(), lab_section_high(0)), 0.6 / pi,
                 1e-7);
    assert_close(polar.centre.x, 250.0, 1e-9);
    struct lab_point at = polar_at(&polar, pi / 3.0, lab_section_lobe(&section, pi / 3.0));
    assert_close(at.x, 250.0 + 0.5 * polar.radius * sin(pi / 3.0), 1e-4);
    assert_close(at.y, polar.centre.y - 0.25 * polar.radius, 1e-4);
    for (double theta = -1.5; theta < 1.5; theta += 0.1) {
        at = polar_at(&polar, theta, lab_section_lobe(&section, theta));
        double up = polar.centre.y - 0.5 * polar.radius - at.y;
        assert_close(hypot(at.x - polar.centre.x, up), 0.5 * polar.radius, 1e-4);
    }
    brdf_bsdf_destroy(bsdf);
}

/* The peak of a lobe that is far narrower than the grid is found, and mirrors send light to the
   right. */
static void narrow_peaks_are_found(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("phong:exponent=100000,diffuse_reflectance=0");
    struct lab_section section = section_of(bsdf, 37.123);
    double peak = lab_section_peak(&section, 0, lab_section_low(), lab_section_high(0));
    double f = lab_section_f(&section, section.incidence);
    assert_true(f > 1e3);
    assert_close(peak / f, 1.0, 1e-3);
    brdf_bsdf_destroy(bsdf);
}

/* Snell's law and Fresnel's equations at 40 degrees into glass of index 1.5. */
static void delta_lobes_have_direction_and_power(void **state)
{
    (void)state;
    struct brdf_bsdf *bsdf = bsdf_make("dielectric:int_ior=1.5,ext_ior=1");
    struct lab_section section = section_of(bsdf, 40.0);
    double in = section.incidence;
    double refracted = asin(sin(in) / 1.5);
    double s = sin(in - refracted) / sin(in + refracted);
    double p = tan(in - refracted) / tan(in + refracted);
    double reflected = 0.5 * (s * s + p * p);
    struct lab_delta delta[LAB_SECTION_DELTAS];
    int count = lab_section_deltas(&section, delta);
    assert_int_equal(count, 2);
    for (int i = 0; i < count; ++i) {
        int through = delta[i].theta > pi / 2.0;
        assert_close(delta[i].theta, through ? pi - refracted : in, 1e-5);
        assert_close(delta[i].power, through ? 1.0 - reflected : reflected, 1e-5);
    }
    brdf_bsdf_destroy(bsdf);
}

static void anisotropy_is_seen_where_it_is(void **state)
{
    (void)state;
    static const struct {
        const char *description;
        int anisotropic;
    } cases[] = {{"ward:alpha=0.2", 0},
                 {"ward:alpha_u=0.1,alpha_v=0.2", 1},
                 {"roughconductor:alpha_u=0.3,alpha_v=0.1", 1},
                 {"diffuse", 0}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdf_bsdf *bsdf = bsdf_make(cases[i].description);
        assert_int_equal(lab_anisotropic(bsdf), cases[i].anisotropic);
        brdf_bsdf_destroy(bsdf);
    }
}

static struct lab_point circle(double t, const void *data)
{
    const double *radius = data;
    struct lab_point point = {*radius * cos(t), *radius * sin(t)};
    return point;
}

/* No chord of the polygon is farther from the circle than the tolerance allows, nor are there many
   more of them than that takes. */
static void curves_are_as_good_as_asked(void **state)
{
    (void)state;
    const double radius = 1000.0, tolerance = 0.01;
    const double knot[2] = {-1.0, 0.123};
    struct lab_curve curve;
    struct brdf_error error;
    assert_int_equal(lab_curve_trace(circle, &radius, 0.0, pi, knot, 2, tolerance, &curve, &error),
                     BRDF_OK);
    for (size_t i = 1; i < curve.count; ++i) {
        struct lab_point a = curve.point[i - 1], b = curve.point[i];
        double sag = radius - hypot(0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
        assert_true(sag < 2.0 * tolerance && sag >= -1e-9);
    }
    double longest = 2.0 * sqrt(2.0 * radius * tolerance);
    assert_true((double)curve.count < 3.0 * pi * radius / longest);
    lab_curve_free(&curve);
    assert_null(curve.point);
}

/* Twice the albedo, twice the light; above, where the key is, it is brighter than below; and no
   number is out of range. */
static void spheres_are_lit_from_above(void **state)
{
    (void)state;
    enum { SIZE = 48 };
    static float pale[SIZE * SIZE * 3], dark[SIZE * SIZE * 3];
    struct brdf_bsdf *bsdf = bsdf_make("diffuse:reflectance=0.2");
    struct brdf_error error;
    assert_int_equal(lab_lit_sphere(bsdf, SIZE, pale, &error), BRDF_OK);
    brdf_bsdf_destroy(bsdf);
    bsdf = bsdf_make("diffuse:reflectance=0.1");
    assert_int_equal(lab_lit_sphere(bsdf, SIZE, dark, &error), BRDF_OK);
    brdf_bsdf_destroy(bsdf);
    for (int i = 0; i < SIZE * SIZE * 3; ++i) {
        assert_true(pale[i] >= 0.0f && pale[i] <= 1.0f);
        assert_close((double)pale[i], 2.0 * (double)dark[i], 1e-5);
    }
    size_t middle = 3 * SIZE / 2;
    assert_true(pale[4 * SIZE * 3 + middle] > 1.5f * pale[(SIZE - 4) * SIZE * 3 + middle]);
    assert_true(pale[0] == 0.0f); /* the corner is off the sphere */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scales_have_round_ticks),
        cmocka_unit_test(a_known_lobe_has_its_place),
        cmocka_unit_test(narrow_peaks_are_found),
        cmocka_unit_test(delta_lobes_have_direction_and_power),
        cmocka_unit_test(anisotropy_is_seen_where_it_is),
        cmocka_unit_test(curves_are_as_good_as_asked),
        cmocka_unit_test(spheres_are_lit_from_above),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
