/*
 * glass_table.h - computing the table of glass_curve.h (internal).
 */
#ifndef BRDF_GLASS_TABLE_H
#define BRDF_GLASS_TABLE_H

#include <stddef.h>

#include "brdf/status.h"

/*
 * A rough interface whose index below over that above is eta; distribution and masking as in
 * microfacet.h. If `coating`, the curves are what passes and what is lost from above (coating.h),
 * otherwise what is lost from above and from below (glass.h). *table, of *words words, is to be
 * freed with free(). BRDF_OUT_OF_MEMORY.
 */
brdf_status brdf_glass_table_make(int distribution, int masking, float eta, int coating,
                                  float **table, size_t *words, struct brdf_error *error);

#endif
