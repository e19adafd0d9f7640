/*
 * merl_make.c - MERL tables out of functions: the inverse of looking one up.
 */
#include "merl_format.h"

#include <math.h>
#include <string.h>

/* Rusinkiewicz 1998: h at (theta_h, 0), and the difference around it at (theta_d, phi_d). */
int brdf_merl_directions(int theta_h, int theta_d, int phi_d, double wo[3], double wi[3])
{
    const double half_pi = 1.57079632679489661923;
    double root = (theta_h + 0.5) / BRDF_MERL_FILE_THETA_H;
    double h = half_pi * root * root;
    double d = half_pi * (theta_d + 0.5) / BRDF_MERL_FILE_THETA_D;
    double p = 2.0 * half_pi * (phi_d + 0.5) / BRDF_MERL_FILE_PHI_D;
    double across = sin(d) * cos(p);
    double difference[3] = {across * cos(h), sin(d) * sin(p), -across * sin(h)};
    double middle[3] = {cos(d) * sin(h), 0.0, cos(d) * cos(h)};
    for (int i = 0; i < 3; ++i) {
        wi[i] = middle[i] + difference[i];
        wo[i] = middle[i] - difference[i];
    }
    return wo[2] > 0.0 && wi[2] > 0.0;
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
