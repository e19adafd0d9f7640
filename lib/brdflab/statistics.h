/*
 * statistics.h - do counts agree with what a distribution predicts?
 */
#ifndef BRDFLAB_STATISTICS_H
#define BRDFLAB_STATISTICS_H

#include <stddef.h>

/* The regularised incomplete gamma function Q(a, x) = Gamma(a, x) / Gamma(a), a > 0, x >= 0. */
double lab_gamma_q(double a, double x);

struct lab_bin {
    double expected;
    double observed;
};

struct lab_chi2 {
    double chi2;
    size_t freedom; /* degrees; 0 where there is nothing to compare */
    double p;       /* the probability of at least this chi2 if the prediction holds */
    int impossible; /* 1: too much was observed where nothing is expected */
};

/*
 * Pearson's test. The expected counts should sum to the observed; bins that expect fewer than 5 are
 * pooled. A few counts (3, and one in 1000) where nothing is expected are put down to rounding at
 * the edges of bins. Reorders the bins.
 */
struct lab_chi2 lab_chi2_test(struct lab_bin *bins, size_t count);

/* What each of `count` tests must reach so that all pass with probability 1 - significance [Sidak
   1967]. */
double lab_sidak(double significance, size_t count);

#endif
