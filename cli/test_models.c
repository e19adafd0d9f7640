/* test_models.c - brdfcl test --all: every case of models, a line for each model. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>

#include "brdflab/cases.h"
#include "say.h"
#include "test.h"

/* What a model's line sums up. */
struct tally {
    struct test_run *run;
    const struct lab_case *one; /* the case at work */
    double worst[LAB_TEST_COUNT];
    size_t views; /* of which there was a chi-square test */
    size_t open;
    size_t failed;
};

/* The worst is the largest, but for p. */
static void keep_worst(struct tally *tally, const struct lab_finding *finding)
{
    double *worst = &tally->worst[finding->test];
    int decided = finding->verdict == LAB_PASS || finding->verdict == LAB_FAIL ||
                  finding->verdict == LAB_NOTE;
    int worse = finding->at_least ? !(finding->measured >= *worst) : !(finding->measured <= *worst);
    if (decided && (isnan(*worst) || worse)) {
        *worst = finding->measured;
    }
}

static void report(const struct lab_finding *finding, void *data)
{
    struct tally *tally = data;
    struct lab_finding noted = *finding;
    keep_worst(tally, finding);
    if (finding->test == LAB_TEST_ENERGY && finding->verdict == LAB_FAIL) {
        /* Random parameters may well ask for more light than there is. */
        lab_finding_set(&noted, LAB_NOTE, "more light than there is, as the parameters may ask");
    }
    tally->views += noted.test == LAB_TEST_CHI2 && noted.verdict != LAB_NONE;
    tally->open += noted.test == LAB_TEST_CHI2 && noted.verdict == LAB_OPEN;
    tally->failed += noted.verdict == LAB_FAIL;
    test_note(tally->run, &noted);
    if (noted.verdict == LAB_FAIL) {
        say("%s\n    %s, %g degrees: %.4g, limit %.4g; %s; %s", tally->one->text,
            lab_test_name(noted.test), noted.angle, noted.measured, noted.limit, noted.detail,
            noted.where);
    }
}

static void print_number(double value, const char *format)
{
    char text[32] = "-";
    if (!isnan(value)) {
        snprintf(text, sizeof text, format, value);
    }
    printf(" %9s", text);
}

static void print_tally(const struct tally *tally, const struct lab_cases *cases)
{
    if (!tally->run->is_printing) {
        return;
    }
    printf("%-17s %5zu %5zu %4zu", cases->model->name, cases->count, tally->views, tally->open);
    print_number(tally->worst[LAB_TEST_CHI2], "%.2g");
    print_number(tally->worst[LAB_TEST_MASS], "%.1e");
    print_number(tally->worst[LAB_TEST_ALBEDO], "%.1e");
    print_number(tally->worst[LAB_TEST_RECIPROCAL], "%.1e");
    print_number(tally->worst[LAB_TEST_WEIGHT], "%.1e");
    print_number(tally->worst[LAB_TEST_ENERGY], "%.5g");
    print_number(tally->worst[LAB_TEST_FINITE], "%.0f");
    printf(" %6zu\n", tally->failed);
    fflush(stdout);
}

static brdf_status test_cases(struct test_run *run, const struct lab_cases *cases,
                              struct brdf_error *error)
{
    struct lab_trial trial = run->trial;
    struct tally tally;
    memset(&tally, 0, sizeof tally);
    tally.run = run;
    for (int i = 0; i < LAB_TEST_COUNT; ++i) {
        tally.worst[i] = (double)NAN;
    }
    trial.calls = run->trial.calls / cases->count + 1;
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < cases->count && !status; ++i) {
        tally.one = &cases->items[i];
        trial.seed = run->trial.seed * 1000 + i;
        json_object(&run->json, NULL);
        json_text(&run->json, "material", cases->items[i].text);
        json_array(&run->json, "findings");
        status = lab_trial_run(&trial, &cases->items[i].bsdf, report, &tally, error);
        json_array_end(&run->json);
        json_object_end(&run->json);
    }
    print_tally(&tally, cases);
    return status;
}

static brdf_status test_model(struct test_run *run, const struct brdf_model_info *model,
                              struct brdf_error *error)
{
    struct lab_cases cases;
    brdf_status status = lab_cases_create(model, &cases, error);
    if (status == BRDF_UNSUPPORTED) { /* a measurement that none can be made of */
        say("%s; left out", error->message);
        return BRDF_OK;
    }
    if (!status) {
        status = test_cases(run, &cases, error);
        lab_cases_destroy(&cases);
    }
    return status;
}

/* The models named, or all, as their numbers; how many, or -1 and an error. */
static int choose_models(const struct texts *names, int *tags, struct brdf_error *error)
{
    for (int i = 0; i < names->count; ++i) {
        const struct brdf_model_info *model = brdf_model_find(names->item[i]);
        if (!model) {
            brdf_fail(error, BRDF_UNKNOWN_NAME,
                      "unknown model \"%s\"%s; \"brdfcl models\" lists them", names->item[i],
                      say_nearest(brdf_model_nearest(names->item[i])).text);
            return -1;
        }
        tags[i] = model->tag;
    }
    for (int tag = 0; tag < brdf_model_count() && names->count == 0; ++tag) {
        tags[tag] = tag;
    }
    return names->count ? names->count : brdf_model_count();
}

brdf_status test_models(struct test_run *run, const struct texts *names, struct brdf_error *error)
{
    int tags[256];
    int count = choose_models(names, tags, error);
    brdf_status status = count < 0 ? BRDF_UNKNOWN_NAME : BRDF_OK;
    /* The same for some models as for all: p of a model does not depend on who else is asked. */
    run->trial.comparisons = lab_suite_comparisons();
    json_int(&run->json, "comparisons", (long long)run->trial.comparisons);
    if (!status && run->is_printing) {
        printf("%-17s %5s %5s %4s %9s %9s %9s %9s %9s %9s %9s %6s\n", "model", "cases", "views",
               "open", "least p", "mass", "2 albedos", "recipr.", "weight", "energy", "faults",
               "failed");
    }
    json_array(&run->json, "cases");
    for (int i = 0; i < count && !status; ++i) {
        status = test_model(run, brdf_model_info(tags[i]), error);
    }
    json_array_end(&run->json);
    return status;
}
