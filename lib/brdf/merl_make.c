/*
 * merl_make.c - MERL tables out of functions: the inverse of looking one up.
 */
#include "merl_format.h"

#include <math.h>
#include <string.h>

int brdf_merl_directions_at(double theta_h, double phi_h, double theta_d, double phi_d,
                            double wo[3], double wi[3])
{
    double x = sin(theta_d) * cos(phi_d);
    double y = sin(theta_d) * sin(phi_d);
    double z = cos(theta_d);
    for (int side = -1; side <= 1; side += 2) {
        double *w = side > 0 ? wi : wo;
        double tilted = z * sin(theta_h) + side * x * cos(theta_h);
        w[0] = tilted * cos(phi_h) - side * y * sin(phi_h);
        w[1] = tilted * sin(phi_h) + side * y * cos(phi_h);
        w[2] = z * cos(theta_h) - side * x * sin(theta_h);
    }
    return wo[2] > 0.0 && wi[2] > 0.0;
}

int brdf_merl_directions(int theta_h, int theta_d, int phi_d, double wo[3], double wi[3])
{
    const double half_pi = 1.57079632679489661923;
    double root = (theta_h + 0.5) / BRDF_MERL_FILE_THETA_H;
    return brdf_merl_directions_at(half_pi * root * root, 0.0,
                                   half_pi * (theta_d + 0.5) / BRDF_MERL_FILE_THETA_D,
                                   2.0 * half_pi * (phi_d + 0.5) / BRDF_MERL_FILE_PHI_D, wo, wi);
}

brdf_status brdf_merl_create(struct brdf_merl_file *file, struct brdf_error *error)
{
    if (!file) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT, "brdf_merl_create needs a file to fill");
    }
    memset(file, 0, sizeof *file);
    brdf_status status = brdf_merl_reserve(file, &brdf_merl_layout, error);
    if (status == BRDF_OK) {
        for (size_t i = 0; i < file->bins * 3; ++i) {
            file->rgb[i] = -1.0f;
        }
        file->invalid = file->bins;
    }
    return status;
}

brdf_status brdf_merl_make(brdf_merl_function *f, void *data, struct brdf_merl_file *file,
                           struct brdf_error *error)
{
    if (!f || !file) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_merl_make needs a function and a file to fill");
    }
    memset(file, 0, sizeof *file);
    brdf_status status = brdf_merl_reserve(file, &brdf_merl_layout, error);
    if (status != BRDF_OK) {
        return status;
    }
    for (size_t bin = 0; bin < file->bins; ++bin) {
        int phi_d = (int)(bin % (size_t)file->phi_d);
        int theta_d = (int)(bin / (size_t)file->phi_d % (size_t)file->theta_d);
        int theta_h = (int)(bin / (size_t)file->phi_d / (size_t)file->theta_d);
        double wo[3], wi[3], rgb[3] = {-1.0, -1.0, -1.0};
        if (brdf_merl_directions(theta_h, theta_d, phi_d, wo, wi)) {
            f(wo, wi, rgb, data);
        } else {
            ++file->invalid;
        }
        for (int c = 0; c < 3; ++c) {
            file->rgb[3 * bin + (size_t)c] = (float)rgb[c];
        }
    }
    return BRDF_OK;
}
