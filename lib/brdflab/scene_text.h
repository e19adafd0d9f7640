/*
 * scene_text.h - materials as they are written in a scene file.
 */
#ifndef BRDFLAB_SCENE_TEXT_H
#define BRDFLAB_SCENE_TEXT_H

#include <stdio.h>

#include <brdf/material.h>

/*
 * Write a blend of `count` parts (1 to 16), whose weights sum to 1, as nested blendbsdf elements;
 * one part by itself as what it is. Every value is written, with the digits that make the same bits
 * again. Indented by `indent` levels of four spaces. Parts must not be tabulated.
 */
void lab_scene_text(FILE *file, const struct brdf_bsdf *const *parts, const double *weights,
                    int count, int indent);

#endif
