/*
 * scene_report.c - errors and remarks that name the file, the line and the column.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_loader.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/info.h>

#define REPORT_SIZE 1024

/* Prefix the place; the root stands for the whole file where there is no node. */
static void scene_place(const struct scene_loader *loader, const struct xml_node *node, char *text,
                        size_t size, const char *format, va_list arguments)
{
    int length;
    if (node) {
        length =
            snprintf(text, size, "%s:%d:%d: ", loader->document.path, node->line, node->column);
    } else {
        length = snprintf(text, size, "%s: ", loader->document.path);
    }
    if (length >= 0 && (size_t)length < size) {
        vsnprintf(text + length, size - (size_t)length, format, arguments);
    }
}

brdf_status scene_fail(const struct scene_loader *loader, const struct xml_node *node,
                       brdf_status status, const char *format, ...)
{
    char text[REPORT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    scene_place(loader, node, text, sizeof text, format, arguments);
    va_end(arguments);
    return brdf_fail(loader->error, status, "%s", text);
}

brdf_status scene_fail_unknown(const struct scene_loader *loader, const struct xml_node *node,
                               const char *what, const char *name, const char *const *known,
                               size_t count)
{
    const char *nearest = brdf_name_nearest(name, known, count);
    char list[512] = "";
    size_t used = 0;
    if (nearest) {
        return scene_fail(loader, node, BRDF_UNKNOWN_NAME,
                          "unknown %s \"%s\"; did you mean \"%s\"?", what, name, nearest);
    }
    for (size_t i = 0; i < count && used < sizeof list; ++i) {
        int length = snprintf(list + used, sizeof list - used, "%s%s", i > 0 ? ", " : "", known[i]);
        used += length > 0 ? (size_t)length : 0;
    }
    if (count == 0) {
        return scene_fail(loader, node, BRDF_UNKNOWN_NAME, "unknown %s \"%s\"", what, name);
    }
    return scene_fail(loader, node, BRDF_UNKNOWN_NAME, "unknown %s \"%s\"; known: %s", what, name,
                      list);
}

brdf_status scene_fail_memory(const struct scene_loader *loader, const struct xml_node *node)
{
    return scene_fail(loader, node, BRDF_OUT_OF_MEMORY, "out of memory");
}

brdf_status scene_fail_inner(const struct scene_loader *loader, const struct xml_node *node,
                             const struct brdf_error *inner)
{
    return scene_fail(loader, node, inner->status, "%s", inner->message);
}

brdf_status scene_note(const struct scene_loader *loader, const struct xml_node *node,
                       const char *format, ...)
{
    struct brdfcl_scene *scene = loader->scene;
    char text[REPORT_SIZE];
    va_list arguments;
    char **notes;
    va_start(arguments, format);
    scene_place(loader, node, text, sizeof text, format, arguments);
    va_end(arguments);

    /* A bsdf that many shapes have is composed for each of them. */
    for (size_t i = 0; i < scene->note_count; ++i) {
        if (strcmp(scene->notes[i], text) == 0) {
            return BRDF_OK;
        }
    }
    notes = realloc(scene->notes, (scene->note_count + 1) * sizeof *notes);
    if (!notes) {
        return scene_fail_memory(loader, node);
    }
    scene->notes = notes;
    notes[scene->note_count] = strdup(text);
    if (!notes[scene->note_count]) {
        return scene_fail_memory(loader, node);
    }
    ++scene->note_count;
    return BRDF_OK;
}
