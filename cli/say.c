/* say.c - messages to the person at the terminal. */
#include "say.h"

#include <stdarg.h>
#include <stdio.h>

#include "commands.h"

static void say_list(const char *format, va_list list)
{
    fflush(stdout); /* so that both streams on one terminal keep their order */
    fputs("brdfcl: ", stderr);
    vfprintf(stderr, format, list);
    fputc('\n', stderr);
}

void say(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    say_list(format, list);
    va_end(list);
}

int say_error(const struct brdf_error *error)
{
    say("%s", error->message[0] ? error->message : brdf_status_text(error->status));
    return EXIT_FAILED;
}

int say_usage(const char *format, ...)
{
    va_list list;
    va_start(list, format);
    say_list(format, list);
    va_end(list);
    return EXIT_USAGE;
}

struct say_hint say_nearest(const char *nearest)
{
    struct say_hint hint = {""};
    if (nearest) {
        snprintf(hint.text, sizeof hint.text, " (did you mean \"%s\"?)", nearest);
    }
    return hint;
}
