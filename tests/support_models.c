/*
 * support_models.c - running checks over the cases of every model.
 */
#include "support_models.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SHOWN_FAILURES = 5 }; /* of a check */

int models_long(void)
{
    const char *value = getenv("BRDFCL_TEST_LONG");
    return value && *value && strcmp(value, "0") != 0;
}

/* The bits of i, mirrored at the point [van der Corput 1935]. */
static double mirrored_bits(size_t i)
{
    double result = 0.0;
    for (double digit = 0.5; i; i >>= 1, digit *= 0.5) {
        result += (i & 1u) ? digit : 0.0;
    }
    return result;
}

/* Hammersley 1960; the third coordinate is Kronecker's sequence of the golden ratio. */
brdf_vec3 models_even_point(size_t i, size_t count)
{
    float x = (float)(((double)i + 0.5) / (double)count);
    float y = (float)mirrored_bits(i);
    double golden = 0.5 + (double)i * 0.61803398874989485;
    float z = (float)(golden - floor(golden));
    return brdf_vec3_make(brdf_min(x, BRDF_ONE_MINUS_ULP), brdf_min(y, BRDF_ONE_MINUS_ULP),
                          brdf_min(z, BRDF_ONE_MINUS_ULP));
}

void models_fail(struct model_cases *cases, const struct lab_case *one, const char *format, ...)
{
    if (cases->failures++ >= SHOWN_FAILURES) {
        return;
    }
    char message[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    print_error("%s\n    %s\n", one->text, message);
}

void models_expect(struct model_cases *cases, const struct lab_case *one,
                   const struct lab_finding *finding)
{
    if (finding->verdict == LAB_FAIL) {
        models_fail(cases, one, "%s (%g degrees): %.6g, limit %.6g; %s; %s",
                    lab_test_name(finding->test), finding->angle, finding->measured, finding->limit,
                    finding->detail, finding->where);
    }
}

void models_verdict(struct model_cases *cases)
{
    if (cases->failures) {
        fail_msg("%s: %zu failures", cases->set.model->name, cases->failures);
    }
}

static int reset(void **state)
{
    struct model_cases *cases = *state;
    cases->failures = 0;
    return 0;
}

static int run_model(const struct brdf_model_info *model, const struct model_check *checks,
                     size_t count)
{
    struct model_cases cases = {.failures = 0};
    struct brdf_error error;
    if (lab_cases_create(model, &cases.set, &error)) {
        print_error("%s\n", error.message);
        return 1;
    }
    struct CMUnitTest *tests = calloc(count, sizeof *tests);
    char(*names)[128] = calloc(count, sizeof *names);
    assert_non_null(tests);
    assert_non_null(names);
    size_t used = 0;
    for (size_t i = 0; i < count; ++i) {
        unsigned wanted = checks[i].needs | checks[i].excludes;
        if ((model->flags & wanted) != checks[i].needs) {
            continue;
        }
        snprintf(names[used], sizeof names[used], "%s: %s", model->name, checks[i].name);
        tests[used].name = names[used];
        tests[used].test_func = checks[i].run;
        tests[used].setup_func = reset;
        tests[used].initial_state = &cases;
        ++used;
    }
    int failures = used ? _cmocka_run_group_tests(model->name, tests, used, NULL, NULL) : 0;
    free(tests);
    free(names);
    lab_cases_destroy(&cases.set);
    return failures;
}

int models_run(const struct model_check *checks, size_t count)
{
    const char *only = getenv("BRDFCL_TEST_MODEL");
    int failures = 0;
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *model = brdf_model_info(tag);
        if (!only || !strcmp(only, model->name)) {
            failures += run_model(model, checks, count);
        }
    }
    return failures;
}
