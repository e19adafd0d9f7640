/*
 * polar.h - the polar axes of lobes: the surface is a line, the normal points up.
 */
#ifndef BRDFLAB_POLAR_H
#define BRDFLAB_POLAR_H

#include "plot_canvas.h"
#include "plot_scale.h"

struct polar {
    struct lab_point centre; /* where the light meets the surface [points] */
    double radius;           /* of the rim [points] */
    int full;                /* also below the surface */
    struct plot_scale scale; /* of the radius: low in the centre, high at the rim */
};

/* The axes within a cell. */
struct polar polar_within(struct plot_box cell, int full, struct plot_scale scale);

/* Where a value is, at theta [rad] from the normal, positive to the right; values below the scale
   are in the centre. */
struct lab_point polar_at(const struct polar *polar, double theta, double value);

/* Where a radius is, 1 at the rim. */
struct lab_point polar_at_radius(const struct polar *polar, double theta, double radius);

/* Spokes, rings and their labels; without `values` the radius means nothing and has no rings. */
void polar_draw(struct plot_canvas *canvas, const struct polar *polar, int values,
                const char *label);

#endif
