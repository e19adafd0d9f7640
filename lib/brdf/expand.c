/* expand.c - one text out of many: quoted includes replaced by the files that they name. */
#include "brdf/source.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "brdf/info.h"
#include "embedded.h"
#include "scan.h"

enum { DEEPEST = 64, PATH_SIZE = 256, MOST_FILES = 512 };

struct expansion {
    const struct brdf_source_file *more;             /* may be NULL */
    const struct brdf_source_file *read[MOST_FILES]; /* those whose guard is passed */
    size_t read_count;
    int depth;
    char *text;
    size_t length;
    size_t size;
    struct brdf_error *error;
};

/* A file or the caller's text: lines end with their terminator or a newline. */
struct input {
    const char *name;
    const char *const *lines;
    struct brdf_guard skip; /* lines to leave out; first < 0: none */
};

static brdf_status put(struct expansion *x, const char *text, size_t length)
{
    if (x->length + length + 1 > x->size) {
        size_t size = 2 * (x->length + length + 1);
        char *larger = realloc(x->text, size);
        if (!larger) {
            return brdf_fail(x->error, BRDF_OUT_OF_MEMORY, "out of memory");
        }
        x->text = larger;
        x->size = size;
    }
    memcpy(x->text + x->length, text, length);
    x->length += length;
    x->text[x->length] = '\0';
    return BRDF_OK;
}

/* Tell the compiler where the next line comes from; lines count from 1 there. */
static brdf_status put_place(struct expansion *x, const char *name, int line)
{
    char directive[32];
    int length = snprintf(directive, sizeof directive, "#line %d \"", line + 1);
    brdf_status status = put(x, directive, (size_t)length);
    for (; !status && *name != '\0'; ++name) {
        if (*name == '"' || *name == '\\') {
            status = put(x, "\\", 1);
        }
        status = status ? status : put(x, name, 1);
    }
    return status ? status : put(x, "\"\n", 2);
}

static const struct brdf_source_file *lookup(const struct expansion *x, const char *name)
{
    const struct brdf_source_file *const tables[] = {x->more, brdf_embedded_files};
    for (int i = 0; i < 2; ++i) {
        for (const struct brdf_source_file *file = tables[i]; file && file->name; ++file) {
            if (strcmp(file->name, name) == 0) {
                return file;
            }
        }
    }
    return NULL;
}

/* Append a path to another, "." and ".." resolved; 0 if it is too long or leaves the root. */
static int append_path(char path[PATH_SIZE], const char *more, size_t length)
{
    const char *end = more + length;
    while (more < end) {
        const char *slash = memchr(more, '/', (size_t)(end - more));
        size_t part = (size_t)((slash ? slash : end) - more);
        size_t used = strlen(path);
        if (part == 2 && memcmp(more, "..", 2) == 0) {
            char *last = strrchr(path, '/');
            if (used == 0) {
                return 0;
            }
            *(last ? last : path) = '\0';
        } else if (part > 0 && !(part == 1 && *more == '.')) {
            if (used + part + 2 > PATH_SIZE) {
                return 0;
            }
            snprintf(path + used, PATH_SIZE - used, "%s%.*s", used ? "/" : "", (int)part, more);
        }
        more += part + (slash != NULL);
    }
    return 1;
}

/* Beside the including file, then from the root, then under brdf/. */
static const struct brdf_source_file *find(const struct expansion *x, const char *from,
                                           const struct brdf_line *include)
{
    const char *slash = strrchr(from, '/');
    const struct {
        const char *directory;
        size_t length;
    } places[] = {{from, slash ? (size_t)(slash - from) : 0}, {"", 0}, {"brdf", 4}};
    for (int i = 0; i < 3; ++i) {
        char path[PATH_SIZE] = "";
        if (append_path(path, places[i].directory, places[i].length) &&
            append_path(path, include->word, include->length)) {
            const struct brdf_source_file *file = lookup(x, path);
            if (file) {
                return file;
            }
        }
    }
    return NULL;
}

static brdf_status refuse_include(struct expansion *x, const struct input *in, int line,
                                  const struct brdf_line *include)
{
    const struct brdf_source_file *const tables[] = {x->more, brdf_embedded_files};
    const char *names[MOST_FILES];
    size_t count = 0;
    for (int i = 0; i < 2; ++i) {
        for (const struct brdf_source_file *f = tables[i]; f && f->name && count < MOST_FILES;
             ++f) {
            names[count++] = f->name;
        }
    }
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%.*s", (int)include->length, include->word);
    const char *nearest = brdf_name_nearest(path, names, count);
    return brdf_fail(x->error, BRDF_UNKNOWN_NAME, "%.200s:%d: there is no \"%s\" to include%s%s%s",
                     in->name, line + 1, path, nearest ? "; did you mean \"" : "",
                     nearest ? nearest : "", nearest ? "\"?" : "");
}

static brdf_status expand(struct expansion *x, const struct input *in);

static brdf_status expand_include(struct expansion *x, const struct input *in, int line,
                                  const struct brdf_line *include)
{
    const struct brdf_source_file *file = find(x, in->name, include);
    if (!file) {
        return refuse_include(x, in, line, include);
    }
    if (x->depth == DEEPEST) {
        return brdf_fail(x->error, BRDF_BAD_ARGUMENT,
                         "%.200s:%d: includes are nested deeper than %d: a circle without guards",
                         in->name, line + 1, DEEPEST);
    }
    struct input inner = {file->name, file->lines, {-1, -1}};
    struct brdf_guard guard = brdf_scan_guard(file->lines);
    for (size_t i = 0; i < x->read_count; ++i) {
        if (x->read[i] == file) {
            inner.skip = guard;
        }
    }
    if (guard.first >= 0 && inner.skip.first < 0 && x->read_count < MOST_FILES) {
        x->read[x->read_count++] = file;
    }
    ++x->depth;
    brdf_status status = expand(x, &inner);
    --x->depth;
    return status;
}

/*
 * Where a guard is left out, blank lines and comments around it are left out as well: they would be
 * all that most files give. A comment that began on a line that was put out must be finished.
 */
static brdf_status expand(struct expansion *x, const struct input *in)
{
    struct brdf_scan scan = {0, 0};
    brdf_status status = BRDF_OK;
    int moved = 1, comment_open = 0, skipping = in->skip.first >= 0;
    for (int i = 0; !status && in->lines[i]; ++i) {
        int began_in_comment = scan.in_comment;
        struct brdf_line line = brdf_scan_line(&scan, in->lines[i]);
        int blank = line.directive == BRDF_DIRECTIVE_BLANK && !comment_open;
        if (skipping && (blank || (i >= in->skip.first && i <= in->skip.last))) {
            moved = 1;
        } else if (line.directive == BRDF_DIRECTIVE_INCLUDE && line.word) {
            status = expand_include(x, in, i, &line);
            moved = 1;
        } else {
            status = moved ? put_place(x, in->name, i) : BRDF_OK;
            if (!status && skipping && began_in_comment && !comment_open) {
                status = put(x, "/*", 2);
            }
            status = status ? status : put(x, in->lines[i], strcspn(in->lines[i], "\n"));
            status = status ? status : put(x, "\n", 1);
            comment_open = scan.in_comment;
            moved = 0;
        }
    }
    return status;
}

/* The start of each line of a text, NULL after the last; to be freed. */
static const char **split(const char *text)
{
    size_t count = 1;
    for (const char *c = text; *c != '\0'; ++c) {
        count += *c == '\n';
    }
    const char **lines = malloc((count + 1) * sizeof *lines);
    size_t i = 0;
    while (lines && *text != '\0') {
        lines[i++] = text;
        text += strcspn(text, "\n");
        text += *text == '\n';
    }
    if (lines) {
        lines[i] = NULL;
    }
    return lines;
}

brdf_status brdf_source_expand(const char *text, const char *text_name,
                               const struct brdf_source_file *more, char **out,
                               struct brdf_error *error)
{
    struct expansion x = {0};
    brdf_status status;
    *out = NULL;
    x.more = more;
    x.error = error;
    const char **lines = split(text);
    if (!lines) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
        goto done;
    }
    struct input in = {text_name, lines, {-1, -1}};
    status = put(&x, "", 0);
    status = status ? status : expand(&x, &in);
    if (!status) {
        *out = x.text;
        x.text = NULL;
    }
done:
    free((void *)lines);
    free(x.text);
    return status;
}
