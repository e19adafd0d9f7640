/*
 * sphere.c - cells of the sphere: cutting, finding.
 */
#include "sphere.h"
#include "angle.h"

#include <math.h>
#include <stdlib.h>

enum {
    ROWS = 16,
    COLUMNS = 32,
    ROOTS = ROWS * COLUMNS,
    PILOTS = 8, /* in a cell, at most */
    CAPACITY = 4096
};

static struct lab_sphere_point point_of(brdf_vec3 w)
{
    double x = (double)w.x;
    double y = (double)w.y;
    double z = (double)w.z;
    struct lab_sphere_point p;
    p.value = 0.0;
    p.cell = 0;
    double q = (x * x + y * y) / (2.0 * (1.0 + fabs(z)));
    q = fmin(q, z == 0.0 ? 0.5 : 0.5 - 1e-12); /* the side is that of z, to the last bit */
    p.at[0] = z < 0.0 ? 1.0 - q : q;
    p.at[1] = atan2(y, x) / (2.0 * pi);
    p.at[1] -= floor(p.at[1]);
    p.at[1] = p.at[1] < 1.0 ? p.at[1] : 0.0;
    return p;
}

void lab_sphere_extent(const struct lab_sphere_node *node, double angle[2])
{
    double middle = 0.5 * (node->low[0] + node->high[0]);
    angle[0] = 2.0 * (asin(sqrt(node->high[0])) - asin(sqrt(node->low[0])));
    angle[1] = 2.0 * pi * (node->high[1] - node->low[1]) * 2.0 * sqrt(middle * (1.0 - middle));
}

void lab_sphere_halve(const struct lab_sphere_node *node, int axis, struct lab_sphere_point *points,
                      struct lab_sphere_node child[2])
{
    double middle = 0.5 * (node->low[axis] + node->high[axis]);
    size_t end = node->first + node->pilots;
    size_t lower = node->first;
    for (size_t i = lower; i < end; ++i) {
        if (points[i].at[axis] < middle) {
            struct lab_sphere_point swap = points[i];
            points[i] = points[lower];
            points[lower++] = swap;
        }
    }
    child[0] = *node;
    child[1] = *node;
    child[0].high[axis] = middle;
    child[1].low[axis] = middle;
    child[0].pilots = lower - node->first;
    child[1].first = lower;
    child[1].pilots = end - lower;
}

/* How much of the node's side along an axis the points take up. */
static double spread(const struct lab_sphere_node *node, int axis,
                     const struct lab_sphere_point *points)
{
    double low = node->high[axis];
    double high = node->low[axis];
    for (size_t i = node->first; i < node->first + node->pilots; ++i) {
        low = fmin(low, points[i].at[axis]);
        high = fmax(high, points[i].at[axis]);
    }
    return (high - low) / (node->high[axis] - node->low[axis]);
}

/* The axis to halve a node along: the longer side, or one of which the points fill but a small
   part, as those of a thin ridge do; -1 for neither. */
static int axis_to_cut(const struct lab_sphere_node *node, const struct lab_sphere_point *points)
{
    double angle[2];
    lab_sphere_extent(node, angle);
    int axis = angle[1] > angle[0];
    if (node->pilots > PILOTS) {
        return angle[axis] > 2e-6 ? axis : -1;
    }
    for (int k = 0; k < 2 && node->pilots >= 2; ++k) {
        if (angle[k] > 2e-6 && spread(node, k, points) < 0.25) {
            return k;
        }
    }
    return -1;
}

/* Room for two more nodes; 0 if there is none. */
static int reserve_two(struct lab_sphere *sphere)
{
    if (sphere->count + 2 <= sphere->capacity) {
        return 1;
    }
    size_t capacity = 2 * sphere->capacity;
    struct lab_sphere_node *nodes = realloc(sphere->nodes, capacity * sizeof *nodes);
    if (!nodes) {
        return 0;
    }
    sphere->nodes = nodes;
    sphere->capacity = capacity;
    return 1;
}

static void cut(struct lab_sphere *sphere, size_t index)
{
    struct lab_sphere_node node = sphere->nodes[index];
    int axis = axis_to_cut(&node, sphere->points);
    if (axis < 0 || !reserve_two(sphere)) {
        return; /* without memory, a cell that is larger than it might be */
    }
    size_t first = sphere->count;
    sphere->nodes[index].child = (int)first;
    lab_sphere_halve(&node, axis, sphere->points, sphere->nodes + first);
    sphere->count += 2;
    cut(sphere, first);
    cut(sphere, first + 1);
}

static size_t root_of(struct lab_sphere_point p)
{
    int row = (int)(p.at[0] * ROWS);
    int column = (int)(p.at[1] * COLUMNS);
    row = row < ROWS ? row : ROWS - 1;
    return (size_t)(row * COLUMNS + column);
}

static int by_root(const void *a, const void *b)
{
    size_t left = root_of(*(const struct lab_sphere_point *)a);
    size_t right = root_of(*(const struct lab_sphere_point *)b);
    return (left > right) - (left < right);
}

/* The roots, each cut for its points, which are in the order of the roots. */
static void cut_roots(struct lab_sphere *sphere)
{
    size_t first = 0;
    for (size_t root = 0; root < ROOTS; ++root) {
        double row = (double)(root / COLUMNS);
        double column = (double)(root % COLUMNS);
        struct lab_sphere_node node = {{row / ROWS, column / COLUMNS},
                                       {(row + 1.0) / ROWS, (column + 1.0) / COLUMNS},
                                       -1,
                                       first,
                                       0,
                                       0.0};
        while (first < sphere->pilots && root_of(sphere->points[first]) == root) {
            ++first;
        }
        node.pilots = first - node.first;
        sphere->nodes[root] = node;
    }
    for (size_t root = 0; root < ROOTS; ++root) {
        cut(sphere, root);
    }
}

struct lab_sphere *lab_sphere_create(const brdf_vec3 *pilot, size_t count)
{
    struct lab_sphere *sphere = calloc(1, sizeof *sphere);
    if (!sphere) {
        return NULL;
    }
    sphere->points = calloc(count + 1, sizeof *sphere->points);
    sphere->nodes = calloc(CAPACITY, sizeof *sphere->nodes);
    if (!sphere->points || !sphere->nodes) {
        lab_sphere_destroy(sphere);
        return NULL;
    }
    sphere->capacity = CAPACITY;
    sphere->count = ROOTS;
    sphere->pilots = count;
    for (size_t i = 0; i < count; ++i) {
        sphere->points[i] = point_of(pilot[i]);
    }
    qsort(sphere->points, count, sizeof *sphere->points, by_root);
    cut_roots(sphere);
    return sphere;
}

void lab_sphere_destroy(struct lab_sphere *sphere)
{
    if (sphere) {
        free(sphere->nodes);
        free(sphere->points);
        free(sphere);
    }
}

static size_t cell_of(const struct lab_sphere *sphere, struct lab_sphere_point p)
{
    size_t index = root_of(p);
    while (sphere->nodes[index].child >= 0) {
        const struct lab_sphere_node *lower = &sphere->nodes[sphere->nodes[index].child];
        int axis = lower->high[0] == sphere->nodes[index].high[0];
        index = (size_t)sphere->nodes[index].child + (p.at[axis] >= lower->high[axis]);
    }
    return index;
}

size_t lab_sphere_find(const struct lab_sphere *sphere, brdf_vec3 w)
{
    return cell_of(sphere, point_of(w));
}

static int by_cell(const void *a, const void *b)
{
    const struct lab_sphere_point *left = a;
    const struct lab_sphere_point *right = b;
    return (left->cell > right->cell) - (left->cell < right->cell);
}

int lab_sphere_watch(struct lab_sphere *sphere, const brdf_vec3 *watch, size_t count)
{
    struct lab_sphere_point *points = calloc(count + 1, sizeof *points);
    if (!points) {
        return 0;
    }
    for (size_t i = 0; i < count; ++i) {
        points[i] = point_of(watch[i]);
        points[i].cell = cell_of(sphere, points[i]);
    }
    qsort(points, count, sizeof *points, by_cell);
    size_t first = 0;
    for (size_t k = 0; k < sphere->count; ++k) {
        struct lab_sphere_node *node = &sphere->nodes[k];
        node->first = first;
        while (first < count && points[first].cell == k) {
            ++first;
        }
        node->pilots = first - node->first;
    }
    free(sphere->points);
    sphere->points = points;
    sphere->pilots = count;
    return 1;
}
