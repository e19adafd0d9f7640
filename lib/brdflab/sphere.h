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

#include <brdf/vec.h>

struct lab_sphere_node {
    double low[2]; /* q, t */
    double high[2];
    int child;       /* the first of two, or -1: this is a cell */
    size_t first;    /* of the directions that it was cut for, those inside: where they begin */
    size_t pilots;   /* and how many they are */
    double integral; /* of a cell: what lab_sphere_integrate has found */
};

/* A direction in these coordinates. */
struct lab_sphere_point {
    double at[2]; /* q, t */
    double value; /* of what lab_sphere_integrate integrates */
    size_t cell;  /* that holds it, for lab_sphere_watch */
};

struct lab_sphere {
    struct lab_sphere_node *nodes; /* the first 512 are the roots */
    size_t count;
    size_t capacity;
    struct lab_sphere_point *points; /* the pilot directions, those of a cell together */
    size_t pilots;
};

typedef double lab_sphere_function(brdf_vec3 w, void *data);

/* Cut for `count` pilot directions; NULL out of memory. */
struct lab_sphere *lab_sphere_create(const brdf_vec3 *pilot, size_t count);
void lab_sphere_destroy(struct lab_sphere *sphere);

/*
 * Other directions in the place of the pilots, to find peaks by; the cells stay. 0 out of memory,
 * with the pilots as they were.
 */
int lab_sphere_watch(struct lab_sphere *sphere, const brdf_vec3 *watch, size_t count);

/* The number of the cell that holds w: an index of `nodes`. */
size_t lab_sphere_find(const struct lab_sphere *sphere, brdf_vec3 w);

/* The two halves of a node along an axis, 0 (q) or 1 (t); the pilots inside are put into their
   order. */
void lab_sphere_halve(const struct lab_sphere_node *node, int axis, struct lab_sphere_point *points,
                      struct lab_sphere_node child[2]);

/* Sides of a node as angles on the sphere: along theta and along phi. */
void lab_sphere_extent(const struct lab_sphere_node *node, double angle[2]);

struct lab_sphere_sum {
    double value;
    double error; /* what cells that did not converge may be off by, together */
};

/*
 * Integrate f over each cell, to about `tolerance` of its value, quartering it up to six times. A
 * peak that falls between the places where f is asked for would go unseen; so f is asked for at the
 * pilot directions and at the corners too (the poles are corners, and lobes like to be there), and
 * a cell where it is much larger is halved until what is asked for comes near. Gives up as soon as
 * the error exceeds `give_up`: f is not resolved.
 */
struct lab_sphere_sum lab_sphere_integrate(struct lab_sphere *sphere, lab_sphere_function *f,
                                           void *data, double tolerance, double give_up);

#endif
