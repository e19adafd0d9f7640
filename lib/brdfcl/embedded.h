/*
 * embedded.h - the text of the kernels, carried inside the library.
 */
#ifndef BRDFCL_EMBEDDED_H
#define BRDFCL_EMBEDDED_H

#include "../brdf/embedded.h"

/* Every file under kernels, sorted by name ("kernels/film.cl"); ended by a null name. */
extern const struct brdf_embedded_file brdfcl_embedded_files[];

#endif
