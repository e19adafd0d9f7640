/*
 * support_sphere.c - cells of the sphere: cutting, finding, adaptive quadrature.
 */
#include "support_sphere.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

enum {
    ROWS = 16,
    COLUMNS = 32,
    ROOTS = ROWS * COLUMNS,
    PILOTS = 8, /* in a cell, at most */
    DEPTH = 3   /* of the subdivision of one cell by quadrature */
};

static const double pi = 3.14159265358979323846;

struct point {
    double at[2]; /* q, t */
};

static struct point point_of(brdf_vec3 w)
{
    double x = (double)w.x;
    double y = (double)w.y;
    double z = (double)w.z;
    struct point p;
    double q = (x * x + y * y) / (2.0 * (1.0 + fabs(z)));
    q = fmin(q, z == 0.0 ? 0.5 : 0.5 - 1e-12); /* the side is that of z, to the last bit */
    p.at[0] = z < 0.0 ? 1.0 - q : q;
    p.at[1] = atan2(y, x) / (2.0 * pi);
    p.at[1] -= floor(p.at[1]);
    p.at[1] = p.at[1] < 1.0 ? p.at[1] : 0.0;
    return p;
}

/* Sides of a node as angles on the sphere: along theta and along phi. */
static void extent(const struct sphere_node *node, double angle[2])
{
    double middle = 0.5 * (node->low[0] + node->high[0]);
    angle[0] = 2.0 * (asin(sqrt(node->high[0])) - asin(sqrt(node->low[0])));
    angle[1] = 2.0 * pi * (node->high[1] - node->low[1]) * 2.0 * sqrt(middle * (1.0 - middle));
}

static void halve(const struct sphere_node *node, int axis, struct sphere_node child[2])
{
    double middle = 0.5 * (node->low[axis] + node->high[axis]);
    child[0] = *node;
    child[1] = *node;
    child[0].high[axis] = middle;
    child[1].low[axis] = middle;
}

/* How much of the node's side along an axis the points take up. */
static double spread(const struct sphere_node *node, int axis, const struct point *points,
                     size_t count)
{
    double low = node->high[axis];
    double high = node->low[axis];
    for (size_t i = 0; i < count; ++i) {
        low = fmin(low, points[i].at[axis]);
        high = fmax(high, points[i].at[axis]);
    }
    return (high - low) / (node->high[axis] - node->low[axis]);
}

/* The axis to halve a node along: the longer side, or one of which the points fill but a small
   part, as those of a thin ridge do; -1 for neither. */
static int axis_to_cut(const struct sphere_node *node, const struct point *points, size_t count)
{
    double angle[2];
    extent(node, angle);
    int axis = angle[1] > angle[0];
    if (count > PILOTS) {
        return angle[axis] > 2e-6 ? axis : -1;
    }
    for (int k = 0; k < 2 && count >= 2; ++k) {
        if (angle[k] > 2e-6 && spread(node, k, points, count) < 0.25) {
            return k;
        }
    }
    return -1;
}

static void cut(struct sphere *sphere, size_t index, struct point *points, size_t count)
{
    sphere->nodes[index].pilots = (int)count;
    struct sphere_node node = sphere->nodes[index];
    int axis = axis_to_cut(&node, points, count);
    if (axis < 0) {
        return;
    }
    if (sphere->count + 2 > sphere->capacity) {
        sphere->capacity *= 2;
        sphere->nodes = realloc(sphere->nodes, sphere->capacity * sizeof *sphere->nodes);
        assert_non_null(sphere->nodes);
    }
    struct sphere_node child[2];
    halve(&node, axis, child);
    size_t lower = 0;
    for (size_t i = 0; i < count; ++i) {
        if (points[i].at[axis] < child[1].low[axis]) {
            struct point swap = points[i];
            points[i] = points[lower];
            points[lower++] = swap;
        }
    }
    size_t first = sphere->count;
    sphere->nodes[index].child = (int)first;
    sphere->nodes[first] = child[0];
    sphere->nodes[first + 1] = child[1];
    sphere->count += 2;
    cut(sphere, first, points, lower);
    cut(sphere, first + 1, points + lower, count - lower);
}

static size_t root_of(struct point p)
{
    int row = (int)(p.at[0] * ROWS);
    int column = (int)(p.at[1] * COLUMNS);
    row = row < ROWS ? row : ROWS - 1;
    return (size_t)(row * COLUMNS + column);
}

static int by_root(const void *a, const void *b)
{
    size_t left = root_of(*(const struct point *)a);
    size_t right = root_of(*(const struct point *)b);
    return (left > right) - (left < right);
}

struct sphere *sphere_create(const brdf_vec3 *pilot, size_t count)
{
    struct sphere *sphere = calloc(1, sizeof *sphere);
    struct point *points = calloc(count + 1, sizeof *points);
    assert_non_null(sphere);
    assert_non_null(points);
    sphere->capacity = 4096;
    sphere->count = ROOTS;
    sphere->pilots = count;
    sphere->nodes = calloc(sphere->capacity, sizeof *sphere->nodes);
    assert_non_null(sphere->nodes);
    for (size_t i = 0; i < count; ++i) {
        points[i] = point_of(pilot[i]);
    }
    qsort(points, count, sizeof *points, by_root);
    size_t first = 0;
    for (size_t root = 0; root < ROOTS; ++root) {
        double row = (double)(root / COLUMNS);
        double column = (double)(root % COLUMNS);
        struct sphere_node node = {{row / ROWS, column / COLUMNS},
                                   {(row + 1.0) / ROWS, (column + 1.0) / COLUMNS},
                                   -1,
                                   0,
                                   0.0};
        size_t end = first;
        while (end < count && root_of(points[end]) == root) {
            ++end;
        }
        sphere->nodes[root] = node;
        cut(sphere, root, points + first, end - first);
        first = end;
    }
    free(points);
    return sphere;
}

void sphere_destroy(struct sphere *sphere)
{
    free(sphere->nodes);
    free(sphere);
}

size_t sphere_find(const struct sphere *sphere, brdf_vec3 w)
{
    struct point p = point_of(w);
    size_t index = root_of(p);
    while (sphere->nodes[index].child >= 0) {
        const struct sphere_node *lower = &sphere->nodes[sphere->nodes[index].child];
        int axis = lower->high[0] == sphere->nodes[index].high[0];
        index = (size_t)sphere->nodes[index].child + (p.at[axis] >= lower->high[axis]);
    }
    return index;
}

struct integrand {
    sphere_function *f;
    void *data;
    double tolerance;
    double error;
};

/* Gauss and Legendre's rule of four points in both directions [DLMF, table 3.5.2]. */
static double gauss(const struct integrand *integrand, const struct sphere_node *node)
{
    static const double place[4] = {-0.861136311594052575, -0.339981043584856265,
                                    0.339981043584856265, 0.861136311594052575};
    static const double weight[4] = {0.347854845137453857, 0.652145154862546143,
                                     0.652145154862546143, 0.347854845137453857};
    double half[2];
    double middle[2];
    double cosine[4];
    double sine[4];
    for (int axis = 0; axis < 2; ++axis) {
        half[axis] = 0.5 * (node->high[axis] - node->low[axis]);
        middle[axis] = 0.5 * (node->high[axis] + node->low[axis]);
    }
    for (int k = 0; k < 4; ++k) {
        double phi = 2.0 * pi * (middle[1] + half[1] * place[k]);
        cosine[k] = cos(phi);
        sine[k] = sin(phi);
    }
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        double q = middle[0] + half[0] * place[i];
        double radius = 2.0 * sqrt(q * (1.0 - q));
        for (int k = 0; k < 4; ++k) {
            brdf_vec3 w = brdf_vec3_make((float)(radius * cosine[k]), (float)(radius * sine[k]),
                                         (float)(1.0 - 2.0 * q));
            sum += weight[i] * weight[k] * integrand->f(w, integrand->data);
        }
    }
    return sum * half[0] * half[1] * 4.0 * pi;
}

static double refine(struct integrand *integrand, const struct sphere_node *node, double whole,
                     int depth)
{
    struct sphere_node half[2];
    struct sphere_node quarter[4];
    double part[4];
    double sum = 0.0;
    halve(node, 0, half);
    halve(&half[0], 1, &quarter[0]);
    halve(&half[1], 1, &quarter[2]);
    for (int i = 0; i < 4; ++i) {
        part[i] = gauss(integrand, &quarter[i]);
        sum += part[i];
    }
    double error = fabs(sum - whole);
    if (error <= integrand->tolerance * fabs(sum) + 1e-8) {
        return sum;
    }
    if (depth == 0) {
        integrand->error += error;
        return sum;
    }
    sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        sum += refine(integrand, &quarter[i], part[i], depth - 1);
    }
    return sum;
}

/* The node cut into 32 x 32 parts, whatever they seem to hold. */
static double search(struct integrand *integrand, const struct sphere_node *node)
{
    double sum = 0.0;
    struct sphere_node part = *node;
    double side[2] = {(node->high[0] - node->low[0]) / 32, (node->high[1] - node->low[1]) / 32};
    for (int i = 0; i < 32; ++i) {
        for (int k = 0; k < 32; ++k) {
            part.low[0] = node->low[0] + i * side[0];
            part.low[1] = node->low[1] + k * side[1];
            part.high[0] = part.low[0] + side[0];
            part.high[1] = part.low[1] + side[1];
            sum += gauss(integrand, &part);
        }
    }
    return sum;
}

struct sphere_sum sphere_integrate(struct sphere *sphere, sphere_function *f, void *data,
                                   double tolerance, double give_up)
{
    struct integrand integrand = {f, data, tolerance, 0.0};
    struct sphere_sum sum = {0.0, 0.0};
    for (size_t i = 0; i < sphere->count && integrand.error <= give_up; ++i) {
        struct sphere_node *node = &sphere->nodes[i];
        if (node->child < 0) {
            node->integral = refine(&integrand, node, gauss(&integrand, node), DEPTH);
            sum.value += node->integral;
        }
    }
    /* Directions where there seems to be nothing: a ridge that fell between the nodes? */
    double share = sum.value / ((double)sphere->pilots + 1.0);
    for (size_t i = 0; i < sphere->count && integrand.error <= give_up; ++i) {
        struct sphere_node *node = &sphere->nodes[i];
        if (node->child < 0 && node->integral < 0.05 * share * node->pilots) {
            double found = search(&integrand, node);
            integrand.error += fabs(found - node->integral);
            sum.value += found - node->integral;
            node->integral = found;
        }
    }
    sum.error = integrand.error;
    return sum;
}
