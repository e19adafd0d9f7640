/* scan.c - directives found, not evaluated; comments, strings and continued lines are minded. */
#include "scan.h"

#include <string.h>

static int at_end(char c)
{
    return c == '\0' || c == '\n';
}

/* The first character that is neither space nor comment. */
static const char *skip_blank(struct brdf_scan *scan, const char *c)
{
    while (!at_end(*c)) {
        if (scan->in_comment) {
            scan->in_comment = !(c[0] == '*' && c[1] == '/');
            c += scan->in_comment ? 1 : 2;
        } else if (c[0] == '/' && c[1] == '*') {
            scan->in_comment = 1;
            c += 2;
        } else if (strchr(" \t\r\f\v", *c)) {
            ++c;
        } else {
            break;
        }
    }
    return !scan->in_comment && c[0] == '/' && c[1] == '/' ? c + strcspn(c, "\n") : c;
}

/* To the end of the line, past strings and comments, to know how the next line begins. */
static void skip_rest(struct brdf_scan *scan, const char *c)
{
    char quote = '\0', last = '\0';
    while (!at_end(*c)) {
        if (quote) {
            int escaped = c[0] == '\\' && !at_end(c[1]);
            quote = !escaped && *c == quote ? '\0' : quote;
            c += escaped;
            last = *c++;
            continue;
        }
        const char *code = skip_blank(scan, c);
        if (code != c) {
            last = code[-1];
            c = code;
            continue;
        }
        quote = *c == '"' || *c == '\'' ? *c : '\0';
        last = *c++;
    }
    scan->continued = last == '\\';
}

static size_t name_length(const char *c)
{
    return strspn(c, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
}

static int is_word(const char *word, size_t length, const char *expected)
{
    return length == strlen(expected) && memcmp(word, expected, length) == 0;
}

static enum brdf_directive directive_of(const char *word, size_t length)
{
    static const struct {
        const char *word;
        enum brdf_directive directive;
    } known[] = {
        {"include", BRDF_DIRECTIVE_INCLUDE}, {"ifndef", BRDF_DIRECTIVE_IFNDEF},
        {"if", BRDF_DIRECTIVE_IF},           {"ifdef", BRDF_DIRECTIVE_IF},
        {"else", BRDF_DIRECTIVE_ELSE},       {"elif", BRDF_DIRECTIVE_ELSE},
        {"endif", BRDF_DIRECTIVE_ENDIF},     {"define", BRDF_DIRECTIVE_DEFINE},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        if (is_word(word, length, known[i].word)) {
            return known[i].directive;
        }
    }
    return BRDF_DIRECTIVE_OTHER;
}

struct brdf_line brdf_scan_line(struct brdf_scan *scan, const char *text)
{
    struct brdf_line line = {BRDF_DIRECTIVE_NONE, NULL, 0};
    int continued = scan->continued;
    const char *c = skip_blank(scan, text);
    if (at_end(*c)) {
        line.directive = continued ? BRDF_DIRECTIVE_NONE : BRDF_DIRECTIVE_BLANK;
    } else if (!continued && *c == '#') {
        c = skip_blank(scan, c + 1);
        size_t length = name_length(c);
        line.directive = directive_of(c, length);
        c = skip_blank(scan, c + length);
        if (line.directive == BRDF_DIRECTIVE_INCLUDE && *c == '"') {
            line.length = strcspn(c + 1, "\"\n");
            line.word = c[1 + line.length] == '"' ? c + 1 : NULL;
        } else if (line.directive == BRDF_DIRECTIVE_IFNDEF ||
                   line.directive == BRDF_DIRECTIVE_DEFINE) {
            line.length = name_length(c);
            line.word = c;
        }
    }
    skip_rest(scan, c);
    return line;
}

struct brdf_guard brdf_scan_guard(const char *const *lines)
{
    struct brdf_guard guard = {-1, -1}, none = {-1, -1};
    struct brdf_scan scan = {0, 0};
    struct brdf_line name = {BRDF_DIRECTIVE_NONE, NULL, 0};
    int depth = 0, defined = 0;
    for (int i = 0; lines[i]; ++i) {
        struct brdf_line line = brdf_scan_line(&scan, lines[i]);
        if (line.directive == BRDF_DIRECTIVE_BLANK) {
            continue;
        }
        if (guard.first < 0) {
            if (line.directive != BRDF_DIRECTIVE_IFNDEF) {
                return none;
            }
            guard.first = i;
            name = line;
        } else if (!defined) {
            if (line.directive != BRDF_DIRECTIVE_DEFINE || line.length != name.length ||
                memcmp(line.word, name.word, name.length) != 0) {
                return none;
            }
            defined = 1;
        } else if (depth == 1 && line.directive == BRDF_DIRECTIVE_ELSE) {
            return none;
        }
        depth += line.directive == BRDF_DIRECTIVE_IF || line.directive == BRDF_DIRECTIVE_IFNDEF;
        depth -= line.directive == BRDF_DIRECTIVE_ENDIF;
        if (depth == 0) {
            guard.last = i;
            return guard;
        }
    }
    return none;
}
