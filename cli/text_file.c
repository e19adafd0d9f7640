/* text_file.c - a small file that appears whole or not at all. */
#define _POSIX_C_SOURCE 200809L
#include "text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "brdfcl/atomic_file.h"
#include "stop.h"

static brdf_status io_failed(const char *path, struct brdf_error *error)
{
    return brdf_fail(error, BRDF_IO, "%s: cannot be written: %s", path, strerror(errno));
}

/* What is written as it is: standard output, a device or a pipe. */
static int is_stream(const char *path)
{
    struct stat info;
    return strcmp(path, "-") == 0 ||
           (stat(path, &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode));
}

brdf_status text_file_check(const char *path, struct brdf_error *error)
{
    if (!is_stream(path)) {
        return brdfcl_atomic_check(path, error);
    }
    return strcmp(path, "-") != 0 && access(path, W_OK) ? io_failed(path, error) : BRDF_OK;
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

static brdf_status replace(const char *path, const char *text, size_t length,
                           struct brdf_error *error)
{
    struct brdfcl_atomic_file file;
    stop_wait();
    brdf_status status = brdfcl_atomic_open(&file, path, error);
    if (!status) {
        status = brdfcl_atomic_write(&file, text, length, 0, error);
        if (status) {
            brdfcl_atomic_discard(&file);
        } else {
            status = brdfcl_atomic_commit(&file, error);
        }
    }
    stop_resume();
    return status;
}

brdf_status text_file_write(const char *path, const char *text, size_t length,
                            struct brdf_error *error)
{
    return is_stream(path) ? write_through(path, text, length, error)
                           : replace(path, text, length, error);
}
