/*
 * separate.h - a measured table taken apart into a diffuse part and a highlight.
 *
 * There is no true answer; this one is simple and leaves nothing negative. Far from the highlight,
 * at half vectors far from the normal, f is the diffuse part alone. So for every theta_d and
 * channel its level is a low quantile of f over all theta_h and phi_d (three tenths of the light,
 * weighted by both cosines and the solid angle of h, is below it), smoothed along theta_d by
 * running medians against noise. The diffuse part of a bin is the level, or f where that is less;
 * the highlight is the rest. What a highlight's own tail has at its faintest counts as diffuse.
 */
#ifndef BRDFLAB_SEPARATE_H
#define BRDFLAB_SEPARATE_H

#include <brdf/merl.h>

enum { LAB_SEPARATE_BINS = 90 }; /* of theta_d */

struct lab_diffuse {
    double level[LAB_SEPARATE_BINS][3]; /* 1/sr */
};

/* Find the levels; invalid bins do not count. Errors: BRDF_OUT_OF_MEMORY. */
brdf_status lab_separate(const struct brdf_merl_file *file, struct lab_diffuse *diffuse,
                         struct brdf_error *error);

#endif
