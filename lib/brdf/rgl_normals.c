/*
 * rgl_normals.c - the distribution of normals that explains what a material sends straight back,
 * and its projected area.
 *
 * Dupuy et al., "Extracting Microfacet-based BRDF Parameters from Arbitrary Materials with Power
 * Iterations", 2015, section 3, as Dupuy and Jakob 2018 use it, section 4.1: for a mirror-like
 * microsurface f(w, w) cos = F D(w) / (4 sigma(w)) and sigma(w) is the integral of D over the
 * normals that w sees, so D is an eigenvector of a positive operator.
 */
#include "rgl_normals.h"
#include "angle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ITERATIONS = 8 };

/* The share of normals that are spread evenly: no direction is out of reach of the warp. */
static const double spread = 0.01;

void brdf_rgl_direction(int row, int rows, int column, int columns, double w[3])
{
    double root = (double)column / (columns - 1);
    double theta = 0.5 * pi * root * root;
    double phi = pi * (2.0 * row / (rows - 1) - 1.0);
    w[0] = sin(theta) * cos(phi);
    w[1] = sin(theta) * sin(phi);
    w[2] = cos(theta);
}

/*
 * The solid angle that a node of the grid stands for, by the trapezoidal rule in both places; the
 * rows are taken together if `around`, for an isotropic distribution.
 */
static double node_weight(int row, int rows, int column, int columns, int around)
{
    double root = (double)column / (columns - 1);
    double along = (column == 0 || column == columns - 1 ? 0.5 : 1.0) / (columns - 1);
    double across = (row == 0 || row == rows - 1 ? 0.5 : 1.0) / (rows - 1);
    double ring = sin(0.5 * pi * root * root) * pi * root * along;
    return ring * (around ? 1.0 : 2.0 * pi * across);
}

/* The integral of max(w . m, 0) over the azimuths of m, for two polar angles. */
static double ring_seen(double theta_w, double theta_m)
{
    double constant = cos(theta_w) * cos(theta_m);
    double wave = sin(theta_w) * sin(theta_m);
    if (constant >= wave) {
        return 2.0 * pi * constant;
    }
    double edge = acos(-constant / wave);
    return 2.0 * (constant * edge + wave * sin(edge));
}

static double area_isotropic(const double *d, int column, int columns)
{
    double sum = 0.0;
    double root = (double)column / (columns - 1);
    for (int k = 0; k < columns; ++k) {
        double other = (double)k / (columns - 1);
        sum += d[k] * node_weight(0, 2, k, columns, 1) *
               ring_seen(0.5 * pi * root * root, 0.5 * pi * other * other);
    }
    return sum;
}

static double area_full(const double *d, const double *nodes, const double w[3], int count)
{
    double sum = 0.0;
    for (int k = 0; k < count; ++k) {
        const double *m = nodes + 4 * k;
        double cosine = w[0] * m[0] + w[1] * m[1] + w[2] * m[2];
        sum += cosine > 0.0 ? d[k] * m[3] * cosine : 0.0;
    }
    return sum;
}

/* Directions of all nodes, and their solid angles; malloc'd, NULL where there is no memory. */
static double *nodes_make(const struct brdf_rgl_normals *n)
{
    int count = n->rows * n->columns;
    double *nodes = malloc((size_t)count * 4 * sizeof *nodes);
    for (int k = 0; nodes && k < count; ++k) {
        int row = k / n->columns;
        int column = k % n->columns;
        brdf_rgl_direction(row, n->rows, column, n->columns, nodes + 4 * k);
        nodes[4 * k + 3] = node_weight(row, n->rows, column, n->columns, 0);
    }
    return nodes;
}

double brdf_rgl_normals_area(const struct brdf_rgl_normals *n, const double *d)
{
    double sum = 0.0;
    if (n->isotropic) {
        return area_isotropic(d, 0, n->columns);
    }
    for (int k = 0; k < n->rows * n->columns; ++k) {
        int column = k % n->columns;
        double root = (double)column / (n->columns - 1);
        sum += d[k] * node_weight(k / n->columns, n->rows, column, n->columns, 0) *
               cos(0.5 * pi * root * root);
    }
    return sum;
}

/* sigma of D for every node of the grid, divided by that of the normal, as D is. */
static void areas_find(struct brdf_rgl_normals *n, const double *nodes)
{
    int count = n->rows * n->columns;
    double normal = brdf_rgl_normals_area(n, n->d);
    for (int k = 0; k < count; ++k) {
        n->d[k] /= normal;
    }
    for (int k = 0; k < count; ++k) {
        n->sigma[k] = n->isotropic && k >= n->columns ? n->sigma[k - n->columns]
                      : n->isotropic                  ? area_isotropic(n->d, k, n->columns)
                                     : area_full(n->d, nodes, nodes + 4 * k, count);
    }
}

brdf_status brdf_rgl_normals_find(struct brdf_rgl_normals *n, const double *back,
                                  struct brdf_error *error)
{
    int count = n->rows * n->columns;
    double *nodes = nodes_make(n);
    if (!nodes) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %d normals", count);
    }
    for (int k = 0; k < count; ++k) {
        n->d[k] = 1.0;
    }
    areas_find(n, nodes);
    for (int i = 0; i < ITERATIONS; ++i) {
        for (int k = 0; k < count; ++k) {
            n->d[k] = back[k] * n->sigma[k];
        }
        areas_find(n, nodes);
    }
    free(nodes);
    return BRDF_OK;
}

brdf_status brdf_rgl_normals_end(struct brdf_rgl_normals *n, struct brdf_error *error)
{
    int count = n->rows * n->columns;
    double *nodes = nodes_make(n);
    if (!nodes) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %d normals", count);
    }
    for (int k = 0; k < count; ++k) {
        n->d[k] = (1.0 - spread) * n->d[k] + spread / pi;
    }
    areas_find(n, nodes);
    free(nodes);
    return BRDF_OK;
}
