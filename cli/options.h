/*
 * options.h - the options of a subcommand as a table, how they are read and how help shows them.
 *
 * --name VALUE, --name=VALUE, -x VALUE and -xVALUE mean the same; "--" ends the options, and what
 * begins with no dash (or is one) is an argument. What is given twice holds as given last, but for
 * lists. A text that is not a number, a name that is not known or a value that is missing is a
 * usage error (exit status 2); a number beyond its range is a failure that names the range (1).
 */
#ifndef BRDFCL_OPTIONS_H
#define BRDFCL_OPTIONS_H

#include <stddef.h>

/* What an option sets, and the type that `to` points at. */
enum option_kind {
    OPTION_ON,     /* no value; int, set to 1 */
    OPTION_OFF,    /* no value; int, set to 0 */
    OPTION_INT,    /* int in [low, high] */
    OPTION_REAL,   /* double in [low, high] */
    OPTION_REALS,  /* struct numbers, each in [low, high] */
    OPTION_TEXT,   /* const char * */
    OPTION_LIST,   /* struct texts */
    OPTION_CHOICE, /* int: which of the names in `value`, such as "opencl|c" */
    OPTION_SIZE,   /* struct size, each side in [low, high] */
    OPTION_ANGLES  /* struct angles */
};

struct option {
    const char *name; /* without its dashes; NULL if there is only the letter */
    char letter;      /* 0 if there is only the name */
    enum option_kind kind;
    void *to;
    const char *value; /* what help calls the value; NULL if it has none */
    double low, high;
    const char *help;
};

/* Texts of the command line, borrowed from it. */
struct texts {
    const char *item[64];
    int count;
};

struct usage {
    const char *command;   /* "render" */
    const char *arguments; /* "SCENE.xml" */
    const char *summary;   /* what it does, in lines that are ready to print */
    const struct option *options;
    size_t count;
    int least, most; /* arguments that must and may be given */
};

/* options_read's result where the command is to go on. */
#define OPTIONS_GO_ON (-1)

/* Read a command line into what the table points at, and its arguments into `arguments`. Returns
   OPTIONS_GO_ON, or an exit status: after --help, or after having said what is wrong. */
int options_read(const struct usage *usage, int argc, char **argv, struct texts *arguments);

/* What --help prints. */
void options_help(const struct usage *usage);

#endif
