/*
 * render.h - from a scene to an image, by the wavefront path tracer on OpenCL or in C.
 *
 * Both run the same stage functions in the same order of additions: the same scene, seed and spp
 * give the same bits from either, at every lane count, thread count and pool size.
 */
#ifndef BRDFCL_RENDER_H
#define BRDFCL_RENDER_H

#include <brdf/status.h>
#include <brdfcl/api.h>
#include <brdfcl/device.h>
#include <brdfcl/image.h>
#include <brdfcl/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

struct brdfcl_progress {
    double seconds;        /* since rendering began, kernel build not counted */
    long long samples;     /* finished, over all pixels */
    long long samples_all; /* wanted */
    int spp_done;          /* finished in every pixel */
};

struct brdfcl_render_options {
    struct brdfcl_device *device; /* NULL: the C renderer */
    int threads;                  /* of the C renderer; 0 = all cores */
    int pool;                     /* paths in flight (a thread, in C); 0 = chosen for the cache */
    /* Called about ten times a second from the calling thread; a result other than 0 stops the
       render at the next pass, keeping what is finished. May be NULL. */
    int (*progress)(void *context, const struct brdfcl_progress *progress);
    void *context;
};

struct brdfcl_render_result {
    struct brdfcl_image image;   /* mean over the finished samples; owned by the caller */
    int spp;                     /* finished samples in every pixel */
    int stopped;                 /* 1 if progress() asked for it */
    double seconds_kernel_build; /* compiling or loading kernels, and building the hierarchy */
    double seconds_render;
    long long samples; /* finished */
    long long rays;    /* traced: path segments and shadow rays */
    long long invalid; /* samples that were not finite and count as black; always 0 unless a bug */
};

/*
 * Render. On BRDF_OK the result holds an image to be destroyed by the caller, also when stopped
 * early: pixels that the unfinished sweep had reached hold its samples as well, and where spp is 0
 * the others are black. Stopped before anything was finished: BRDF_CANCELLED, and no image.
 */
BRDFCL_API brdf_status brdfcl_render(const struct brdfcl_scene *scene,
                                     const struct brdfcl_render_options *options,
                                     struct brdfcl_render_result *result, struct brdf_error *error);

#ifdef __cplusplus
}
#endif

#endif
