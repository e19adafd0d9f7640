/*
 * statistics.c - Pearson's chi-square test.
 */
#include "statistics.h"

#include <math.h>
#include <stdlib.h>

/* exp(-x) x^a / Gamma(a), which both expansions share. */
static double scale_of(double a, double x)
{
    return exp(a * log(x) - x - lgamma(a));
}

/* P(a, x) by its power series, for x < a + 1 [DLMF 8.11.4]. */
static double gamma_p_series(double a, double x)
{
    double term = 1.0 / a;
    double sum = term;
    for (int k = 1; k < 100000 && term > 1e-17 * sum; ++k) {
        term *= x / (a + k);
        sum += term;
    }
    return sum * scale_of(a, x);
}

/* Q(a, x) by its continued fraction, for x >= a + 1 [DLMF 8.9.2], evaluated by Lentz' algorithm. */
static double gamma_q_fraction(double a, double x)
{
    double b = x + 1.0 - a;
    double c = 1e300;
    double d = 1.0 / b;
    double value = d;
    for (int k = 1; k < 100000; ++k) {
        double numerator = k * (a - k);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        value *= d * c;
        if (fabs(d * c - 1.0) < 1e-16) {
            break;
        }
    }
    return value * scale_of(a, x);
}

double lab_gamma_q(double a, double x)
{
    if (x <= 0.0) {
        return 1.0;
    }
    return x < a + 1.0 ? 1.0 - gamma_p_series(a, x) : gamma_q_fraction(a, x);
}

static int by_expected(const void *a, const void *b)
{
    const struct lab_bin *left = a;
    const struct lab_bin *right = b;
    return (left->expected > right->expected) - (left->expected < right->expected);
}

struct lab_chi2 lab_chi2_test(struct lab_bin *bins, size_t count)
{
    struct lab_chi2 result = {0.0, 0, 1.0, 0};
    struct lab_bin pool = {0.0, 0.0};
    qsort(bins, count, sizeof *bins, by_expected);
    size_t used = 0;
    double impossible = 0.0;
    double total = 0.0;
    for (size_t i = 0; i < count; ++i) {
        impossible += bins[i].expected <= 0.0 ? bins[i].observed : 0.0;
        total += bins[i].observed;
        pool.expected += bins[i].expected;
        pool.observed += bins[i].observed;
        /* Sorted: the small ones come first, and what is left of them joins the next. */
        if (pool.expected >= 5.0) {
            double difference = pool.observed - pool.expected;
            result.chi2 += difference * difference / pool.expected;
            ++used;
            pool.expected = 0.0;
            pool.observed = 0.0;
        }
    }
    result.impossible = impossible > 3.0 + 1e-3 * total;
    if (used > 1) {
        result.freedom = used - 1;
        result.p = lab_gamma_q(0.5 * (double)result.freedom, 0.5 * result.chi2);
    }
    return result;
}

double lab_sidak(double significance, size_t count)
{
    return 1.0 - pow(1.0 - significance, 1.0 / (double)count);
}
