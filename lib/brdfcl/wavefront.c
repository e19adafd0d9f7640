/*
 * wavefront.c - making the path tracer's kernels: one program for a scene, specialised to it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wavefront.h"

#include "kernels/film.h"

/* Work-items of a work-group where each is a packet, a ray or a pixel. */
#define GROUP_PACKETS 16
#define GROUP_RAYS 64
#define GROUP_PIXELS 64

/* The program's text: the stages, and a kernel for each variant with its constants written in. */
static char *program_text(const struct world *world)
{
    size_t size = 256 + 1024 * (size_t)world->settings.variant_count;
    char *text = malloc(size);
    if (!text) {
        return NULL;
    }
    size_t used = (size_t)snprintf(text, size, "#include \"kernels/wavefront.cl\"\n");
    for (int v = 0; v < world->settings.variant_count - 1; ++v) {
        const struct world_variant *variant = &world->variants[v];
        used += (size_t)snprintf(
            text + used, size - used,
            "__kernel void shade_%d(__global const struct pt_settings *settings,\n"
            "    __global const float *scene, __global const float *tables,\n"
            "    __global float *state, struct pt_pass pass, int depth)\n"
            "{\n"
            "    struct pt_world w = pt_world_make(settings, scene, tables, state);\n"
            "    int packet = (int)get_global_id(0);\n"
            "    if (packet < w.queues[PT_VARIANTS + %d]) {\n"
            "        packet += w.queues[settings->variant_first + %d];\n",
            v, v, v);
        if (variant->through) {
            used += (size_t)snprintf(text + used, size - used,
                                     "        pt_shade_through(w, pass, packet, depth);\n"
                                     "    }\n}\n");
            continue;
        }
        used += (size_t)snprintf(
            text + used, size - used,
            "        struct pt_variant variant = {%s, 0x%xu, 0x%xu, %d, 0x%xu, 0x%xu, 0x%xu};\n"
            "        pt_shade(w, pass, variant, packet, depth);\n"
            "    }\n}\n",
            opencl_model_tag(variant->model), variant->flags, variant->choices, v,
            variant->textured, variant->colors, variant->tilt);
    }
    return text;
}

static brdf_status build(struct wavefront *wave, struct brdf_error *error)
{
    const struct world *world = &wave->job->world;
    char options[64];
    snprintf(options, sizeof options, "-DPT_FEATURES=%d", world->settings.features);
    char *text = program_text(world);
    if (!text) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the kernels' text");
    }
    struct opencl_materials materials = {0};
    for (int v = 0; v < world->settings.variant_count - 1; ++v) {
        if (!world->variants[v].through) {
            opencl_materials_add(&materials, world->variants[v].model, world->variants[v].choices);
        }
    }
    brdf_status status = opencl_build(wave->device, wave->device->lanes, &materials, text,
                                      "wavefront", options, &wave->program, error);
    free(text);
    return status;
}

static brdf_status make_buffers(struct wavefront *wave, struct brdf_error *error)
{
    struct brdfcl_device *device = wave->device;
    const struct world *world = &wave->job->world;
    size_t film = (size_t)wave->job->pixels * PT_FILM_WORDS * sizeof(float);
    brdf_status status = opencl_buffer_over(device, &world->settings, sizeof world->settings,
                                            &wave->settings, error);
    if (status == BRDF_OK) {
        status = opencl_buffer_over(device, world->scene, world->scene_words * sizeof(float),
                                    &wave->scene, error);
    }
    if (status == BRDF_OK) {
        status = opencl_buffer_over(device, world->tables, world->table_words * sizeof(float),
                                    &wave->tables, error);
    }
    if (status == BRDF_OK) {
        status = opencl_buffer(device, world->state_words * sizeof(float), &wave->state, error);
    }
    if (status == BRDF_OK) {
        status = opencl_buffer(device, film, &wave->film, error);
    }
    if (status == BRDF_OK) {
        status = opencl_check(clEnqueueWriteBuffer(device->queue, wave->film, CL_TRUE, 0, film,
                                                   wave->job->film, 0, NULL, NULL),
                              "clEnqueueWriteBuffer", error);
    }
    if (status == BRDF_OK) {
        const int counters[PT_COUNTERS] = {0};
        size_t at = (size_t)world->settings.queues * sizeof(float);
        status = opencl_check(clEnqueueWriteBuffer(device->queue, wave->state, CL_TRUE, at,
                                                   sizeof counters, counters, 0, NULL, NULL),
                              "clEnqueueWriteBuffer", error);
    }
    if (status == BRDF_OK) {
        int first[PT_MAX_VARIANTS];
        world_variant_first(world, device->lanes, first);
        size_t at = ((size_t)world->settings.queues + (size_t)world->settings.variant_first) *
                    sizeof(float);
        status = opencl_check(clEnqueueWriteBuffer(device->queue, wave->state, CL_TRUE, at,
                                                   sizeof first, first, 0, NULL, NULL),
                              "clEnqueueWriteBuffer", error);
    }
    return status;
}

static brdf_status make_stage(struct wavefront *wave, int stage, const char *name, size_t items,
                              size_t group, struct brdf_error *error)
{
    struct launch *launch = &wave->stages[stage];
    cl_int result;
    launch->kernel = clCreateKernel(wave->program, name, &result);
    launch->items = (items + group - 1) / group * group;
    launch->group = group;
    if (result == CL_SUCCESS) {
        const cl_mem arguments[4] = {wave->settings, wave->scene, wave->tables, wave->state};
        for (cl_uint i = 0; i < 4 && result == CL_SUCCESS; ++i) {
            result = clSetKernelArg(launch->kernel, i, sizeof(cl_mem), &arguments[i]);
        }
    }
    if (result == CL_SUCCESS && stage == STAGE_FILM) {
        result = clSetKernelArg(launch->kernel, 6, sizeof(cl_mem), &wave->film);
    }
    return opencl_check(result, name, error);
}

static brdf_status make_stages(struct wavefront *wave, struct brdf_error *error)
{
    const struct world *world = &wave->job->world;
    const struct pt_settings *settings = &world->settings;
    size_t lanes = (size_t)wave->device->lanes;
    size_t pool = (size_t)settings->pool;
    size_t packets = (pool + lanes - 1) / lanes;
    int hierarchy = (settings->features & PT_HAS_BVH) != 0;
    size_t group = hierarchy ? GROUP_RAYS : GROUP_PACKETS;
    size_t rays = hierarchy ? pool : packets;
    const struct {
        int stage;
        const char *name;
        size_t items;
        size_t group;
    } list[] = {
        {STAGE_BEGIN, "begin", 1, 1},
        {STAGE_GENERATE, "generate", packets, GROUP_PACKETS},
        {STAGE_EXTEND, hierarchy ? "extend_rays" : "extend_packets", rays, group},
        {STAGE_SORT, "sort", (size_t)world->sort_blocks, 1},
        {STAGE_CONNECT, hierarchy ? "connect_rays" : "connect_packets", rays, group},
        {STAGE_FILM, "film", pool, GROUP_PIXELS},
    };
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < sizeof list / sizeof list[0] && status == BRDF_OK; ++i) {
        status = make_stage(wave, list[i].stage, list[i].name, list[i].items, list[i].group, error);
    }
    if (status == BRDF_OK && (settings->features & PT_HAS_FORKS)) {
        status = make_stage(wave, STAGE_RESOLVE, "resolve", packets, GROUP_PACKETS, error);
    }
    for (int v = 0; v < settings->variant_count && status == BRDF_OK; ++v) {
        char name[32];
        snprintf(name, sizeof name, "shade_%d", v);
        int missed = v == settings->variant_count - 1;
        size_t items = packets + (size_t)(world->sort_blocks * world->variants[v].surfaces);
        status = make_stage(wave, STAGE_SHADE + v, missed ? "shade_missed" : name, items,
                            GROUP_PACKETS, error);
    }
    return status;
}

cl_int wavefront_run(struct wavefront *wave, int stage, const struct pt_pass *pass, int depth)
{
    const struct launch *launch = &wave->stages[stage];
    cl_int result = clSetKernelArg(launch->kernel, 4, sizeof *pass, pass);
    if (result == CL_SUCCESS) {
        result = clSetKernelArg(launch->kernel, 5, sizeof depth, &depth);
    }
    if (result == CL_SUCCESS) {
        result = clEnqueueNDRangeKernel(wave->device->queue, launch->kernel, 1, NULL,
                                        &launch->items, &launch->group, 0, NULL, NULL);
    }
    return result;
}

/* Every kernel once with nothing to do: devices compile for a launch what they have not yet. */
static brdf_status warm_up(struct wavefront *wave, struct brdf_error *error)
{
    struct pt_pass nothing;
    memset(&nothing, 0, sizeof nothing);
    cl_int result = CL_SUCCESS;
    for (int stage = 0; stage < STAGE_COUNT && result == CL_SUCCESS; ++stage) {
        if (wave->stages[stage].kernel) {
            result = wavefront_run(wave, stage, &nothing, 0);
        }
    }
    if (result == CL_SUCCESS) {
        result = clFinish(wave->device->queue);
    }
    return opencl_check(result, "compiling the path tracer's kernels", error);
}

brdf_status wavefront_create(struct wavefront *wave, struct render_job *job,
                             struct brdf_error *error)
{
    memset(wave, 0, sizeof *wave);
    wave->job = job;
    wave->device = job->options->device;
    brdf_status status = build(wave, error);
    if (status == BRDF_OK) {
        status = make_buffers(wave, error);
    }
    if (status == BRDF_OK) {
        status = make_stages(wave, error);
    }
    return status == BRDF_OK ? warm_up(wave, error) : status;
}

void wavefront_release(struct wavefront *wave)
{
    clFinish(wave->device->queue);
    for (int stage = 0; stage < STAGE_COUNT; ++stage) {
        if (wave->stages[stage].kernel) {
            clReleaseKernel(wave->stages[stage].kernel);
        }
    }
    cl_mem buffers[] = {wave->settings, wave->scene, wave->tables, wave->state, wave->film};
    for (size_t i = 0; i < sizeof buffers / sizeof buffers[0]; ++i) {
        if (buffers[i]) {
            clReleaseMemObject(buffers[i]);
        }
    }
    if (wave->program) {
        clReleaseProgram(wave->program);
    }
}
