/*
 * lobe_spread.h - how to sample the lobe of what a surface has lost (internal).
 */
#ifndef BRDF_LOBE_SPREAD_H
#define BRDF_LOBE_SPREAD_H

#include "facet_shares.h"

/*
 * The `spread` of energy.h with which the greatest weight of the lobe's samples is least: between
 * those of the two roughnesses. Losses, up to a factor, for `count` directions, and the squares of
 * their cosines.
 */
double brdf_lobe_spread(const struct facet_surface *surface, const float *losses,
                        const double *cosine2, int count);

#endif
