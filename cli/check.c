/* check.c - brdfcl check: do C and OpenCL give the same bits? */
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/model.h>
#include <brdfcl/check.h>

#include "arrays.h"
#include "brdflab/open.h"
#include "commands.h"
#include "options.h"
#include "say.h"

static const char summary[] =
    "Compare C with OpenCL, bit by bit, at every number of lanes: over random directions, random "
    "numbers\n"
    "and random parameters of each model (all if none is named), or of one material where a "
    "description\n"
    "such as ward:alpha=0.2 or a measured file is given. A model that needs a file and is given "
    "none\n"
    "gets one that is made for it. Exit status 1 if any bit differs.";

static const int all_lanes[] = {1, 4, 8, 16, 32};
enum { LANES = sizeof all_lanes / sizeof all_lanes[0], BATCH = 1 << 20 };

struct check_run {
    int count; /* of calls of each operation */
    unsigned seed;
    const char *device;
    int differs;
};

static void report(const struct brdfcl_check_result *result, void *data)
{
    struct check_run *run = data;
    printf("%-15s %-7s %5d %11zu %9zu %10u\n", result->model, result->operation, result->lanes,
           result->compared, result->differing, result->max_ulp);
    fflush(stdout);
    if (result->differing) {
        run->differs = 1;
        say("%s %s at %d lanes: %s", result->model, result->operation, result->lanes,
            result->first ? result->first : "some bits differ");
    }
}

/* One material: batches of random directions and numbers. */
static brdf_status check_operation(struct check_run *run, const char *name,
                                   const struct brdf_bsdf *bsdf, struct brdfcl_evaluator *evaluator,
                                   struct brdfcl_check_result *result, enum operation operation,
                                   struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    struct arrays arrays;
    for (size_t done = 0; done < (size_t)run->count && !status; done += BATCH) {
        size_t left = (size_t)run->count - done;
        unsigned ulp = 0;
        status = arrays_create(&arrays, left < BATCH ? left : BATCH, run->seed++, error);
        if (!status) {
            arrays_run_c(&arrays, bsdf, operation, 0, arrays.count);
            status = arrays_run_opencl(&arrays, evaluator, operation, error);
        }
        if (!status) {
            result->differing += arrays_compare(&arrays, operation, &ulp);
            result->compared += arrays.count;
            result->max_ulp = ulp > result->max_ulp ? ulp : result->max_ulp;
        }
        arrays_destroy(&arrays);
    }
    result->model = name;
    result->operation = operation_name(operation);
    return status;
}

static brdf_status check_material(struct check_run *run, const char *description,
                                  struct brdfcl_device *device, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    struct brdfcl_evaluator *evaluator = NULL;
    brdf_status status = measured_bsdf_create(description, &bsdf, error);
    if (!status) {
        status = brdfcl_evaluator_create(device, bsdf, &evaluator, error);
    }
    for (int i = 0; i < OPERATION_BOUNCE && !status; ++i) {
        struct brdfcl_check_result result;
        memset(&result, 0, sizeof result);
        result.lanes = brdfcl_device_lanes(device);
        const char *name = brdf_model_info((int)brdf_bsdf_material(bsdf)->model)->name;
        status = check_operation(run, name, bsdf, evaluator, &result, (enum operation)i, error);
        if (!status) {
            report(&result, run);
        }
    }
    brdfcl_evaluator_destroy(evaluator);
    brdf_bsdf_destroy(bsdf);
    return status;
}

/* One model or material at every number of lanes. */
static brdf_status check_all_lanes(struct check_run *run, const char *what,
                                   struct brdf_error *error)
{
    const struct brdf_model_info *model = brdf_model_find(what);
    brdf_status status = BRDF_OK;
    for (int i = 0; i < LANES && !status; ++i) {
        struct brdfcl_device *device = NULL;
        status = brdfcl_device_open(run->device, all_lanes[i], 0, &device, error);
        if (!status && model) {
            status = brdfcl_check_model(device, model->tag, (size_t)run->count, run->seed, report,
                                        run, error);
        } else if (!status) {
            status = check_material(run, what, device, error);
        }
        brdfcl_device_close(device);
    }
    return status;
}

/* Names that are not known are refused before the first minute is spent. */
static brdf_status check_names(const struct texts *names, struct brdf_error *error)
{
    for (int i = 0; i < names->count; ++i) {
        struct brdf_bsdf *bsdf;
        if (brdf_model_find(names->item[i])) {
            continue;
        }
        brdf_status status = measured_bsdf_create(names->item[i], &bsdf, error);
        if (status) {
            return status;
        }
        brdf_bsdf_destroy(bsdf);
    }
    return BRDF_OK;
}

int command_check(int argc, char **argv)
{
    struct check_run run = {100000, 1, NULL, 0};
    int seed = 1;
    const struct option options[] = {
        {"count", 0, OPTION_INT, &run.count, "N", 1, 2147483647,
         "calls of each operation; 100000 if not given"},
        {"device", 0, OPTION_TEXT, &run.device, "D", 0, 0,
         "OpenCL device: its number or a part of its name"},
        {"seed", 0, OPTION_INT, &seed, "N", 0, 2147483647, "another seed, other calls"},
    };
    const struct usage usage = {
        "check", "[MODEL|MATERIAL...]", summary, options, sizeof options / sizeof options[0], 0,
        64};
    struct texts names;
    int exit_status = options_read(&usage, argc, argv, &names);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    run.seed = (unsigned)seed;
    struct brdf_error error = {BRDF_OK, ""};
    if (check_names(&names, &error)) {
        return say_error(&error);
    }
    if (names.count == 0) {
        for (int tag = 0; tag < brdf_model_count() && tag < 64; ++tag) {
            names.item[names.count++] = brdf_model_info(tag)->name;
        }
    }
    printf("%-15s %-7s %5s %11s %9s %10s\n", "model", "operation", "lanes", "compared", "differing",
           "max_ulp");
    for (int i = 0; i < names.count; ++i) {
        if (check_all_lanes(&run, names.item[i], &error)) {
            return say_error(&error);
        }
    }
    return run.differs ? EXIT_FAILED : EXIT_DONE;
}
