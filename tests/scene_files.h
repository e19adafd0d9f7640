/*
 * scene_files.h - scenes written to a temporary folder, loaded, and looked into.
 */
#ifndef BRDFCL_TESTS_SCENE_FILES_H
#define BRDFCL_TESTS_SCENE_FILES_H

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scene.h"

/* Group set-up and tear-down: a folder, empty again at the end. */
int scene_files_open(void **state);
int scene_files_close(void **state);

/* Write a file into the folder; returns its path, valid until the next call for the same name. */
const char *scene_file_write(const char *name, const char *text);
const char *scene_file_write_bytes(const char *name, const void *bytes, size_t length);

/* Load a text as a scene file. */
brdf_status scene_text_load(const char *text, const struct brdfcl_define *defines, size_t count,
                            struct brdfcl_scene **scene, struct brdf_error *error);

/* The same, and it must succeed; with a camera and an integrator around the text. */
struct brdfcl_scene *scene_content_load(const char *content);

/* The row of a primitive, and the int in one of its words. */
const float *scene_row(const struct brdfcl_scene *scene, size_t index);
int scene_row_int(const float *row, int word);

/* Three words from `word` on, within 1e-6. */
void assert_vector(const float *row, int word, float x, float y, float z);

/* A scene that must be refused, and how. */
struct scene_mistake {
    const char *text;
    int line; /* 0: the message has none */
    brdf_status status;
    const char *says; /* part of the message */
};

void scene_mistakes_check(const struct scene_mistake *mistakes, size_t count);

/* Whether one of the scene's notes contains this text. */
int scene_has_note(const struct brdfcl_scene *scene, const char *text);

#endif
