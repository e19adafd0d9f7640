/*
 * test_merl_model.c - the model merl: its lookup, against MERL's published formulas.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "merl_tables.h"

/* MERL's published lookup in double: turn h to +z, take the angles of what becomes of wi. */
static void published_place(brdf_vec3 o, brdf_vec3 i, double place[3])
{
    double wi[3] = {(double)i.x, (double)i.y, (double)i.z};
    double h[3] = {(double)o.x + wi[0], (double)o.y + wi[1], (double)o.z + wi[2]};
    double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
    double theta_h = acos(h[2] / length), phi_h = atan2(h[1], h[0]);
    double c = cos(-phi_h), s = sin(-phi_h);
    double turned[3] = {c * wi[0] - s * wi[1], s * wi[0] + c * wi[1], wi[2]};
    c = cos(-theta_h);
    s = sin(-theta_h);
    double x = c * turned[0] + s * turned[2], z = c * turned[2] - s * turned[0];
    double theta_d = atan2(sqrt(x * x + turned[1] * turned[1]), z);
    double phi_d = atan2(turned[1], x);
    place[0] = sqrt(theta_h / (0.5 * pi) * 90.0 * 90.0);
    place[1] = theta_d / (0.5 * pi) * 90.0;
    place[2] = (phi_d < 0.0 ? phi_d + pi : phi_d) / pi * 180.0;
}

/* Of half and difference angles, the published lookup finds the same again. */
static void angles_lead_to_their_directions(void **state)
{
    (void)state;
    struct brdfcl_random random = {3};
    for (int i = 0; i < 2000; ++i) {
        double theta_h = 1.2 * (double)brdfcl_random_uniform(&random) + 0.01,
               phi_h = 6.0 * (double)brdfcl_random_uniform(&random);
        double theta_d = 1.2 * (double)brdfcl_random_uniform(&random) + 0.01;
        double phi_d = pi * (0.01 + 0.98 * (double)brdfcl_random_uniform(&random));
        double o[3], w[3], place[3];
        int above = brdf_merl_directions_at(theta_h, phi_h, theta_d, phi_d, o, w);
        assert_int_equal(above, o[2] > 0.0 && w[2] > 0.0);
        assert_true(fabs(o[0] * w[0] + o[1] * w[1] + o[2] * w[2] - cos(2.0 * theta_d)) < 1e-12);
        published_place(brdf_vec3_make((float)o[0], (float)o[1], (float)o[2]),
                        brdf_vec3_make((float)w[0], (float)w[1], (float)w[2]), place);
        assert_true(fabs(place[0] * place[0] / 8100.0 - theta_h / (0.5 * pi)) < 1e-5);
        assert_true(fabs(place[1] / 90.0 - theta_d / (0.5 * pi)) < 1e-5);
        assert_true(fabs(place[2] / 180.0 - phi_d / pi) < 1e-4);
        double turn = atan2(o[1] + w[1], o[0] + w[0]) - phi_h;
        assert_true(fabs(sin(0.5 * turn)) < 1e-9);
    }
}

/* Two directions close to each other and to the normal now and then: small angles are hardest. */
static void random_pair(struct brdfcl_random *random, int number, brdf_vec3 *wo, brdf_vec3 *wi)
{
    float near_normal = number % 4 == 1 ? 0.01f : 1.0f;
    float near_mirror = number % 4 >= 2 ? 0.02f : 1.0f;
    *wo = random_above(random);
    *wi = random_above(random);
    wo->z /= near_normal;
    if (near_mirror < 1.0f) {
        wi->x = -wo->x + near_mirror * wi->x;
        wi->y = -wo->y + near_mirror * wi->y;
        wi->z = wo->z;
    } else {
        wi->z /= near_normal;
    }
    *wo = brdf_normalize(*wo);
    *wi = brdf_normalize(*wi);
}

static void nearest_is_the_published_lookup(void **state)
{
    struct baked *baked = *state;
    struct brdfcl_random random = {1};
    int compared = 0;
    for (int i = 0; i < 200000; ++i) {
        brdf_vec3 wo, wi;
        double place[3];
        int clear = 1; /* of the edges of bins, where rounding decides */
        random_pair(&random, i, &wo, &wi);
        published_place(wo, wi, place);
        for (int k = 0; k < 3; ++k) {
            double edge = fabs(place[k] - floor(place[k] + 0.5));
            clear = clear && edge > 0.01;
        }
        if (!clear) {
            continue;
        }
        ++compared;
        brdf_rgb f = brdf_merl_eval(material(BRDF_MERL_NEAREST), wo, wi, baked->numbers);
        if (f.r != (float)floor(place[0]) || f.g != (float)floor(place[1]) ||
            f.b != (float)floor(place[2])) {
            fail_msg("pair %d: bin %g %g %g instead of %g %g %g", i, (double)f.r, (double)f.g,
                     (double)f.b, place[0], place[1], place[2]);
        }
    }
    assert_true(compared > 180000);
}

/* Both ways of looking up give a bin's own value at its centre. */
static void centres_have_the_values_of_the_file(void **state)
{
    struct baked *baked = *state;
    for (int bin = 0; bin < 90 * 90 * 180; bin += 101) {
        double o[3], i[3];
        int h = bin / (180 * 90), d = bin / 180 % 90, p = bin % 180;
        if (!brdf_merl_directions(h, d, p, o, i)) {
            continue;
        }
        brdf_vec3 wo = brdf_vec3_make((float)o[0], (float)o[1], (float)o[2]);
        brdf_vec3 wi = brdf_vec3_make((float)i[0], (float)i[1], (float)i[2]);
        brdf_rgb nearest = brdf_merl_eval(material(BRDF_MERL_NEAREST), wo, wi, baked->numbers);
        assert_float_equal(nearest.r, (float)h, 0.0f);
        assert_float_equal(nearest.g, (float)d, 0.0f);
        assert_float_equal(nearest.b, (float)p, 0.0f);
        brdf_rgb linear = brdf_merl_eval(material(BRDF_MERL_LINEAR), wo, wi, baked->numbers);
        assert_float_equal(linear.r, (float)h, 0.01f);
        assert_float_equal(linear.g, (float)d, 0.01f);
        if (p > 0 && p < 179) { /* the numbers jump where the half turn closes */
            assert_float_equal(linear.b, (float)p, 0.05f);
        }
    }
}

static void interpolation_beats_the_nearest_bin(void **state)
{
    struct baked *baked = *state;
    double alpha = glossy_alpha, error[2] = {0.0, 0.0};
    struct brdfcl_random random = {2};
    for (int i = 0; i < 100000; ++i) {
        brdf_vec3 wo = random_above(&random), wi = random_above(&random);
        double o[3] = {(double)wo.x, (double)wo.y, (double)wo.z};
        double w[3] = {(double)wi.x, (double)wi.y, (double)wi.z}, truth[3];
        if (wo.z < 0.1f || wi.z < 0.1f) {
            continue;
        }
        test_glossy(o, w, truth, &alpha);
        for (int kind = 0; kind < 2; ++kind) {
            brdf_rgb f = brdf_merl_eval(material(kind), wo, wi, baked->glossy);
            double off = ((double)f.g - truth[1]) / truth[1];
            error[kind] += off * off / 100000.0;
        }
    }
    assert_true(sqrt(error[BRDF_MERL_LINEAR]) < 0.004);
    assert_true(sqrt(error[BRDF_MERL_LINEAR]) < 0.2 * sqrt(error[BRDF_MERL_NEAREST]));
}

static void values_are_reciprocal_and_nothing_is_below(void **state)
{
    struct baked *baked = *state;
    struct brdfcl_random random = {3};
    for (int i = 0; i < 200000; ++i) {
        brdf_vec3 wo, wi;
        random_pair(&random, i, &wo, &wi);
        for (int kind = 0; kind < 2; ++kind) {
            brdf_rgb f = brdf_merl_eval(material(kind), wo, wi, baked->glossy);
            brdf_rgb g = brdf_merl_eval(material(kind), wi, wo, baked->glossy);
            assert_memory_equal(&f, &g, sizeof f);
            assert_true(isfinite(f.r) && f.r > 0.0f);
        }
        brdf_vec3 below = brdf_vec3_make(wi.x, wi.y, -wi.z);
        brdf_rgb f = brdf_merl_eval(material(0), wo, below, baked->glossy);
        assert_true(f.r == 0.0f && f.g == 0.0f && f.b == 0.0f);
        assert_true(brdf_merl_pdf(material(0), wo, below, baked->glossy) == 0.0f);
        assert_true(brdf_merl_pdf(material(0), below, wi, baked->glossy) == 0.0f);
        assert_true(brdf_merl_sample(material(0), below, random_cube(&random), baked->glossy).pdf ==
                    0.0f);
    }
}

/* The cases that end in 0 / 0 where one is careless. */
static void degenerate_pairs_are_finite(void **state)
{
    struct baked *baked = *state;
    const brdf_vec3 cases[] = {{0.0f, 0.0f, 1.0f},  {1.0f, 0.0f, 0.0f},   {-1.0f, 0.0f, 0.0f},
                               {0.0f, 0.0f, -1.0f}, {1.0f, 0.0f, 1e-7f},  {-1.0f, 0.0f, 1e-7f},
                               {0.6f, 0.0f, 0.8f},  {1e-20f, 0.0f, 1.0f}, {-0.0f, -0.0f, 1.0f}};
    enum { COUNT = sizeof cases / sizeof cases[0] };
    for (int i = 0; i < COUNT * COUNT; ++i) {
        brdf_vec3 wo = cases[i / COUNT], wi = cases[i % COUNT];
        for (int kind = 0; kind < 2; ++kind) {
            assert_true(isfinite(brdf_merl_eval(material(kind), wo, wi, baked->glossy).r));
        }
        assert_true(isfinite(brdf_merl_pdf(material(0), wo, wi, baked->glossy)));
        for (int k = 0; k < 8; ++k) {
            brdf_vec3 u = brdf_vec3_make(k & 1 ? 0.99999994f : 0.0f, k & 2 ? 0.99999994f : 0.0f,
                                         k & 4 ? 0.99999994f : 0.0f);
            struct brdf_sample s = brdf_merl_sample(material(0), wo, u, baked->glossy);
            assert_true(isfinite(s.wi.x) && isfinite(s.weight.r) && isfinite(s.pdf));
            assert_true(s.pdf >= 0.0f && s.weight.r >= 0.0f);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_lead_to_their_directions),
        cmocka_unit_test(nearest_is_the_published_lookup),
        cmocka_unit_test(centres_have_the_values_of_the_file),
        cmocka_unit_test(interpolation_beats_the_nearest_bin),
        cmocka_unit_test(values_are_reciprocal_and_nothing_is_below),
        cmocka_unit_test(degenerate_pairs_are_finite),
    };
    return cmocka_run_group_tests(tests, tables_make, tables_free);
}
