/*
 * json.h - JSON as it is written: objects and arrays opened, filled and closed in order.
 *
 * What is written is always valid: texts are escaped, bytes that are not UTF-8 replaced, numbers
 * that JSON lacks (NaN, infinities) written as null.
 */
#ifndef BRDFCL_JSON_H
#define BRDFCL_JSON_H

#include <stddef.h>

#include <brdf/status.h>

/* Begin with all zero; the text is malloc'd, grows, and is to be freed with json_free. */
struct json {
    char *text;
    size_t length;
    size_t room;
    int depth;
    int filled; /* the innermost object or array has a member already */
    int failed; /* out of memory: the text is not complete */
};

/* `key` is NULL in arrays and for the outermost value. */
void json_object(struct json *json, const char *key);
void json_object_end(struct json *json);
void json_array(struct json *json, const char *key);
void json_array_end(struct json *json);
void json_text(struct json *json, const char *key, const char *value);
void json_int(struct json *json, const char *key, long long value);
void json_real(struct json *json, const char *key, double value);

/*
 * Write the text to a file, whole or not at all: under a temporary name in its folder, then
 * renamed.
 * "-" is standard output. BRDF_IO, BRDF_OUT_OF_MEMORY.
 */
brdf_status json_write(const struct json *json, const char *path, struct brdf_error *error);

void json_free(struct json *json);

#endif
