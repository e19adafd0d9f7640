/*
 * mix.h - mixtures of measured materials.
 */
#ifndef BRDFLAB_MIX_H
#define BRDFLAB_MIX_H

#include <stddef.h>

#include <brdf/merl.h>

/* What is averaged. */
enum lab_mix_space {
    /* the log-relative mapping (logrelative.h), where halfway looks halfway: a highlight of the
       mixture is as wide as between those of its parts */
    LAB_MIX_LOGRELATIVE,
    LAB_MIX_LINEAR /* f itself, as if specks of the materials lay side by side */
};

/*
 * Mix `count` tables with weights >= 0, which are divided by their sum. In the log-relative mapping
 * the reference divides out where weights sum to 1, so none is needed:
 *
 *   f c + epsilon = product over k of (f_k c + epsilon)^(w_k).
 *
 * A bin is valid where it is valid in all that have a weight above 0. Where these agree in a
 * value, or there is only one of them, the result has the value's own bits. The result is the
 * caller's, for brdf_merl_free. Errors: BRDF_BAD_ARGUMENT (no table, a weight that is negative or
 * not finite, no weight above 0, no bin that is valid in all), BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_mix_merl(const struct brdf_merl_file *files, const double *weights, size_t count,
                         enum lab_mix_space space, struct brdf_merl_file *mixture,
                         struct brdf_error *error);

/*
 * Which of the tables the mixture is, bit for bit: the number of one that has a weight above 0 and
 * that all others of a weight above 0 equal; -1 if there is none.
 */
int lab_mix_same(const struct brdf_merl_file *files, const double *weights, size_t count);

#endif
