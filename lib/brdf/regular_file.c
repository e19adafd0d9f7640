/* regular_file.c - opening and replacing regular files. */
#define _POSIX_C_SOURCE 200809L

#include "regular_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

brdf_status brdf_regular_file_open(const char *path, FILE **stream, long long *bytes,
                                   struct brdf_error *error)
{
    struct stat info;
    int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        return brdf_fail(error, BRDF_IO, "%s: cannot be opened: %s", path, strerror(errno));
    }
    if (fstat(descriptor, &info) != 0 || !S_ISREG(info.st_mode)) {
        close(descriptor);
        return brdf_fail(error, BRDF_IO, "%s: is not a regular file but %s", path,
                         S_ISDIR(info.st_mode) ? "a folder" : "a pipe, socket or device");
    }
    *bytes = (long long)info.st_size;
    *stream = fdopen(descriptor, "rb");
    if (!*stream) {
        close(descriptor);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: cannot be read: %s", path,
                         strerror(errno));
    }
    return BRDF_OK;
}

brdf_status brdf_new_file_begin(struct brdf_new_file *file, const char *path,
                                struct brdf_error *error)
{
    struct stat info;
    brdf_status status = BRDF_OK;
    size_t size = strlen(path) + 32;
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode)) {
        return brdf_fail(error, BRDF_IO, "%s: not written: it exists and is not a regular file",
                         path);
    }
    file->stream = NULL;
    file->path = path;
    file->temporary = malloc(size);
    if (!file->temporary) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: no memory to write it", path);
    }
    snprintf(file->temporary, size, "%s.%ld.part", path, (long)getpid());
    int descriptor = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        status =
            brdf_fail(error, BRDF_IO, "%s: cannot be made: %s", file->temporary, strerror(errno));
        free(file->temporary);
        return status;
    }
    file->stream = fdopen(descriptor, "wb");
    if (!file->stream) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: not written: %s", path, strerror(errno));
        close(descriptor);
        unlink(file->temporary);
        free(file->temporary);
    }
    return status;
}

brdf_status brdf_new_file_end(struct brdf_new_file *file, int failed, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    int reason = errno;
    if (fclose(file->stream) != 0 && !failed) {
        failed = 1;
        reason = errno;
    }
    if (!failed && rename(file->temporary, file->path) != 0) {
        failed = 1;
        reason = errno;
    }
    if (failed) {
        unlink(file->temporary);
        status = brdf_fail(error, BRDF_IO, "%s: not written: %s", file->path, strerror(reason));
    }
    free(file->temporary);
    return status;
}
