/*
 * curve.h - a function as a polygon that looks like a curve: points where it bends, few elsewhere.
 */
#ifndef BRDFLAB_CURVE_H
#define BRDFLAB_CURVE_H

#include <stddef.h>

#include <brdf/status.h>

struct lab_point {
    double x;
    double y;
};

struct lab_curve {
    struct lab_point *point; /* malloc'd */
    size_t count;
};

/* Where the curve is at t. */
typedef struct lab_point lab_curve_function(double t, const void *data);

/*
 * Follow a function from t = low to high: from one of `count` knots (ascending; those outside are
 * left out) and of a grid of 1 in 90 to the next, halving each step until its middle is within
 * `tolerance` of the straight line. Points that the lines between others pass as near are then left
 * out. On failure (BRDF_OUT_OF_MEMORY) the curve is empty.
 */
brdf_status lab_curve_trace(lab_curve_function *function, const void *data, double low, double high,
                            const double *knot, int count, double tolerance,
                            struct lab_curve *curve, struct brdf_error *error);

void lab_curve_free(struct lab_curve *curve);

#endif
