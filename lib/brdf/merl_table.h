/*
 * merl_table.h - the words that the model `merl` reads: a file's values and its sampling tables
 * (internal).
 */
#ifndef BRDF_MERL_TABLE_H
#define BRDF_MERL_TABLE_H

#include <stddef.h>

#include "brdf/merl.h"

/*
 * Read the file at `path`, replace its invalid bins (not BRDF_MERL_INVALID_KEEP) and build the
 * table of model/merl.h: *words floats at *table, malloc'd, for the caller to free. On failure both
 * are left as they were. Errors: those of brdf_merl_read.
 */
brdf_status brdf_merl_table_load(const char *path, enum brdf_merl_invalid invalid, float **table,
                                 size_t *words, struct brdf_error *error);

/* The same from values in memory, which must hold no invalid bins. Errors: BRDF_OUT_OF_MEMORY. */
brdf_status brdf_merl_table_build(const struct brdf_merl_file *file, float **table, size_t *words,
                                  struct brdf_error *error);

#endif
