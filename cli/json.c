/* json.c - JSON as it is written. */
#include "json.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text_file.h"

static void put(struct json *json, const char *text, size_t length)
{
    if (json->failed) {
        return;
    }
    if (json->length + length + 1 > json->room) {
        size_t room = 2 * (json->length + length) + 256;
        char *larger = realloc(json->text, room);
        if (!larger) {
            json->failed = 1;
            return;
        }
        json->text = larger;
        json->room = room;
    }
    memcpy(json->text + json->length, text, length);
    json->length += length;
    json->text[json->length] = '\0';
}

static void put_text(struct json *json, const char *text)
{
    put(json, text, strlen(text));
}

/* How many bytes the UTF-8 character at `s` has; 0 if they are none. */
static size_t utf8_length(const unsigned char *s)
{
    size_t length = s[0] < 0x80                   ? 1
                    : s[0] >= 0xc2 && s[0] < 0xe0 ? 2
                    : s[0] >= 0xe0 && s[0] < 0xf0 ? 3
                    : s[0] >= 0xf0 && s[0] < 0xf5 ? 4
                                                  : 0;
    for (size_t i = 1; i < length; ++i) {
        if ((s[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    /* Overlong forms, surrogates, and what is beyond the last code point. */
    if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0) ||
        (s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] >= 0x90)) {
        return 0;
    }
    return length;
}

static void put_string(struct json *json, const char *text)
{
    const unsigned char *s = (const unsigned char *)text;
    put_text(json, "\"");
    while (*s) {
        char escape[8];
        size_t length = utf8_length(s);
        if (length == 0) {
            put_text(json, "\xef\xbf\xbd"); /* U+FFFD */
            length = 1;
        } else if (*s == '"' || *s == '\\') {
            snprintf(escape, sizeof escape, "\\%c", *s);
            put_text(json, escape);
        } else if (*s < 0x20) {
            snprintf(escape, sizeof escape, "\\u%04x", *s);
            put_text(json, escape);
        } else {
            put(json, (const char *)s, length);
        }
        s += length;
    }
    put_text(json, "\"");
}

/* What goes before a value: a comma, a new line, the key. */
static void begin_value(struct json *json, const char *key)
{
    if (json->depth) {
        put_text(json, json->filled ? ",\n" : "\n");
        for (int i = 0; i < json->depth; ++i) {
            put_text(json, "  ");
        }
    }
    if (key) {
        put_string(json, key);
        put_text(json, ": ");
    }
    json->filled = 1;
}

static void open_group(struct json *json, const char *key, const char *mark)
{
    begin_value(json, key);
    put_text(json, mark);
    ++json->depth;
    json->filled = 0;
}

static void close_group(struct json *json, const char *mark)
{
    --json->depth;
    if (json->filled) {
        put_text(json, "\n");
        for (int i = 0; i < json->depth; ++i) {
            put_text(json, "  ");
        }
    }
    put_text(json, mark);
    json->filled = 1;
    if (!json->depth) {
        put_text(json, "\n");
    }
}

void json_object(struct json *json, const char *key)
{
    open_group(json, key, "{");
}

void json_object_end(struct json *json)
{
    close_group(json, "}");
}

void json_array(struct json *json, const char *key)
{
    open_group(json, key, "[");
}

void json_array_end(struct json *json)
{
    close_group(json, "]");
}

void json_text(struct json *json, const char *key, const char *value)
{
    begin_value(json, key);
    put_string(json, value);
}

void json_int(struct json *json, const char *key, long long value)
{
    char text[32];
    begin_value(json, key);
    snprintf(text, sizeof text, "%lld", value);
    put_text(json, text);
}

void json_real(struct json *json, const char *key, double value)
{
    char text[32] = "null";
    begin_value(json, key);
    if (isfinite(value)) {
        snprintf(text, sizeof text, "%.9g", value);
    }
    put_text(json, text);
}

brdf_status json_write(const struct json *json, const char *path, struct brdf_error *error)
{
    if (json->failed || !json->text) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory for its text", path);
    }
    return text_file_write(path, json->text, json->length, error);
}

void json_free(struct json *json)
{
    free(json->text);
    memset(json, 0, sizeof *json);
}
