/*
 * render_contents.h - two scenes in which everything occurs that a renderer tells apart.
 */
#ifndef TEST_RENDER_CONTENTS_H
#define TEST_RENDER_CONTENTS_H

/* The contents of a box: spheres, planar shapes, glass, twosided, anisotropic metal, lights of
   every shape, textures, a constant environment; few enough primitives for packets of rays. */
extern const char *const box_contents;

/* Primitives that no ray meets: with them a hierarchy is needed, and nothing else changes. */
extern const char *const far_contents;

/* A mesh with normals and texture coordinates and pictures on it under an environment map, and two
 * lights. */
extern const char *const mesh_contents;

/* The files that they refer to, into the folder of scene_files_open. */
void render_files_write(void);

#endif
