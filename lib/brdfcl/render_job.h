/*
 * render_job.h - what both renderers share: the passes of a render, its film, its clock.
 *
 * An image is rendered in sweeps over all pixels, each adding 1, 2, 4, 8 or 16 samples to every
 * pixel, and a sweep in passes over runs of pixels that fit the pool of paths.
 */
#ifndef BRDFCL_LIB_RENDER_JOB_H
#define BRDFCL_LIB_RENDER_JOB_H

#include <brdfcl/render.h>

#include "world.h"

/* Samples of a pixel in one pass at most, as a power of two: a packet then starts coherent. */
#define SWEEP_BITS 4

struct render_job {
    const struct brdfcl_render_options *options;
    struct brdfcl_render_result *result;
    struct world world;
    float *film; /* PT_FILM_WORDS a pixel, aligned to 64 bytes */
    int pixels;
    int spp;        /* wanted */
    int run_pixels; /* pixels in a pass at most, at one sample each */

    /* Where the render is: passes handed out so far. */
    int first_pixel;
    int first_sample;
    int sweep_bits;

    double started; /* render_now() */
    double reported;
    long long samples; /* finished */
};

/* Seconds of a clock that only goes forward. */
double render_now(void);

/* Start a sweep: the largest that the samples still wanted allow, and that fits the pool. */
void render_sweep_begin(struct render_job *job, int first_sample);

/* The next pass; 0 where there is none left. Starts a new sweep only where `new_sweep` is set, and
   returns 0 where it would have to. */
int render_next_pass(struct render_job *job, int new_sweep, struct pt_pass *pass);

/* Is there a pass left? */
int render_has_pass(const struct render_job *job);

/* Count finished paths, and the rays and invalid samples that they brought. */
void render_count(struct render_job *job, long long paths, unsigned rays, unsigned invalid);

/* Tell the caller, if it is time; 1 where the caller wants to stop. */
int render_report(struct render_job *job);

/* Run all passes, and leave the sums in job->film. */
brdf_status render_opencl(struct render_job *job, struct brdf_error *error);
brdf_status render_c(struct render_job *job, struct brdf_error *error);

#endif
