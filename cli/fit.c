/* fit.c - brdfcl fit: the parameters of a model that bring it nearest to a material. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include <brdf/info.h>
#include <brdf/model.h>

#include "brdflab/fit.h"
#include "brdflab/open.h"
#include "brdflab/plot.h"
#include "brdflab/scene_text.h"

#include "commands.h"
#include "file_name.h"
#include "fit_picture.h"
#include "measured.h"
#include "options.h"
#include "say.h"
#include "stop.h"

static const char summary[] =
    "Find the parameters of a model that bring it nearest to a measured file (or to any other\n"
    "material), and print the material for a command line and for a scene. What the model's\n"
    "description sets, as in ward:variant=ward, is held; the rest is searched.";

static const char *const metric_names[] = {"cube root of f cos", "log of 1 + f cos", "f cos"};

static int show_progress(const struct lab_fit_progress *state, void *data)
{
    const int *terminal = data;
    if (*terminal) {
        fprintf(stderr, "\r  start %d of %d, error %.6f ", state->start + 1, state->starts,
                state->error);
    }
    return stop_signal();
}

static void print_fit(const struct lab_fit_options *options, const struct lab_fit_result *fit)
{
    char text[2048];
    printf("error      %.6g, the root mean square of the difference in %s\n", fit->error,
           metric_names[options->metric]);
    printf("           over %zu pairs of directions; black would have %.6g\n", fit->samples,
           fit->error_black);
    printf("search     %.0f of %d starts ended within 1 %% of this error, %zu evaluations%s\n",
           fit->agreement * options->starts, options->starts, fit->evaluations,
           fit->agreement * options->starts < 1.5 ? "; more --starts may find a smaller one" : "");
    for (int i = 0; i < fit->part_count; ++i) {
        brdf_bsdf_describe(fit->parts[i], text, sizeof text);
        if (fit->part_count > 1) {
            printf("part       %.6g of %s\n", fit->weights[i], text);
        } else {
            printf("fit        %s\n", text);
        }
    }
    printf("\n");
    lab_scene_text(stdout, (const struct brdf_bsdf *const *)fit->parts, fit->weights,
                   fit->part_count, 0);
}

/* What a plot calls the target: a file without its folder. */
static const char *name_of(const char *what, enum lab_format format)
{
    return format == LAB_FORMAT_NONE ? what : file_name_of(what);
}

static brdf_status run(const char *what, int fill, struct lab_fit_options *options,
                       const char *picture, struct brdf_error *error)
{
    struct brdf_bsdf *target = NULL;
    struct lab_fit_result fit;
    int terminal = isatty(2);
    enum lab_format format = LAB_FORMAT_NONE;
    brdf_status status = picture ? lab_plot_path_check(picture, error) : BRDF_OK;
    if (!status) {
        status = lab_open_filled(what, fill, &target, &format, error);
    }
    if (status) {
        return status;
    }
    options->progress = show_progress;
    options->data = &terminal;
    stop_install();
    stop_set_phase(STOP_ASKS);
    status = lab_fit(target, options, &fit, error);
    stop_set_phase(STOP_QUITS);
    if (terminal) {
        fputs("\r                                        \r", stderr);
    }
    if (!status) {
        print_fit(options, &fit);
    }
    if (!status && picture) {
        status = fit_picture_write(picture, target, name_of(what, format), &fit, error);
    }
    lab_fit_free(&fit);
    brdf_bsdf_destroy(target);
    return status;
}

int command_fit(int argc, char **argv)
{
    struct lab_fit_options fit = lab_fit_defaults(NULL);
    int metric = (int)fit.metric;
    int seed = 0, fill = 1;
    const char *picture = NULL;
    int evaluations = (int)fit.evaluations_max;
    const struct option options[] = {
        {"model", 'm', OPTION_TEXT, &fit.model, "MODEL", 0, 0,
         "what to fit: a model, or a description whose settings are held"},
        {"lobes", 0, OPTION_INT, &fit.lobes, "N", 1, 2, "of that model, blended; 1 if not given"},
        {"diffuse", 0, OPTION_ON, &fit.diffuse, NULL, 0, 0,
         "blend with a diffuse part (for models that have none)"},
        {"metric", 0, OPTION_CHOICE, &metric, "cube-root|log|linear", 0, 0,
         "of the difference in f cos; cube-root if not given"},
        {"free", 0, OPTION_TEXT, &fit.free, "NAMES", 0, 0,
         "search these parameters too, such as specular_reflectance"},
        {"anisotropic", 0, OPTION_ON, &fit.anisotropic, NULL, 0, 0,
         "look from all around, and search both roughnesses"},
        {"starts", 0, OPTION_INT, &fit.starts, "N", 1, 1000, "local searches; 8 if not given"},
        {"evaluations", 0, OPTION_INT, &evaluations, "N", 1, 1000000,
         "of the error in each walk of a search, at most; 4000 if not given"},
        {"output", 'o', OPTION_TEXT, &picture, "FILE", 0, 0,
         "plot what was fitted and the fit, as .png or .svg"},
        {"seed", 0, OPTION_INT, &seed, "N", 0, 1e9, "where the starts begin"},
        MEASURED_NO_FILL(&fill),
    };
    const struct usage usage = {
        "fit", "MATERIAL", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    struct brdf_error error = {BRDF_OK, ""};
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (!fit.model) {
        return say_usage("fit needs --model MODEL; \"brdfcl models\" lists them");
    }
    fit.metric = (enum lab_fit_metric)metric;
    fit.seed = (unsigned)seed;
    fit.evaluations_max = (size_t)evaluations;
    if (run(arguments.item[0], fill, &fit, picture, &error)) {
        int signal = error.status == BRDF_CANCELLED ? stop_signal() : 0;
        return signal ? 128 + signal : say_error(&error);
    }
    return EXIT_DONE;
}
