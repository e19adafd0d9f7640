/*
 * wavefront.h - the path tracer's kernels on a device: program, buffers, and how each is launched.
 */
#ifndef BRDFCL_LIB_WAVEFRONT_H
#define BRDFCL_LIB_WAVEFRONT_H

#include "opencl.h"
#include "render_job.h"

enum stage {
    STAGE_BEGIN,
    STAGE_GENERATE,
    STAGE_EXTEND,
    STAGE_RESOLVE, /* only where a scene has forks */
    STAGE_SORT,
    STAGE_CONNECT,
    STAGE_FILM,
    STAGE_SHADE, /* and one for each further variant */
    STAGE_COUNT = STAGE_SHADE + PT_MAX_VARIANTS
};

struct launch {
    cl_kernel kernel;
    size_t items; /* a multiple of group */
    size_t group;
};

struct wavefront {
    struct render_job *job;
    struct brdfcl_device *device;
    cl_program program;
    cl_mem settings;
    cl_mem scene;
    cl_mem tables;
    cl_mem state;
    cl_mem film;
    struct launch stages[STAGE_COUNT];
    unsigned rays; /* the counters when they were last read */
    unsigned invalid;
};

/*
 * Build and load everything for job->world, and let the device compile what it compiles late, so
 * that nothing is left to do but to render. A failed wavefront is to be released as well.
 */
brdf_status wavefront_create(struct wavefront *wave, struct render_job *job,
                             struct brdf_error *error);
void wavefront_release(struct wavefront *wave);

/* Put a stage in the queue. */
cl_int wavefront_run(struct wavefront *wave, int stage, const struct pt_pass *pass, int depth);

#endif
