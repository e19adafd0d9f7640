/*
 * merl_bake.h - analytic materials to bake into MERL tables.
 */
#ifndef TEST_MERL_BAKE_H
#define TEST_MERL_BAKE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/merl.h>

#include "angle.h"

/* A gray Lambertian surface of the albedo at `data`. */
static inline void test_lambert(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    (void)wo;
    (void)wi;
    rgb[0] = rgb[1] = rgb[2] = *(const double *)data / pi;
}

/*
 * A GGX lobe of the width alpha at `data`, with separable Smith masking and Schlick's Fresnel term,
 * over a little blue Lambert: D G F / (4 cos cos) + floor.
 */
static inline void test_glossy(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    double alpha2 = *(const double *)data * *(const double *)data;
    double h[3], length = 0.0, masking = 1.0;
    for (int i = 0; i < 3; ++i) {
        h[i] = wo[i] + wi[i];
        length += h[i] * h[i];
    }
    length = sqrt(length);
    double h_cos = h[2] / length;
    double bottom = h_cos * h_cos * (alpha2 - 1.0) + 1.0;
    double d = alpha2 / (pi * bottom * bottom);
    const double cosines[2] = {wo[2], wi[2]};
    for (int i = 0; i < 2; ++i) {
        double c = cosines[i];
        masking *= 2.0 * c / (c + sqrt(alpha2 + (1.0 - alpha2) * c * c));
    }
    double grazing = pow(1.0 - 0.5 * length, 5.0); /* wo . h is half the length of wo + wi */
    const double normal[3] = {0.9, 0.6, 0.2}, base[3] = {0.0, 0.01, 0.05};
    for (int c = 0; c < 3; ++c) {
        double fresnel = normal[c] + (1.0 - normal[c]) * grazing;
        rgb[c] = d * masking * fresnel / (4.0 * wo[2] * wi[2]) + base[c] / pi;
    }
}

#endif
