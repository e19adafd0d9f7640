/*
 * support_place.h - a place for a file: a temporary folder of its own.
 */
#ifndef SUPPORT_PLACE_H
#define SUPPORT_PLACE_H

struct place {
    char folder[256]; /* in $TMPDIR, or /tmp */
    char path[320];   /* of the file, which is not made */
};

/* 0, or -1 where no folder can be made. */
int place_make(struct place *place, const char *name);

/* Remove the file, if it is there, and the folder. Not 0 if anything else is left in it. */
int place_remove(struct place *place);

#endif
