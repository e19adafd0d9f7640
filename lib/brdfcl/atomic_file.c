/* atomic_file.c - write beside the target, then rename over it. */
#define _POSIX_C_SOURCE 200809L

#include "atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#define LINKS_MAX 40  /* as Linux; beyond that it is a loop */
#define TRIES_MAX 100 /* random names that are tried before giving up */
#define NAME_KEPT 200 /* bytes of NAME in `.NAME.XXXXXX.tmp`: file systems allow 255 in all */

static brdf_status fail_errno(struct brdf_error *error, const char *path, const char *what)
{
    return brdf_fail(error, BRDF_IO, "%s: %s: %s", path, what, strerror(errno));
}

static brdf_status fail_memory(struct brdf_error *error, const char *path)
{
    return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory while preparing to write", path);
}

/* How many bytes of the path are its folder, with the last slash; 0 means the current folder. */
static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/* The folder of the path as a string of its own that can be opened; NULL: out of memory. */
static char *folder_copy(const char *path)
{
    size_t length = folder_length(path);
    char *folder = malloc(length + 2);
    if (!folder)
        return NULL;
    memcpy(folder, path, length);
    if (length == 0)
        folder[length++] = '.';
    folder[length] = '\0';
    return folder;
}

/* One step along a symbolic link: the path that link says, seen from where it stands. */
static char *link_step(const char *link)
{
    char goal[4096];
    ssize_t length = readlink(link, goal, sizeof goal);
    if (length < 0)
        return NULL;
    if ((size_t)length >= sizeof goal) {
        errno = ENAMETOOLONG;
        return NULL;
    }
    size_t prefix = goal[0] == '/' ? 0 : folder_length(link);
    char *next = malloc(prefix + (size_t)length + 1);
    if (!next)
        return NULL;
    memcpy(next, link, prefix);
    memcpy(next + prefix, goal, (size_t)length);
    next[prefix + (size_t)length] = '\0';
    return next;
}

/*
 * Follow the links at the end of the path. The last one may point to nothing yet, which realpath()
 * would not have. On success *info is that of the target, with st_mode 0 if there is none.
 */
static brdf_status resolve(const char *path, char **target, struct stat *info,
                           struct brdf_error *error)
{
    char *at = strdup(path);
    if (!at)
        return fail_memory(error, path);
    for (int links = 0; lstat(at, info) == 0; links++) {
        if (!S_ISLNK(info->st_mode)) {
            *target = at;
            return BRDF_OK;
        }
        char *next = NULL;
        if (links < LINKS_MAX)
            next = link_step(at);
        else
            errno = ELOOP;
        brdf_status status =
            next ? BRDF_OK : fail_errno(error, path, "cannot follow the symbolic link");
        free(at);
        if (!next)
            return status;
        at = next;
    }
    if (errno != ENOENT) {
        brdf_status status = fail_errno(error, path, "cannot be written");
        free(at);
        return status;
    }
    memset(info, 0, sizeof *info);
    *target = at;
    return BRDF_OK;
}

/* May the folder of target take a new file? */
static brdf_status check_folder(const char *path, const char *target, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    struct stat info;
    char *folder = folder_copy(target);
    if (!folder)
        return fail_memory(error, path);
    if (stat(folder, &info) != 0)
        status = brdf_fail(error, BRDF_IO, "%s: cannot be written: the folder %s: %s", path, folder,
                           strerror(errno));
    else if (!S_ISDIR(info.st_mode))
        status =
            brdf_fail(error, BRDF_IO, "%s: cannot be written: %s is not a folder", path, folder);
    else if (access(folder, W_OK | X_OK) != 0)
        status =
            brdf_fail(error, BRDF_IO, "%s: cannot be written: no new file in the folder %s: %s",
                      path, folder, strerror(errno));
    free(folder);
    return status;
}

/* Find the target of a path and check that it may be replaced; *mode: its permissions, 0 if new. */
static brdf_status prepare(const char *path, char **target, mode_t *mode, struct brdf_error *error)
{
    struct stat info;
    if (path[0] == '\0')
        return brdf_fail(error, BRDF_IO, "the name of the file to write is empty");
    brdf_status status = resolve(path, target, &info, error);
    if (status != BRDF_OK)
        return status;
    *mode = info.st_mode & 07777;
    if (S_ISDIR(info.st_mode) || (*target)[strlen(*target) - 1] == '/')
        status = brdf_fail(error, BRDF_IO, "%s: is a folder; name a file in it", path);
    else if (info.st_mode && !S_ISREG(info.st_mode))
        status = brdf_fail(error, BRDF_IO,
                           "%s: is a device, a pipe or a socket, which cannot be replaced whole; "
                           "name an ordinary file",
                           path);
    else if (info.st_mode && access(*target, W_OK) != 0)
        status = fail_errno(error, path, "exists and may not be overwritten");
    else
        status = check_folder(path, *target, error);
    if (status != BRDF_OK) {
        free(*target);
        *target = NULL;
    }
    return status;
}

brdf_status brdfcl_atomic_check(const char *path, struct brdf_error *error)
{
    char *target = NULL;
    mode_t mode;
    brdf_status status = prepare(path, &target, &mode, error);
    free(target);
    return status;
}

/* Six letters that differ between processes and calls; O_EXCL does the rest. */
static void fill_random(char *letters, unsigned attempt)
{
    static const char alphabet[] = "abcdefghijklmnopqrstuvwxyz0123456789";
    struct timespec now = {0, 0};
    clock_gettime(CLOCK_REALTIME, &now);
    uint64_t bits = (uint64_t)now.tv_nsec ^ ((uint64_t)now.tv_sec << 30) ^
                    ((uint64_t)getpid() << 40) ^ (uint64_t)(uintptr_t)letters;
    bits = (bits + attempt) * 0x9e3779b97f4a7c15u;
    bits ^= bits >> 32;
    for (int i = 0; i < 6; i++) {
        letters[i] = alphabet[bits % 36];
        bits /= 36;
    }
}

/*
 * Not mkstemp(): that makes files of mode 0600, and the umask, which should decide, cannot be read
 * without changing it for the whole process.
 */
static brdf_status open_temporary(struct brdfcl_atomic_file *file, struct brdf_error *error)
{
    static const char blank[] = ".XXXXXX.tmp";
    size_t prefix = folder_length(file->target);
    const char *name = file->target + prefix;
    size_t kept = strlen(name);
    if (kept > NAME_KEPT)
        kept = NAME_KEPT;
    file->temporary = malloc(prefix + 1 + kept + sizeof blank);
    if (!file->temporary)
        return fail_memory(error, file->path);
    memcpy(file->temporary, file->target, prefix);
    file->temporary[prefix] = '.';
    memcpy(file->temporary + prefix + 1, name, kept);
    memcpy(file->temporary + prefix + 1 + kept, blank, sizeof blank);
    for (unsigned attempt = 0; attempt < TRIES_MAX; attempt++) {
        fill_random(file->temporary + prefix + 1 + kept + 1, attempt);
        file->fd = open(file->temporary, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file->fd >= 0)
            return BRDF_OK;
        if (errno != EEXIST)
            break;
    }
    brdf_status status = fail_errno(error, file->path, "cannot make a temporary file beside it");
    free(file->temporary); /* not ours: discard must not remove it */
    file->temporary = NULL;
    return status;
}

brdf_status brdfcl_atomic_open(struct brdfcl_atomic_file *file, const char *path,
                               struct brdf_error *error)
{
    mode_t mode = 0;
    memset(file, 0, sizeof *file);
    file->path = path;
    file->fd = -1;
    brdf_status status = prepare(path, &file->target, &mode, error);
    if (status == BRDF_OK)
        status = open_temporary(file, error);
    if (status == BRDF_OK && mode != 0 && fchmod(file->fd, mode) != 0)
        status = fail_errno(error, path, "cannot take over the permissions of the old file");
    if (status != BRDF_OK)
        brdfcl_atomic_discard(file);
    return status;
}

brdf_status brdfcl_atomic_write(struct brdfcl_atomic_file *file, const void *data, size_t size,
                                long long offset, struct brdf_error *error)
{
    const char *bytes = data;
    for (size_t done = 0; done < size;) {
        ssize_t n = pwrite(file->fd, bytes + done, size - done, (off_t)(offset + (long long)done));
        if (n < 0 && errno == EINTR)
            continue;
        if (n == 0)
            errno = ENOSPC;
        if (n <= 0)
            return fail_errno(error, file->path, "cannot be written");
        done += (size_t)n;
    }
    return BRDF_OK;
}

/* Make the new name last through a power cut. Too late to fail: the file is already in place. */
static void sync_folder(const char *target)
{
    char *folder = folder_copy(target);
    int fd = folder ? open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (fd >= 0) {
        fsync(fd);
        close(fd);
    }
    free(folder);
}

brdf_status brdfcl_atomic_commit(struct brdfcl_atomic_file *file, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    /* EINVAL: a file system that has nothing to flush. */
    if (fsync(file->fd) != 0 && errno != EINVAL)
        status = fail_errno(error, file->path, "cannot be written");
    int closed = close(file->fd);
    file->fd = -1;
    if (status == BRDF_OK && closed != 0)
        status = fail_errno(error, file->path, "cannot be written");
    if (status == BRDF_OK && rename(file->temporary, file->target) != 0)
        status = fail_errno(error, file->path, "cannot be put in place");
    if (status == BRDF_OK) {
        sync_folder(file->target);
        free(file->temporary);
        file->temporary = NULL;
    }
    brdfcl_atomic_discard(file);
    return status;
}

void brdfcl_atomic_discard(struct brdfcl_atomic_file *file)
{
    if (file->fd >= 0)
        close(file->fd);
    if (file->temporary)
        unlink(file->temporary);
    free(file->temporary);
    free(file->target);
    file->temporary = NULL;
    file->target = NULL;
    file->fd = -1;
}
