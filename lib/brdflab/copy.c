/* copy.c - bytes from one file into another that appears when it is complete. */
#include "copy.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "brdfcl/atomic_file.h"

static brdf_status bytes_copy(FILE *stream, const char *from, struct brdfcl_atomic_file *file,
                              struct brdf_error *error)
{
    char bytes[1 << 16];
    long long offset = 0;
    size_t count;
    while ((count = fread(bytes, 1, sizeof bytes, stream)) > 0) {
        brdf_status status = brdfcl_atomic_write(file, bytes, count, offset, error);
        if (status) {
            return status;
        }
        offset += (long long)count;
    }
    return ferror(stream)
               ? brdf_fail(error, BRDF_IO, "%s: cannot be read: %s", from, strerror(errno))
               : BRDF_OK;
}

brdf_status lab_copy_file(const char *from, const char *to, struct brdf_error *error)
{
    struct brdfcl_atomic_file file;
    FILE *stream = fopen(from, "rb");
    if (!stream) {
        return brdf_fail(error, BRDF_IO, "%s: cannot be opened: %s", from, strerror(errno));
    }
    brdf_status status = brdfcl_atomic_open(&file, to, error);
    if (status == BRDF_OK) {
        status = bytes_copy(stream, from, &file, error);
        if (status == BRDF_OK) {
            status = brdfcl_atomic_commit(&file, error);
        } else {
            brdfcl_atomic_discard(&file);
        }
    }
    fclose(stream);
    return status;
}
