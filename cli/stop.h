/*
 * stop.h - Ctrl-C (and SIGTERM, SIGHUP) while there is something to save.
 *
 * The first signal asks, a second one quits at once. Where there is nothing to save the first one
 * quits. While files are written both wait, so that no temporary file is left.
 */
#ifndef BRDFCL_STOP_H
#define BRDFCL_STOP_H

enum stop_phase {
    STOP_QUITS, /* nothing to save */
    STOP_ASKS,  /* the work in progress looks at stop_signal() */
    STOP_WAITS  /* files are being written */
};

/* Begin to listen, in the phase STOP_QUITS. */
void stop_install(void);

void stop_set_phase(enum stop_phase phase);

/* A file is about to be written: listen, if nobody does yet, and wait. */
void stop_wait(void);

/* It is written: back to the phase before stop_wait. */
void stop_resume(void);

/* The signal that came first, or 0. The exit status that belongs to it is 128 + its number. */
int stop_signal(void);

#endif
