/*
 * sphere.h - the sphere of directions cut into cells, small where a lobe is narrow.
 *
 * Coordinates are q = (1 - cos theta) / 2, which keeps its precision near the normal, and the
 * azimuth in turns; a cell has the solid angle 4 pi dq dt. 16 x 32 cells to begin with (so the
 * horizon is an edge); a cell with many of the pilot directions is halved, and so on.
 */
#ifndef BRDFLAB_SPHERE_H
#define BRDFLAB_SPHERE_H

#include <stddef.h>

#include <brdf/material.h>
#include <brdf/vec.h>

struct lab_sphere_node {
    double low[2]; /* q, t */
    double high[2];
    int child;       /* the first of two, or -1: this is a cell */
    int pilots;      /* of the directions that it was cut for, those inside */
    double integral; /* of a cell: what lab_sphere_integrate has found */
};

struct lab_sphere {
    struct lab_sphere_node *nodes; /* the first 512 are the roots */
    size_t count;
    size_t capacity;
    size_t pilots;
};

typedef double lab_sphere_function(brdf_vec3 w, void *data);

/* Cut for `count` pilot directions; NULL out of memory. */
struct lab_sphere *lab_sphere_create(const brdf_vec3 *pilot, size_t count);
void lab_sphere_destroy(struct lab_sphere *sphere);

/* The number of the cell that holds w: an index of `nodes`. */
size_t lab_sphere_find(const struct lab_sphere *sphere, brdf_vec3 w);

/* The two halves of a node along an axis, 0 (q) or 1 (t). */
void lab_sphere_halve(const struct lab_sphere_node *node, int axis,
                      struct lab_sphere_node child[2]);

struct lab_sphere_sum {
    double value;
    double error; /* what cells that did not converge may be off by, together */
};

/*
 * Integrate f over each cell, to about `tolerance` of its value, quartering it up to `depth` times;
 * f should be large where the pilot directions are dense. Gives up as soon as the error exceeds
 * `give_up`: f is not resolved.
 */
enum {
    LAB_SPHERE_DEPTH = 3,      /* enough for what is smooth */
    LAB_SPHERE_DEPTH_STEPS = 6 /* for what jumps, as the density of a table does between its bins */
};
struct lab_sphere_sum lab_sphere_integrate(struct lab_sphere *sphere, lab_sphere_function *f,
                                           void *data, int depth, double tolerance, double give_up);

/* The depth that the density of a material needs. */
int lab_sphere_depth(const struct brdf_bsdf *bsdf);

#endif
