/* options.c - command lines by table. */
#include "options.h"

#include <stdio.h>
#include <string.h>

#include <brdf/info.h>

#include "commands.h"
#include "parse.h"
#include "say.h"

enum { MOST_NAMES = 64 };

static int has_value(const struct option *option)
{
    return option->kind != OPTION_ON && option->kind != OPTION_OFF;
}

/* The option of a name of some length; NULL if there is none. */
static const struct option *find_name(const struct usage *usage, const char *name, size_t length)
{
    for (size_t i = 0; i < usage->count; ++i) {
        const char *known = usage->options[i].name;
        if (known && strlen(known) == length && strncmp(known, name, length) == 0) {
            return &usage->options[i];
        }
    }
    return NULL;
}

static const struct option *find_letter(const struct usage *usage, char letter)
{
    for (size_t i = 0; i < usage->count; ++i) {
        if (usage->options[i].letter && usage->options[i].letter == letter) {
            return &usage->options[i];
        }
    }
    return NULL;
}

static int unknown_option(const struct usage *usage, const char *given, const char *name,
                          size_t length)
{
    const char *names[MOST_NAMES];
    size_t count = 0;
    char text[64];
    snprintf(text, sizeof text, "%.*s", (int)(length < 60 ? length : 60), name);
    for (size_t i = 0; i < usage->count && count < MOST_NAMES; ++i) {
        if (usage->options[i].name) {
            names[count++] = usage->options[i].name;
        }
    }
    const char *nearest = length ? brdf_name_nearest(text, names, count) : NULL;
    char dashed[72];
    snprintf(dashed, sizeof dashed, "--%s", nearest ? nearest : "");
    return say_usage("unknown option \"%s\"%s; \"brdfcl %s --help\" lists them", given,
                     say_nearest(nearest ? dashed : NULL).text, usage->command);
}

/* Which of the names "a|b|c" a text is; -1 if none. */
static int choice_of(const char *names, const char *text)
{
    size_t length = strlen(text);
    for (int i = 0;; ++i) {
        size_t span = strcspn(names, "|");
        if (span == length && strncmp(names, text, span) == 0) {
            return i;
        }
        if (!names[span]) {
            return -1;
        }
        names += span + 1;
    }
}

static enum parse_result set_value(const struct option *option, const char *text)
{
    switch (option->kind) {
    case OPTION_INT:
        return parse_int(text, option->low, option->high, option->to);
    case OPTION_REAL:
        return parse_real(text, option->low, option->high, option->to);
    case OPTION_REALS:
        return parse_list(text, option->low, option->high, option->to);
    case OPTION_SIZE:
        return parse_size(text, option->low, option->high, option->to);
    case OPTION_ANGLES:
        return parse_angles(text, option->to);
    case OPTION_CHOICE: {
        int choice = choice_of(option->value, text);
        *(int *)option->to = choice;
        return choice < 0 ? PARSE_MALFORMED : PARSE_OK;
    }
    case OPTION_LIST: {
        struct texts *list = option->to;
        if (list->count == (int)(sizeof list->item / sizeof list->item[0])) {
            return PARSE_RANGE;
        }
        list->item[list->count++] = text;
        return PARSE_OK;
    }
    default:
        *(const char **)option->to = text;
        return PARSE_OK;
    }
}

/* A value that is not of the kind wanted: say what would be. */
static int say_malformed(const struct option *option, const char *shown, const char *text)
{
    switch (option->kind) {
    case OPTION_INT:
        return say_usage("%s \"%s\": expected a whole number from %.15g to %.15g", shown, text,
                         option->low, option->high);
    case OPTION_REAL:
        return say_usage("%s \"%s\": expected a number from %.15g to %.15g", shown, text,
                         option->low, option->high);
    case OPTION_REALS:
        return say_usage("%s \"%s\": expected numbers from %.15g to %.15g, as in 1,2.5,4", shown,
                         text, option->low, option->high);
    case OPTION_SIZE:
        return say_usage("%s \"%s\": expected WIDTHxHEIGHT in pixels, as in 640x480", shown, text);
    case OPTION_ANGLES:
        return say_usage("%s \"%s\": expected THETA,PHI in degrees, as in 30,180", shown, text);
    default:
        return say_usage("%s \"%s\": expected one of %s", shown, text, option->value);
    }
}

/* Give an option its value; an exit status, or OPTIONS_GO_ON. */
static int apply(const struct option *option, const char *shown, const char *text)
{
    if (!has_value(option)) {
        *(int *)option->to = option->kind == OPTION_ON;
        return OPTIONS_GO_ON;
    }
    switch (set_value(option, text)) {
    case PARSE_OK:
        return OPTIONS_GO_ON;
    case PARSE_MALFORMED:
        return say_malformed(option, shown, text);
    default:
        break;
    }
    if (option->kind == OPTION_ANGLES) {
        say("%s \"%s\": theta goes from 0 to 180 degrees, phi is finite", shown, text);
    } else if (option->kind == OPTION_LIST) {
        say("%s is given more often than 64 times", shown);
    } else if (option->kind == OPTION_REALS) {
        say("%s \"%s\": up to 256 numbers from %.15g to %.15g", shown, text, option->low,
            option->high);
    } else {
        say("%s \"%s\" is out of range: from %.15g to %.15g", shown, text, option->low,
            option->high);
    }
    return EXIT_FAILED;
}

/* One option at argv[*at]; *at moves on to its value if that is the next argument. */
static int read_option(const struct usage *usage, int argc, char **argv, int *at)
{
    const char *given = argv[*at];
    int is_long = given[1] == '-';
    const char *name = given + 1 + is_long;
    size_t length = is_long ? strcspn(name, "=") : 1;
    const struct option *option =
        is_long ? find_name(usage, name, length) : find_letter(usage, *name);
    if (!option) {
        return unknown_option(usage, given, name, is_long ? length : strlen(name));
    }
    char shown[64];
    snprintf(shown, sizeof shown, "%.*s", (int)(name + length - given), given);
    const char *text = NULL;
    if (name[length]) {
        text = name + length + is_long;
        if (!has_value(option)) {
            return say_usage("%s takes no value", shown);
        }
    } else if (has_value(option)) {
        if (*at + 1 >= argc) {
            return say_usage("%s needs a value: %s", shown, option->value);
        }
        text = argv[++*at];
    }
    return apply(option, shown, text);
}

static int is_help(const char *text)
{
    return strcmp(text, "--help") == 0 || strcmp(text, "-h") == 0;
}

int options_read(const struct usage *usage, int argc, char **argv, struct texts *arguments)
{
    int only_arguments = 0;
    arguments->count = 0;
    for (int i = 0; i < argc; ++i) {
        const char *text = argv[i];
        if (only_arguments || text[0] != '-' || text[1] == '\0') {
            if (arguments->count == usage->most) {
                return say_usage("\"%s\" is one argument too many; usage: brdfcl %s %s", text,
                                 usage->command, usage->arguments);
            }
            arguments->item[arguments->count++] = text;
        } else if (strcmp(text, "--") == 0) {
            only_arguments = 1;
        } else if (is_help(text)) {
            options_help(usage);
            return EXIT_DONE;
        } else {
            int status = read_option(usage, argc, argv, &i);
            if (status != OPTIONS_GO_ON) {
                return status;
            }
        }
    }
    if (arguments->count < usage->least) {
        return say_usage("an argument is missing; usage: brdfcl %s %s", usage->command,
                         usage->arguments);
    }
    return OPTIONS_GO_ON;
}

static void help_option(const struct option *option)
{
    char left[64];
    char letter[4] = "   ";
    if (option->letter) {
        snprintf(letter, sizeof letter, "-%c%c", option->letter, option->name ? ',' : ' ');
    }
    snprintf(left, sizeof left, "%s %s%s%s%s", letter, option->name ? "--" : "",
             option->name ? option->name : "", option->value && option->name ? " " : "",
             option->value ? option->value : "");
    printf("  %-26s %s\n", left, option->help);
}

void options_help(const struct usage *usage)
{
    printf("usage: brdfcl %s %s%s\n\n%s\n", usage->command, usage->arguments,
           usage->count ? " [options]" : "", usage->summary);
    if (usage->count) {
        printf("\n");
    }
    for (size_t i = 0; i < usage->count; ++i) {
        help_option(&usage->options[i]);
    }
}
