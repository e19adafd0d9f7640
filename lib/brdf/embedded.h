/*
 * embedded.h - the text of the shared headers, carried inside the library.
 *
 * tools/embed.awk makes the table. A file is its lines, without their line ends; every file ends
 * with one.
 */
#ifndef BRDF_EMBEDDED_H
#define BRDF_EMBEDDED_H

#include <brdf/source.h>

/* Every file under include/brdf as an include names it, "brdf/vec.h", by name; then a NULL name. */
extern const struct brdf_source_file brdf_embedded_files[];

#endif
