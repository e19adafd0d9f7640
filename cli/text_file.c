/* text_file.c - a small file that appears whole or not at all. */
#define _XOPEN_SOURCE 700 /* realpath, mkstemp */
#include "text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static brdf_status io_failed(const char *path, struct brdf_error *error)
{
    return brdf_fail(error, BRDF_IO, "%s: cannot be written: %s", path, strerror(errno));
}

/* The folder that a path names a file in; malloc'd. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    size_t length = !slash ? 1 : slash == path ? 1 : (size_t)(slash - path);
    char *folder = malloc(length + 1);
    if (folder) {
        memcpy(folder, slash ? path : ".", length);
        folder[length] = '\0';
    }
    return folder;
}

brdf_status text_file_check(const char *path, struct brdf_error *error)
{
    struct stat info;
    if (strcmp(path, "-") == 0) {
        return BRDF_OK;
    }
    if (stat(path, &info) == 0) {
        if (S_ISDIR(info.st_mode)) {
            return brdf_fail(error, BRDF_IO, "%s: is a folder, not a file to write", path);
        }
        if (access(path, W_OK)) {
            return io_failed(path, error);
        }
        if (!S_ISREG(info.st_mode)) {
            return BRDF_OK;
        }
    }
    char *folder = folder_of(path);
    if (!folder) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
    }
    brdf_status status = BRDF_OK;
    if (!*path || path[strlen(path) - 1] == '/') {
        status = brdf_fail(error, BRDF_IO, "'%s' names no file to write", path);
    } else if (access(folder, W_OK | X_OK)) {
        status = brdf_fail(error, BRDF_IO, "%s: its folder cannot be written: %s", path,
                           strerror(errno));
    }
    free(folder);
    return status;
}

static int write_all(int fd, const char *text, size_t length)
{
    while (length) {
        ssize_t written = write(fd, text, length);
        if (written < 0 && errno != EINTR) {
            return -1;
        }
        if (written > 0) {
            text += written;
            length -= (size_t)written;
        }
    }
    return 0;
}

/* Standard output, a device or a pipe: there is nothing to rename. */
static brdf_status write_through(const char *path, const char *text, size_t length,
                                 struct brdf_error *error)
{
    int is_output = strcmp(path, "-") == 0;
    fflush(stdout);
    int fd = is_output ? STDOUT_FILENO : open(path, O_WRONLY);
    brdf_status status = BRDF_OK;
    if (fd < 0 || write_all(fd, text, length)) {
        status = io_failed(is_output ? "standard output" : path, error);
    }
    if (fd >= 0 && !is_output && close(fd) && !status) {
        status = io_failed(path, error);
    }
    return status;
}

/* mkstemp makes files that only their owner reads; give the temporary what the file had or would
   have had. */
static int set_mode(int fd, const char *target)
{
    struct stat info;
    if (stat(target, &info) == 0) {
        return fchmod(fd, info.st_mode & 07777);
    }
    mode_t mask = umask(0);
    umask(mask);
    return fchmod(fd, 0666 & ~mask);
}

static brdf_status replace(const char *path, const char *target, const char *text, size_t length,
                           struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    int fd = -1;
    size_t size = strlen(target) + 16;
    char *folder = folder_of(target);
    char *temporary = malloc(size + 2);
    if (!folder || !temporary) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
        goto done;
    }
    const char *slash = strrchr(target, '/');
    snprintf(temporary, size + 2, "%s/.%s.XXXXXX", folder, slash ? slash + 1 : target);
    fd = mkstemp(temporary);
    if (fd < 0) {
        status = io_failed(path, error);
        goto done;
    }
    int bad = set_mode(fd, target) || write_all(fd, text, length) || fsync(fd);
    if (close(fd) || bad || rename(temporary, target)) {
        status = io_failed(path, error);
        unlink(temporary);
    }
done:
    free(folder);
    free(temporary);
    return status;
}

brdf_status text_file_write(const char *path, const char *text, size_t length,
                            struct brdf_error *error)
{
    struct stat info;
    brdf_status status = text_file_check(path, error);
    if (status) {
        return status;
    }
    if (strcmp(path, "-") == 0 || (stat(path, &info) == 0 && !S_ISREG(info.st_mode))) {
        return write_through(path, text, length, error);
    }
    char *target = realpath(path, NULL); /* NULL: there is no such file yet */
    status = replace(path, target ? target : path, text, length, error);
    free(target);
    return status;
}
