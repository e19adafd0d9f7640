/*
 * render_scenes.h - small scenes rendered by either renderer, and what their pixels say together.
 */
#ifndef TEST_RENDER_SCENES_H
#define TEST_RENDER_SCENES_H

#include "scene_files.h"

#include <brdfcl/render.h>

/* How a scene is looked at; members that are 0 take the value in brackets. */
struct view {
    const char *from;    /* ["0, 1, 4"] */
    const char *to;      /* ["0, 0.5, 0"] */
    double fov;          /* degrees [45] */
    int size;            /* pixels, a square [16] */
    int spp;             /* [4] */
    int depth;           /* [5]; -1: unlimited */
    int rr_depth;        /* [1000] */
    const char *sampler; /* ["independent"] */
    const char *filter;  /* ["box"] */
};

/* Load a scene, which must be a good one. The folder is that of scene_files_open. */
struct brdfcl_scene *render_scene_load(const struct view *view, const char *content);

/* Who renders: lanes of the first OpenCL device, or 0 for C. */
struct renderer {
    int lanes;
    int threads; /* of C; 0 = all */
    int pool;    /* 0 = chosen by the renderer */
};

/* Render; every sample must be finite. The image is the caller's. */
struct brdfcl_render_result render_by(const struct renderer *who, const struct brdfcl_scene *scene);

/* The hash of the image that it makes. */
unsigned long long render_hash(const struct renderer *who, const struct brdfcl_scene *scene);

/* Load and render in C, and the mean and its standard error over all pixels, which should look at
   the same thing and be independent. Of the first channel. */
struct estimate {
    double mean;
    double error;
    double least; /* of a pixel */
    double most;
};
struct estimate render_estimate(const struct view *view, const char *content);

/*
 * Fail unless the mean is `expected`, but for 4.5 standard errors and a relative `slack` that is
 * not noise (rounding, rays that start a little off their surface); and where the noise is above
 * `noise` times what is expected, as then the test would say nothing.
 */
void assert_estimate(const char *name, struct estimate estimate, double expected, double slack,
                     double noise);

/* A number formatted into one of a few static strings, for texts made of pieces. */
const char *text_of(double number);

#endif
