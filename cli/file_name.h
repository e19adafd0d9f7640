/*
 * file_name.h - what a person calls a file.
 */
#ifndef BRDFCL_FILE_NAME_H
#define BRDFCL_FILE_NAME_H

#include <string.h>

/* A path without its folders; points into it. */
static inline const char *file_name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

#endif
