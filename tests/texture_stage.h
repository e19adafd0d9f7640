/*
 * texture_stage.h - a scene laid out for one lane, to look things up in by calling the stages'
 * functions.
 */
#ifndef TEST_TEXTURE_STAGE_H
#define TEST_TEXTURE_STAGE_H

#include "scene_files.h"
#include "world.h"

#include "kernels/texture.h"

struct stage {
    struct brdfcl_scene *scene;
    struct world world;
    float *state;
    struct pt_world w;
};

/* Of the content of a scene file, which must be a good one. */
void stage_open(struct stage *stage, const char *content);
void stage_close(struct stage *stage);

/* Within 2e-5 in every channel; (u, v) is for the message. */
void assert_color(const char *name, double u, double v, brdf_rgb got, const double want[3]);

#endif
