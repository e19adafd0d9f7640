/*
 * embedded.h - the text of the kernels, carried inside the library.
 */
#ifndef BRDFCL_EMBEDDED_H
#define BRDFCL_EMBEDDED_H

#include <brdf/source.h>

/* Every file under kernels, "kernels/film.cl", by name; then a NULL name. For brdf_source_expand.
 */
extern const struct brdf_source_file brdfcl_embedded_files[];

#endif
