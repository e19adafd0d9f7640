/*
 * support_sphere.h - the sphere of directions cut into cells, small where a lobe is narrow.
 *
 * Coordinates are q = (1 - cos theta) / 2, which keeps its precision near the normal, and the
 * azimuth in turns; a cell has the solid angle 4 pi dq dt. 16 x 32 cells to begin with (so the
 * horizon is an edge); a cell with many of the pilot directions is halved, and so on.
 */
#ifndef SUPPORT_SPHERE_H
#define SUPPORT_SPHERE_H

#include <stddef.h>

#include <brdf/vec.h>

struct sphere_node {
    double low[2]; /* q, t */
    double high[2];
    int child;       /* the first of two, or -1: this is a cell */
    int pilots;      /* of the directions that it was cut for, those inside */
    double integral; /* of a cell: what sphere_integrate has found */
};

struct sphere {
    struct sphere_node *nodes; /* the first 512 are the roots */
    size_t count;
    size_t capacity;
    size_t pilots;
};

typedef double sphere_function(brdf_vec3 w, void *data);

/* Cut for `count` pilot directions. Not NULL; ends the test out of memory. */
struct sphere *sphere_create(const brdf_vec3 *pilot, size_t count);
void sphere_destroy(struct sphere *sphere);

/* The number of the cell that holds w: an index of `nodes`. */
size_t sphere_find(const struct sphere *sphere, brdf_vec3 w);

struct sphere_sum {
    double value;
    double error; /* what cells that did not converge may be off by, together */
};

/*
 * Integrate f over each cell, to about `tolerance` of its value; f should be large where the pilot
 * directions are dense. Gives up as soon as the error exceeds `give_up`: f is not resolved.
 */
struct sphere_sum sphere_integrate(struct sphere *sphere, sphere_function *f, void *data,
                                   double tolerance, double give_up);

#endif
