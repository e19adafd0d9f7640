/*
 * glass_table.h - computing the table of glass.h (internal).
 */
#ifndef BRDF_GLASS_TABLE_H
#define BRDF_GLASS_TABLE_H

#include <stddef.h>

#include "brdf/status.h"

/*
 * What rough glass loses whose index below over that above is eta; distribution and masking as in
 * microfacet.h. *table, of *words words, is to be freed with free(). BRDF_OUT_OF_MEMORY.
 */
brdf_status brdf_glass_table_make(int distribution, int masking, float eta, float **table,
                                  size_t *words, struct brdf_error *error);

#endif
