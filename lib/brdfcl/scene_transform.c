/*
 * scene_transform.c - <transform>: operations in the order of the file, the first applied first.
 */
#include "angle.h"
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <string.h>

static double transform_normalize(double v[3])
{
    double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; ++i) {
        v[i] = length > 0.0 ? v[i] / length : 0.0;
    }
    return length;
}

static void transform_cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static brdf_status transform_translate(const struct scene_loader *loader,
                                       const struct xml_node *node, double m[16])
{
    double v[3];
    brdf_status status = scene_value_vector(loader, node, 0.0, 0, v);
    for (int i = 0; i < 3 && !status; ++i) {
        m[4 * i + 3] = v[i];
    }
    return status;
}

static brdf_status transform_scale(const struct scene_loader *loader, const struct xml_node *node,
                                   double m[16])
{
    double v[3];
    brdf_status status = scene_value_vector(loader, node, 1.0, 0, v);
    for (int i = 0; i < 3 && !status; ++i) {
        m[5 * i] = v[i];
    }
    return status;
}

/* Of degrees; exact where it is 0 or 1, so that quarter turns leave axes on axes. */
static double transform_sine(double degrees)
{
    double turn = fmod(degrees, 360.0);
    if (fmod(turn, 180.0) == 0.0) {
        return 0.0;
    }
    if (fabs(turn) == 90.0 || fabs(turn) == 270.0) {
        return (turn == 90.0) || (turn == -270.0) ? 1.0 : -1.0;
    }
    return sin(turn * pi / 180.0);
}

/* Rodrigues' formula; counter-clockwise when looking against the axis, in degrees. */
static brdf_status transform_rotate(const struct scene_loader *loader, const struct xml_node *node,
                                    double m[16])
{
    double a[3];
    double angle = 0.0;
    double length;
    brdf_status status = scene_value_vector(loader, node, 0.0, 0, a);
    if (!status) {
        status = scene_value_number(loader, node, xml_attribute_get(node, "angle"), &angle);
    }
    if (status) {
        return status;
    }
    length = transform_normalize(a);
    if (!(length > 0.0)) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "the axis of a rotation is zero");
    }
    if (fabs(length - 1.0) > 1e-3) {
        status = scene_note(loader, node,
                            "the axis of a rotation is made a unit vector, which "
                            "Mitsuba 3 does not do");
    }
    double s = transform_sine(angle);
    double c = transform_sine(angle + 90.0);
    for (int i = 0; i < 3; ++i) {
        int j = (i + 1) % 3;
        int k = (i + 2) % 3;
        m[5 * i] = a[i] * a[i] * (1.0 - c) + c;
        m[4 * i + j] = a[i] * a[j] * (1.0 - c) - a[k] * s;
        m[4 * i + k] = a[i] * a[k] * (1.0 - c) + a[j] * s;
    }
    return status;
}

static brdf_status transform_read_three(const struct scene_loader *loader,
                                        const struct xml_node *node, const char *name, double v[3])
{
    int count = 0;
    brdf_status status =
        scene_value_numbers(loader, node, xml_attribute_get(node, name), v, 3, &count);
    if (!status && count != 3) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "\"%s\" has %d numbers, not three", name,
                          count);
    }
    return status;
}

/* A direction across `dir` where the file gives none: the first tangent of Duff et al., "Building
   an Orthonormal Basis, Revisited" (2017), so that the camera stands as it does in Mitsuba. */
static void transform_any_up(const double dir[3], double up[3])
{
    double sign = dir[2] < 0.0 ? -1.0 : 1.0;
    double a = -1.0 / (sign + dir[2]);
    up[0] = 1.0 + sign * dir[0] * dir[0] * a;
    up[1] = sign * dir[0] * dir[1] * a;
    up[2] = -sign * dir[0];
}

static brdf_status transform_lookat(const struct scene_loader *loader, const struct xml_node *node,
                                    double m[16])
{
    double origin[3];
    double dir[3];
    double up[3] = {0.0, 0.0, 0.0};
    double left[3];
    brdf_status status = transform_read_three(loader, node, "origin", origin);
    if (!status) {
        status = transform_read_three(loader, node, "target", dir);
    }
    if (!status && xml_attribute_get(node, "up")) {
        status = transform_read_three(loader, node, "up", up);
    }
    if (status) {
        return status;
    }
    for (int i = 0; i < 3; ++i) {
        dir[i] -= origin[i];
    }
    if (!(transform_normalize(dir) > 0.0)) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "origin and target are the same point");
    }
    if (!(transform_normalize(up) > 0.0)) {
        transform_any_up(dir, up);
    }
    transform_cross(up, dir, left);
    if (!(transform_normalize(left) > 1e-9)) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "up is parallel to the line of sight");
    }
    transform_cross(dir, left, up);
    for (int i = 0; i < 3; ++i) {
        m[4 * i] = left[i];
        m[4 * i + 1] = up[i];
        m[4 * i + 2] = dir[i];
        m[4 * i + 3] = origin[i];
    }
    return BRDF_OK;
}

static brdf_status transform_matrix(const struct scene_loader *loader, const struct xml_node *node,
                                    double m[16])
{
    double v[16];
    int count = 0;
    brdf_status status =
        scene_value_numbers(loader, node, xml_attribute_get(node, "value"), v, 16, &count);
    if (status) {
        return status;
    }
    if (count == 16) {
        memcpy(m, v, sizeof v);
        if (m[12] != 0.0 || m[13] != 0.0 || m[14] != 0.0 || m[15] != 1.0) {
            return scene_fail(loader, node, BRDF_UNSUPPORTED,
                              "the last row of a matrix is 0 0 0 1; projections are not read");
        }
        return BRDF_OK;
    }
    if (count != 9) {
        return scene_fail(loader, node, BRDF_BAD_FILE, "a matrix has 9 or 16 numbers, not %d",
                          count);
    }
    for (int i = 0; i < 9; ++i) {
        m[4 * (i / 3) + i % 3] = v[i];
    }
    return BRDF_OK;
}

brdf_status scene_transform_read(const struct scene_loader *loader, const struct xml_node *node,
                                 double m[16])
{
    static const struct {
        const char *tag;
        brdf_status (*read)(const struct scene_loader *, const struct xml_node *, double *);
    } operations[] = {{"translate", transform_translate},
                      {"scale", transform_scale},
                      {"rotate", transform_rotate},
                      {"lookat", transform_lookat},
                      {"matrix", transform_matrix}};
    brdf_status status = BRDF_OK;
    scene_matrix_identity(m);
    for (const struct xml_node *child = node->child; child && !status; child = child->next) {
        double step[16];
        scene_matrix_identity(step);
        for (size_t i = 0; i < sizeof operations / sizeof operations[0]; ++i) {
            if (strcmp(operations[i].tag, child->tag) == 0) {
                status = operations[i].read(loader, child, step);
            }
        }
        scene_matrix_multiply(step, m, m);
    }
    for (int i = 0; i < 16 && !status; ++i) {
        if (!(fabs(m[i]) <= (double)FLT_MAX)) {
            status = scene_fail(loader, node, BRDF_OUT_OF_RANGE, "the transform overflows");
        }
    }
    return status;
}
