/*
 * place.h - a new material at a place in a basis.
 */
#ifndef BRDFLAB_PLACE_H
#define BRDFLAB_PLACE_H

#include "basis.h"

/*
 * Make the table that lies `step` [K standard deviations] from `start`, which keeps whatever the
 * components do not describe; with a NULL start, from the mean. In the log-relative mapping it is
 *
 *   x = x_start + sum over k, i of step_k loading_ik x_i / sqrt(N - 1),
 *
 * a mixture of the materials of the basis whose weights may be negative and, beside the start's,
 * sum to 0. The materials are read again, all that take part. `file` is for brdf_merl_free. A bin
 * is valid where its directions are above the surface. Errors: those of lab_open_merl,
 * BRDF_OUT_OF_MEMORY, BRDF_CANCELLED.
 */
brdf_status lab_place_make(const struct lab_basis *basis, const char *const *materials,
                           const char *start, const double *step, lab_basis_progress *progress,
                           void *data, struct brdf_merl_file *file, struct brdf_error *error);

#endif
