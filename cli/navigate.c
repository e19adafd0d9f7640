/* navigate.c - brdfcl navigate: a map of measured materials, and new ones at places of it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <brdf/info.h>

#include "brdflab/complete.h"
#include "brdflab/open.h"
#include "brdflab/place.h"
#include "commands.h"
#include "measured.h"
#include "navigate_list.h"
#include "navigate_print.h"
#include "options.h"
#include "parse.h"
#include "say.h"
#include "stop.h"

static const char summary[] =
    "Make a map of materials (a folder of .binary and .bsdf files, single files, descriptions):\n"
    "principal components in the log-relative mapping, and where each material lies on them. With\n"
    "--at or --trait, make the material at another place of the map and write it as a file.\n"
    "Coordinates and amounts of traits are in standard deviations of the materials.";

struct navigate_run {
    struct navigate_list list;
    const char *from;        /* where to start; NULL: the mean */
    struct measured_out out; /* what to write; no path: print the map */
    struct numbers at;
    struct texts traits;
    int project;
    int components;
    int terminal;
    const char *doing;
    struct lab_basis *basis;
    double *start; /* [components] coordinates of `from` */
    double *step;  /* from there */
};

static int show_progress(size_t done, size_t count, void *data)
{
    const struct navigate_run *run = data;
    if (run->terminal) {
        fprintf(stderr, "\r  %s %zu of %zu ", run->doing, done + 1, count);
    }
    return stop_signal();
}

static void end_progress(const struct navigate_run *run)
{
    if (run->terminal) {
        fprintf(stderr, "\r%40s\r", "");
    }
}

/* "gloss=1.5" */
static brdf_status step_trait(struct navigate_run *run, const char *text, struct brdf_error *error)
{
    const char *names[LAB_TRAITS];
    char name[64];
    double amount;
    size_t length = strcspn(text, "=");
    snprintf(name, sizeof name, "%.*s", (int)(length < 60 ? length : 60), text);
    if (text[length] != '=' || parse_real(text + length + 1, -10.0, 10.0, &amount)) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "\"%s\" is not a trait and an amount from -10 to 10, such as gloss=1.5",
                         text);
    }
    for (int t = 0; t < LAB_TRAITS; ++t) {
        names[t] = lab_trait_name(t);
        if (strcmp(name, names[t]) != 0) {
            continue;
        }
        return lab_basis_step(run->basis, (enum lab_trait)t, amount, run->step)
                   ? BRDF_OK
                   : brdf_fail(error, BRDF_UNSUPPORTED, "%s is the same for all of these materials",
                               name);
    }
    return brdf_fail(error, BRDF_UNKNOWN_NAME,
                     "no trait is called \"%s\"%s; \"brdfcl navigate\" on the materials lists them",
                     name, say_nearest(brdf_name_nearest(name, names, LAB_TRAITS)).text);
}

/* The coordinates of where to start. */
static brdf_status find_start(struct navigate_run *run, struct brdf_error *error)
{
    struct brdf_merl_file file;
    enum lab_format format;
    double residual = 0.0;
    if (!run->from) {
        return BRDF_OK;
    }
    brdf_status status = lab_open_merl(run->from, &file, &format, error);
    if (!status) {
        status = lab_complete_merl(&file, 1, error);
    }
    if (!status) {
        status = lab_basis_project(run->basis, &file, run->start, &residual, error);
    }
    brdf_merl_free(&file);
    if (!status) {
        printf("%s: at", run->from);
        for (int k = 0; k < run->basis->components; ++k) {
            printf(" %.3f", run->start[k]);
        }
        printf(", %.1f %% of its distance from the mean beside the components\n", 100.0 * residual);
    }
    return status;
}

static brdf_status find_step(struct navigate_run *run, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    if (run->at.count > run->basis->components) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "--at has %d coordinates, the map has %d (--components asks for more)",
                         run->at.count, run->basis->components);
    }
    for (int k = 0; k < run->at.count; ++k) {
        run->step[k] = run->at.item[k] - run->start[k];
    }
    for (int i = 0; i < run->traits.count && !status; ++i) {
        status = step_trait(run, run->traits.item[i], error);
    }
    return status;
}

static brdf_status make_place(struct navigate_run *run, struct brdf_error *error)
{
    struct brdf_merl_file file = {0};
    int from_mean = !run->from || run->project;
    double *step = calloc((size_t)run->basis->components, sizeof *step);
    brdf_status status = step ? BRDF_OK : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    for (int k = 0; k < run->basis->components && !status; ++k) {
        step[k] = run->step[k] + (from_mean ? run->start[k] : 0.0);
    }
    if (!status) {
        run->doing = "mixing";
        status =
            lab_place_make(run->basis, (const char *const *)run->list.material,
                           from_mean ? NULL : run->from, step, show_progress, run, &file, error);
        end_progress(run);
    }
    if (!status) {
        status = measured_write(&run->out, &file, error);
    }
    if (!status) {
        navigate_print_place(run->out.path, run->basis, run->start, run->step);
    }
    free(step);
    brdf_merl_free(&file);
    return status;
}

static brdf_status navigate(struct navigate_run *run, struct brdf_error *error)
{
    brdf_status status = run->out.path ? measured_check(&run->out, error) : BRDF_OK;
    stop_install();
    stop_set_phase(STOP_ASKS);
    if (!status) {
        run->doing = "reading";
        status = lab_basis_create((const char *const *)run->list.material, run->list.count,
                                  run->components, show_progress, run, &run->basis, error);
        end_progress(run);
    }
    if (!status) {
        size_t components = (size_t)run->basis->components;
        run->start = calloc(components, sizeof *run->start);
        run->step = calloc(components, sizeof *run->step);
        status = run->start && run->step ? find_start(run, error)
                                         : brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    if (!status) {
        status = find_step(run, error);
    }
    if (!status && run->out.path) {
        status = make_place(run, error);
    } else if (!status && !run->from) {
        navigate_print_map(run->basis, &run->list);
    }
    stop_set_phase(STOP_QUITS);
    return status;
}

static int read_command_line(struct navigate_run *run, int argc, char **argv,
                             struct brdf_error *error)
{
    const char *list = NULL;
    struct texts arguments;
    const struct option options[] = {
        {"list", 0, OPTION_TEXT, &list, "FILE", 0, 0,
         "more materials: a line each, a name and white space may come before it"},
        {"components", 'k', OPTION_INT, &run->components, "K", 1, 100,
         "of the map; 5 if not given"},
        {"from", 0, OPTION_TEXT, &run->from, "MATERIAL", 0, 0,
         "where to start; the mean of all if not given"},
        {"at", 0, OPTION_REALS, &run->at, "Z,...", -100, 100,
         "where to go: coordinates, of the first components"},
        {"trait", 't', OPTION_LIST, &run->traits, "NAME=AMOUNT", 0, 0,
         "go that far: brightness, gloss, sharpness, metallic, saturation, warmth, grazing"},
        {"project", 0, OPTION_ON, &run->project, NULL, 0, 0,
         "leave out of the start what the components do not describe"},
        {"output", 'o', OPTION_TEXT, &run->out.path, "OUT", 0, 0,
         "the file to write; if not given, the map is printed"},
        MEASURED_OUT_OPTIONS(run->out),
    };
    const struct usage usage = {
        "navigate", "FOLDER|MATERIAL...", summary, options, sizeof options / sizeof options[0], 0,
        64};
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (!run->out.path && (run->at.count || run->traits.count || run->project)) {
        return say_usage("--at, --trait and --project make a material: give its file, -o OUT");
    }
    for (int i = 0; i < arguments.count; ++i) {
        if (navigate_list_add(&run->list, arguments.item[i], error)) {
            return say_error(error);
        }
    }
    if (list && navigate_list_read(&run->list, list, error)) {
        return say_error(error);
    }
    if (!run->out.path) {
        return OPTIONS_GO_ON;
    }
    status = measured_out_set(&run->out, run->out.path, &run->from, run->from != NULL);
    return status == OPTIONS_GO_ON
               ? measured_out_set(&run->out, run->out.path, (const char *const *)run->list.material,
                                  run->list.count)
               : status;
}

int command_navigate(int argc, char **argv)
{
    struct navigate_run run = {.components = 5};
    struct brdf_error error = {BRDF_OK, ""};
    int status = read_command_line(&run, argc, argv, &error);
    run.terminal = isatty(2);
    if (status == OPTIONS_GO_ON) {
        status = measured_exit(navigate(&run, &error), &error);
    }
    if (error.status == BRDF_CANCELLED && stop_signal()) {
        status = 128 + stop_signal();
    }
    lab_basis_destroy(run.basis);
    free(run.start);
    free(run.step);
    navigate_list_free(&run.list);
    return status;
}
