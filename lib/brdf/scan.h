/*
 * scan.h - as much of the C preprocessor's reading as it takes to find directives (internal).
 */
#ifndef BRDF_SCAN_H
#define BRDF_SCAN_H

#include <stddef.h>

enum brdf_directive {
    BRDF_DIRECTIVE_NONE,  /* a line of code */
    BRDF_DIRECTIVE_BLANK, /* nothing but spaces and comments */
    BRDF_DIRECTIVE_INCLUDE,
    BRDF_DIRECTIVE_IFNDEF,
    BRDF_DIRECTIVE_IF,   /* #if, #ifdef */
    BRDF_DIRECTIVE_ELSE, /* #else, #elif */
    BRDF_DIRECTIVE_ENDIF,
    BRDF_DIRECTIVE_DEFINE,
    BRDF_DIRECTIVE_OTHER
};

/* Where a reader stands; zeros before the first line. */
struct brdf_scan {
    int in_comment; /* a block comment goes on */
    int continued;  /* the last line ended with a backslash */
};

/* One line of a file. */
struct brdf_line {
    enum brdf_directive directive;
    const char *word; /* INCLUDE: the path if it is quoted, else NULL; IFNDEF, DEFINE: the name */
    size_t length;    /* of the word */
};

/* Read one line, which ends before a newline or at the end of the text. */
struct brdf_line brdf_scan_line(struct brdf_scan *scan, const char *text);

/*
 * The include guard of a file: #ifndef NAME, #define NAME before anything else, and the #endif that
 * belongs to them. Lines count from 0; first = last = -1 if there is none.
 */
struct brdf_guard {
    int first;
    int last;
};
struct brdf_guard brdf_scan_guard(const char *const *lines);

#endif
