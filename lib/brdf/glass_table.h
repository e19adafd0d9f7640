/*
 * glass_table.h - computing the table of glass_curve.h (internal).
 */
#ifndef BRDF_GLASS_TABLE_H
#define BRDF_GLASS_TABLE_H

#include <stddef.h>

#include "brdf/status.h"
#include "facet_shares.h"

/*
 * A rough interface as seen from above. With alpha 0 the table is for any roughness; otherwise only
 * the rows that this one needs are right. If `coating`, the curves are what passes and what is lost
 * from above (coating.h), otherwise what is lost from above and from below (glass.h). *table, of
 * *words words, is to be freed with free(). BRDF_OUT_OF_MEMORY.
 */
brdf_status brdf_glass_table_make(const struct facet_surface *surface, int coating, float **table,
                                  size_t *words, struct brdf_error *error);

#endif
