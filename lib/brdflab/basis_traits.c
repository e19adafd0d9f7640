/*
 * basis_traits.c - traits as linear functions of the coordinates, and the way to change one.
 */
#include "basis_traits.h"

#include <math.h>

/* Linear regression. The coordinates have mean 0, variance 1 and no correlation over the set, so
   each slope is one inner product. */
void basis_traits_regress(struct lab_basis *basis)
{
    size_t n = basis->count, components = (size_t)basis->components;
    for (int t = 0; t < LAB_TRAITS; ++t) {
        double mean = 0.0, square = 0.0, explained = 0.0;
        for (size_t i = 0; i < n; ++i) {
            mean += basis->trait[i][t] / (double)n;
        }
        for (size_t i = 0; i < n; ++i) {
            double off = basis->trait[i][t] - mean;
            square += off * off / (double)(n - 1);
        }
        for (size_t k = 0; k < components; ++k) {
            double slope = 0.0;
            for (size_t i = 0; i < n; ++i) {
                slope += basis->coordinate[i * components + k] * (basis->trait[i][t] - mean) /
                         (double)(n - 1);
            }
            basis->slope[k][t] = slope;
            explained += slope * slope;
        }
        basis->trait_deviation[t] = sqrt(square);
        basis->trait_explained[t] = square > 0.0 ? explained / square : 0.0;
    }
}

int lab_basis_step(const struct lab_basis *basis, enum lab_trait trait, double amount, double *step)
{
    double square = 0.0;
    for (int k = 0; k < basis->components; ++k) {
        square += basis->slope[k][trait] * basis->slope[k][trait];
    }
    if (!(square > 0.0)) {
        return 0;
    }
    for (int k = 0; k < basis->components; ++k) {
        step[k] += amount * basis->trait_deviation[trait] * basis->slope[k][trait] / square;
    }
    return 1;
}
