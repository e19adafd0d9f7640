/*
 * world_environment.c - the environment: its pixels, and the distribution that samples them.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "world.h"

static double pixel_luminance(const struct brdfcl_image *image, int x, int y)
{
    const float *rgb =
        image->rgb + 3 * ((size_t)y * (size_t)image->width + (size_t)(x % image->width));
    return world_luminance(rgb);
}

/*
 * The weight of the cell between four pixels: their mean luminance times the sine in the middle. It
 * is above 0 wherever the bilinear radiance is.
 */
static double cell_weight(const struct brdfcl_image *image, int x, int y)
{
    double mean = 0.25 * (pixel_luminance(image, x, y) + pixel_luminance(image, x + 1, y) +
                          pixel_luminance(image, x, y + 1) + pixel_luminance(image, x + 1, y + 1));
    return mean * sin(pi * (y + 0.5) / (image->height - 1));
}

static brdf_status append_distribution(const struct brdfcl_image *image,
                                       struct pt_settings *settings, struct world_words *words,
                                       struct brdf_error *error)
{
    size_t width = (size_t)image->width;
    size_t cells = (size_t)image->height - 1;
    brdf_status status =
        world_append(words, NULL, cells * (width + 1), &settings->environment_columns, error);
    if (status == BRDF_OK) {
        status = world_append(words, NULL, cells + 1, &settings->environment_rows, error);
    }
    double *row = malloc((width + cells) * sizeof *row);
    if (status != BRDF_OK || !row) {
        free(row);
        return status != BRDF_OK
                   ? status
                   : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the environment map");
    }
    double *rows = row + width;
    for (size_t y = 0; y < cells; ++y) {
        rows[y] = 0.0;
        for (size_t x = 0; x < width; ++x) {
            row[x] = cell_weight(image, (int)x, (int)y);
            rows[y] += row[x];
        }
        world_cdf(row, width, words->words + settings->environment_columns + y * (width + 1));
    }
    world_cdf(rows, cells, words->words + settings->environment_rows);
    settings->environment_row_steps = world_search_steps((int)cells);
    settings->environment_column_steps = world_search_steps((int)width);
    free(row);
    return BRDF_OK;
}

brdf_status world_environment(const struct brdfcl_scene *scene, struct world *world,
                              struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    const struct scene_environment *environment = &scene->environment;
    if (environment->kind == ENVIRONMENT_CONSTANT) {
        settings->features |= PT_HAS_CONSTANT;
        memcpy(settings->environment_radiance, environment->radiance,
               sizeof settings->environment_radiance);
    }
    if (environment->kind != ENVIRONMENT_MAP) {
        return BRDF_OK;
    }
    const struct brdfcl_image *image = &environment->image;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    settings->features |= PT_HAS_MAP;
    settings->environment_width = image->width;
    settings->environment_height = image->height;
    memcpy(settings->environment_to_world, environment->to_world,
           sizeof settings->environment_to_world);
    brdf_status status =
        world_append(words, NULL, pixels * 4, &settings->environment_texels, error);
    if (status != BRDF_OK) {
        return status;
    }
    float *texels = words->words + settings->environment_texels;
    for (size_t i = 0; i < pixels; ++i) {
        memcpy(texels + 4 * i, image->rgb + 3 * i, 3 * sizeof(float));
    }
    return append_distribution(image, settings, words, error);
}
