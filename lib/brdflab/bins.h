/*
 * bins.h - the bins of a MERL table (brdf/merl.h): their numbers, and what lies at their centres.
 */
#ifndef BRDFLAB_BINS_H
#define BRDFLAB_BINS_H

#include <stddef.h>

#include <brdf/merl.h>

/* A bin by its place along each angle, counted from 0. */
struct lab_bin {
    int theta_h;
    int theta_d;
    int phi_d;
};

/* Between the place of a bin and its number: three values of `rgb` each. */
struct lab_bin lab_bin_of(const struct brdf_merl_file *file, size_t number);
size_t lab_bin_number(const struct brdf_merl_file *file, struct lab_bin bin);

/* theta_h [rad] at the centre of a bin. */
double lab_bin_theta_h(const struct brdf_merl_file *file, int theta_h);

/* The directions at the centre of a bin; 1 if both are above the surface, else 0. */
int lab_bin_directions(struct lab_bin bin, double wo[3], double wi[3]);

/* What the log-relative mapping weights a bin by (logrelative.h), and again whether it is above. */
int lab_bin_cosine(struct lab_bin bin, double *cosine);

#endif
