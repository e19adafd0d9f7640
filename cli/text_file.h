/*
 * text_file.h - a small file that appears whole or not at all.
 */
#ifndef BRDFCL_TEXT_FILE_H
#define BRDFCL_TEXT_FILE_H

#include <stddef.h>

#include <brdf/status.h>

/* Could text_file_write write here? Leaves no trace. BRDF_IO. */
brdf_status text_file_check(const char *path, struct brdf_error *error);

/*
 * Write a file by way of a temporary in its folder; a symbolic link is followed. "-" is standard
 * output, and what is not a regular file (/dev/null, a pipe) is written as it is. BRDF_IO,
 * BRDF_OUT_OF_MEMORY.
 */
brdf_status text_file_write(const char *path, const char *text, size_t length,
                            struct brdf_error *error);

#endif
