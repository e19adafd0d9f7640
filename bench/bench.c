/* bench.c - brdfcl bench: scalar C on one thread and on all against OpenCL at each lane count. */
#define _POSIX_C_SOURCE 200809L
#include "bench.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <brdf/info.h>
#include <brdf/material.h>

#include "commands.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Measure C on one thread and on all against OpenCL at each number of lanes: the materials "
    "named (or\n"
    "every model as it is initially), each operation, and whole renders (of scenes/cornell.xml, "
    "where it\n"
    "is found, or of each --scene). All run in turns; medians are printed, in millions a second. "
    "\"ratio\"\n"
    "is OpenCL at the lanes it takes by itself, on all cores, against C on one thread; \"B\" the "
    "bytes that an "
    "evaluation\n"
    "moves, \"of triad\" what part of the measured bandwidth that is. All bits are compared "
    "first.\n"
    "Rates never decide the exit status; bits that differ do. With --variance no time is measured, "
    "but\n"
    "how much noise each material's sampling leaves, beside sampling the cosine.";

static const char cornell[] = "scenes/cornell.xml";
static const int all_lanes[BENCH_LANES] = {1, 4, 8, 16, 32};

static int read_command_line(struct bench *bench, int argc, char **argv)
{
    const struct option options[] = {
        {"json", 0, OPTION_TEXT, &bench->json_path, "FILE", 0, 0,
         "write everything as JSON, each round too; - is standard output"},
        {"quick", 0, OPTION_ON, &bench->quick, NULL, 0, 0, "shorter timings and smaller renders"},
        {"variance", 0, OPTION_ON, &bench->variance, NULL, 0, 0,
         "noise instead of time: relative variance under four lights, --count samples"},
        {"scene", 0, OPTION_LIST, &bench->scenes, "FILE", 0, 0, "render this; several are fine"},
        {"rounds", 0, OPTION_INT, &bench->rounds, "N", 1, BENCH_ROUNDS, "7 if not given"},
        {"count", 0, OPTION_INT, &bench->count, "N", 1024, 1 << 26,
         "evaluations in one run of a kernel; 262144 if not given"},
        {"spp", 0, OPTION_INT, &bench->spp, "N", 1, 1 << 24,
         "samples for each pixel of renders; 16 if not given, quick 4"},
        {"device", 0, OPTION_TEXT, &bench->device_choice, "D", 0, 0,
         "OpenCL device: its number or a part of its name"},
    };
    const struct usage usage = {
        "bench", "[MATERIAL...]", summary, options, sizeof options / sizeof options[0], 0, 64};
    int status = options_read(&usage, argc, argv, &bench->materials);
    bench->seconds = bench->quick ? 0.01 : 0.05;
    bench->rounds = bench->rounds ? bench->rounds : bench->quick ? 5 : 7;
    bench->spp = bench->spp ? bench->spp : bench->quick ? 4 : 16;
    return status;
}

static void add_material(struct bench *bench, const char *model, const char *parameter,
                         const char *option)
{
    int index = bench->materials.count;
    if (index < 64) {
        char *name = bench->material_names[index];
        snprintf(name, sizeof bench->material_names[index], "%s%s%s%s%s", model, option ? ":" : "",
                 option ? parameter : "", option ? "=" : "", option ? option : "");
        bench->materials.item[bench->materials.count++] = name;
    }
}

/* Not every option goes with the initial ones of the other choices. */
static int is_material(const char *model, const char *parameter, const char *option)
{
    struct brdf_setting setting = brdf_setting_text(parameter, option);
    struct brdf_bsdf *bsdf;
    int exists = brdf_bsdf_create_from(model, &setting, 1, &bsdf, NULL) == BRDF_OK;
    brdf_bsdf_destroy(bsdf);
    return exists;
}

/* A model as it is initially; where it has options, once with each of the first choice that does
   not need other options as well. */
static void add_model(struct bench *bench, const struct brdf_model_info *model)
{
    const struct brdf_parameter_info *first = model->parameters;
    char option[32];
    if (model->parameter_count == 0 || first->kind != BRDF_KIND_CHOICE) {
        add_material(bench, model->name, NULL, NULL);
        return;
    }
    for (int i = 0; brdf_parameter_item(first, i, option, sizeof option); ++i) {
        if ((model->flags & BRDF_TABULATED) || is_material(model->name, first->name, option)) {
            add_material(bench, model->name, first->name, option);
        }
    }
}

static void choose_subjects(struct bench *bench)
{
    int nothing_named = bench->materials.count == 0 && bench->scenes.count == 0;
    for (int tag = 0; nothing_named && tag < brdf_model_count(); ++tag) {
        add_model(bench, brdf_model_info(tag));
    }
    if (bench->variance) {
        return;
    }
    if (nothing_named && access(cornell, R_OK) == 0) {
        bench->scenes.item[bench->scenes.count++] = cornell;
    } else if (nothing_named) {
        say("%s is not here: no render is measured (name one with --scene)", cornell);
    }
}

/* A model that wants a file, and was not given one, is left out with a word. */
static brdf_status forgive_missing_file(brdf_status status, const struct brdf_error *error)
{
    if (status == BRDF_UNSUPPORTED) {
        say("%s; left out", error->message);
        return BRDF_OK;
    }
    return status;
}

static brdf_status measure_variance(struct bench *bench, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    bench_variance_begin(bench);
    for (int i = 0; i < bench->materials.count && !status; ++i) {
        status = bench_variance(bench, bench->materials.item[i], error);
        status = forgive_missing_file(status, error);
    }
    return status ? status : bench_report_end(bench, error);
}

static brdf_status open_devices(struct bench *bench, struct brdf_error *error)
{
    struct brdfcl_device *device = NULL;
    brdf_status status = brdfcl_device_open(bench->device_choice, 0, 0, &device, error);
    if (status) {
        return status;
    }
    bench->info = brdfcl_device_get_info(device);
    int render_lanes = brdfcl_device_lanes(device);
    int array_lanes = brdfcl_device_array_lanes(device);
    brdfcl_device_close(device);
    for (int i = 0; i < BENCH_LANES && !status; ++i) {
        status =
            brdfcl_device_open(bench->device_choice, all_lanes[i], 0, &bench->device[i], error);
        bench->render_chosen = all_lanes[i] == render_lanes ? 2 + i : bench->render_chosen;
        bench->array_chosen = all_lanes[i] == array_lanes ? 2 + i : bench->array_chosen;
    }
    return status;
}

static brdf_status measure(struct bench *bench, struct brdf_error *error)
{
    brdf_status status = open_devices(bench, error);
    if (status) {
        return status;
    }
    bench->triad_near = bench_triad(bench->threads, (size_t)bench->count * 76 / 12, 9);
    bench->triad_memory = bench_triad(bench->threads, (size_t)1 << 24, 5);
    bench_report_begin(bench);
    if (bench->materials.count) {
        bench_report_heading(bench, "M evaluations/s", BENCH_CONTENDERS);
    }
    for (int i = 0; i < bench->materials.count && !status; ++i) {
        status = bench_material(bench, bench->materials.item[i], error);
        status = forgive_missing_file(status, error);
    }
    if (bench->scenes.count && !status) {
        bench_report_heading(bench, "M samples/s", 2 + BENCH_RENDER_LANES);
    }
    for (int i = 0; i < bench->scenes.count && !status; ++i) {
        status = bench_scene(bench, bench->scenes.item[i], error);
    }
    return status ? status : bench_report_end(bench, error);
}

int command_bench(int argc, char **argv)
{
    struct bench bench;
    memset(&bench, 0, sizeof bench);
    bench.count = 1 << 18;
    int exit_status = read_command_line(&bench, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    bench.threads = cores > 0 && cores < 256 ? (int)cores : 1;
    choose_subjects(&bench);
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = bench.json_path ? text_file_check(bench.json_path, &error) : BRDF_OK;
    if (!status) {
        status = bench.variance ? measure_variance(&bench, &error) : measure(&bench, &error);
    }
    for (int i = 0; i < BENCH_LANES; ++i) {
        brdfcl_device_close(bench.device[i]);
    }
    json_free(&bench.json);
    if (status) {
        return say_error(&error);
    }
    if (bench.differs) {
        say("some results differ from those of C: see the table");
        return EXIT_FAILED;
    }
    return EXIT_DONE;
}
