/*
 * survey_merl.c - the bins of a MERL table counted, and their noise.
 *
 * The noise is what a parabola through neighbours does not explain: for four bins in a row along
 * phi_d, f(-1) - 3 f(0) + 3 f(1) - f(2) would have the root mean square sqrt(20) sigma if each had
 * an independent error sigma, and almost nothing where f is smooth. It is taken relative to the
 * mean of the four.
 */
#include "angle.h"
#include "survey.h"

#include <math.h>
#include <string.h>

#include "bins.h"

static const double grazing = 60.0; /* degrees; where the noise is counted apart */

struct noise {
    double sum;
    size_t count;
};

static struct lab_place place_of(const struct brdf_merl_file *file, size_t bin)
{
    struct lab_bin at = lab_bin_of(file, bin);
    struct lab_place place = {lab_bin_theta_h(file, at.theta_h) * 180.0 / pi,
                              90.0 * (at.theta_d + 0.5) / file->theta_d,
                              180.0 * (at.phi_d + 0.5) / file->phi_d};
    return place;
}

/* The angle of the lower of the two directions at a bin [degrees]; above 90 if it is below. */
static double angle_of(const struct brdf_merl_file *file, size_t bin)
{
    double wo[3], wi[3];
    lab_bin_directions(lab_bin_of(file, bin), wo, wi);
    return acos(fmin(wo[2], wi[2])) * 180.0 / pi;
}

static void valid_count(const struct brdf_merl_file *file, size_t bin,
                        struct lab_merl_survey *survey)
{
    const float *f = file->rgb + 3 * bin;
    ++survey->valid;
    survey->zero += f[0] == 0.0f || f[1] == 0.0f || f[2] == 0.0f;
    for (int c = 0; c < 3; ++c) {
        double value = (double)f[c];
        if (value < survey->least) {
            survey->least = value;
            survey->least_at = place_of(file, bin);
        }
        if (value > survey->most) {
            survey->most = value;
            survey->most_at = place_of(file, bin);
        }
    }
}

/* The third differences around a bin, if it and its neighbours were measured. */
static void noise_add(const struct brdf_merl_file *file, size_t bin, struct noise *noise)
{
    size_t phi = bin % (size_t)file->phi_d;
    const float *f = file->rgb + 3 * bin;
    if (phi < 1 || phi + 2 >= (size_t)file->phi_d || f[-3] < 0.0f || f[3] < 0.0f || f[6] < 0.0f) {
        return;
    }
    for (int c = 0; c < 3; ++c) {
        double a = (double)f[c - 3], b = (double)f[c], d = (double)f[c + 3], e = (double)f[c + 6];
        double mean = 0.25 * (a + b + d + e);
        if (mean > 0.0) {
            double third = (a - 3.0 * b + 3.0 * d - e) / mean;
            noise->sum += third * third / 20.0;
            ++noise->count;
        }
    }
}

static double noise_of(struct noise noise)
{
    return noise.count ? sqrt(noise.sum / (double)noise.count) : 0.0;
}

void lab_survey_merl(const struct brdf_merl_file *file, struct lab_merl_survey *survey)
{
    struct noise noise[2] = {{0.0, 0}, {0.0, 0}};
    memset(survey, 0, sizeof *survey);
    survey->bins = file->bins;
    survey->folded = file->folded;
    survey->folding = file->folding;
    survey->least = HUGE_VAL;
    survey->invalid_from = 90.0;
    for (size_t bin = 0; bin < file->bins; ++bin) {
        double angle = angle_of(file, bin);
        int above = angle < 90.0;
        survey->above += (size_t)above;
        if (file->rgb[3 * bin] >= 0.0f) {
            valid_count(file, bin, survey);
            noise_add(file, bin, &noise[angle > grazing]);
        } else if (above) {
            ++survey->above_invalid;
            survey->invalid_from = fmin(survey->invalid_from, angle);
        }
    }
    survey->noise = noise_of(noise[0]);
    survey->noise_grazing = noise_of(noise[1]);
}
