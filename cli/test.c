/* test.c - brdfcl test: is a material what it says it is? */
#include "test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/material.h>

#include "brdflab/open.h"
#include "commands.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Test a material: values over random inputs, half of them at some limit (grazing, equal, "
    "opposite\n"
    "directions, random numbers of 0 and just below 1), and from each of several directions its "
    "energy,\n"
    "the mass of its density, and whether its samples have that density (chi-square). For each "
    "test what\n"
    "was measured, the limit, and where it was the worst; \"open\" is what could not be told, "
    "\"note\"\n"
    "what is beyond its limit as the data or the parameters ask for it. Exit status 1 if a test "
    "fails.\n"
    "With --all the cases of every model, or of the models named: initial and "
    "random\n"
    "parameters in every variant; chi-square is then judged at 0.01 over all cases of all models.";

void test_note(struct test_run *run, const struct lab_finding *finding)
{
    struct json *json = &run->json;
    run->failed += finding->verdict == LAB_FAIL;
    run->open += finding->verdict == LAB_OPEN;
    run->passed += finding->verdict == LAB_PASS;
    run->noted += finding->verdict == LAB_NOTE;
    json_object(json, NULL);
    json_text(json, "test", lab_test_name(finding->test));
    json_real(json, "theta", finding->angle);
    json_real(json, "measured", finding->measured);
    json_real(json, finding->at_least ? "at_least" : "at_most", finding->limit);
    json_text(json, "verdict", lab_verdict_name(finding->verdict));
    json_text(json, "detail", finding->detail);
    json_text(json, "where", finding->where);
    json_object_end(json);
}

static void report(const struct lab_finding *finding, void *data)
{
    struct test_run *run = data;
    char angle[16] = "";
    char measured[32] = "";
    char limit[32] = "";
    test_note(run, finding);
    if (!run->is_printing) {
        return;
    }
    if (!isnan(finding->angle)) {
        snprintf(angle, sizeof angle, "%.0f", finding->angle);
    }
    if (finding->verdict != LAB_OPEN && finding->verdict != LAB_NONE) {
        snprintf(measured, sizeof measured, "%.4g", finding->measured);
        snprintf(limit, sizeof limit, "%s %.4g", finding->at_least ? ">=" : "<=", finding->limit);
    }
    printf("%-23s %5s  %10s  %-13s  %-4s  %s\n", lab_test_name(finding->test), angle, measured,
           limit, lab_verdict_name(finding->verdict), finding->detail);
    if (finding->verdict == LAB_FAIL && finding->where[0]) {
        printf("    worst at %s\n", finding->where);
    }
    fflush(stdout);
}

brdf_status test_material(struct test_run *run, const char *description, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf;
    brdf_status status = lab_open(description, &bsdf, NULL, error);
    if (status) {
        return status;
    }
    json_text(&run->json, "material", description);
    json_array(&run->json, "findings");
    if (run->is_printing) {
        printf("%-23s %5s  %10s  %-13s\n", "test", "angle", "measured", "limit");
    }
    status = lab_trial_run(&run->trial, bsdf, report, run, error);
    json_array_end(&run->json);
    brdf_bsdf_destroy(bsdf);
    return status;
}

static brdf_status test_all(struct test_run *run, int all, const struct texts *arguments,
                            struct brdf_error *error)
{
    struct json *json = &run->json;
    json_object(json, NULL);
    json_int(json, "seed", (long long)run->trial.seed);
    json_int(json, "calls", (long long)run->trial.calls);
    json_int(json, "samples", (long long)run->trial.samples);
    brdf_status status =
        all ? test_models(run, arguments, error) : test_material(run, arguments->item[0], error);
    if (!status) {
        json_int(json, "passed", (long long)run->passed);
        json_int(json, "failed", (long long)run->failed);
        json_int(json, "open", (long long)run->open);
        json_int(json, "noted", (long long)run->noted);
        json_object_end(json);
        status = run->json_path ? json_write(json, run->json_path, error) : BRDF_OK;
    }
    if (!status && run->is_printing) {
        printf("%zu passed, %zu failed, %zu open, %zu noted\n", run->passed, run->failed, run->open,
               run->noted);
    }
    return status;
}

int command_test(int argc, char **argv)
{
    struct test_run run;
    memset(&run, 0, sizeof run);
    int all = 0, seed = 0, samples = 1000000, calls = 1000000;
    const struct option options[] = {
        {"samples", 0, OPTION_INT, &samples, "N", 10000, 1 << 30,
         "of a chi-square test; 1000000 if not given"},
        {"calls", 0, OPTION_INT, &calls, "N", 1000, 1 << 30,
         "random inputs for tests of values (--all: of a model); 1000000 if not given"},
        {"seed", 0, OPTION_INT, &seed, "N", 0, 2147483647, "another seed, other inputs"},
        {"all", 0, OPTION_ON, &all, NULL, 0, 0, "all cases of the models named, or of every model"},
        {"json", 0, OPTION_TEXT, &run.json_path, "FILE", 0, 0,
         "write everything as JSON; - is standard output, which then has no table"},
    };
    const struct usage usage = {"test",  "MATERIAL | --all [MODEL...]",      summary,
                                options, sizeof options / sizeof options[0], 0,
                                64};
    struct texts arguments;
    int exit_status = options_read(&usage, argc, argv, &arguments);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    if (!all && arguments.count != 1) {
        return say_usage("test needs one material, or --all; usage: brdfcl test %s",
                         usage.arguments);
    }
    run.trial.calls = (size_t)calls;
    run.trial.samples = (size_t)samples;
    run.trial.seed = (unsigned)seed;
    run.trial.significance = 0.01;
    run.is_printing = !run.json_path || strcmp(run.json_path, "-") != 0;
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = run.json_path ? text_file_check(run.json_path, &error) : BRDF_OK;
    status = status ? status : test_all(&run, all, &arguments, &error);
    json_free(&run.json);
    if (status) {
        return say_error(&error);
    }
    return run.failed ? EXIT_FAILED : EXIT_DONE;
}
