/*
 * basis.h - principal components of a set of materials, in the log-relative mapping.
 *
 * A material is a vector of mapped values (logrelative.h), three for each bin of a sub-grid of the
 * MERL grid. The mean is taken off, so the mapping's reference divides out. The components are
 * eigenvectors of the covariance; a coordinate is counted in standard deviations of its component
 * over the set, so that 0 is the mean and values beyond 3 are far from all that was measured.
 * Reference: Matusik, Pfister, Brand, McMillan 2003, section 4 (the linear model, there of
 * logarithms); Nielsen, Jensen, Ramamoorthi 2015, section 4 (the mapping).
 */
#ifndef BRDFLAB_BASIS_H
#define BRDFLAB_BASIS_H

#include <stddef.h>

#include <brdf/merl.h>

#include "trait.h"

/* Called with the number of each material before it is read; not 0: stop. May be NULL. */
typedef int lab_basis_progress(size_t done, size_t count, void *data);

struct lab_basis {
    size_t count;       /* materials, N */
    int components;     /* K <= N - 1 */
    double *eigenvalue; /* [K] of the matrix of inner products, descending */
    double *explained;  /* [K] share of the variance */
    double *loading;    /* [N][K]: orthonormal columns; that of a component sums to 0 over N */
    double *coordinate; /* [N][K] in standard deviations */
    double (*trait)[LAB_TRAITS];        /* [N] */
    double (*slope)[LAB_TRAITS];        /* [K] a trait's change for each standard deviation */
    double trait_deviation[LAB_TRAITS]; /* over the set */
    double trait_explained[LAB_TRAITS]; /* R^2 of the trait from the K coordinates */
    size_t dimensions;                  /* of the vectors */
    float *vector;                      /* [N][dimensions], mean taken off */
    float *mean;                        /* [dimensions] */
};

/*
 * Build a basis of `components` (fewer where the set has not as many) from at least 3 materials,
 * as lab_open_merl takes them. Errors: those of lab_open_merl; BRDF_BAD_ARGUMENT, BRDF_UNSUPPORTED
 * (all materials are the same), BRDF_OUT_OF_MEMORY, BRDF_CANCELLED. On success for
 * lab_basis_destroy.
 */
brdf_status lab_basis_create(const char *const *materials, size_t count, int components,
                             lab_basis_progress *progress, void *data, struct lab_basis **out,
                             struct brdf_error *error);

/* NULL is fine. */
void lab_basis_destroy(struct lab_basis *basis);

/*
 * The coordinates of any table without invalid bins above the surface, and in *residual (which may
 * be NULL) the part of its distance from the mean that the components do not reach, 0 to 1.
 * BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_basis_project(const struct lab_basis *basis, const struct brdf_merl_file *file,
                              double *coordinates, double *residual, struct brdf_error *error);

/*
 * The shortest step, added to `step` [K], that changes a trait by `amount` standard deviations of
 * it, as far as the trait is linear in the coordinates. 0 if it does not depend on them.
 */
int lab_basis_step(const struct lab_basis *basis, enum lab_trait trait, double amount,
                   double *step);

#endif
