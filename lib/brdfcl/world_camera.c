/*
 * world_camera.c - the perspective camera as a corner of the film and its two edges.
 */
#include <math.h>

#include "angle.h"
#include "world.h"

void world_camera(const struct brdfcl_scene *scene, struct pt_settings *settings)
{
    double aspect = (double)scene->width / (double)scene->height;
    double half = tan(0.5 * (double)scene->fov * pi / 180.0);
    int along_x = 0;
    switch (scene->fov_axis) {
    case FOV_X:
        along_x = 1;
        break;
    case FOV_Y:
        break;
    case FOV_DIAGONAL:
        half /= sqrt(1.0 + 1.0 / (aspect * aspect));
        along_x = 1;
        break;
    case FOV_SMALLER:
        along_x = aspect < 1.0;
        break;
    case FOV_LARGER:
        along_x = aspect >= 1.0;
        break;
    }
    double half_x = along_x ? half : half * aspect;
    double half_y = half_x / aspect;

    /* In its own frame the camera looks along +z, with +x to the left and +y up, as Mitsuba's. */
    double offset_x = (double)scene->principal_offset[0];
    double offset_y = (double)scene->principal_offset[1];
    double corner[3] = {half_x * (1.0 - 2.0 * offset_x), half_y * (1.0 - 2.0 * offset_y), 1.0};
    for (int row = 0; row < 3; ++row) {
        const float *m = scene->camera_to_world + 4 * row;
        settings->camera_origin[row] = m[3];
        settings->camera_corner[row] =
            (float)((double)m[0] * corner[0] + (double)m[1] * corner[1] + (double)m[2] * corner[2]);
        settings->camera_right[row] = (float)(-2.0 * half_x * (double)m[0]);
        settings->camera_down[row] = (float)(-2.0 * half_y * (double)m[1]);
    }
}
