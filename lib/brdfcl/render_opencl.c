/*
 * render_opencl.c - the wavefront on an OpenCL device: kernels in order, nothing read back in
 * between but once in a while whether any path is left.
 */
#include <string.h>

#include "wavefront.h"

#include "kernels/film.h"

/* From this depth on, every few bounces, the host asks whether any path is left. */
#define ASK_FROM 8
#define ASK_EVERY 4

/* Passes that are put in the queue before the host waits: for about so long, and so many at most.
 */
#define BATCH_SECONDS 0.05
#define BATCH_PASSES 16

static cl_int read_counters(struct wavefront *wave, int *counters, int count)
{
    size_t at = (size_t)wave->job->world.settings.queues * sizeof(float);
    return clEnqueueReadBuffer(wave->device->queue, wave->state, CL_TRUE, at,
                               (size_t)count * sizeof(int), counters, 0, NULL, NULL);
}

static cl_int bounce(struct wavefront *wave, const struct pt_pass *pass, int depth)
{
    const struct pt_settings *settings = &wave->job->world.settings;
    int lights = settings->features & (PT_HAS_LIGHTS | PT_HAS_CONSTANT | PT_HAS_MAP);
    int environment = settings->features & (PT_HAS_CONSTANT | PT_HAS_MAP);
    cl_int result = wavefront_run(wave, STAGE_EXTEND, pass, depth);
    if (result == CL_SUCCESS && (settings->features & PT_HAS_FORKS)) {
        result = wavefront_run(wave, STAGE_RESOLVE, pass, depth);
    }
    if (result == CL_SUCCESS) {
        result = wavefront_run(wave, STAGE_SORT, pass, depth);
    }
    int variants = settings->variant_count - (environment ? 0 : 1);
    for (int v = 0; v < variants && result == CL_SUCCESS; ++v) {
        result = wavefront_run(wave, STAGE_SHADE + v, pass, depth);
    }
    if (result == CL_SUCCESS && lights) {
        result = wavefront_run(wave, STAGE_CONNECT, pass, depth);
    }
    return result;
}

/* All paths of a pass, put in the queue; not waited for. */
static cl_int trace(struct wavefront *wave, const struct pt_pass *pass)
{
    int max_depth = wave->job->world.settings.max_depth;
    cl_int result = wavefront_run(wave, STAGE_BEGIN, pass, 0);
    if (result == CL_SUCCESS) {
        result = wavefront_run(wave, STAGE_GENERATE, pass, 0);
    }
    for (int depth = 0; depth < max_depth && result == CL_SUCCESS; ++depth) {
        result = bounce(wave, pass, depth);
        if (result == CL_SUCCESS && depth >= ASK_FROM && depth % ASK_EVERY == 0) {
            int active[2] = {0, 0};
            result = read_counters(wave, active, 2);
            if (active[(depth + 1) & 1] == 0) {
                break;
            }
        }
    }
    return result == CL_SUCCESS ? wavefront_run(wave, STAGE_FILM, pass, 0) : result;
}

/*
 * Some passes, waited for once: the device need not stop between them. Never so many that the
 * counter of rays could wrap around unseen, or that stopping would take long.
 */
static brdf_status run_batch(struct wavefront *wave, int passes, struct brdf_error *error)
{
    struct render_job *job = wave->job;
    struct pt_pass pass;
    int counters[PT_VARIANTS] = {0};
    cl_int result = CL_SUCCESS;
    long long paths = 0;
    for (int i = 0; i < passes && result == CL_SUCCESS && render_next_pass(job, 1, &pass); ++i) {
        result = trace(wave, &pass);
        paths += pass.path_count;
    }
    if (result == CL_SUCCESS) {
        result = read_counters(wave, counters, PT_VARIANTS);
    }
    render_count(job, paths, (unsigned)counters[PT_RAYS] - wave->rays,
                 (unsigned)counters[PT_INVALID] - wave->invalid);
    wave->rays = (unsigned)counters[PT_RAYS];
    wave->invalid = (unsigned)counters[PT_INVALID];
    return opencl_check(result, "running the path tracer's kernels", error);
}

static brdf_status run_passes(struct wavefront *wave, struct brdf_error *error)
{
    struct render_job *job = wave->job;
    brdf_status status = BRDF_OK;
    int passes = 1;
    while (status == BRDF_OK && !job->result->stopped && render_has_pass(job)) {
        double began = render_now();
        status = run_batch(wave, passes, error);
        double seconds = render_now() - began;
        if (seconds < 0.5 * BATCH_SECONDS && passes < BATCH_PASSES) {
            passes *= 2;
        } else if (seconds > BATCH_SECONDS && passes > 1) {
            passes /= 2;
        }
        job->result->stopped = render_report(job) != 0;
    }
    if (status == BRDF_OK) {
        size_t bytes = (size_t)job->pixels * PT_FILM_WORDS * sizeof(float);
        status = opencl_check(clEnqueueReadBuffer(wave->device->queue, wave->film, CL_TRUE, 0,
                                                  bytes, job->film, 0, NULL, NULL),
                              "clEnqueueReadBuffer", error);
    }
    return status;
}

brdf_status render_opencl(struct render_job *job, struct brdf_error *error)
{
    struct wavefront wave;
    double began = render_now();
    brdf_status status = wavefront_create(&wave, job, error);
    job->started = render_now();
    job->reported = job->started;
    job->result->seconds_kernel_build += job->started - began;
    if (status == BRDF_OK) {
        status = run_passes(&wave, error);
    }
    wavefront_release(&wave);
    return status;
}
