/*
 * lattice.c - points that fill a unit cube evenly.
 */
#include "lattice.h"

#include <math.h>

#include <brdf/math.h>

#include "brdfcl/check_random.h"

/* The root above 1 of x^(d + 1) = x + 1; the iteration contracts by 1 / (d + 1) at least. */
static double root_of(int dimensions)
{
    double x = 1.5;
    for (int k = 0; k < 64; ++k) {
        x = pow(1.0 + x, 1.0 / (dimensions + 1));
    }
    return x;
}

struct lab_lattice lab_lattice_make(int dimensions, unsigned long long seed)
{
    struct lab_lattice lattice = {dimensions, {0.0}, {0.0}};
    struct brdfcl_random random = {seed};
    double root = root_of(dimensions);
    double step = 1.0;
    for (int d = 0; d < dimensions; ++d) {
        step /= root;
        lattice.step[d] = step;
        lattice.shift[d] = (double)brdfcl_random_uniform(&random);
    }
    return lattice;
}

float lab_lattice_at(const struct lab_lattice *lattice, size_t i, int dimension)
{
    double x = lattice->shift[dimension] + (double)i * lattice->step[dimension];
    return brdf_min((float)(x - floor(x)), BRDF_ONE_MINUS_ULP);
}
