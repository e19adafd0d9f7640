/*
 * render_job.c - see render_job.h.
 */
#define _POSIX_C_SOURCE 200809L
#include <time.h>

#include "render_job.h"

#define REPORT_SECONDS 0.1

double render_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void render_sweep_begin(struct render_job *job, int first_sample)
{
    int left = job->spp - first_sample;
    int bits = SWEEP_BITS;
    while (bits > 0 && ((1 << bits) > left || (1 << bits) > job->run_pixels)) {
        --bits;
    }
    job->first_sample = first_sample;
    job->first_pixel = 0;
    job->sweep_bits = bits;
}

int render_next_pass(struct render_job *job, int new_sweep, struct pt_pass *pass)
{
    if (job->first_pixel == job->pixels) {
        if (!new_sweep || job->first_sample + (1 << job->sweep_bits) >= job->spp) {
            return 0;
        }
        render_sweep_begin(job, job->first_sample + (1 << job->sweep_bits));
    }
    int run = job->run_pixels >> job->sweep_bits;
    int left = job->pixels - job->first_pixel;
    run = run < left ? run : left;
    pass->first_pixel = job->first_pixel;
    pass->first_sample = job->first_sample;
    pass->sample_bits = job->sweep_bits;
    pass->path_count = run << job->sweep_bits;
    job->first_pixel += run;
    return 1;
}

int render_has_pass(const struct render_job *job)
{
    return job->first_pixel < job->pixels || job->first_sample + (1 << job->sweep_bits) < job->spp;
}

void render_count(struct render_job *job, long long paths, unsigned rays, unsigned invalid)
{
    job->samples += paths;
    job->result->rays += rays;
    job->result->invalid += invalid;
}

int render_report(struct render_job *job)
{
    double now = render_now();
    if (!job->options->progress || now - job->reported < REPORT_SECONDS) {
        return 0;
    }
    job->reported = now;
    struct brdfcl_progress progress;
    progress.seconds = now - job->started;
    progress.samples = job->samples;
    progress.samples_all = (long long)job->pixels * job->spp;
    progress.spp_done = (int)(job->samples / job->pixels);
    return job->options->progress(job->options->context, &progress);
}
