/*
 * albedo.c - albedos by sampling over shifted points.
 */
#include "albedo.h"

#include <math.h>

#include <brdf/warp.h>

#include "lattice.h"

enum { CHANNELS = 6 }; /* reflection, transmission */

/* Adds what a sample carries to reflection or transmission. */
static void add_sample(double sum[CHANNELS], brdf_vec3 wo, struct brdf_sample s)
{
    int through = (s.wi.z < 0.0f) != (wo.z < 0.0f);
    double scale = through ? (double)s.eta * (double)s.eta : 1.0;
    double *to = through ? sum + 3 : sum;
    to[0] += scale * (double)s.weight.r;
    to[1] += scale * (double)s.weight.g;
    to[2] += scale * (double)s.weight.b;
}

/* The means of all shifts, their mean, and the standard error of it. */
static struct lab_albedo summarize(double mean[LAB_ALBEDO_SHIFTS][CHANNELS])
{
    struct lab_albedo albedo = {{0.0}, {0.0}, 0.0};
    for (int channel = 0; channel < CHANNELS; ++channel) {
        double sum = 0.0;
        double squares = 0.0;
        for (int k = 0; k < LAB_ALBEDO_SHIFTS; ++k) {
            sum += mean[k][channel];
        }
        double value = sum / LAB_ALBEDO_SHIFTS;
        for (int k = 0; k < LAB_ALBEDO_SHIFTS; ++k) {
            squares += (mean[k][channel] - value) * (mean[k][channel] - value);
        }
        double error = sqrt(squares / (LAB_ALBEDO_SHIFTS * (LAB_ALBEDO_SHIFTS - 1.0)));
        *(channel < 3 ? &albedo.reflection[channel] : &albedo.transmission[channel - 3]) = value;
        albedo.error = fmax(albedo.error, error);
    }
    return albedo;
}

/* Where light arrives: always the same direction, or cosine-weighted from all of a side. */
struct source {
    int spread;
    brdf_vec3 wo;
    float sign; /* of z, where spread */
};

static struct lab_albedo albedo_of(const struct brdf_bsdf *bsdf, const struct source *source,
                                   size_t samples)
{
    double mean[LAB_ALBEDO_SHIFTS][CHANNELS] = {{0.0}};
    size_t count = samples / LAB_ALBEDO_SHIFTS + (samples % LAB_ALBEDO_SHIFTS != 0);
    for (int k = 0; k < LAB_ALBEDO_SHIFTS; ++k) {
        struct lab_lattice lattice = lab_lattice_make(5, (unsigned)k);
        for (size_t i = 0; i < count; ++i) {
            brdf_vec3 u = lab_lattice_cube(&lattice, i);
            brdf_vec3 wo = source->wo;
            if (source->spread) {
                wo = brdf_warp_cosine(lab_lattice_at(&lattice, i, 3),
                                      lab_lattice_at(&lattice, i, 4));
                wo.z *= source->sign;
            }
            add_sample(mean[k], wo, brdf_sample(bsdf, wo, u));
        }
        for (int channel = 0; channel < CHANNELS; ++channel) {
            mean[k][channel] /= (double)(count ? count : 1);
        }
    }
    return summarize(mean);
}

struct lab_albedo lab_albedo_at(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples)
{
    struct source source = {0, wo, 1.0f};
    return albedo_of(bsdf, &source, samples);
}

struct lab_albedo lab_albedo_average(const struct brdf_bsdf *bsdf, int inside, size_t samples)
{
    struct source source = {1, {0.0f, 0.0f, 0.0f}, inside ? -1.0f : 1.0f};
    return albedo_of(bsdf, &source, samples);
}
