/*
 * sphere_integrate.c - adaptive quadrature over the cells of the sphere.
 */
#include "sphere.h"

#include <math.h>

#include <brdf/model.h>

static const double pi = 3.14159265358979323846;

struct integrand {
    lab_sphere_function *f;
    void *data;
    double tolerance;
    double error;
};

/* Gauss and Legendre's rule of four points in both directions [DLMF, table 3.5.2]. */
static double gauss(const struct integrand *integrand, const struct lab_sphere_node *node)
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

static double refine(struct integrand *integrand, const struct lab_sphere_node *node, double whole,
                     int depth)
{
    struct lab_sphere_node half[2];
    struct lab_sphere_node quarter[4];
    double part[4];
    double sum = 0.0;
    lab_sphere_halve(node, 0, half);
    lab_sphere_halve(&half[0], 1, &quarter[0]);
    lab_sphere_halve(&half[1], 1, &quarter[2]);
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
static double search(struct integrand *integrand, const struct lab_sphere_node *node)
{
    double sum = 0.0;
    struct lab_sphere_node part = *node;
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

struct lab_sphere_sum lab_sphere_integrate(struct lab_sphere *sphere, lab_sphere_function *f,
                                           void *data, int depth, double tolerance, double give_up)
{
    struct integrand integrand = {f, data, tolerance, 0.0};
    struct lab_sphere_sum sum = {0.0, 0.0};
    for (size_t i = 0; i < sphere->count && integrand.error <= give_up; ++i) {
        struct lab_sphere_node *node = &sphere->nodes[i];
        if (node->child < 0) {
            node->integral = refine(&integrand, node, gauss(&integrand, node), depth);
            sum.value += node->integral;
        }
    }
    /* Directions where there seems to be nothing: a ridge that fell between the nodes? */
    double share = sum.value / ((double)sphere->pilots + 1.0);
    for (size_t i = 0; i < sphere->count && integrand.error <= give_up; ++i) {
        struct lab_sphere_node *node = &sphere->nodes[i];
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

int lab_sphere_depth(const struct brdf_bsdf *bsdf)
{
    int jumps = (brdf_bsdf_material(bsdf)->flags & BRDF_TABULATED) != 0;
    return jumps ? LAB_SPHERE_DEPTH_STEPS : LAB_SPHERE_DEPTH;
}
