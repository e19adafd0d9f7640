/*
 * math_functions.h - the functions of <brdf/math.h> as a table, for the tests of their accuracy and
 * of their bits.
 */
#ifndef MATH_FUNCTIONS_H
#define MATH_FUNCTIONS_H

#include <stddef.h>
#include <stdint.h>

struct math_function {
    const char *name;
    const char *expression; /* of brdf_real a and b, in the dialect */
    float (*ours)(float a, float b);
    double (*reference)(double a, double b);
    double ulp;      /* the bound that the header states */
    float low, high; /* |a| in the domain; 0 belongs to it as well */
    int negative;    /* does -a belong to the domain? */
    int has_b;       /* does b matter? Then both are scattered, not in order */
};

/* Ends with a row whose name is NULL. */
extern const struct math_function math_functions[];

/* Arguments, chosen by number: every call with the same numbers gives the same ones. */
struct math_arguments {
    float a;
    float b;
};

/* Number `index` of `count`: magnitudes spread over the floats of the domain, signs alternating. */
struct math_arguments math_arguments_make(const struct math_function *f, uint32_t index,
                                          uint32_t count);

#endif
