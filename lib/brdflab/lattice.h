/*
 * lattice.h - points that fill a unit cube of several dimensions evenly.
 *
 * Point i is the fractional part of shift + i step, where the steps are powers of the inverse of
 * the root of x^(d + 1) = x + 1: the golden ratio for one dimension, and its like for more [Roberts
 * 2018]. A random shift makes the mean over the points an unbiased estimate, so that several shifts
 * tell its error [Cranley and Patterson 1976].
 */
#ifndef BRDFLAB_LATTICE_H
#define BRDFLAB_LATTICE_H

#include <stddef.h>

enum { LAB_LATTICE_MOST = 8 };

struct lab_lattice {
    int dimensions;
    double step[LAB_LATTICE_MOST];
    double shift[LAB_LATTICE_MOST];
};

/* A lattice of 1 to LAB_LATTICE_MOST dimensions; another seed shifts it elsewhere. */
struct lab_lattice lab_lattice_make(int dimensions, unsigned long long seed);

/* One coordinate of point i, in [0, 1) also as a float. */
float lab_lattice_at(const struct lab_lattice *lattice, size_t i, int dimension);

#endif
