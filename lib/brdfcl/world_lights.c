/*
 * world_lights.c - the lights of next-event estimation: chosen in proportion to their power.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "angle.h"
#include "world.h"

#include "kernels/extend.h"

/* Where both are, the environment and the primitives are chosen equally often. */
#define ENVIRONMENT_SHARE 0.5

static double area_of(const float *primitive)
{
    const float *a = primitive + PT_E1;
    const float *b = primitive + PT_E2;
    double x = (double)a[1] * (double)b[2] - (double)a[2] * (double)b[1];
    double y = (double)a[2] * (double)b[0] - (double)a[0] * (double)b[2];
    double z = (double)a[0] * (double)b[1] - (double)a[1] * (double)b[0];
    double across = sqrt(x * x + y * y + z * z);
    double radius = (double)primitive[PT_RADIUS];
    switch (pt_int_bits(primitive[PT_KIND])) {
    case PT_TRIANGLE:
        return 0.5 * across;
    case PT_DISK:
        return pi * across;
    case PT_SPHERE:
        return 4.0 * pi * radius * radius;
    default:
        return across;
    }
}

static const struct scene_surface *surface_of(const struct brdfcl_scene *scene, size_t primitive)
{
    int reference = pt_int_bits(scene->primitives.words[primitive * PT_ROW + PT_SURFACE]);
    /* All parts of a composed surface emit alike. */
    while (reference < 0) {
        reference = scene->forks[-1 - reference].first;
    }
    return &scene->surfaces[reference];
}

/* A light's record. The primitive learns its probability, which a path that meets it by chance
   needs to know. */
static void write_light(const struct scene_surface *surface, float *primitive, double select,
                        float *light)
{
    memcpy(light, primitive, 9 * sizeof(float));
    memcpy(light + PT_LIGHT_RADIANCE, surface->radiance, sizeof surface->radiance);
    light[PT_LIGHT_KIND] = primitive[PT_KIND];
    light[PT_LIGHT_SELECT] = (float)select;
    light[PT_LIGHT_RADIUS] = primitive[PT_RADIUS];
    light[PT_LIGHT_FLIP] = primitive[PT_FLIP];
    primitive[PT_LIGHT_PDF] = (float)select;
}

/* Weights of all lights that shine: primitives first, the environment last. Their number. */
static size_t weigh(const struct brdfcl_scene *scene, int environment, double *weights,
                    size_t *primitives)
{
    size_t count = 0;
    double total = 0.0;
    for (size_t i = 0; i < scene->primitives.count; ++i) {
        const struct scene_surface *surface = surface_of(scene, i);
        double power =
            area_of(scene->primitives.words + i * PT_ROW) * world_luminance(surface->radiance);
        if (surface->emits && power > 0.0) {
            weights[count] = power;
            primitives[count] = i;
            total += power;
            ++count;
        }
    }
    for (size_t i = 0; i < count; ++i) {
        weights[i] *= (environment ? 1.0 - ENVIRONMENT_SHARE : 1.0) / total;
    }
    if (environment && count > 0) {
        weights[count++] = ENVIRONMENT_SHARE;
    }
    return count;
}

static brdf_status append_lights(const struct brdfcl_scene *scene, struct world *world,
                                 struct world_words *words, const double *weights,
                                 const size_t *primitives, size_t count, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    brdf_status status = world_append(words, NULL, count * PT_ROW, &settings->lights, error);
    if (status == BRDF_OK) {
        status = world_append(words, NULL, count + 1, &settings->light_cdf, error);
    }
    if (status != BRDF_OK) {
        return status;
    }
    world_cdf(weights, count, words->words + settings->light_cdf);
    settings->light_count = (int)count;
    settings->light_steps = world_search_steps((int)count);
    settings->features |= PT_HAS_LIGHTS;
    int environment = settings->features & (PT_HAS_CONSTANT | PT_HAS_MAP);
    size_t solid = count - (environment ? 1 : 0);
    for (size_t i = 0; i < solid; ++i) {
        float *primitive = words->words + settings->primitives + primitives[i] * PT_ROW;
        float *light = words->words + settings->lights + i * PT_ROW;
        write_light(surface_of(scene, primitives[i]), primitive, weights[i], light);
        if (pt_int_bits(primitive[PT_KIND]) == PT_SPHERE) {
            settings->features |= PT_HAS_SPHERE_LIGHTS;
        }
    }
    if (environment) {
        float *light = words->words + settings->lights + solid * PT_ROW;
        light[PT_LIGHT_KIND] = pt_float_of_bits(-1);
        light[PT_LIGHT_SELECT] = (float)ENVIRONMENT_SHARE;
        settings->environment_select = (float)ENVIRONMENT_SHARE;
    }
    return BRDF_OK;
}

brdf_status world_lights(const struct brdfcl_scene *scene, struct world *world,
                         struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    int environment = (settings->features & (PT_HAS_CONSTANT | PT_HAS_MAP)) != 0;
    settings->environment_select = 1.0f;
    double *weights = malloc((scene->primitives.count + 1) * sizeof *weights);
    size_t *primitives = malloc((scene->primitives.count + 1) * sizeof *primitives);
    brdf_status status = BRDF_OK;
    if (!weights || !primitives) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the lights");
    } else {
        size_t count = weigh(scene, environment, weights, primitives);
        if (count > 0) {
            status = append_lights(scene, world, words, weights, primitives, count, error);
        }
    }
    free(weights);
    free(primitives);
    return status;
}
