/*
 * scene_grammar.c - which elements there are, which attributes they have and what they may hold.
 */
#include "scene_loader.h"

#include <string.h>

struct grammar_rule {
    const char *tag;
    enum xml_class kind;
    const char *required; /* attributes, separated by "|" */
    const char *optional;
};

static const struct grammar_rule grammar[] = {
    {"scene", XML_OBJECT, "version", "type|id|name"},
    {"integrator", XML_OBJECT, "type", "id|name"},
    {"sensor", XML_OBJECT, "type", "id|name"},
    {"sampler", XML_OBJECT, "type", "id|name"},
    {"film", XML_OBJECT, "type", "id|name"},
    {"rfilter", XML_OBJECT, "type", "id|name"},
    {"shape", XML_OBJECT, "type", "id|name"},
    {"bsdf", XML_OBJECT, "type", "id|name"},
    {"texture", XML_OBJECT, "type", "id|name"},
    {"emitter", XML_OBJECT, "type", "id|name"},
    {"float", XML_PROPERTY, "name|value", ""},
    {"integer", XML_PROPERTY, "name|value", ""},
    {"boolean", XML_PROPERTY, "name|value", ""},
    {"string", XML_PROPERTY, "name|value", ""},
    {"rgb", XML_PROPERTY, "name|value", ""},
    {"spectrum", XML_PROPERTY, "name|value", ""},
    {"point", XML_PROPERTY, "name", "value|x|y|z"},
    {"vector", XML_PROPERTY, "name", "value|x|y|z"},
    {"transform", XML_PROPERTY, "name", ""},
    {"translate", XML_OPERATION, "", "value|x|y|z"},
    {"scale", XML_OPERATION, "", "value|x|y|z"},
    {"rotate", XML_OPERATION, "angle", "value|x|y|z"},
    {"lookat", XML_OPERATION, "origin|target", "up"},
    {"matrix", XML_OPERATION, "value", ""},
    {"ref", XML_REFERENCE, "id", "name"},
    {"default", XML_OTHER, "name|value", ""},
};

/* Elements of Mitsuba that we know of and do not read. */
static const char *const unsupported[] = {"medium", "phase", "volume", "include", "alias", "path"};

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static const struct grammar_rule *grammar_find(const char *tag)
{
    for (size_t i = 0; i < COUNT(grammar); ++i) {
        if (strcmp(grammar[i].tag, tag) == 0) {
            return &grammar[i];
        }
    }
    return NULL;
}

enum xml_class scene_grammar_class(const struct xml_node *node)
{
    return grammar_find(node->tag)->kind;
}

static brdf_status grammar_fail_tag(const struct scene_loader *loader, const struct xml_node *node)
{
    const char *known[COUNT(grammar)];
    for (size_t i = 0; i < COUNT(unsupported); ++i) {
        if (strcmp(unsupported[i], node->tag) == 0) {
            return scene_fail(loader, node, BRDF_UNSUPPORTED, "<%s> is not supported", node->tag);
        }
    }
    for (size_t i = 0; i < COUNT(grammar); ++i) {
        known[i] = grammar[i].tag;
    }
    return scene_fail_unknown(loader, node, "element", node->tag, known, COUNT(grammar));
}

/* The names of a list such as "name|value", for the search of the nearest one. */
static size_t grammar_split(const char *list, char names[8][16], const char *known[8], size_t count)
{
    while (*list && count < 8) {
        size_t length = strcspn(list, "|");
        size_t kept = length < sizeof names[0] ? length : sizeof names[0] - 1;
        memcpy(names[count], list, kept);
        names[count][kept] = '\0';
        known[count] = names[count];
        ++count;
        list += length + (list[length] == '|');
    }
    return count;
}

static brdf_status grammar_check_attributes(const struct scene_loader *loader,
                                            const struct xml_node *node,
                                            const struct grammar_rule *rule)
{
    char names[8][16];
    const char *known[8];
    size_t required = grammar_split(rule->required, names, known, 0);
    size_t count = grammar_split(rule->optional, names, known, required);
    for (int i = 0; i < node->attribute_count; ++i) {
        const char *name = node->attributes[i].name;
        if (!scene_list_has(rule->required, name) && !scene_list_has(rule->optional, name)) {
            return scene_fail_unknown(loader, node, "attribute", name, known, count);
        }
    }
    for (size_t i = 0; i < required; ++i) {
        if (!xml_attribute_get(node, known[i])) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "<%s> lacks the attribute \"%s\"",
                              node->tag, known[i]);
        }
    }
    return BRDF_OK;
}

/* Where an element may stand: operations in transforms, all else in objects. */
static brdf_status grammar_check_place(const struct scene_loader *loader,
                                       const struct xml_node *node, const struct grammar_rule *rule)
{
    const struct xml_node *parent = node->parent;
    int in_transform = parent && strcmp(parent->tag, "transform") == 0;
    int is_root = strcmp(node->tag, "scene") == 0;
    int fits = parent ? !is_root && (rule->kind == XML_OPERATION) == in_transform &&
                            (in_transform || scene_grammar_class(parent) == XML_OBJECT)
                      : is_root;
    if (fits) {
        return BRDF_OK;
    }
    if (!parent) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "the outermost element is <%s>, not <scene>",
                          node->tag);
    }
    return scene_fail(loader, node, BRDF_BAD_FILE, "<%s> cannot stand in <%s>", node->tag,
                      parent->tag);
}

static brdf_status grammar_check(const struct scene_loader *loader, const struct xml_node *node)
{
    const struct grammar_rule *rule = grammar_find(node->tag);
    brdf_status status = BRDF_OK;
    if (!rule) {
        return grammar_fail_tag(loader, node);
    }
    if (strcmp(node->tag, "spectrum") == 0 && xml_attribute_get(node, "filename")) {
        return scene_fail(loader, node, BRDF_UNSUPPORTED,
                          "spectra are not supported; use <rgb>, or <spectrum> with one number");
    }
    status = grammar_check_place(loader, node, rule);
    if (!status) {
        status = grammar_check_attributes(loader, node, rule);
    }
    for (const struct xml_node *child = node->child; child && !status; child = child->next) {
        status = grammar_check(loader, child);
    }
    return status;
}

brdf_status scene_grammar_check(const struct scene_loader *loader)
{
    const struct xml_node *root = loader->document.root;
    brdf_status status = grammar_check(loader, root);
    const char *version = status ? NULL : xml_attribute_get(root, "version");
    if (version && (version[0] < '2' || version[0] > '3' || version[1] != '.')) {
        return scene_fail(loader, root, BRDF_UNSUPPORTED,
                          "scenes of version \"%s\" are not read; this is for Mitsuba 3, "
                          "version=\"3.0.0\"",
                          version);
    }
    return status;
}
