/*
 * math_functions.c - each function, its reference in double precision, and where to look at it.
 */
#include "math_functions.h"

#include <math.h>
#include <string.h>

#include <brdf/math.h>

/* ---- Ours -------------------------------------------------------------------------------------*/

static float sin_2pi(float a, float b)
{
    (void)b;
    return brdf_sincos_2pi(a).sin;
}

static float cos_2pi(float a, float b)
{
    (void)b;
    return brdf_sincos_2pi(a).cos;
}

static float our_sin(float a, float b)
{
    (void)b;
    return brdf_sin(a);
}

static float our_cos(float a, float b)
{
    (void)b;
    return brdf_cos(a);
}

static float our_asin(float a, float b)
{
    (void)b;
    return brdf_asin(a);
}

static float our_acos(float a, float b)
{
    (void)b;
    return brdf_acos(a);
}

static float our_atan2(float a, float b)
{
    return brdf_atan2(a, b);
}

static float our_exp(float a, float b)
{
    (void)b;
    return brdf_exp(a);
}

static float our_log(float a, float b)
{
    (void)b;
    return brdf_log(a);
}

static float our_pow(float a, float b)
{
    return brdf_pow(a, b);
}

static float our_erf(float a, float b)
{
    (void)b;
    return brdf_erf(a);
}

static float our_erfinv(float a, float b)
{
    (void)b;
    return brdf_erfinv(a);
}

/* ---- References -------------------------------------------------------------------------------*/

/* sin(pi/2 (4u + quarter)); subtracting the nearest quarter turn is exact. */
static double sin_of_turn(double u, int quarter)
{
    double n = rint(4.0 * u);
    double rest = (4.0 * u - n) * 1.57079632679489661923;
    unsigned quadrant = (unsigned)((long)n + quarter) & 3u;
    double value = quadrant & 1u ? cos(rest) : sin(rest);
    return quadrant & 2u ? -value : value;
}

static double sin_2pi_reference(double a, double b)
{
    (void)b;
    return sin_of_turn(a, 0);
}

static double cos_2pi_reference(double a, double b)
{
    (void)b;
    return sin_of_turn(a, 1);
}

static double sin_reference(double a, double b)
{
    (void)b;
    return sin(a);
}

static double cos_reference(double a, double b)
{
    (void)b;
    return cos(a);
}

static double asin_reference(double a, double b)
{
    (void)b;
    return asin(a);
}

static double acos_reference(double a, double b)
{
    (void)b;
    return acos(a);
}

static double exp_reference(double a, double b)
{
    (void)b;
    return exp(a);
}

static double log_reference(double a, double b)
{
    (void)b;
    return log(a);
}

static double erf_reference(double a, double b)
{
    (void)b;
    return erf(a);
}

/* Solves erf(y) = a by Halley's method, in the upper half through erfc, which keeps its digits. */
static double erfinv_reference(double a, double b)
{
    double x = fabs(a);
    double l = log1p(-x * x);
    double k = 4.3307467508 + 0.5 * l;
    double y = sqrt(sqrt(k * k - l / 0.147) - k); /* Winitzki 2008: two digits to start from */
    (void)b;
    for (int i = 0; i < 4; ++i) {
        double excess = x > 0.5 ? (1.0 - x) - erfc(y) : erf(y) - x;
        double newton = excess / (1.12837916709551257390 * exp(-y * y));
        y -= newton / (1.0 + y * newton);
    }
    return copysign(y, a);
}

const struct math_function math_functions[] = {
    {"sin_2pi", "brdf_sincos_2pi(a).sin", sin_2pi, sin_2pi_reference, 2, 1e-30f, 1e4f, 1, 0},
    {"cos_2pi", "brdf_sincos_2pi(a).cos", cos_2pi, cos_2pi_reference, 2, 1e-30f, 1e4f, 1, 0},
    {"sin", "brdf_sin(a)", our_sin, sin_reference, 3, 1e-30f, 8192.0f, 1, 0},
    {"cos", "brdf_cos(a)", our_cos, cos_reference, 3, 1e-30f, 8192.0f, 1, 0},
    {"asin", "brdf_asin(a)", our_asin, asin_reference, 3, 1e-30f, 1.0f, 1, 0},
    {"acos", "brdf_acos(a)", our_acos, acos_reference, 2, 1e-30f, 1.0f, 1, 0},
    {"atan2", "brdf_atan2(a, b)", our_atan2, atan2, 2, 1e-20f, 1e20f, 1, 1},
    {"exp", "brdf_exp(a)", our_exp, exp_reference, 1, 1e-30f, 87.33654f, 1, 0},
    {"log", "brdf_log(a)", our_log, log_reference, 1, BRDF_SMALLEST, BRDF_LARGEST, 0, 0},
    {"pow", "brdf_pow(a, b)", our_pow, pow, 4, BRDF_SMALLEST, BRDF_LARGEST, 0, 1},
    {"erf", "brdf_erf(a)", our_erf, erf_reference, 3, 1e-30f, 1e30f, 1, 0},
    {"erfinv", "brdf_erfinv(a)", our_erfinv, erfinv_reference, 4, 1e-30f, BRDF_ONE_MINUS_ULP, 1, 0},
    {NULL, NULL, NULL, NULL, 0, 0.0f, 0.0f, 0, 0},
};

/* ---- Arguments --------------------------------------------------------------------------------*/

/* A number in [0, 1) out of two; the finisher of MurmurHash3 over a Weyl sequence. */
static double scatter(uint32_t index, uint32_t dimension)
{
    uint32_t h = index * 0x9e3779b9u + dimension * 0x85ebca6bu;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return (h ^ h >> 16) / 4294967296.0;
}

/* Positive floats are ordered as their bits are: t in [0, 1] goes evenly over the floats. */
static float among_floats(float low, float high, double t)
{
    return brdf_from_bits(brdf_bits(low) + (int)(t * (brdf_bits(high) - brdf_bits(low))));
}

/* Near or far from the diagonal, in every quadrant. */
static struct math_arguments arguments_of_atan2(const struct math_function *f, uint32_t index)
{
    struct math_arguments arguments;
    double t = scatter(index, 1);
    arguments.a = among_floats(f->low, f->high, scatter(index, 0));
    arguments.b = index & 4u ? among_floats(f->low, f->high, t)
                             : (float)((double)arguments.a * exp(4.0 * t - 2.0));
    arguments.a *= index & 1u ? -1.0f : 1.0f;
    arguments.b *= index & 2u ? -1.0f : 1.0f;
    return arguments;
}

/* Exponents up to 1e5 of what is below 1, as a Phong lobe has them; else results over all floats.
 */
static struct math_arguments arguments_of_pow(const struct math_function *f, uint32_t index)
{
    struct math_arguments arguments;
    double s = scatter(index, 0);
    double t = scatter(index, 1);
    double shrink = exp(-18.0 * scatter(index, 2));
    switch (index & 3u) {
    case 0:
        arguments.a = (float)(1.0 - s * shrink);
        arguments.b = (float)exp(11.5 * t);
        return arguments;
    case 1:
        arguments.a = among_floats(f->low, f->high, s);
        break;
    case 2:
        arguments.a = (float)(0.5 + 1.5 * s);
        break;
    default:
        arguments.a = (float)(1.0 + (s - 0.5) * shrink);
        break;
    }
    arguments.b =
        arguments.a == 1.0f ? 1.0f : (float)((256.0 * t - 127.0) / log2((double)arguments.a));
    return arguments;
}

/* Half of the arguments lie here, where most happens, the others all over the domain. */
#define NEAR_ONE_LOW 0.00390625f
#define NEAR_ONE_HIGH 128.0f

struct math_arguments math_arguments_make(const struct math_function *f, uint32_t index,
                                          uint32_t count)
{
    struct math_arguments arguments = {0.0f, 0.0f};
    int all = index & 2u ? 1 : 0;
    float low = all || f->low > NEAR_ONE_LOW ? f->low : NEAR_ONE_LOW;
    float high = all || f->high < NEAR_ONE_HIGH ? f->high : NEAR_ONE_HIGH;
    if (strcmp(f->name, "atan2") == 0) {
        return arguments_of_atan2(f, index);
    }
    if (strcmp(f->name, "pow") == 0) {
        return arguments_of_pow(f, index);
    }
    arguments.a = among_floats(low, high, (index + scatter(index, 0)) / count);
    arguments.a *= f->negative && index & 1u ? -1.0f : 1.0f;
    return arguments;
}
