/*
 * sphere_integrate.c - adaptive quadrature over the cells of the sphere.
 */
#include "angle.h"
#include "sphere.h"

#include <math.h>

struct integrand {
    lab_sphere_function *f;
    void *data;
    struct lab_sphere_point *points; /* the pilots */
    double tolerance;
    double error;
};

static brdf_vec3 direction_at(double q, double cosine, double sine)
{
    double radius = 2.0 * sqrt(q * (1.0 - q));
    return brdf_vec3_make((float)(radius * cosine), (float)(radius * sine), (float)(1.0 - 2.0 * q));
}

static double value_at(const struct integrand *integrand, double q, double t)
{
    double phi = 2.0 * pi * t;
    return integrand->f(direction_at(q, cos(phi), sin(phi)), integrand->data);
}

/* An integral, and the largest value that went into it. */
struct part {
    double sum;
    double most;
};

/* Gauss and Legendre's rule of four points in both directions [DLMF, table 3.5.2]. */
static struct part gauss(const struct integrand *integrand, const struct lab_sphere_node *node)
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
    struct part part = {0.0, 0.0};
    for (int i = 0; i < 4; ++i) {
        double q = middle[0] + half[0] * place[i];
        for (int k = 0; k < 4; ++k) {
            double value = integrand->f(direction_at(q, cosine[k], sine[k]), integrand->data);
            part.sum += weight[i] * weight[k] * value;
            part.most = fmax(part.most, value);
        }
    }
    part.sum *= half[0] * half[1] * 4.0 * pi;
    return part;
}

static double refine(struct integrand *integrand, const struct lab_sphere_node *node, double whole,
                     int depth)
{
    struct lab_sphere_node half[2];
    struct lab_sphere_node quarter[4];
    double part[4];
    double sum = 0.0;
    lab_sphere_halve(node, 0, integrand->points, half);
    lab_sphere_halve(&half[0], 1, integrand->points, &quarter[0]);
    lab_sphere_halve(&half[1], 1, integrand->points, &quarter[2]);
    for (int i = 0; i < 4; ++i) {
        part[i] = gauss(integrand, &quarter[i]).sum;
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

/* The largest value at the corners of a node and at the pilots inside. */
static double peak_of(const struct integrand *integrand, const struct lab_sphere_node *node)
{
    double peak = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        double q = corner & 1 ? node->high[0] : node->low[0];
        double t = corner & 2 ? node->high[1] : node->low[1];
        peak = fmax(peak, value_at(integrand, q, t));
    }
    for (size_t i = node->first; i < node->first + node->pilots; ++i) {
        peak = fmax(peak, integrand->points[i].value);
    }
    return peak;
}

/* Sides of this [rad] are not halved. */
#define SMALLEST 1e-7

/* Of quarters: enough for the flank of a peak that the neighbour was halved for, and for what jumps
   as the density of a table does between its bins. */
enum { DEPTH = 6 };

/* The integral over a node, which is halved until there is no peak that the rule cannot see. */
static double approach(struct integrand *integrand, const struct lab_sphere_node *node)
{
    struct part part = gauss(integrand, node);
    double angle[2];
    lab_sphere_extent(node, angle);
    int axis = angle[1] > angle[0];
    if (peak_of(integrand, node) <= 8.0 * part.most || angle[axis] < SMALLEST) {
        return refine(integrand, node, part.sum, DEPTH);
    }
    struct lab_sphere_node half[2];
    lab_sphere_halve(node, axis, integrand->points, half);
    return approach(integrand, &half[0]) + approach(integrand, &half[1]);
}

struct lab_sphere_sum lab_sphere_integrate(struct lab_sphere *sphere, lab_sphere_function *f,
                                           void *data, double tolerance, double give_up)
{
    struct integrand integrand = {f, data, sphere->points, tolerance, 0.0};
    struct lab_sphere_sum sum = {0.0, 0.0};
    for (size_t i = 0; i < sphere->pilots; ++i) {
        struct lab_sphere_point *point = &sphere->points[i];
        point->value = value_at(&integrand, point->at[0], point->at[1]);
    }
    for (size_t i = 0; i < sphere->count && integrand.error <= give_up; ++i) {
        struct lab_sphere_node *node = &sphere->nodes[i];
        if (node->child < 0) {
            node->integral = approach(&integrand, node);
            sum.value += node->integral;
        }
    }
    sum.error = integrand.error;
    return sum;
}
