/*
 * brushed_table.h - computing the tables of brushed.h and brushed_glass.h (internal).
 */
#ifndef BRDF_BRUSHED_TABLE_H
#define BRDF_BRUSHED_TABLE_H

#include <stddef.h>

#include "brdf/status.h"
#include "facet_shares.h"

/* For mirrors (eta 0). *table, of *words words, is to be freed with free(). BRDF_OUT_OF_MEMORY. */
brdf_status brdf_brushed_table_make(const struct facet_surface *surface, float **table,
                                    size_t *words, struct brdf_error *error);

/* The same for an interface between dielectrics, seen from above. brushed_glass_table.c */
brdf_status brdf_brushed_glass_table_make(const struct facet_surface *surface, float **table,
                                          size_t *words, struct brdf_error *error);

#endif
