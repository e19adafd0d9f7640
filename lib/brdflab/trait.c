/*
 * trait.c - what a person would call a material, as numbers read off its table.
 */
#include <math.h>
#include <stddef.h>

#include "bins.h"
#include "brdf/luminance.h"
#include "trait.h"

static const struct {
    const char *name;
    const char *meaning;
} traits_known[LAB_TRAITS] = {
    {"brightness", "how much light comes back"},
    {"gloss", "how far the highlight stands out from the base"},
    {"sharpness", "how narrow the highlight is"},
    {"metallic", "how much colour the highlight has"},
    {"saturation", "how much colour the base has"},
    {"warmth", "red against blue"},
    {"grazing", "how much more it mirrors at grazing angles"},
};

const char *lab_trait_name(int trait)
{
    return trait >= 0 && trait < LAB_TRAITS ? traits_known[trait].name : NULL;
}

const char *lab_trait_meaning(int trait)
{
    return trait >= 0 && trait < LAB_TRAITS ? traits_known[trait].meaning : NULL;
}

/* Black has no logarithm: less than this [1/sr] counts as this. */
#define DARKEST 1e-5

/* Below the horizon there is no value: the nearest one above stands for it. */
static const float *value_at(const struct brdf_merl_file *file, int theta_h, int theta_d)
{
    double wo[3], wi[3];
    struct lab_bin bin = {theta_h, theta_d, file->phi_d / 2};
    while (bin.theta_h > 0 && !lab_bin_directions(bin, wo, wi)) {
        --bin.theta_h;
    }
    return file->rgb + 3 * lab_bin_number(file, bin);
}

static double luminance(const float *rgb)
{
    return fmax(brdf_luminance((double)rgb[0], (double)rgb[1], (double)rgb[2]), DARKEST);
}

static double saturation(const float *rgb)
{
    double most = fmax(fmax((double)rgb[0], (double)rgb[1]), fmax((double)rgb[2], DARKEST));
    double least = fmin(fmin((double)rgb[0], (double)rgb[1]), (double)rgb[2]);
    return 1.0 - fmax(least, 0.0) / most;
}

/* theta_h at which the highlight has fallen to half between its peak and the base; the widest
   where there is no highlight. */
static double half_width(const struct brdf_merl_file *file, int theta_d, double peak, double base)
{
    enum { WIDEST = 60 };
    int theta_h = 0;
    double half = peak > 1.02 * base ? 0.5 * (peak + base) : 0.0;
    while (theta_h < WIDEST && luminance(value_at(file, theta_h, theta_d)) > half) {
        ++theta_h;
    }
    return lab_bin_theta_h(file, theta_h);
}

/* The mean of f cos(theta_o) cos(theta_i) over the bins of a coarser grid, by channel. */
static void mean_value(const struct brdf_merl_file *file, double mean[3])
{
    size_t count = 0;
    mean[0] = mean[1] = mean[2] = 0.0;
    for (int h = 1; h < file->theta_h; h += 3) {
        for (int d = 1; d < file->theta_d; d += 3) {
            for (int p = 5; p < file->phi_d; p += 10) {
                double wo[3], wi[3];
                struct lab_bin bin = {h, d, p};
                if (!lab_bin_directions(bin, wo, wi)) {
                    continue;
                }
                const float *rgb = file->rgb + 3 * lab_bin_number(file, bin);
                for (int c = 0; c < 3; ++c) {
                    mean[c] += fmax((double)rgb[c], 0.0) * wo[2] * wi[2];
                }
                ++count;
            }
        }
    }
    for (int c = 0; c < 3; ++c) {
        mean[c] = fmax(mean[c] / (double)(count ? count : 1), DARKEST);
    }
}

void lab_traits_measure(const struct brdf_merl_file *file, double traits[LAB_TRAITS])
{
    enum { UPRIGHT = 5, SLANTED = 20, GRAZING = 75, BESIDE = 62 }; /* BESIDE: theta_h = 43 deg */
    const float *highlight = value_at(file, 0, SLANTED);
    const float *beside = value_at(file, BESIDE, SLANTED);
    double peak = luminance(highlight);
    double base = luminance(beside);
    double mean[3];
    mean_value(file, mean);
    const float color[3] = {(float)mean[0], (float)mean[1], (float)mean[2]};
    traits[LAB_TRAIT_BRIGHTNESS] = log(luminance(color));
    traits[LAB_TRAIT_GLOSS] = log(peak / base);
    traits[LAB_TRAIT_SHARPNESS] = -log(half_width(file, SLANTED, peak, base));
    traits[LAB_TRAIT_METALLIC] = saturation(highlight);
    traits[LAB_TRAIT_SATURATION] = saturation(beside);
    traits[LAB_TRAIT_WARMTH] = log(mean[0] / mean[2]);
    traits[LAB_TRAIT_GRAZING] =
        log(luminance(value_at(file, 0, GRAZING)) / luminance(value_at(file, 0, UPRIGHT)));
}
