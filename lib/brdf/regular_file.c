/* regular_file.c - opening and replacing regular files. */
#define _XOPEN_SOURCE 700 /* realpath */

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

/* The file that a path leads to, which need not exist; malloc'd. A link to nothing is no target. */
static brdf_status find_target(const char *path, char **target, mode_t *mode,
                               struct brdf_error *error)
{
    struct stat info;
    *mode = 0;
    if (stat(path, &info) == 0) {
        if (!S_ISREG(info.st_mode)) {
            return brdf_fail(error, BRDF_IO, "%s: not written: it exists and is not a regular file",
                             path);
        }
        *mode = info.st_mode & 07777;
        *target = realpath(path, NULL);
    } else if (lstat(path, &info) == 0) {
        return brdf_fail(error, BRDF_IO, "%s: not written: a symbolic link that leads nowhere",
                         path);
    } else {
        *target = strdup(path);
    }
    return *target ? BRDF_OK
                   : brdf_fail(error, BRDF_IO, "%s: not written: %s", path, strerror(errno));
}

static void new_file_free(struct brdf_new_file *file)
{
    free(file->temporary);
    free(file->target);
}

brdf_status brdf_new_file_begin(struct brdf_new_file *file, const char *path,
                                struct brdf_error *error)
{
    mode_t mode;
    memset(file, 0, sizeof *file);
    file->path = path;
    brdf_status status = find_target(path, &file->target, &mode, error);
    if (status) {
        return status;
    }
    size_t size = strlen(file->target) + 32;
    file->temporary = malloc(size);
    if (!file->temporary) {
        new_file_free(file);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: no memory to write it", path);
    }
    snprintf(file->temporary, size, "%s.%ld.part", file->target, (long)getpid());
    int descriptor = open(file->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        status =
            brdf_fail(error, BRDF_IO, "%s: cannot be made: %s", file->temporary, strerror(errno));
        new_file_free(file);
        return status;
    }
    file->stream = mode && fchmod(descriptor, mode) ? NULL : fdopen(descriptor, "wb");
    if (!file->stream) {
        status = brdf_fail(error, BRDF_IO, "%s: not written: %s", path, strerror(errno));
        close(descriptor);
        unlink(file->temporary);
        new_file_free(file);
    }
    return status;
}

brdf_status brdf_new_file_end(struct brdf_new_file *file, int failed, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    int reason = errno;
    /* On the disk before it takes the name; EINVAL: a file system with nothing to flush. */
    if (!failed && (fflush(file->stream) || (fsync(fileno(file->stream)) && errno != EINVAL))) {
        failed = 1;
        reason = errno;
    }
    if (fclose(file->stream) != 0 && !failed) {
        failed = 1;
        reason = errno;
    }
    if (!failed && rename(file->temporary, file->target) != 0) {
        failed = 1;
        reason = errno;
    }
    if (failed) {
        unlink(file->temporary);
        status = brdf_fail(error, BRDF_IO, "%s: not written: %s", file->path, strerror(reason));
    }
    new_file_free(file);
    return status;
}
