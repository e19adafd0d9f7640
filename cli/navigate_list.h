/*
 * navigate_list.h - the materials of a map: files, descriptions, all files of a folder, lists.
 */
#ifndef BRDFCL_NAVIGATE_LIST_H
#define BRDFCL_NAVIGATE_LIST_H

#include <stddef.h>

#include <brdf/status.h>

/* Texts and what to call them; begin with all zero, end with navigate_list_free. */
struct navigate_list {
    char **material;
    char **name;
    size_t count;
    size_t room;
};

/*
 * Add what an argument names: a folder's .binary and .bsdf files in the order of their names, or
 * one material. BRDF_IO (a folder that cannot be read, or holds none), BRDF_OUT_OF_MEMORY.
 */
brdf_status navigate_list_add(struct navigate_list *list, const char *argument,
                              struct brdf_error *error);

/*
 * Add the lines of a text file: a material each, or a name, white space and a material. Empty lines
 * and what follows "#" at the beginning of a line are skipped. BRDF_IO, BRDF_OUT_OF_MEMORY.
 */
brdf_status navigate_list_read(struct navigate_list *list, const char *path,
                               struct brdf_error *error);

void navigate_list_free(struct navigate_list *list);

#endif
