/*
 * bvh_box.c - boxes around primitives, rounding errors included.
 *
 * What the intersection functions accept is not quite the primitive: they accept what its rounded
 * dual vectors say. The vectors are known here, so the set of points that they accept can be
 * computed in double precision, and what remains are the errors of two dot products.
 */
#include <math.h>

#include "bvh.h"
#include "kernels/intersect.h"

#define LARGEST 1.0e18 /* beyond it products of two lengths overflow */
#define UNITS 9.5e-7   /* 2^-20, 16 units of rounding; 6 to 15 are needed */

struct bvh_box bvh_box_empty(void)
{
    struct bvh_box box;
    for (int i = 0; i < 3; ++i) {
        box.lower[i] = PT_MISS_T;
        box.upper[i] = -PT_MISS_T;
    }
    return box;
}

int bvh_box_is_empty(struct bvh_box box)
{
    return box.lower[0] > box.upper[0];
}

struct bvh_box bvh_box_join(struct bvh_box a, struct bvh_box b)
{
    for (int i = 0; i < 3; ++i) {
        a.lower[i] = b.lower[i] < a.lower[i] ? b.lower[i] : a.lower[i];
        a.upper[i] = b.upper[i] > a.upper[i] ? b.upper[i] : a.upper[i];
    }
    return a;
}

static float float_below(double x)
{
    float f = (float)x;
    return (double)f > x ? nextafterf(f, -INFINITY) : f;
}

static void box_round_out(const double lower[3], const double upper[3], struct bvh_box *box)
{
    for (int i = 0; i < 3; ++i) {
        box->lower[i] = float_below(lower[i]);
        box->upper[i] = -float_below(-upper[i]);
    }
}

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void vector_of(brdf_vec3 v, double out[3])
{
    out[0] = (double)v.x;
    out[1] = (double)v.y;
    out[2] = (double)v.z;
}

static void sphere_box(const float *row, struct bvh_box *box)
{
    double radius = fabs((double)row[PT_RADIUS]) * (1.0 + 4.0 * UNITS);
    double lower[3], upper[3];
    for (int i = 0; i < 3; ++i) {
        lower[i] = (double)row[PT_P + i] - radius;
        upper[i] = (double)row[PT_P + i] + radius;
    }
    box_round_out(lower, upper, box);
}

/* The edges e1 and e2 as the plane's vectors have them: the columns of the inverse of (a x b, a,
 * b). */
static void plane_edges(const struct pt_plane *plane, double e1[3], double e2[3], double growth[2])
{
    double n[3], a[3], b[3], across[3];
    vector_of(plane->n, n);
    vector_of(plane->a, a);
    vector_of(plane->b, b);
    cross(a, b, across);
    double determinant = dot(n, across);
    cross(b, n, e1);
    cross(n, a, e2);
    for (int i = 0; i < 3; ++i) {
        e1[i] /= determinant;
        e2[i] /= determinant;
    }
    double size = sqrt(dot(e1, e1)) + sqrt(dot(e2, e2));
    growth[0] = (double)PT_EDGE + UNITS * (1.0 + size * sqrt(dot(a, a)));
    growth[1] = (double)PT_EDGE + UNITS * (1.0 + size * sqrt(dot(b, b)));
}

static void planar_box(const float *row, int kind, struct bvh_box *box)
{
    const float *p = row + PT_P;
    const float *f1 = row + PT_E1;
    const float *f2 = row + PT_E2;
    struct pt_plane plane =
        pt_plane_make(brdf_vec3_make(p[0], p[1], p[2]), brdf_vec3_make(f1[0], f1[1], f1[2]),
                      brdf_vec3_make(f2[0], f2[1], f2[2]));
    if (plane.n.x == 0.0f && plane.n.y == 0.0f && plane.n.z == 0.0f) {
        *box = bvh_box_empty();
        return;
    }
    double e1[3], e2[3], growth[2], lower[3], upper[3];
    plane_edges(&plane, e1, e2, growth);
    double size = sqrt(dot(e1, e1)) + sqrt(dot(e2, e2));
    for (int i = 0; i < 3; ++i) {
        double least = 0.0, most = 0.0;
        if (kind == PT_DISK) {
            most = sqrt(e1[i] * e1[i] + e2[i] * e2[i]);
            least = -most;
        } else if (kind == PT_RECTANGLE) {
            least = fmin(e1[i], 0.0) + fmin(e2[i], 0.0);
            most = fmax(e1[i], 0.0) + fmax(e2[i], 0.0);
        } else {
            least = fmin(fmin(e1[i], e2[i]), 0.0);
            most = fmax(fmax(e1[i], e2[i]), 0.0);
        }
        double pad = fabs(e1[i]) * growth[0] + fabs(e2[i]) * growth[1] + UNITS * size;
        lower[i] = (double)p[i] + least - pad;
        upper[i] = (double)p[i] + most + pad;
    }
    box_round_out(lower, upper, box);
}

int bvh_primitive_box(const float *row, struct bvh_box *box)
{
    int kind = brdf_bits(row[PT_KIND]);
    int words = kind == PT_SPHERE ? PT_E1 : PT_KIND;
    for (int i = 0; i < words; ++i) {
        if (!(fabs((double)row[i]) <= LARGEST)) {
            return 0;
        }
    }
    if (kind == PT_SPHERE) {
        if (!(fabs((double)row[PT_RADIUS]) <= LARGEST)) {
            return 0;
        }
        sphere_box(row, box);
    } else {
        planar_box(row, kind, box);
    }
    return 1;
}
