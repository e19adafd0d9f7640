/*
 * embedded.h - the text of the shared headers, carried inside the library.
 *
 * tools/embed.awk makes the table. A file is its lines, each with its newline; put together they are
 * the file, byte for byte.
 */
#ifndef BRDF_EMBEDDED_H
#define BRDF_EMBEDDED_H

struct brdf_embedded_file {
    const char *name;         /* as an #include names it: "brdf/model/diffuse.h" */
    const char *const *lines; /* ended by a null pointer */
};

/* Every file under include/brdf, sorted by name; ended by a null name. */
extern const struct brdf_embedded_file brdf_embedded_files[];

#endif
