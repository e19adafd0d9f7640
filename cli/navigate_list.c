/* navigate_list.c - the materials of a map: files, descriptions, all files of a folder, lists. */
#define _POSIX_C_SOURCE 200809L
#include "navigate_list.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "brdflab/open.h"
#include "file_name.h"

/* The part of a path that a person calls it by: without folder and suffix. */
static char *name_of(const char *material)
{
    const char *dot = strrchr(material, '.');
    if (!dot || (strcmp(dot, ".binary") != 0 && strcmp(dot, ".bsdf") != 0)) {
        return strdup(material); /* a description */
    }
    const char *begin = file_name_of(material);
    return strndup(begin, (size_t)(dot - begin));
}

/* Takes over both texts, also where it fails. */
static brdf_status append(struct navigate_list *list, char *material, char *name,
                          struct brdf_error *error)
{
    if (material && name && list->count == list->room) {
        size_t room = 2 * list->room + 64;
        char **materials = realloc(list->material, room * sizeof *materials);
        list->material = materials ? materials : list->material;
        char **names = realloc(list->name, room * sizeof *names);
        list->name = names ? names : list->name;
        list->room = materials && names ? room : list->room;
    }
    if (!material || !name || list->count == list->room) {
        free(material);
        free(name);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    list->material[list->count] = material;
    list->name[list->count++] = name;
    return BRDF_OK;
}

static int is_measured(const struct dirent *entry)
{
    const char *dot = strrchr(entry->d_name, '.');
    return dot && (strcmp(dot, ".binary") == 0 || strcmp(dot, ".bsdf") == 0);
}

static brdf_status add_folder(struct navigate_list *list, const char *folder,
                              struct brdf_error *error)
{
    struct dirent **entries = NULL;
    int count = scandir(folder, &entries, is_measured, alphasort);
    brdf_status status = BRDF_OK;
    if (count <= 0) {
        status =
            brdf_fail(error, BRDF_IO, "%s: %s", folder,
                      count < 0 ? strerror(errno) : "the folder holds no .binary or .bsdf file");
    }
    for (int i = 0; i < count; ++i) {
        size_t size = strlen(folder) + strlen(entries[i]->d_name) + 2;
        char *path = malloc(size);
        if (path) {
            snprintf(path, size, "%s/%s", folder, entries[i]->d_name);
        }
        if (!status) {
            status = append(list, path, path ? name_of(path) : NULL, error);
        } else {
            free(path);
        }
        free(entries[i]);
    }
    free(entries);
    return status;
}

brdf_status navigate_list_add(struct navigate_list *list, const char *argument,
                              struct brdf_error *error)
{
    struct stat about;
    if (stat(argument, &about) == 0 && S_ISDIR(about.st_mode)) {
        return add_folder(list, argument, error);
    }
    return append(list, strdup(argument), name_of(argument), error);
}

/* One line of a list: both words, or the material alone. What it names must be there. */
static brdf_status add_line(struct navigate_list *list, char *line, struct brdf_error *error)
{
    static const char space[] = " \t\r\n";
    enum lab_format format;
    line += strspn(line, space);
    line[strcspn(line, "\r\n")] = '\0';
    for (size_t end = strlen(line); end > 0 && strchr(space, line[end - 1]); --end) {
        line[end - 1] = '\0';
    }
    if (*line == '#' || *line == '\0') {
        return BRDF_OK;
    }
    size_t first = strcspn(line, space);
    char *material = line;
    if (line[first] != '\0') {
        line[first] = '\0';
        material += first + 1;
        material += strspn(material, space);
    }
    brdf_status status = lab_format_of(material, &format, error);
    if (status) {
        return status;
    }
    return append(list, strdup(material), material == line ? name_of(line) : strdup(line), error);
}

brdf_status navigate_list_read(struct navigate_list *list, const char *path,
                               struct brdf_error *error)
{
    char *line = NULL;
    size_t room = 0;
    struct brdf_error reason = {BRDF_OK, ""};
    brdf_status status = BRDF_OK;
    FILE *file = fopen(path, "r");
    if (!file) {
        return brdf_fail(error, BRDF_IO, "%s: %s", path, strerror(errno));
    }
    for (unsigned long number = 1; !status && getline(&line, &room, file) >= 0; ++number) {
        status = add_line(list, line, &reason);
        if (status) {
            status = brdf_fail(error, status, "%s:%lu: %s", path, number, reason.message);
        }
    }
    if (!status && ferror(file)) {
        status = brdf_fail(error, BRDF_IO, "%s: %s", path, strerror(errno));
    }
    free(line);
    fclose(file);
    return status;
}

void navigate_list_free(struct navigate_list *list)
{
    for (size_t i = 0; i < list->count; ++i) {
        free(list->material[i]);
        free(list->name[i]);
    }
    free(list->material);
    free(list->name);
    memset(list, 0, sizeof *list);
}
