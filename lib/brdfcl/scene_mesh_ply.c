/*
 * scene_mesh_ply.c - the header of a ply file, read before assimp sees the file: assimp 5.2 loops
 * forever over a header that does not end, and believes every count.
 */
#include "scene_mesh.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#define PLY_WORDS 6

/* One line of the header as words; at most PLY_WORDS are kept. */
struct ply_line {
    char text[256];
    char *words[PLY_WORDS];
    int count;
};

/* Split the next line off; 0 at the end of the file, or where the line is longer than any of a
   header. Only "comment" and "obj_info" lines may be, and are cut. */
static int ply_next(const char *bytes, size_t length, size_t *at, struct ply_line *line)
{
    const char *begin = bytes + *at;
    const char *end = memchr(begin, '\n', length - *at);
    size_t size;
    char *word;
    if (!end) {
        return 0;
    }
    *at += (size_t)(end - begin) + 1;
    size = (size_t)(end - begin);
    size = size < sizeof line->text - 1 ? size : sizeof line->text - 1;
    memcpy(line->text, begin, size);
    line->text[size] = '\0';
    line->count = 0;
    word = line->text;
    for (;;) {
        word += strspn(word, " \t\r");
        if (*word == '\0' || line->count == PLY_WORDS) {
            return 1;
        }
        line->words[line->count++] = word;
        word += strcspn(word, " \t\r");
        if (*word) {
            *word++ = '\0';
        }
    }
}

/* The bytes of a number type in a binary file, 0 if there is no such type. */
static size_t ply_size(const char *type)
{
    return scene_list_has("char|uchar|int8|uint8", type)       ? 1
           : scene_list_has("short|ushort|int16|uint16", type) ? 2
           : scene_list_has("int|uint|float|int32|uint32|float32", type)
               ? 4
               : (size_t)(scene_list_has("double|float64", type) ? 8 : 0);
}

/* What the header promises. */
struct ply_header {
    int is_ascii;
    int has_format;
    size_t count; /* of the element that is being described */
    size_t bytes; /* of each one, at least */
    size_t total; /* of all elements before */
};

static void ply_close_element(struct ply_header *header)
{
    size_t each = header->is_ascii ? 1 : header->bytes;
    size_t most = (size_t)-1 - header->total;
    header->total += each > 0 && header->count > most / each ? most : header->count * each;
    header->count = 0;
    header->bytes = 0;
}

/* 0 if it is no line of a header. */
static int ply_take(struct ply_header *header, struct ply_line *line)
{
    char **words = line->words;
    if (line->count == 0 || scene_list_has("comment|obj_info", words[0])) {
        return 1;
    }
    if (strcmp(words[0], "format") == 0 && line->count == 3) {
        header->has_format = 1;
        header->is_ascii = strcmp(words[1], "ascii") == 0;
        return scene_list_has("ascii|binary_little_endian|binary_big_endian", words[1]);
    }
    if (strcmp(words[0], "element") == 0 && line->count == 3) {
        char *end = NULL;
        unsigned long count = strtoul(words[2], &end, 10);
        ply_close_element(header);
        header->count = count;
        return isdigit((unsigned char)words[2][0]) && *end == '\0' && count < 0xffffffffu;
    }
    if (strcmp(words[0], "property") == 0 && line->count == 3) {
        header->bytes += ply_size(words[1]);
        return ply_size(words[1]) > 0;
    }
    if (strcmp(words[0], "property") == 0 && line->count == 5 && strcmp(words[1], "list") == 0) {
        header->bytes += ply_size(words[2]);
        return ply_size(words[2]) > 0 && ply_size(words[3]) > 0;
    }
    return 0;
}

brdf_status mesh_check_ply(const struct scene_loader *loader, const struct xml_node *node,
                           const char *path, const char *bytes, size_t length)
{
    struct ply_header header = {0, 0, 0, 0, 0};
    struct ply_line line;
    size_t at = 0;
    int number = 1;
    if (!ply_next(bytes, length, &at, &line) || line.count != 1 ||
        strcmp(line.words[0], "ply") != 0) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "%s: does not begin with \"ply\"", path);
    }
    for (;;) {
        ++number;
        if (!ply_next(bytes, length, &at, &line)) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "%s: the header has no end_header",
                              path);
        }
        if (line.count == 1 && strcmp(line.words[0], "end_header") == 0) {
            break;
        }
        if (!ply_take(&header, &line)) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "%s:%d: not a line of a ply header",
                              path, number);
        }
    }
    ply_close_element(&header);
    if (!header.has_format) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "%s: the header has no format", path);
    }
    if (header.total > length - at) {
        return scene_fail(loader, node, BRDF_BAD_FILE,
                          "%s: %lu bytes after the header, which promises %lu or more", path,
                          (unsigned long)(length - at), (unsigned long)header.total);
    }
    return BRDF_OK;
}
