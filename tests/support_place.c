/*
 * support_place.c - see support_place.h.
 */
#define _POSIX_C_SOURCE 200809L

#include "support_place.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

int place_make(struct place *place, const char *name)
{
    const char *parent = getenv("TMPDIR");
    int length = snprintf(place->folder, sizeof place->folder, "%s/brdfcl-test-XXXXXX",
                          parent && *parent ? parent : "/tmp");
    if (length >= (int)sizeof place->folder || !mkdtemp(place->folder)) {
        return -1;
    }
    length = snprintf(place->path, sizeof place->path, "%s/%s", place->folder, name);
    return length < (int)sizeof place->path ? 0 : -1;
}

int place_remove(struct place *place)
{
    unlink(place->path);
    return rmdir(place->folder);
}
