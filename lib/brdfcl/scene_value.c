/*
 * scene_value.c - texts of attributes as numbers, vectors, colours and paths.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define VALUE_SPACES " \t\r\n"
#define VALUE_SEPARATORS " \t\r\n,"

int scene_list_has(const char *list, const char *name)
{
    size_t length = strlen(name);
    while (*list) {
        size_t item = strcspn(list, "|");
        if (item == length && strncmp(list, name, length) == 0) {
            return 1;
        }
        list += item + (list[item] == '|');
    }
    return 0;
}

/* A number of `length` characters: decimal digits only (strtod would also take nan, inf and hex).
 */
static int value_parse(const char *text, size_t length, double *number)
{
    char copy[64];
    char *end = NULL;
    if (length == 0 || length >= sizeof copy) {
        return 0;
    }
    memcpy(copy, text, length);
    copy[length] = '\0';
    if (strspn(copy, "0123456789+-.eE") != length) {
        return 0;
    }
    *number = strtod(copy, &end);
    return end == copy + length && fabs(*number) <= (double)FLT_MAX;
}

brdf_status scene_value_numbers(const struct scene_loader *loader, const struct xml_node *node,
                                const char *text, double *numbers, int max, int *count)
{
    int n = 0;
    text += strspn(text, VALUE_SEPARATORS);
    while (*text) {
        size_t length = strcspn(text, VALUE_SEPARATORS);
        double number = 0.0;
        if (!value_parse(text, length, &number)) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "\"%.*s\" is not a finite number",
                              (int)(length < 64 ? length : 64), text);
        }
        if (n == max) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "more than %d numbers", max);
        }
        numbers[n++] = number;
        text += length;
        text += strspn(text, VALUE_SEPARATORS);
    }
    *count = n;
    return BRDF_OK;
}

brdf_status scene_value_number(const struct scene_loader *loader, const struct xml_node *node,
                               const char *text, double *number)
{
    const char *begin = text + strspn(text, VALUE_SPACES);
    size_t length = strlen(begin);
    while (length > 0 && strchr(VALUE_SPACES, begin[length - 1])) {
        --length;
    }
    if (!value_parse(begin, length, number)) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" is not a finite number", text);
    }
    return BRDF_OK;
}

brdf_status scene_value_vector(const struct scene_loader *loader, const struct xml_node *node,
                               double rest, int complete, double vector[3])
{
    static const char *const axes[3] = {"x", "y", "z"};
    const char *value = xml_attribute_get(node, "value");
    brdf_status status = BRDF_OK;
    int count = 0;
    for (int i = 0; i < 3 && !status; ++i) {
        const char *text = xml_attribute_get(node, axes[i]);
        vector[i] = rest;
        if (text && value) {
            return scene_fail(loader, node, BRDF_BAD_FILE,
                              "\"value\" and \"%s\" exclude each other", axes[i]);
        }
        if (text) {
            status = scene_value_number(loader, node, text, &vector[i]);
        } else if (complete && !value) {
            return scene_fail(loader, node, BRDF_BAD_FILE, "<%s> lacks the attribute \"%s\"",
                              node->tag, axes[i]);
        }
    }
    if (!value || status) {
        return status;
    }
    status = scene_value_numbers(loader, node, value, vector, 3, &count);
    if (!status && count == 1) {
        vector[1] = vector[0];
        vector[2] = vector[0];
    } else if (!status && count != 3) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "expected one or three numbers, not \"%s\"",
                          value);
    }
    return status;
}

/* The transfer function of sRGB (IEC 61966-2-1), inverted. */
static double value_from_srgb(double x)
{
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static int value_parse_hex(const char *text, double color[3])
{
    size_t length = strspn(text + 1, "0123456789abcdefABCDEF");
    unsigned long bits = strtoul(text + 1, NULL, 16);
    if (length != 6 || text[7 + strspn(text + 7, VALUE_SPACES)] != '\0') {
        return 0;
    }
    for (int i = 0; i < 3; ++i) {
        color[i] = value_from_srgb((double)(bits >> (16 - 8 * i) & 255) / 255.0);
    }
    return 1;
}

brdf_status scene_value_color(const struct scene_loader *loader, const struct xml_node *node,
                              double color[3])
{
    const char *text = xml_attribute_get(node, "value");
    const char *begin = text + strspn(text, VALUE_SPACES);
    brdf_status status;
    int count = 0;
    if (*begin == '#') {
        if (!value_parse_hex(begin, color)) {
            return scene_fail(loader, node, BRDF_BAD_FILE,
                              "\"%s\" is not a colour: # and six hexadecimal digits", text);
        }
        return BRDF_OK;
    }
    status = scene_value_numbers(loader, node, text, color, 3, &count);
    if (!status && count == 1) {
        color[1] = color[0];
        color[2] = color[0];
    } else if (!status && count != 3) {
        return scene_fail(loader, node, BRDF_BAD_FILE,
                          "\"%s\" is not a colour: one number, three, or #rrggbb", text);
    }
    return status;
}

char *scene_value_path(const struct scene_loader *loader, const char *name)
{
    const char *slash = strrchr(loader->document.path, '/');
    size_t folder = name[0] != '/' && slash ? (size_t)(slash - loader->document.path) + 1 : 0;
    size_t length = strlen(name);
    char *path = malloc(folder + length + 1);
    if (path) {
        memcpy(path, loader->document.path, folder);
        memcpy(path + folder, name, length + 1);
    }
    return path;
}
