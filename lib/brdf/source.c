/* source.c - the shared headers that the library carries. */
#include "brdf/source.h"

#include <stddef.h>
#include <string.h>

#include "embedded.h"

const char *const *brdf_source_lines(const char *name)
{
    for (const struct brdf_source_file *file = brdf_embedded_files; file->name; ++file) {
        if (strcmp(file->name, name) == 0) {
            return file->lines;
        }
    }
    return NULL;
}

const char *brdf_source_name(int i)
{
    int count = 0;
    while (brdf_embedded_files[count].name) {
        ++count;
    }
    return i >= 0 && i < count ? brdf_embedded_files[i].name : NULL;
}
