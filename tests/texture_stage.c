/* texture_stage.c - a scene loaded and laid out for one lane. */
#include "texture_stage.h"

#include <math.h>

void stage_open(struct stage *stage, const char *content)
{
    struct brdf_error error;
    stage->scene = scene_content_load(content);
    if (world_create(stage->scene, 1, 16, &stage->world, &error) != BRDF_OK) {
        fail_msg("%s", error.message);
    }
    stage->state = world_allocate(stage->world.state_words * sizeof(float));
    assert_non_null(stage->state);
    stage->w = pt_world_make(&stage->world.settings, stage->world.scene, stage->world.tables,
                             stage->state);
}

void stage_close(struct stage *stage)
{
    world_destroy(&stage->world);
    brdfcl_scene_destroy(stage->scene);
    free(stage->state);
}

void assert_color(const char *name, double u, double v, brdf_rgb got, const double want[3])
{
    const float channels[3] = {got.r, got.g, got.b};
    for (int c = 0; c < 3; ++c) {
        if (!(fabs((double)channels[c] - want[c]) <= 2e-5)) {
            fail_msg("%s at (%g, %g), channel %d: %.7g, expected %.7g", name, u, v, c,
                     (double)channels[c], want[c]);
        }
    }
}
