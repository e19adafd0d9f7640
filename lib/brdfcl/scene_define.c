/*
 * scene_define.c - $name in attributes, replaced by what -D or <default> says.
 */
#include "scene_loader.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/info.h>

#define DEFINE_LENGTH_MAX 65536 /* an attribute that grows beyond is a mistake */

struct define_entry {
    const char *name;
    const char *value;
    int used;      /* it, or a <default> of its name, was in the file */
    int from_user; /* by -D: stands above every <default> */
};

struct define_table {
    struct define_entry *entries;
    size_t count;
    size_t capacity;
};

static struct define_entry *define_find(const struct define_table *table, const char *name)
{
    for (size_t i = 0; i < table->count; ++i) {
        if (strcmp(table->entries[i].name, name) == 0) {
            return &table->entries[i];
        }
    }
    return NULL;
}

static int define_add(struct define_table *table, const char *name, const char *value, int user)
{
    struct define_entry entry = {name, value, !user, user};
    if (table->count == table->capacity) {
        size_t capacity = 2 * table->capacity + 8;
        struct define_entry *entries = realloc(table->entries, capacity * sizeof *entries);
        if (!entries) {
            return 0;
        }
        table->entries = entries;
        table->capacity = capacity;
    }
    table->entries[table->count++] = entry;
    return 1;
}

/* The longest known name that the text after '$' begins with. */
static struct define_entry *define_match(const struct define_table *table, const char *text)
{
    struct define_entry *best = NULL;
    for (size_t i = 0; i < table->count; ++i) {
        const char *name = table->entries[i].name;
        size_t length = strlen(name);
        if (strncmp(text, name, length) == 0 && (!best || length > strlen(best->name))) {
            best = &table->entries[i];
        }
    }
    return best;
}

static brdf_status define_fail(const struct scene_loader *loader, const struct xml_node *node,
                               const struct define_table *table, const char *text)
{
    char name[64];
    size_t length = 0;
    const char *nearest = NULL;
    const char **known = malloc((table->count + 1) * sizeof *known);
    brdf_status status;
    while (length + 1 < sizeof name &&
           (isalnum((unsigned char)text[length]) || text[length] == '_')) {
        name[length] = text[length];
        ++length;
    }
    name[length] = '\0';
    for (size_t i = 0; known && i < table->count; ++i) {
        known[i] = table->entries[i].name;
    }
    nearest = known ? brdf_name_nearest(name, known, table->count) : NULL;
    status =
        scene_fail(loader, node, BRDF_UNKNOWN_NAME,
                   "$%s has no value: give it with -D %s=... or <default>%s%s%s", name, name,
                   nearest ? "; did you mean $" : "", nearest ? nearest : "", nearest ? "?" : "");
    free(known);
    return status;
}

/* Write the text with its names replaced to `out`, or only measure it where out is NULL. */
static brdf_status define_expand(const struct scene_loader *loader, const struct xml_node *node,
                                 const struct define_table *table, const char *text, char *out,
                                 size_t *length)
{
    size_t n = 0;
    while (*text) {
        const char *piece = text;
        size_t size = 1;
        if (text[0] == '\\' && text[1] == '$') {
            piece = text + 1;
            text += 2;
        } else if (text[0] == '$') {
            struct define_entry *entry = define_match(table, text + 1);
            if (!entry) {
                return define_fail(loader, node, table, text + 1);
            }
            entry->used = 1;
            piece = entry->value;
            size = strlen(piece);
            text += 1 + strlen(entry->name);
        } else {
            ++text;
        }
        if (n + size > DEFINE_LENGTH_MAX) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "a value grows beyond %d characters",
                              DEFINE_LENGTH_MAX);
        }
        if (out) {
            memcpy(out + n, piece, size);
        }
        n += size;
    }
    *length = n;
    return BRDF_OK;
}

static brdf_status define_replace(struct scene_loader *loader, const struct xml_node *node,
                                  const struct define_table *table, struct xml_attribute *attribute)
{
    size_t length = 0;
    char *text;
    brdf_status status;
    if (!strchr(attribute->value, '$')) {
        return BRDF_OK;
    }
    status = define_expand(loader, node, table, attribute->value, NULL, &length);
    if (status) {
        return status;
    }
    text = xml_allocate(&loader->document, length + 1);
    if (!text) {
        return scene_fail_memory(loader, node);
    }
    status = define_expand(loader, node, table, attribute->value, text, &length);
    attribute->value = text;
    return status;
}

static brdf_status define_default(const struct scene_loader *loader, const struct xml_node *node,
                                  struct define_table *table)
{
    const char *name = xml_attribute_get(node, "name");
    const char *value = xml_attribute_get(node, "value");
    struct define_entry *entry;
    if (!name || !value) {
        return BRDF_OK; /* the grammar refuses it with a better sentence */
    }
    if (name[0] == '\0') {
        return scene_fail(loader, node, BRDF_BAD_FILE, "<default> has an empty name");
    }
    entry = define_find(table, name);
    if (entry && !entry->from_user) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "<default> \"%s\" is given twice", name);
    }
    if (entry) {
        entry->used = 1;
    } else if (!define_add(table, name, value, 0)) {
        return scene_fail_memory(loader, node);
    }
    return BRDF_OK;
}

/* In the order of the file: a <default> holds for what follows it. */
static brdf_status define_walk(struct scene_loader *loader, struct xml_node *node,
                               struct define_table *table)
{
    brdf_status status = BRDF_OK;
    for (int i = 0; i < node->attribute_count && !status; ++i) {
        status = define_replace(loader, node, table, &node->attributes[i]);
    }
    if (!status && strcmp(node->tag, "default") == 0) {
        status = define_default(loader, node, table);
    }
    for (struct xml_node *child = node->child; child && !status; child = child->next) {
        status = define_walk(loader, child, table);
    }
    return status;
}

/* A -D that nothing in the file asks for is a typing error. */
static brdf_status define_check(const struct scene_loader *loader, const struct define_table *table)
{
    const char **known = malloc((table->count + 1) * sizeof *known);
    size_t count = 0;
    brdf_status status = BRDF_OK;
    if (!known) {
        return scene_fail_memory(loader, NULL);
    }
    for (size_t i = 0; i < table->count; ++i) {
        if (table->entries[i].used) {
            known[count++] = table->entries[i].name;
        }
    }
    for (size_t i = 0; i < table->count && !status; ++i) {
        if (!table->entries[i].used) {
            status = scene_fail_unknown(loader, NULL, "name given with -D,", table->entries[i].name,
                                        known, count);
        }
    }
    free(known);
    return status;
}

brdf_status scene_define_apply(struct scene_loader *loader, const struct brdfcl_define *defines,
                               size_t count)
{
    struct define_table table = {NULL, 0, 0};
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < count && !status; ++i) {
        struct define_entry *entry = define_find(&table, defines[i].name);
        if (defines[i].name[0] == '\0') {
            status = scene_fail(loader, NULL, BRDF_BAD_ARGUMENT, "-D needs a name: -D name=value");
        } else if (entry) {
            entry->value = defines[i].value; /* the last one counts */
        } else if (!define_add(&table, defines[i].name, defines[i].value, 1)) {
            status = scene_fail_memory(loader, NULL);
        }
    }
    if (!status) {
        status = define_walk(loader, loader->document.root, &table);
    }
    if (!status) {
        status = define_check(loader, &table);
    }
    free(table.entries);
    return status;
}
