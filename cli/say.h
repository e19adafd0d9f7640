/*
 * say.h - messages to the person at the terminal; all go to standard error, results do not.
 */
#ifndef BRDFCL_SAY_H
#define BRDFCL_SAY_H

#include <brdf/status.h>

#ifdef __GNUC__
#define SAY_FORMAT __attribute__((format(printf, 1, 2)))
#else
#define SAY_FORMAT
#endif

/* "brdfcl: " and a sentence made as printf would. */
SAY_FORMAT void say(const char *format, ...);

/* Say what an error holds; returns EXIT_FAILED, so that a command can end with it. */
int say_error(const struct brdf_error *error);

/* The same for a command line that was not understood; returns EXIT_USAGE. */
SAY_FORMAT int say_usage(const char *format, ...);

/* What is nearest to a name, " (did you mean 'X'?)", or "": for the end of a sentence. */
struct say_hint {
    char text[96];
};
struct say_hint say_nearest(const char *nearest);

#endif
