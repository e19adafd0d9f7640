/*
 * render.h - the subcommand render, shared by its files: what was asked for, and what came of it.
 */
#ifndef BRDFCL_CLI_RENDER_H
#define BRDFCL_CLI_RENDER_H

#include <brdfcl/render.h>

#include "backend.h"
#include "options.h"
#include "parse.h"

struct render_request {
    const char *scene_path;
    struct texts outputs; /* where the picture goes */
    struct texts defines; /* "name=value" */
    const char *json;     /* NULL: none */
    int spp;              /* 0 = as the scene says */
    int depth;            /* DEPTH_OF_SCENE, or -1 = unlimited */
    int seed;             /* -1 = as the scene says */
    struct size size;     /* 0 = as the scene says */
    struct backend backend;
    double exposure; /* stops, PNG */
    int half;        /* HALF_OF_SCENE, 0 or 1 */
    int quiet;
    char default_output[1024];
};

#define DEPTH_OF_SCENE (-2)
#define HALF_OF_SCENE (-1)

/* What the files say about a render. */
struct render_outcome {
    struct brdfcl_scene_info scene;
    struct brdfcl_render_result result;
    const char *device; /* its name; "C" for the C renderer */
    int lanes;
};

/* Could every output be written? Asked before rendering. */
brdf_status render_outputs_check(const struct render_request *request, struct brdf_error *error);

/* Write the picture everywhere, and the JSON. */
brdf_status render_outputs_write(const struct render_request *request,
                                 const struct render_outcome *outcome, struct brdf_error *error);

#endif
