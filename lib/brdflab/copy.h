/*
 * copy.h - a file copied byte for byte.
 */
#ifndef BRDFLAB_COPY_H
#define BRDFLAB_COPY_H

#include <brdf/status.h>

/* Copy a file, whole or not at all. The two may be the same. BRDF_IO, BRDF_OUT_OF_MEMORY. */
brdf_status lab_copy_file(const char *from, const char *to, struct brdf_error *error);

#endif
