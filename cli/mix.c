/* mix.c - brdfcl mix: a material between measured materials. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "brdflab/mix.h"
#include "brdflab/open.h"
#include "commands.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "say.h"

static const char summary[] =
    "Mix materials into a measured file, OUT, which is the last argument. The others are measured "
    "files\n"
    "(.binary, .bsdf) or descriptions such as roughconductor:material=Au,alpha=0.2. In the "
    "log-relative\n"
    "mapping [Nielsen et al. 2015] halfway looks halfway; linear is what specks side by side "
    "reflect.";

#define SPACES "log-relative|linear"

struct mix_run {
    struct texts arguments;
    struct measured_out out;
    size_t count; /* materials */
    int fill;
    struct numbers given;
    double *weight;
    int space;
    struct brdf_merl_file *files;
    enum lab_format *formats;
};

static int read_command_line(struct mix_run *run, int argc, char **argv)
{
    const struct option options[] = {
        {"weight", 'w', OPTION_REALS, &run->given, "W,...", 0, 1e6,
         "of the second material, the third, ..., the first has the rest of 1; or of all, by "
         "their sum"},
        {"space", 0, OPTION_CHOICE, &run->space, SPACES, 0, 0,
         "what is averaged; log-relative if not given"},
        MEASURED_OUT_OPTIONS(run->out),
        MEASURED_NO_FILL(&run->fill),
    };
    const struct usage usage = {"mix",   "MATERIAL MATERIAL... OUT",         summary,
                                options, sizeof options / sizeof options[0], 3,
                                64};
    int status = options_read(&usage, argc, argv, &run->arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    run->count = (size_t)run->arguments.count - 1;
    return measured_out_set(&run->out, run->arguments.item[run->count], run->arguments.item,
                            run->count);
}

/* As many weights as materials; equal ones if none is given. */
static int set_weights(struct mix_run *run)
{
    size_t given = (size_t)run->given.count;
    double sum = 0.0;
    for (size_t k = 0; k < given; ++k) {
        sum += run->given.item[k];
    }
    if (given == 0) {
        for (size_t k = 0; k < run->count; ++k) {
            run->weight[k] = 1.0;
        }
    } else if (given == run->count) {
        memcpy(run->weight, run->given.item, given * sizeof *run->weight);
    } else if (given + 1 == run->count) {
        if (sum > 1.0 + 1e-12) {
            return say_usage("the weights of all materials but the first sum to %.15g, and leave "
                             "it none: give one for each of the %zu",
                             sum, run->count);
        }
        run->weight[0] = sum < 1.0 ? 1.0 - sum : 0.0;
        memcpy(run->weight + 1, run->given.item, given * sizeof *run->weight);
    } else {
        return say_usage("%zu weights for %zu materials: give %zu, or %zu and the first has the "
                         "rest of 1",
                         given, run->count, run->count, run->count - 1);
    }
    return given && given == run->count && sum <= 0.0 ? say_usage("all weights are 0")
                                                      : OPTIONS_GO_ON;
}

static brdf_status mix_and_write(struct mix_run *run, struct brdf_error *error)
{
    struct brdf_merl_file mixture = {0};
    brdf_status status = measured_check(&run->out, error);
    for (size_t k = 0; k < run->count && !status; ++k) {
        status = measured_open(run->arguments.item[k], run->fill, &run->files[k], &run->formats[k],
                               error);
    }
    if (status) {
        return status;
    }
    /* A mixture that is one of its parts is that file, to the last bit of its doubles. */
    int same = lab_mix_same(run->files, run->weight, run->count);
    if (same >= 0 && (int)run->formats[same] == run->out.format && run->fill) {
        return measured_copy(&run->out, run->arguments.item[same], error);
    }
    status = lab_mix_merl(run->files, run->weight, run->count, (enum lab_mix_space)run->space,
                          &mixture, error);
    if (!status) {
        status = measured_write(&run->out, &mixture, error);
    }
    brdf_merl_free(&mixture);
    return status;
}

static void report(const struct mix_run *run)
{
    double sum = 0.0;
    for (size_t k = 0; k < run->count; ++k) {
        sum += run->weight[k];
    }
    printf("%s:", run->out.path);
    for (size_t k = 0; k < run->count; ++k) {
        printf("%s %.6g %s", k ? " +" : "", run->weight[k] / sum, run->arguments.item[k]);
    }
    printf(", %s\n", run->space == LAB_MIX_LINEAR ? "linear" : "log-relative");
}

int command_mix(int argc, char **argv)
{
    struct mix_run run = {.space = LAB_MIX_LOGRELATIVE, .fill = 1};
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = BRDF_OK;
    int exit_status = read_command_line(&run, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    run.weight = calloc(run.count, sizeof *run.weight);
    run.files = calloc(run.count, sizeof *run.files);
    run.formats = calloc(run.count, sizeof *run.formats);
    if (!run.weight || !run.files || !run.formats) {
        status = brdf_fail(&error, BRDF_OUT_OF_MEMORY, "out of memory");
    } else {
        exit_status = set_weights(&run);
    }
    if (!status && exit_status == OPTIONS_GO_ON) {
        status = mix_and_write(&run, &error);
        if (!status) {
            report(&run);
        }
        exit_status = OPTIONS_GO_ON;
    }
    for (size_t k = 0; run.files && k < run.count; ++k) {
        brdf_merl_free(&run.files[k]);
    }
    free(run.files);
    free(run.formats);
    free(run.weight);
    return exit_status == OPTIONS_GO_ON ? measured_exit(status, &error) : exit_status;
}
