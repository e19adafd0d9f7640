/*
 * cases.h - the materials that every test of every model is made with.
 *
 * A new model gets all of them without a word here: its cases are its initial parameters and random
 * ones from all over their ranges, as info.h tells them, in every variant. What deserves a case of
 * its own is a line in cases.c.
 */
#ifndef BRDFLAB_CASES_H
#define BRDFLAB_CASES_H

#include <stddef.h>

#include <brdf/info.h>
#include <brdf/material.h>

#include "brdf/bsdf.h"

/* A material to be tested. Evaluate it with brdf_eval(&it->bsdf, ...) and so on. */
struct lab_case {
    char text[1024]; /* what it is, for messages; a description but for a FILE */
    struct brdf_bsdf bsdf;
    int is_made; /* 1: described in words, owns its table; 0: random, shares that of the first */
};

struct lab_cases {
    const struct brdf_model_info *model;
    struct lab_case *items; /* the first has the initial parameters */
    size_t count;
};

/* How many cases a model has. */
size_t lab_cases_count(const struct brdf_model_info *model);

/* How many chi-square tests the cases of all models are together: one for each view of each that
   shows something (density.h). What significance over the whole suite refers to. */
size_t lab_suite_comparisons(void);

/* Make the cases of a model, for the caller to destroy. The errors of brdf_bsdf_create. */
brdf_status lab_cases_create(const struct brdf_model_info *model, struct lab_cases *cases,
                             struct brdf_error *error);
void lab_cases_destroy(struct lab_cases *cases);

#endif
