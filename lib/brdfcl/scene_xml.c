/*
 * scene_xml.c - expat's events, made a tree.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_xml.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <expat.h>

#define XML_CHUNK 65536
#define XML_DEPTH_MAX 64 /* later walks are recursive */

/* The header of one allocation; aligned for whatever follows it. */
struct xml_block {
    union {
        struct xml_block *next;
        double alignment;
    } header;
};

struct xml_reader {
    struct xml_document *document;
    struct xml_node *open; /* the innermost element that has not ended */
    XML_Parser parser;
    int depth;
    brdf_status status;
    struct brdf_error *error;
};

void *xml_allocate(struct xml_document *document, size_t size)
{
    struct xml_block *block = NULL;
    if (size <= SIZE_MAX - sizeof *block) {
        block = calloc(1, sizeof *block + size);
    }
    if (!block) {
        return NULL;
    }
    block->header.next = document->blocks;
    document->blocks = block;
    return block + 1;
}

const char *xml_copy(struct xml_document *document, const char *text, size_t length)
{
    char *copy = xml_allocate(document, length + 1);
    if (copy) {
        memcpy(copy, text, length);
    }
    return copy;
}

const char *xml_attribute_get(const struct xml_node *node, const char *name)
{
    for (int i = 0; i < node->attribute_count; ++i) {
        if (strcmp(node->attributes[i].name, name) == 0) {
            return node->attributes[i].value;
        }
    }
    return NULL;
}

static void xml_stop(struct xml_reader *reader, brdf_status status, const char *what)
{
    if (reader->status) {
        return;
    }
    reader->status = brdf_fail(reader->error, status, "%s:%lu:%lu: %s", reader->document->path,
                               (unsigned long)XML_GetCurrentLineNumber(reader->parser),
                               (unsigned long)XML_GetCurrentColumnNumber(reader->parser) + 1, what);
    XML_StopParser(reader->parser, XML_FALSE);
}

static void xml_append(struct xml_reader *reader, struct xml_node *node)
{
    struct xml_node *parent = reader->open;
    node->parent = parent;
    if (!parent) {
        reader->document->root = node;
    } else if (parent->last) {
        parent->last->next = node;
    } else {
        parent->child = node;
    }
    if (parent) {
        parent->last = node;
    }
}

static int xml_fill(struct xml_document *document, struct xml_node *node, const char *tag,
                    const char **attributes)
{
    int count = 0;
    while (attributes[2 * count]) {
        ++count;
    }
    node->tag = xml_copy(document, tag, strlen(tag));
    node->attributes = xml_allocate(document, (size_t)count * sizeof *node->attributes);
    if (!node->tag || !node->attributes) {
        return 0;
    }
    node->attribute_count = count;
    for (int i = 0; i < count; ++i) {
        const char *name = attributes[2 * i];
        const char *value = attributes[2 * i + 1];
        node->attributes[i].name = xml_copy(document, name, strlen(name));
        node->attributes[i].value = xml_copy(document, value, strlen(value));
        if (!node->attributes[i].name || !node->attributes[i].value) {
            return 0;
        }
    }
    return 1;
}

static void XMLCALL xml_on_start(void *user, const XML_Char *tag, const XML_Char **attributes)
{
    struct xml_reader *reader = user;
    struct xml_node *node = xml_allocate(reader->document, sizeof *node);
    if (!node || !xml_fill(reader->document, node, tag, attributes)) {
        xml_stop(reader, BRDF_OUT_OF_MEMORY, "out of memory");
        return;
    }
    node->line = (int)XML_GetCurrentLineNumber(reader->parser);
    node->column = (int)XML_GetCurrentColumnNumber(reader->parser) + 1;
    xml_append(reader, node);
    reader->open = node;
    if (++reader->depth > XML_DEPTH_MAX) {
        xml_stop(reader, BRDF_BAD_FILE, "elements are nested more than 64 deep");
    }
}

static void XMLCALL xml_on_end(void *user, const XML_Char *tag)
{
    struct xml_reader *reader = user;
    (void)tag;
    reader->open = reader->open->parent;
    --reader->depth;
}

static void XMLCALL xml_on_text(void *user, const XML_Char *text, int length)
{
    struct xml_reader *reader = user;
    for (int i = 0; i < length; ++i) {
        if (!strchr(" \t\r\n", text[i])) {
            xml_stop(reader, BRDF_BAD_FILE,
                     "text between elements means nothing here; values are attributes");
            return;
        }
    }
}

static void XMLCALL xml_on_doctype(void *user, const XML_Char *name, const XML_Char *system,
                                   const XML_Char *public, int has_subset)
{
    (void)name;
    (void)system;
    (void)public;
    (void)has_subset;
    xml_stop(user, BRDF_UNSUPPORTED, "a scene has no <!DOCTYPE>; remove it");
}

static brdf_status xml_parse(struct xml_reader *reader, FILE *file)
{
    struct xml_document *document = reader->document;
    int last = 0;
    while (!last) {
        void *buffer = XML_GetBuffer(reader->parser, XML_CHUNK);
        if (!buffer) {
            return brdf_fail(reader->error, BRDF_OUT_OF_MEMORY, "%s: out of memory",
                             document->path);
        }
        errno = 0;
        size_t length = fread(buffer, 1, XML_CHUNK, file);
        if (ferror(file)) {
            return brdf_fail(reader->error, BRDF_IO, "%s: cannot be read: %s", document->path,
                             strerror(errno));
        }
        last = length < XML_CHUNK;
        if (XML_ParseBuffer(reader->parser, (int)length, last) != XML_STATUS_OK) {
            if (!reader->status) {
                xml_stop(reader, BRDF_BAD_FILE, XML_ErrorString(XML_GetErrorCode(reader->parser)));
            }
            return reader->status;
        }
    }
    return BRDF_OK;
}

brdf_status xml_document_read(const char *path, struct xml_document *document,
                              struct brdf_error *error)
{
    struct xml_reader reader = {document, NULL, NULL, 0, BRDF_OK, error};
    brdf_status status;
    FILE *file = NULL;

    memset(document, 0, sizeof *document);
    document->path = path;
    file = fopen(path, "rb");
    if (!file) {
        status = brdf_fail(error, BRDF_IO, "%s: cannot be opened: %s", path, strerror(errno));
        goto done;
    }
    reader.parser = XML_ParserCreate(NULL);
    if (!reader.parser) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: out of memory", path);
        goto done;
    }
    XML_SetUserData(reader.parser, &reader);
    XML_SetElementHandler(reader.parser, xml_on_start, xml_on_end);
    XML_SetCharacterDataHandler(reader.parser, xml_on_text);
    XML_SetStartDoctypeDeclHandler(reader.parser, xml_on_doctype);
    status = xml_parse(&reader, file);
done:
    if (reader.parser) {
        XML_ParserFree(reader.parser);
    }
    if (file) {
        fclose(file);
    }
    return status;
}

void xml_document_free(struct xml_document *document)
{
    struct xml_block *block = document->blocks;
    while (block) {
        struct xml_block *next = block->header.next;
        free(block);
        block = next;
    }
    document->blocks = NULL;
    document->root = NULL;
}
