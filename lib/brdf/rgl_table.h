/*
 * rgl_table.h - the words that the model `measured` reads, made of an RGL file (internal).
 */
#ifndef BRDF_RGL_TABLE_H
#define BRDF_RGL_TABLE_H

#include <stddef.h>

#include "brdf/rgl.h"

/*
 * Read the file at `path` and build the table of model/measured.h: *words floats at *table,
 * aligned to cache lines, for the caller to free(). On failure both are left as they were. Errors:
 * those of brdf_rgl_read, and BRDF_UNSUPPORTED where it would be too large to be indexed.
 */
brdf_status brdf_rgl_table_load(const char *path, float **table, size_t *words,
                                struct brdf_error *error);

/* The same from values in memory, which become RGB if they are spectral. */
brdf_status brdf_rgl_table_build(struct brdf_rgl_file *file, float **table, size_t *words,
                                 struct brdf_error *error);

/* A table without values or luminance, of a file that has neither yet, for warping by normals. */
brdf_status brdf_rgl_table_of_normals(const struct brdf_rgl_file *file, float **table,
                                      struct brdf_error *error);

#endif
