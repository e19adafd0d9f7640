/*
 * scene_reference.c - ids and the <ref>s to them: unique, resolved, free of circles.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

#define REFERENCE_DEPTH_MAX 512 /* walks are recursive */

struct scene_name {
    const char *id;
    struct xml_node *node;
};

static int reference_compare(const void *a, const void *b)
{
    const struct scene_name *x = a;
    const struct scene_name *y = b;
    int order = strcmp(x->id, y->id);
    return order ? order : (x->node->line > y->node->line) - (x->node->line < y->node->line);
}

/* Objects with an id: counted where names is NULL. */
static void reference_collect(struct xml_node *node, struct scene_name *names, size_t *count)
{
    const char *id = xml_attribute_get(node, "id");
    if (id && scene_grammar_class(node) == XML_OBJECT) {
        if (names) {
            names[*count].id = id;
            names[*count].node = node;
        }
        ++*count;
    }
    for (struct xml_node *child = node->child; child; child = child->next) {
        reference_collect(child, names, count);
    }
}

static struct xml_node *reference_find(const struct scene_loader *loader, const char *id)
{
    size_t low = 0;
    size_t high = loader->id_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        int order = strcmp(loader->ids[middle].id, id);
        if (order == 0) {
            return loader->ids[middle].node;
        }
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

struct xml_node *scene_reference_target(const struct scene_loader *loader, struct xml_node *node)
{
    (void)loader;
    return strcmp(node->tag, "ref") == 0 ? node->product : node;
}

struct xml_node *scene_object_next(const struct scene_loader *loader, const struct xml_node *parent,
                                   const char *tag, struct xml_node **child)
{
    for (*child = *child ? (*child)->next : parent->child; *child; *child = (*child)->next) {
        enum xml_class kind = scene_grammar_class(*child);
        struct xml_node *target;
        if (kind != XML_OBJECT && kind != XML_REFERENCE) {
            continue;
        }
        target = scene_reference_target(loader, *child);
        if (!tag || strcmp(target->tag, tag) == 0) {
            return target;
        }
    }
    return NULL;
}

static brdf_status reference_link(const struct scene_loader *loader, struct xml_node *node)
{
    brdf_status status = BRDF_OK;
    if (strcmp(node->tag, "ref") == 0) {
        const char *id = xml_attribute_get(node, "id");
        node->product = reference_find(loader, id);
        if (!node->product) {
            size_t count = loader->id_count;
            const char **known = malloc((count + 1) * sizeof *known);
            for (size_t i = 0; known && i < count; ++i) {
                known[i] = loader->ids[i].id;
            }
            status = scene_fail_unknown(loader, node, "id", id, known, known ? count : 0);
            free(known);
        }
    }
    for (struct xml_node *child = node->child; child && !status; child = child->next) {
        status = reference_link(loader, child);
    }
    return status;
}

static brdf_status reference_walk(const struct scene_loader *loader, struct xml_node *node,
                                  int depth)
{
    brdf_status status = BRDF_OK;
    if (node->visit == 2) {
        return BRDF_OK;
    }
    if (depth > REFERENCE_DEPTH_MAX) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "references lead more than %d deep",
                          REFERENCE_DEPTH_MAX);
    }
    node->visit = 1;
    for (struct xml_node *child = node->child; child && !status; child = child->next) {
        struct xml_node *target = scene_reference_target(loader, child);
        if (target->visit == 1) {
            status = scene_fail(loader, child, BRDF_BAD_FILE, "\"%s\" contains itself",
                                xml_attribute_get(child, "id"));
        } else {
            status = reference_walk(loader, target, depth + 1);
        }
    }
    node->visit = 2;
    return status;
}

brdf_status scene_reference_resolve(struct scene_loader *loader)
{
    struct xml_node *root = loader->document.root;
    size_t count = 0;
    brdf_status status;
    reference_collect(root, NULL, &count);
    loader->ids = calloc(count + 1, sizeof *loader->ids);
    if (!loader->ids) {
        return scene_fail_memory(loader, root);
    }
    reference_collect(root, loader->ids, &loader->id_count);
    qsort(loader->ids, count, sizeof *loader->ids, reference_compare);
    for (size_t i = 1; i < count; ++i) {
        if (strcmp(loader->ids[i - 1].id, loader->ids[i].id) == 0) {
            return scene_fail(loader, loader->ids[i].node, BRDF_BAD_FILE,
                              "the id \"%s\" is taken: it is in line %d already", loader->ids[i].id,
                              loader->ids[i - 1].node->line);
        }
    }
    status = reference_link(loader, root);
    return status ? status : reference_walk(loader, root, 0);
}

void scene_reference_free(struct scene_loader *loader)
{
    free(loader->ids);
    loader->ids = NULL;
    loader->id_count = 0;
}
