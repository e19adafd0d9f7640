/*
 * lattice.c - Halton's points, shifted.
 */
#include "lattice.h"

#include <math.h>

#include <brdf/math.h>

#include "brdfcl/check_random.h"

/* The digits of i to a base, mirrored at the point. */
static double mirrored(size_t i, size_t base)
{
    double scale = 1.0 / (double)base;
    double result = 0.0;
    for (double place = scale; i; i /= base, place *= scale) {
        result += place * (double)(i % base);
    }
    return result;
}

struct lab_lattice lab_lattice_make(int dimensions, unsigned long long seed)
{
    struct lab_lattice lattice = {dimensions, {0.0}};
    struct brdfcl_random random = {seed};
    for (int d = 0; d < dimensions; ++d) {
        lattice.shift[d] = (double)brdfcl_random_uniform(&random);
    }
    return lattice;
}

float lab_lattice_at(const struct lab_lattice *lattice, size_t i, int dimension)
{
    static const size_t base[LAB_LATTICE_MOST] = {2, 3, 5, 7, 11, 13, 17, 19};
    double x = mirrored(i, base[dimension]) + lattice->shift[dimension];
    return brdf_min((float)(x - floor(x)), BRDF_ONE_MINUS_ULP);
}

brdf_vec3 lab_lattice_cube(const struct lab_lattice *lattice, size_t i)
{
    return brdf_vec3_make(lab_lattice_at(lattice, i, 0), lab_lattice_at(lattice, i, 1),
                          lab_lattice_at(lattice, i, 2));
}
