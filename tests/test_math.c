/*
 * test_math.c - the elementary functions keep the error bounds that their headers state, and their
 * exact values, symmetries and promises at the edge of the domain.
 */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/math.h>

#include "angle.h"
#include "math_functions.h"

#define COUNT 2000000u

/* The distance from `value` to `exact` in units in the last place of the float nearest to it. */
static double ulps(float value, double exact)
{
    int exponent;
    frexp(fmax(fabs((double)(float)exact), (double)FLT_MIN), &exponent);
    return fabs((double)value - exact) / ldexp(1.0, exponent - FLT_MANT_DIG);
}

struct worst {
    double error;
    float a, b, value;
    double exact;
    uint32_t tried;
};

static void worst_update(struct worst *worst, const struct math_function *f, float a, float b)
{
    double exact = f->reference((double)a, (double)b);
    if (!(fabs(exact) <= (double)FLT_MAX) || (exact != 0.0 && fabs(exact) < (double)FLT_MIN)) {
        return; /* no float holds it: the promise for such results is another one, tested below */
    }
    float value = f->ours(a, b);
    double error = ulps(value, exact);
    worst->tried += 1;
    if (!(error <= worst->error)) {
        *worst = (struct worst){error, a, b, value, exact, worst->tried};
    }
}

static void worst_check(const struct worst *worst, const struct math_function *f)
{
    print_message("%-8s %.3f ulp (bound %g) at a = %.9g, b = %.9g\n", f->name, worst->error, f->ulp,
                  (double)worst->a, (double)worst->b);
    if (!(worst->error <= f->ulp)) {
        fail_msg("%s(%.9g, %.9g) is %.9g, should be %.9g: %.3f ulp off, %g are allowed", f->name,
                 (double)worst->a, (double)worst->b, (double)worst->value, worst->exact,
                 worst->error, f->ulp);
    }
}

static void errors_are_within_their_bounds(void **state)
{
    (void)state;
    for (const struct math_function *f = math_functions; f->name; ++f) {
        struct worst worst = {0};
        for (uint32_t i = 0; i < COUNT; ++i) {
            struct math_arguments arguments = math_arguments_make(f, i, COUNT);
            worst_update(&worst, f, arguments.a, arguments.b);
        }
        assert_true(worst.tried > COUNT / 2);
        worst_check(&worst, f);
    }
}

static const struct math_function *function_named(const char *name)
{
    const struct math_function *f = math_functions;
    while (f->name && strcmp(f->name, name) != 0) {
        ++f;
    }
    assert_non_null(f->name);
    return f;
}

/* The floats around k pi/2: there one of sine and cosine is as small as it ever gets. */
static void reduction_is_exact_near_multiples_of_half_pi(void **state)
{
    static const char *const names[] = {"sin", "cos"};
    (void)state;
    for (int i = 0; i < 2; ++i) {
        const struct math_function *f = function_named(names[i]);
        struct worst worst = {0};
        for (int k = 1; k <= 5215; ++k) {
            int middle = brdf_bits((float)(k * 1.57079632679489661923));
            for (int bits = middle - 20; bits <= middle + 20; ++bits) {
                worst_update(&worst, f, brdf_from_bits(bits), 0.0f);
            }
        }
        worst_check(&worst, f);
    }
}

static const float extremes[] = {0.0f,
                                 FLT_MIN,
                                 1e-45f,
                                 1e-30f,
                                 1e-8f,
                                 0.5f,
                                 1.0f,
                                 1.5f,
                                 2.0f,
                                 87.34f,
                                 88.73f,
                                 1e4f,
                                 99999.0f,
                                 1e9f,
                                 3e10f,
                                 1e20f,
                                 1e30f,
                                 FLT_MAX,
                                 BRDF_ONE_MINUS_ULP};
#define EXTREMES (sizeof extremes / sizeof *extremes)

static void assert_finite_for_extremes(const struct math_function *f)
{
    int turns = strstr(f->name, "_2pi") != NULL;
    for (size_t i = 0; i < 4 * EXTREMES * EXTREMES; ++i) {
        float a = extremes[i / 4 / EXTREMES] * (i & 1 ? -1.0f : 1.0f);
        float b = extremes[i / 4 % EXTREMES] * (i & 2 ? -1.0f : 1.0f);
        if (turns && fabsf(a) > 1048576.0f) {
            continue; /* outside the domain */
        }
        if (!isfinite(f->ours(a, b))) {
            fail_msg("%s(%g, %g) is not finite", f->name, (double)a, (double)b);
        }
    }
}

static void results_are_finite_for_extreme_arguments(void **state)
{
    (void)state;
    for (const struct math_function *f = math_functions; f->name; ++f) {
        assert_finite_for_extremes(f);
    }
}

/* On the interval the function changes by far more than its error from one of these to the next. */
static void assert_rises(const char *name, float low, float high, float sign)
{
    const struct math_function *f = function_named(name);
    float before = -FLT_MAX;
    for (int i = 0; i <= 4096; ++i) {
        float a = low + (high - low) * ((float)i / 4096.0f);
        float value = sign * f->ours(a, 0.0f);
        if (!(value > before)) {
            fail_msg("%s does not %s at %.9g", name, sign > 0.0f ? "rise" : "fall", (double)a);
        }
        before = value;
    }
}

static void monotone_functions_are_monotone(void **state)
{
    (void)state;
    assert_rises("exp", -80.0f, 80.0f, 1.0f);
    assert_rises("log", 1e-4f, 100.0f, 1.0f);
    assert_rises("erf", -3.0f, 3.0f, 1.0f);
    assert_rises("erfinv", -1.0f, 1.0f, 1.0f);
    assert_rises("asin", -1.0f, 1.0f, 1.0f);
    assert_rises("acos", -1.0f, 1.0f, -1.0f);
    assert_rises("sin", -1.5f, 1.5f, 1.0f);
    assert_rises("cos", 0.01f, 3.13f, -1.0f);
}

static void odd_functions_are_odd_to_the_bit(void **state)
{
    static const char *const names[] = {"sin_2pi", "sin", "asin", "atan2", "erf", "erfinv"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        const struct math_function *f = function_named(names[i]);
        for (uint32_t k = 0; k < 20000; ++k) {
            struct math_arguments x = math_arguments_make(f, k, 20000);
            assert_int_equal(brdf_bits(f->ours(-x.a, x.b)), brdf_bits(-f->ours(x.a, x.b)));
        }
    }
}

static void sine_and_cosine_lie_on_the_circle(void **state)
{
    (void)state;
    for (int i = -40000; i <= 40000; ++i) {
        struct brdf_sincos turn = brdf_sincos_2pi((float)i / 20011.0f);
        struct brdf_sincos radians = brdf_sincos((float)i / 5.0f);
        assert_true(fabsf(turn.sin * turn.sin + turn.cos * turn.cos - 1.0f) < 4e-7f);
        assert_true(fabsf(radians.sin * radians.sin + radians.cos * radians.cos - 1.0f) < 4e-7f);
    }
}

static void quarter_turns_are_exact(void **state)
{
    static const float sines[] = {0.0f, 1.0f, 0.0f, -1.0f};
    (void)state;
    for (int i = -4000; i <= 4000; ++i) {
        struct brdf_sincos turn = brdf_sincos_2pi((float)i * 0.25f);
        assert_true(turn.sin == sines[(unsigned)i & 3u]);
        assert_true(turn.cos == sines[(unsigned)(i + 1) & 3u]);
    }
}

/* Whole turns added to a fraction of 12 bits stay exact in a float, so the bits must not change. */
static void whole_turns_change_nothing(void **state)
{
    (void)state;
    for (int i = 0; i < 4096; ++i) {
        struct brdf_sincos here = brdf_sincos_2pi((float)i / 4096.0f);
        struct brdf_sincos there = brdf_sincos_2pi((float)i / 4096.0f - 77.0f);
        assert_int_equal(brdf_bits(here.sin), brdf_bits(there.sin));
        assert_int_equal(brdf_bits(here.cos), brdf_bits(there.cos));
    }
}

static void special_values_of_exp_log_and_pow(void **state)
{
    (void)state;
    assert_true(brdf_exp(0.0f) == 1.0f);
    assert_true(brdf_exp(-87.4f) == 0.0f);
    assert_true(brdf_exp(-FLT_MAX) == 0.0f);
    assert_true(brdf_exp(FLT_MAX) == brdf_exp(88.7228317f));
    assert_true(brdf_exp(FLT_MAX) > 3.402e38f);
    assert_true(brdf_log(1.0f) == 0.0f);
    assert_true(brdf_log(0.0f) == brdf_log(FLT_MIN));
    assert_true(brdf_log(-1.0f) == brdf_log(FLT_MIN));
    assert_true(brdf_pow(0.0f, 0.0f) == 1.0f);
    assert_true(brdf_pow(0.0f, 1e-3f) == 0.0f);
    assert_true(brdf_pow(0.0f, -1.0f) == FLT_MAX);
    assert_true(brdf_pow(1.0f, FLT_MAX) == 1.0f);
    assert_true(brdf_pow(12.5f, 0.0f) == 1.0f);
    assert_true(brdf_pow(2.0f, 128.0f) == FLT_MAX);
    assert_true(brdf_pow(2.0f, -127.0f) == 0.0f);
    assert_true(brdf_pow(BRDF_ONE_MINUS_ULP, FLT_MAX) == 0.0f);
    for (int i = -126; i < 128; ++i) {
        assert_true(brdf_pow(2.0f, (float)i) == ldexpf(1.0f, i));
    }
}

static void special_values_of_inverses_and_erf(void **state)
{
    (void)state;
    assert_true(brdf_acos(1.0f) == 0.0f);
    assert_true(brdf_acos(1.00001f) == 0.0f);
    assert_true(brdf_acos(-1.0f) == BRDF_PI);
    assert_true(brdf_acos(-2.0f) == BRDF_PI);
    assert_true(brdf_asin(7.0f) == (float)1.57079632679489661923);
    assert_true(brdf_atan2(0.0f, 0.0f) == 0.0f);
    assert_true(brdf_atan2(0.0f, -3.0f) == BRDF_PI);
    assert_true(brdf_atan2(-0.0f, -3.0f) == -BRDF_PI);
    assert_true(brdf_atan2(2.0f, 0.0f) == (float)1.57079632679489661923);
    assert_true(brdf_atan2(-2.0f, 0.0f) == -(float)1.57079632679489661923);
    assert_true(brdf_erf(0.0f) == 0.0f);
    assert_true(brdf_erf(4.0f) == 1.0f);
    assert_true(brdf_erf(-FLT_MAX) == -1.0f);
    assert_true(brdf_erfinv(0.0f) == 0.0f);
    assert_true(brdf_erfinv(1.0f) == brdf_erfinv(BRDF_ONE_MINUS_ULP));
    assert_true(brdf_erfinv(-9.0f) == -brdf_erfinv(1.0f));
    assert_true(brdf_erfinv(1.0f) < 3.84f);
}

static void rounding_is_to_the_nearest_even_and_floor_is_floor(void **state)
{
    (void)state;
    for (int i = -4000; i <= 4000; ++i) {
        float x = (float)i * 0.25f;
        float y = (float)i * 1048.1f;
        assert_true(brdf_round(x) == rintf(x));
        assert_true(brdf_round(y) == rintf(y));
        assert_true(brdf_floor(x) == floorf(x));
        assert_true(brdf_floor(y) == floorf(y));
    }
}

static void constants_are_the_nearest_floats(void **state)
{
    (void)state;
    assert_true(BRDF_PI == (float)pi);
    assert_true(BRDF_TWO_PI == (float)(2.0 * pi));
    assert_true(BRDF_1_PI == (float)(1.0 / pi));
    assert_true(BRDF_TWO_OVER_PI == (float)(2.0 / pi));
    assert_true(BRDF_SQRT_PI == (float)sqrt(pi));
    assert_true(BRDF_1_SQRT_PI == (float)(1.0 / sqrt(pi)));
    assert_true(BRDF_ONE_MINUS_ULP == nextafterf(1.0f, 0.0f));
    assert_true(BRDF_LARGEST == FLT_MAX);
    assert_true(BRDF_SMALLEST == FLT_MIN);
}

int main(void)
{
    static const struct CMUnitTest tests[] = {
        cmocka_unit_test(errors_are_within_their_bounds),
        cmocka_unit_test(results_are_finite_for_extreme_arguments),
        cmocka_unit_test(reduction_is_exact_near_multiples_of_half_pi),
        cmocka_unit_test(monotone_functions_are_monotone),
        cmocka_unit_test(odd_functions_are_odd_to_the_bit),
        cmocka_unit_test(sine_and_cosine_lie_on_the_circle),
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(whole_turns_change_nothing),
        cmocka_unit_test(special_values_of_exp_log_and_pow),
        cmocka_unit_test(special_values_of_inverses_and_erf),
        cmocka_unit_test(rounding_is_to_the_nearest_even_and_floor_is_floor),
        cmocka_unit_test(constants_are_the_nearest_floats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
