/*
 * regular_file.h - regular files: opened for reading and nothing else mistaken for one, and written
 * whole or not at all (internal).
 */
#ifndef BRDF_REGULAR_FILE_H
#define BRDF_REGULAR_FILE_H

#include <stdio.h>

#include "brdf/status.h"

/*
 * Open for reading, without waiting for the other end of a pipe. Errors: BRDF_IO (missing,
 * unreadable, a folder, pipe, socket or device), BRDF_OUT_OF_MEMORY.
 */
brdf_status brdf_regular_file_open(const char *path, FILE **stream, long long *bytes,
                                   struct brdf_error *error);

/* A file that is being written under a temporary name. */
struct brdf_new_file {
    FILE *stream;
    const char *path;
    char *target; /* the file of that name, behind its symbolic links */
    char *temporary;
};

/* Begin to write `path`, which must outlive the struct. A file that is replaced hands its
   permissions on, and symbolic links to it stay. Errors: BRDF_IO, BRDF_OUT_OF_MEMORY. */
brdf_status brdf_new_file_begin(struct brdf_new_file *file, const char *path,
                                struct brdf_error *error);

/*
 * The end, to be reached after every successful beginning: the file takes its name, or vanishes if
 * `failed` is not 0 or the last bytes cannot be written. `failed` with errno as it was then.
 */
brdf_status brdf_new_file_end(struct brdf_new_file *file, int failed, struct brdf_error *error);

#endif
