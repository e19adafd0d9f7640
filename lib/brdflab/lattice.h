/*
 * lattice.h - points that fill a unit cube of several dimensions evenly, however many one takes.
 *
 * Halton's points [1960]: the digits of i mirrored at the point, to the bases 2, 3, 5, ... A random
 * shift modulo 1 makes the mean over the points an unbiased estimate of an integral, so that
 * several shifts tell its error [Cranley and Patterson 1976].
 */
#ifndef BRDFLAB_LATTICE_H
#define BRDFLAB_LATTICE_H

#include <stddef.h>

#include <brdf/vec.h>

enum { LAB_LATTICE_MOST = 8 };

struct lab_lattice {
    int dimensions;
    double shift[LAB_LATTICE_MOST];
};

/* Points of 1 to LAB_LATTICE_MOST dimensions; another seed shifts them elsewhere. */
struct lab_lattice lab_lattice_make(int dimensions, unsigned long long seed);

/* One coordinate of point i, in [0, 1) also as a float. */
float lab_lattice_at(const struct lab_lattice *lattice, size_t i, int dimension);

/* The first three coordinates of point i. */
brdf_vec3 lab_lattice_cube(const struct lab_lattice *lattice, size_t i);

#endif
