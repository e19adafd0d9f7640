/*
 * scene_slot.c - a plugin's parameters: a table of names and places, filled from its element.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_loader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define SLOT_COUNT_MAX 32

/* Equal energy at every wavelength, in linear Rec. 709: the rows of the matrix from CIE XYZ (ITU-R
   BT.709) summed. It is what a constant <spectrum> is as light. */
static const double slot_equal_energy[3] = {1.204794, 0.948291, 0.908916};

static brdf_status slot_fail_type(const struct scene_loader *loader, const struct xml_node *node,
                                  const struct scene_slot *slot, const char *tags)
{
    return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not a <%s>; expected <%s>",
                      slot->name, node->tag, tags);
}

static brdf_status slot_fail_range(const struct scene_loader *loader, const struct xml_node *node,
                                   const struct scene_slot *slot)
{
    const char *text = xml_attribute_get(node, "value");
    if (slot->low > 0.0 && slot->low < 1e-30) {
        return scene_fail(loader, node, BRDF_OUT_OF_RANGE,
                          "%s = %s: expected more than 0, up to %g", slot->name, text, slot->high);
    }
    return scene_fail(loader, node, BRDF_OUT_OF_RANGE, "%s = %s: expected %.10g to %.10g",
                      slot->name, text, slot->low, slot->high);
}

static brdf_status slot_read_real(const struct scene_loader *loader, const struct xml_node *node,
                                  struct scene_slot *slot)
{
    double number = 0.0;
    brdf_status status;
    if (!scene_list_has("float|integer", node->tag)) {
        return slot_fail_type(loader, node, slot, "float");
    }
    status = scene_value_number(loader, node, xml_attribute_get(node, "value"), &number);
    if (status) {
        return status;
    }
    if (!(number >= slot->low && number <= slot->high)) {
        return slot_fail_range(loader, node, slot);
    }
    *(double *)slot->value = number;
    return BRDF_OK;
}

static brdf_status slot_read_integer(const struct scene_loader *loader, const struct xml_node *node,
                                     struct scene_slot *slot)
{
    const char *text = xml_attribute_get(node, "value");
    char *end = NULL;
    long number;
    if (strcmp(node->tag, "integer") != 0) {
        return slot_fail_type(loader, node, slot, "integer");
    }
    errno = 0;
    number = strtol(text, &end, 10);
    if (end == text || end[strspn(end, " \t\r\n")] != '\0') {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not an integer", text);
    }
    if (errno || !((double)number >= slot->low && (double)number <= slot->high)) {
        return slot_fail_range(loader, node, slot);
    }
    *(int *)slot->value = (int)number;
    return BRDF_OK;
}

static brdf_status slot_read_boolean(const struct scene_loader *loader, const struct xml_node *node,
                                     struct scene_slot *slot)
{
    const char *text = xml_attribute_get(node, "value");
    int is_true = strcasecmp(text, "true") == 0;
    if (strcmp(node->tag, "boolean") != 0) {
        return slot_fail_type(loader, node, slot, "boolean");
    }
    if (!is_true && strcasecmp(text, "false") != 0) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is neither \"true\" nor \"false\"",
                          text);
    }
    *(int *)slot->value = is_true;
    return BRDF_OK;
}

static brdf_status slot_read_color(const struct scene_loader *loader, const struct xml_node *node,
                                   struct scene_slot *slot)
{
    double *color = slot->value;
    brdf_status status;
    int is_light = slot->kind == SLOT_RADIANCE;
    int is_spectrum = strcmp(node->tag, "spectrum") == 0;
    if (!scene_list_has("rgb|spectrum|float|integer", node->tag)) {
        return slot_fail_type(loader, node, slot, "rgb");
    }
    if (strcmp(node->tag, "rgb") == 0) {
        status = scene_value_color(loader, node, color);
    } else {
        status = scene_value_number(loader, node, xml_attribute_get(node, "value"), &color[0]);
        color[1] = color[0];
        color[2] = color[0];
    }
    for (int i = 0; i < 3 && !status; ++i) {
        if (is_light && color[i] < 0.0) {
            status = scene_fail(loader, node, BRDF_OUT_OF_RANGE, "%s is negative: %s", slot->name,
                                xml_attribute_get(node, "value"));
        }
        color[i] *= is_light && is_spectrum ? slot_equal_energy[i] : 1.0;
    }
    return status;
}

static brdf_status slot_read(const struct scene_loader *loader, const struct xml_node *node,
                             struct scene_slot *slot)
{
    if (slot->given) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is given in line %d already",
                          slot->name, slot->given->line);
    }
    slot->given = node;
    switch (slot->kind) {
    case SLOT_REAL:
        return slot_read_real(loader, node, slot);
    case SLOT_INTEGER:
        return slot_read_integer(loader, node, slot);
    case SLOT_BOOLEAN:
        return slot_read_boolean(loader, node, slot);
    case SLOT_STRING:
        if (strcmp(node->tag, "string") != 0) {
            return slot_fail_type(loader, node, slot, "string");
        }
        *(const char **)slot->value = xml_attribute_get(node, "value");
        return BRDF_OK;
    case SLOT_POINT:
        if (!scene_list_has("point|vector", node->tag)) {
            return slot_fail_type(loader, node, slot, "point");
        }
        return scene_value_vector(loader, node, 0.0, 1, slot->value);
    case SLOT_RADIANCE:
    case SLOT_COLOR:
        return slot_read_color(loader, node, slot);
    case SLOT_TRANSFORM:
        break;
    }
    if (strcmp(node->tag, "transform") != 0) {
        return slot_fail_type(loader, node, slot, "transform");
    }
    return scene_transform_read(loader, node, slot->value);
}

static brdf_status slots_fail_unknown(const struct scene_loader *loader,
                                      const struct xml_node *node, const char *name,
                                      const struct scene_slot *slots, size_t count)
{
    const char *known[SLOT_COUNT_MAX];
    char what[96] = "parameter of ";
    const char *type = xml_attribute_get(node->parent, "type");
    for (size_t i = 0; i < count && i < SLOT_COUNT_MAX; ++i) {
        known[i] = slots[i].name;
    }
    strncat(what, type ? type : node->parent->tag, sizeof what - strlen(what) - 1);
    return scene_fail_unknown(loader, node, what, name, known, count);
}

brdf_status scene_slots_read(const struct scene_loader *loader, struct xml_node *node,
                             struct scene_slot *slots, size_t count, const char *objects)
{
    const char *type = xml_attribute_get(node, "type");
    brdf_status status = BRDF_OK;
    for (struct xml_node *child = node->child; child && !status; child = child->next) {
        enum xml_class kind = scene_grammar_class(child);
        const char *name = xml_attribute_get(child, "name");
        size_t i = 0;
        if (kind == XML_OBJECT || kind == XML_REFERENCE) {
            const char *tag = scene_reference_target(loader, child)->tag;
            if (!scene_list_has(objects, tag)) {
                status = scene_fail(loader, child, BRDF_BAD_FILE, "a %s has no place in a %s", tag,
                                    type ? type : node->tag);
            }
        } else if (kind == XML_PROPERTY) {
            while (i < count && strcmp(slots[i].name, name) != 0) {
                ++i;
            }
            status = i < count ? slot_read(loader, child, &slots[i])
                               : slots_fail_unknown(loader, child, name, slots, count);
        }
    }
    return status;
}

brdf_status scene_slot_check(const struct scene_loader *loader, const struct scene_slot *slot,
                             const char *const *names, size_t count)
{
    const char *value = *(const char **)slot->value;
    for (size_t i = 0; i < count; ++i) {
        if (strcmp(names[i], value) == 0) {
            return BRDF_OK;
        }
    }
    return scene_fail_unknown(loader, slot->given, slot->name, value, names, count);
}

brdf_status scene_slots_note(const struct scene_loader *loader, const struct scene_slot *slots,
                             size_t count)
{
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < count && !status; ++i) {
        if (slots[i].given) {
            status = scene_note(loader, slots[i].given, "%s changes nothing here", slots[i].name);
        }
    }
    return status;
}
