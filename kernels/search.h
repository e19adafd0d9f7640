/*
 * search.h - inverting a tabulated distribution function.
 */
#ifndef PT_SEARCH_H
#define PT_SEARCH_H

#include "brdf/vec.h"

struct pt_choice {
    brdf_int index;      /* the chosen bin */
    brdf_real remainder; /* where in the bin u fell: again uniform in [0, 1) */
    brdf_real mass;      /* probability of the bin */
};

/*
 * The bin of a CDF (words first .. first + bins, from 0 to 1, in every lane its own first word)
 * that u in [0, 1) falls into; `steps` >= log2(bins). Bins of no mass are never chosen.
 */
static inline struct pt_choice pt_search(BRDF_GLOBAL const float *words, brdf_int first, int bins,
                                         int steps, brdf_real u)
{
    /* Invariant: cdf[low] <= u < cdf[high]. */
    brdf_int low = 0;
    brdf_int high = bins;
    for (int step = 0; step < steps; ++step) {
        brdf_int middle = (low + high) >> 1;
        brdf_mask right = brdf_gather(words, first + middle) <= u;
        low = brdf_pick_int(right, middle, low);
        high = brdf_pick_int(right, high, middle);
    }
    brdf_real below = brdf_gather(words, first + low);
    struct pt_choice choice;
    choice.index = low;
    choice.mass = brdf_gather(words, first + low + 1) - below;
    choice.remainder = (u - below) / brdf_max(choice.mass, 1e-30f);
    choice.remainder = brdf_clamp(choice.remainder, 0.0f, BRDF_ONE_MINUS_ULP);
    return choice;
}

#endif
