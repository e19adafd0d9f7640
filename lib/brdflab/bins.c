/*
 * bins.c - see bins.h.
 */
#include "bins.h"

#include "angle.h"
#include "logrelative.h"

struct lab_bin lab_bin_of(const struct brdf_merl_file *file, size_t number)
{
    size_t theta_d = (size_t)file->theta_d, phi_d = (size_t)file->phi_d;
    struct lab_bin bin = {(int)(number / phi_d / theta_d), (int)(number / phi_d % theta_d),
                          (int)(number % phi_d)};
    return bin;
}

size_t lab_bin_number(const struct brdf_merl_file *file, struct lab_bin bin)
{
    size_t row = (size_t)bin.theta_h * (size_t)file->theta_d + (size_t)bin.theta_d;
    return row * (size_t)file->phi_d + (size_t)bin.phi_d;
}

double lab_bin_theta_h(const struct brdf_merl_file *file, int theta_h)
{
    double root = (theta_h + 0.5) / file->theta_h;
    return 0.5 * pi * root * root;
}

int lab_bin_directions(struct lab_bin bin, double wo[3], double wi[3])
{
    return brdf_merl_directions(bin.theta_h, bin.theta_d, bin.phi_d, wo, wi);
}

int lab_bin_cosine(struct lab_bin bin, double *cosine)
{
    double wo[3], wi[3];
    int above = lab_bin_directions(bin, wo, wi);
    *cosine = lab_logrelative_cosine(wo[2], wi[2]);
    return above;
}
