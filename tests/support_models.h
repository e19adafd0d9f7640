/*
 * support_models.h - every check over every model: cases, and cmocka tests made of both.
 *
 * A new model gets all of this without a word here: brdflab/cases.h makes its cases.
 */
#ifndef SUPPORT_MODELS_H
#define SUPPORT_MODELS_H

#include <stddef.h>

#include <brdf/info.h>
#include <brdf/material.h>

#include "cases.h"
#include "check_cases.h"
#include "finding.h"

struct model_cases {
    struct lab_cases set; /* of one model */
    size_t failures;      /* of the running check */
};

/* A check: a function of a cmocka test whose *state is a struct model_cases. */
struct model_check {
    const char *name;
    void (*run)(void **state);
    unsigned needs;    /* flags of the models that it is for */
    unsigned excludes; /* flags of those that it is not for */
};

/*
 * Run each check over each model, as the test "model: name"; only the models that
 * the environment variable BRDFCL_TEST_MODEL names, if it is set. Returns the number of failures.
 */
int models_run(const struct model_check *checks, size_t count);

/* 1 if the suite has been asked for its long form, with BRDFCL_TEST_LONG=1 in the environment. */
int models_long(void);

/* Note a failure of a case, as printf would; the first few of a check are printed. */
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
void models_fail(struct model_cases *cases, const struct lab_case *one, const char *format, ...);

/* The same for a finding that failed. */
void models_expect(struct model_cases *cases, const struct lab_case *one,
                   const struct lab_finding *finding);

/* The end of a check: fails the test if anything has failed. */
void models_verdict(struct model_cases *cases);

/* Point i of `count` that fill the unit cube evenly. */
brdf_vec3 models_even_point(size_t i, size_t count);

#endif
