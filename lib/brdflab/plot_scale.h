/*
 * plot_scale.h - from values to places between 0 and 1, and the ticks between.
 */
#ifndef BRDFLAB_PLOT_SCALE_H
#define BRDFLAB_PLOT_SCALE_H

#include <stddef.h>

struct plot_scale {
    int logarithmic;
    double low;  /* the value at 0 */
    double high; /* the value at 1; more than low */
    double step; /* of linear ticks */
};

/* From 0 to a little more than `most`, with about `ticks` round ticks. */
struct plot_scale plot_scale_linear(double most, int ticks);

/* Whole powers of ten that hold `most`, and at most so many of them. */
struct plot_scale plot_scale_decades(double least, double most, int decades);

/* Between two numbers, with a tick at each multiple of step. */
struct plot_scale plot_scale_fixed(double low, double high, double step);

/* The place of a value: 0 at low, 1 at high, linear (or linear in the logarithm) beyond; of what
   has no logarithm, -1. */
double plot_scale_at(const struct plot_scale *scale, double value);

/* Tick i; 0 when there are no more of them. */
int plot_scale_tick(const struct plot_scale *scale, int i, double *value);

/* How the value of a tick is written: "0.25", "10^3" (see plot_canvas.h). */
void plot_scale_label(const struct plot_scale *scale, double value, char *text, size_t size);

#endif
