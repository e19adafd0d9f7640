/*
 * finding.h - what a statistical test of a material has found.
 */
#ifndef BRDFLAB_FINDING_H
#define BRDFLAB_FINDING_H

#include <stddef.h>

#include <brdf/vec.h>

enum lab_test {
    LAB_TEST_FINITE,
    LAB_TEST_RECIPROCAL,
    LAB_TEST_ISOTROPIC,
    LAB_TEST_WEIGHT,
    LAB_TEST_ENERGY,
    LAB_TEST_ALBEDO,
    LAB_TEST_MASS,
    LAB_TEST_CHI2,
    LAB_TEST_COUNT
};

enum lab_verdict {
    LAB_PASS,
    LAB_FAIL,
    LAB_OPEN, /* applies, but could not be told: `detail` says why */
    LAB_NONE, /* does not apply: `detail` says why */
    LAB_NOTE  /* beyond its limit, but that is no fault of the model: `detail` says whose */
};

struct lab_finding {
    int test;         /* enum lab_test */
    double angle;     /* of wo from the normal [degrees]; NaN if wo was random */
    double measured;  /* NaN for LAB_NONE */
    double limit;     /* that it may not exceed, or not be below */
    int at_least;     /* 1: not below */
    int verdict;      /* enum lab_verdict */
    char detail[192]; /* more about what was measured; may be empty */
    char where[256];  /* for which directions it was the worst; may be empty */
};

/* One for random directions, or for an angle; measured is 0, and the limit that it may not exceed
   as given. */
struct lab_finding lab_finding_make(enum lab_test test, double angle, double limit);

/* The verdict that follows from measured and limit; what is not a number fails. */
void lab_finding_judge(struct lab_finding *finding);

/* The verdict `verdict` with a reason. */
void lab_finding_set(struct lab_finding *finding, enum lab_verdict verdict, const char *reason);

/* Note the worst case: two directions, and the random numbers u (NULL if none were used). */
void lab_finding_note(struct lab_finding *finding, brdf_vec3 wo, brdf_vec3 wi, const brdf_vec3 *u);

/* A few words: "finite and not negative", "chi-square", ... */
const char *lab_test_name(int test);

/* "pass", "FAIL", "open", "-" */
const char *lab_verdict_name(int verdict);

#endif
