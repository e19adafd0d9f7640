/*
 * test.h - brdfcl test: what both of its forms share.
 */
#ifndef BRDFCL_TEST_H
#define BRDFCL_TEST_H

#include "brdflab/trial.h"
#include "json.h"
#include "options.h"

struct test_run {
    struct lab_trial trial;
    const char *json_path;
    int is_printing;
    struct json json;
    size_t failed; /* findings */
    size_t open;
    size_t passed;
    size_t noted;
};

/* Count a finding, and put it into the array of the JSON that is open. */
void test_note(struct test_run *run, const struct lab_finding *finding);

/* One material, a line for each finding. */
brdf_status test_material(struct test_run *run, const char *description, struct brdf_error *error);

/* The cases of models (cases.h), a line for each model, and each failure in full; of all models if
   none is named. */
brdf_status test_models(struct test_run *run, const struct texts *names, struct brdf_error *error);

#endif
