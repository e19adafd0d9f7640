/*
 * progress.h - how far a render is: a bar that moves on a terminal, a line now and then elsewhere.
 */
#ifndef BRDFCL_PROGRESS_H
#define BRDFCL_PROGRESS_H

#include <brdfcl/render.h>

struct progress {
    int quiet;
    int terminal;     /* standard error is one */
    int shown;        /* the bar stands in the current line */
    double said;      /* seconds at which the last line was printed */
    int said_percent; /* and what it said */
};

/* Before the first samples a terminal is told that something is being done. */
struct progress progress_begin(int quiet);

/* Show the state of the render. */
void progress_show(struct progress *progress, const struct brdfcl_progress *state);

/* Clear the bar away, so that other text can follow. */
void progress_end(struct progress *progress);

/* A number of things a second or a count in few letters, "5.43 M"; returns `text`. */
const char *short_number(double value, char text[16]);

/* Seconds as a person reads them, "12.3 s", "4 min 05 s", "2 h 07 min"; returns `text`. */
const char *short_time(double seconds, char text[32]);

#endif
