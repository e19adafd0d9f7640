/* scene.c - a whole render in C on one thread and on all, and by OpenCL at each lane count. */
#include <string.h>

#include <brdfcl/render.h>

#include "bench.h"

struct scene_work {
    struct bench *bench;
    struct brdfcl_scene *scene;
    double seconds_build;    /* of the last render */
    unsigned long long hash; /* of its picture */
};

static brdf_status run(void *context, int index, int times, double *seconds,
                       struct brdf_error *error)
{
    struct scene_work *work = context;
    struct brdfcl_render_options options;
    memset(&options, 0, sizeof options);
    options.device = index < 2 ? NULL : work->bench->device[index - 2];
    options.threads = index == 0 ? 1 : 0;
    brdf_status status = BRDF_OK;
    *seconds = 0.0;
    for (int i = 0; i < times && !status; ++i) {
        struct brdfcl_render_result result;
        status = brdfcl_render(work->scene, &options, &result, error);
        if (!status) {
            *seconds += result.seconds_render;
            work->seconds_build = result.seconds_kernel_build;
            work->hash = brdfcl_image_hash(&result.image);
            brdfcl_image_destroy(&result.image);
        }
    }
    return status;
}

/* The picture of every contender against that of C on one thread. */
static brdf_status compare(struct scene_work *work, struct bench_row *row, struct brdf_error *error)
{
    unsigned long long wanted = 0;
    brdf_status status = BRDF_OK;
    for (int i = 0; i < row->contenders && !status; ++i) {
        struct bench_contender *contender = &row->contender[i];
        double seconds;
        status = run(work, i, 1, &seconds, error);
        wanted = i == 0 ? work->hash : wanted;
        contender->seconds_build = work->seconds_build;
        contender->differing = !status && work->hash != wanted;
        contender->lanes = i < 2 ? 0 : brdfcl_device_lanes(work->bench->device[i - 2]);
        contender->threads = i == 0   ? 1
                             : i == 1 ? work->bench->threads
                                      : work->bench->info.compute_units;
        work->bench->differs |= contender->differing > 0;
    }
    return status;
}

brdf_status bench_scene(struct bench *bench, const char *path, struct brdf_error *error)
{
    struct scene_work work;
    struct bench_row row;
    memset(&work, 0, sizeof work);
    memset(&row, 0, sizeof row);
    work.bench = bench;
    row.subject = path;
    row.operation = "render";
    row.contenders = 2 + BENCH_RENDER_LANES;
    row.chosen = bench->render_chosen;
    brdf_status status = brdfcl_scene_load(path, NULL, 0, &work.scene, error);
    status = status ? status : brdfcl_scene_set_spp(work.scene, bench->spp, error);
    status = status ? status : compare(&work, &row, error);
    if (!status) {
        struct brdfcl_scene_info info = brdfcl_scene_get_info(work.scene);
        double samples = (double)info.width * (double)info.height * (double)info.spp;
        status = bench_contest(bench, &row, samples, run, &work, error);
    }
    if (!status) {
        bench_report_row(bench, &row);
    }
    brdfcl_scene_destroy(work.scene);
    return status;
}
