/*
 * atomic_file.h - a file that appears whole or not at all.
 *
 * Bytes go to `.NAME.XXXXXX.tmp` in the folder of the file that is to be; commit makes them safe on
 * the disk and renames. Until then whatever stood there before is untouched, and a process that is
 * killed leaves at most the temporary file.
 */
#ifndef BRDFCL_ATOMIC_FILE_H
#define BRDFCL_ATOMIC_FILE_H

#include <stddef.h>

#include <brdf/status.h>

struct brdfcl_atomic_file {
    const char *path; /* as the caller named it, for messages; borrowed */
    char *target;     /* the file that will be replaced: path with symbolic links followed */
    char *temporary;  /* where the bytes are until then */
    int fd;           /* of the temporary; -1 when closed */
};

/*
 * Check that path can be written: its folder exists and may be written, and it is itself nothing,
 * or a regular file that may be written. BRDF_IO, BRDF_OUT_OF_MEMORY.
 */
brdf_status brdfcl_atomic_check(const char *path, struct brdf_error *error);

/* Check path and open a temporary for it. On success, commit or discard must follow. */
brdf_status brdfcl_atomic_open(struct brdfcl_atomic_file *file, const char *path,
                               struct brdf_error *error);

/* Write all of the bytes at an offset from the start; holes are zero. BRDF_IO. */
brdf_status brdfcl_atomic_write(struct brdfcl_atomic_file *file, const void *data, size_t size,
                                long long offset, struct brdf_error *error);

/* Put the file in its place. Whether it succeeds or fails, file is closed and no temporary stays.
 */
brdf_status brdfcl_atomic_commit(struct brdfcl_atomic_file *file, struct brdf_error *error);

/* Give up: close and remove the temporary. Harmless after a commit. */
void brdfcl_atomic_discard(struct brdfcl_atomic_file *file);

#endif
