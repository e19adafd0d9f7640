/*
 * render.c - a render from beginning to end: lay out the scene, run all passes, divide the sums.
 */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "opencl.h"
#include "render_job.h"

#include "kernels/film.h"

/*
 * Paths in flight. On a processor, for each core: few enough that their records (150 bytes a path)
 * stay in the last cache, many enough that launching kernels costs little. Half as many are a sixth
 * slower on an idle machine.
 */
#define POOL_CORE (1 << 15)
#define POOL_OTHER (1 << 20)
#define POOL_C (1 << 11)

/* Sums to means; pixels before the place of a stop have the samples of the unfinished sweep too. */
static brdf_status develop(struct render_job *job, struct brdf_error *error)
{
    struct brdfcl_render_result *result = job->result;
    int width = job->world.settings.width;
    int height = job->world.settings.height;
    brdf_status status = brdfcl_image_create(&result->image, width, height, error);
    if (status != BRDF_OK) {
        return status;
    }
    int sweep = 1 << job->sweep_bits;
    int complete = job->first_pixel == job->pixels;
    result->spp = job->first_sample + (complete ? sweep : 0);
    for (int i = 0; i < job->pixels; ++i) {
        int samples = job->first_sample + (i < job->first_pixel ? sweep : 0);
        for (int c = 0; c < 3; ++c) {
            float sum = job->film[(size_t)i * PT_FILM_WORDS + (size_t)c];
            result->image.rgb[(size_t)i * 3 + (size_t)c] =
                samples > 0 ? sum / (float)samples : 0.0f;
        }
    }
    return BRDF_OK;
}

/* How many paths one renderer has in flight: a multiple of 16, and no more than there are. */
static int choose_pool(const struct brdfcl_render_options *options, long long paths)
{
    int pool = options->pool;
    if (pool <= 0) {
        pool = !options->device                 ? POOL_C
               : options->device->info.cpu != 0 ? POOL_CORE * options->device->info.compute_units
                                                : POOL_OTHER;
    }
    pool = pool < 16 ? 16 : pool > (1 << 24) ? 1 << 24 : pool;
    if (pool > paths) {
        pool = (int)paths;
    }
    return (pool + 15) / 16 * 16;
}

/* Does the largest buffer of a device hold the film, and the paths? Asked before anything is made.
 */
static brdf_status check_device(const struct brdfcl_scene *scene,
                                const struct brdfcl_device *device, long long pixels,
                                size_t state_words, struct brdf_error *error)
{
    unsigned long long film = (unsigned long long)pixels * PT_FILM_WORDS * sizeof(float);
    unsigned long long state = (unsigned long long)state_words * sizeof(float);
    if (!device || (film <= device->info.largest && state <= device->info.largest)) {
        return BRDF_OK;
    }
    return film > device->info.largest
               ? brdf_fail(error, BRDF_OUT_OF_MEMORY,
                           "%d x %d pixels need a buffer of %llu MB; %s gives at most %llu MB: "
                           "make the picture smaller, or use the C backend",
                           scene->width, scene->height, film >> 20, device->info.name,
                           device->info.largest >> 20)
               : brdf_fail(error, BRDF_OUT_OF_MEMORY,
                           "the paths in flight need a buffer of %llu MB; %s gives at most %llu "
                           "MB: use a smaller pool",
                           state >> 20, device->info.name, device->info.largest >> 20);
}

brdf_status brdfcl_render(const struct brdfcl_scene *scene,
                          const struct brdfcl_render_options *options,
                          struct brdfcl_render_result *result, struct brdf_error *error)
{
    memset(result, 0, sizeof *result);
    long long pixels = (long long)scene->width * scene->height;
    if (pixels * PT_FILM_WORDS > INT_MAX) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%d x %d pixels: at most %d million can be rendered at once", scene->width,
                         scene->height, INT_MAX / PT_FILM_WORDS / 1000000);
    }
    if (options->device && options->device->lanes > PT_WIDTH) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%d lanes are for evaluating arrays: open the device with at most %d to "
                         "render",
                         options->device->lanes, PT_WIDTH);
    }
    struct render_job job;
    memset(&job, 0, sizeof job);
    job.options = options;
    job.result = result;
    job.pixels = (int)pixels;
    job.spp = scene->spp;
    int pool = choose_pool(options, pixels * scene->spp);
    job.run_pixels = pool;
    render_sweep_begin(&job, 0);

    double began = render_now();
    int lanes = options->device ? options->device->lanes : 1;
    brdf_status status = world_create(scene, lanes, pool, &job.world, error);
    if (status == BRDF_OK) {
        status = check_device(scene, options->device, pixels, job.world.state_words, error);
    }
    if (status == BRDF_OK) {
        job.film = world_allocate((size_t)pixels * PT_FILM_WORDS * sizeof(float));
        if (!job.film) {
            status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %d x %d pixels",
                               scene->width, scene->height);
        }
    }
    result->seconds_kernel_build = render_now() - began;
    if (status == BRDF_OK) {
        status = options->device ? render_opencl(&job, error) : render_c(&job, error);
    }
    if (status == BRDF_OK && job.samples == 0) {
        status = brdf_fail(error, BRDF_CANCELLED, "stopped before the first sample was finished");
    }
    result->seconds_render = render_now() - job.started;
    result->samples = job.samples;
    if (status == BRDF_OK) {
        status = develop(&job, error);
    }
    free(job.film);
    world_destroy(&job.world);
    return status;
}
