/*
 * scene_matrix.c - affine maps: double[16], row-major, last row 0 0 0 1.
 */
#include "scene_loader.h"

#include <math.h>
#include <string.h>

void scene_matrix_identity(double m[16])
{
    memset(m, 0, 16 * sizeof *m);
    m[0] = 1.0;
    m[5] = 1.0;
    m[10] = 1.0;
    m[15] = 1.0;
}

void scene_matrix_multiply(const double a[16], const double b[16], double product[16])
{
    double c[16];
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            c[4 * i + j] = a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] +
                           a[4 * i + 3] * b[12 + j];
        }
    }
    memcpy(product, c, sizeof c);
}

void scene_matrix_vector(const double m[16], const double v[3], double out[3])
{
    for (int i = 0; i < 3; ++i) {
        out[i] = m[4 * i] * v[0] + m[4 * i + 1] * v[1] + m[4 * i + 2] * v[2];
    }
}

void scene_matrix_point(const double m[16], const double p[3], double out[3])
{
    scene_matrix_vector(m, p, out);
    for (int i = 0; i < 3; ++i) {
        out[i] += m[4 * i + 3];
    }
}

/* Cofactors of the upper 3 x 3: the determinant times its inverse transposed. */
static void matrix_cofactors(const double m[16], double c[9])
{
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            int i1 = (i + 1) % 3;
            int i2 = (i + 2) % 3;
            int j1 = (j + 1) % 3;
            int j2 = (j + 2) % 3;
            c[3 * i + j] = m[4 * i1 + j1] * m[4 * i2 + j2] - m[4 * i1 + j2] * m[4 * i2 + j1];
        }
    }
}

void scene_matrix_inverse(const double m[16], double inverse[16])
{
    double c[9];
    double out[16];
    matrix_cofactors(m, c);
    double determinant = m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
    scene_matrix_identity(out);
    for (int i = 0; i < 3; ++i) {
        out[4 * i + 3] = 0.0;
        for (int j = 0; j < 3; ++j) {
            out[4 * i + j] = c[3 * j + i] / determinant;
            out[4 * i + 3] -= out[4 * i + j] * m[4 * j + 3];
        }
    }
    memcpy(inverse, out, sizeof out);
}

double scene_matrix_determinant(const double m[16])
{
    double c[9];
    matrix_cofactors(m, c);
    return m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
}

/* Normals go with the inverse transposed, so that a mirror does not turn them inside out. */
void scene_matrix_normal(const double m[16], const double n[3], double out[3])
{
    double c[9];
    double sign = scene_matrix_determinant(m) < 0.0 ? -1.0 : 1.0;
    double length = 0.0;
    double v[3];
    matrix_cofactors(m, c);
    for (int i = 0; i < 3; ++i) {
        v[i] = sign * (c[3 * i] * n[0] + c[3 * i + 1] * n[1] + c[3 * i + 2] * n[2]);
        length += v[i] * v[i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; ++i) {
        out[i] = length > 0.0 ? v[i] / length : 0.0;
    }
}

int scene_matrix_is_singular(const double m[16])
{
    double volume = 1.0; /* of a box with edges as long as the columns */
    for (int j = 0; j < 3; ++j) {
        volume *= sqrt(m[j] * m[j] + m[4 + j] * m[4 + j] + m[8 + j] * m[8 + j]);
    }
    return !(fabs(scene_matrix_determinant(m)) > 1e-9 * volume);
}

int scene_matrix_is_uniform(const double m[16], double *scale)
{
    double length2 = m[0] * m[0] + m[4] * m[4] + m[8] * m[8];
    int uniform = length2 > 0.0;
    for (int i = 0; i < 3; ++i) {
        for (int j = i; j < 3; ++j) {
            double dot = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
            uniform &= fabs(dot - (i == j ? length2 : 0.0)) <= 1e-5 * length2;
        }
    }
    *scale = sqrt(length2);
    return uniform;
}
