/* survey_rgl.c - the values of an RGL file counted. */
#include "angle.h"
#include "survey.h"

#include <math.h>
#include <string.h>

#include "lattice.h"

enum { POINTS = 1024 }; /* of each view */

static struct lab_pair pair_of(brdf_vec3 wo, brdf_vec3 wi)
{
    struct lab_pair pair;
    double phi = atan2((double)wi.y, (double)wi.x) - atan2((double)wo.y, (double)wo.x);
    pair.theta_o = acos(fmin((double)wo.z, 1.0)) * 180.0 / pi;
    pair.theta_i = acos(fmin((double)wi.z, 1.0)) * 180.0 / pi;
    pair.phi = fabs(phi - 2.0 * pi * floor(phi / (2.0 * pi) + 0.5)) * 180.0 / pi;
    return pair;
}

/* Draws from a view follow its own grid: they are where the file has its nodes. */
static void view_add(const struct brdf_bsdf *bsdf, brdf_vec3 wo, struct lab_rgl_survey *survey)
{
    struct lab_lattice lattice = lab_lattice_make(3, 1);
    for (size_t i = 0; i < POINTS; ++i) {
        brdf_vec3 u = lab_lattice_cube(&lattice, i);
        struct brdf_sample sample = brdf_sample(bsdf, wo, u);
        if (sample.pdf > 0.0f) {
            brdf_rgb f = brdf_eval(bsdf, wo, sample.wi);
            double least = fmin((double)f.r, fmin((double)f.g, (double)f.b));
            double most = fmax((double)f.r, fmax((double)f.g, (double)f.b));
            if (least < survey->least) {
                survey->least = least;
                survey->least_at = pair_of(wo, sample.wi);
            }
            if (most > survey->most) {
                survey->most = most;
                survey->most_at = pair_of(wo, sample.wi);
            }
        }
    }
}

void lab_survey_rgl(const struct brdf_rgl_file *file, const struct brdf_bsdf *bsdf,
                    struct lab_rgl_survey *survey)
{
    size_t count = (size_t)file->phi_count * (size_t)file->theta_count * (size_t)file->channels *
                   (size_t)file->size * (size_t)file->size;
    size_t negative = 0;
    for (size_t i = 0; i < count; ++i) {
        negative += file->values[i] < 0.0f;
    }
    memset(survey, 0, sizeof *survey);
    survey->phis = file->phi_count;
    survey->thetas = file->theta_count;
    survey->size = file->size;
    survey->channels = file->channels;
    survey->spectral = file->wavelengths != NULL;
    survey->theta_most = (double)file->theta_i[file->theta_count - 1] * 180.0 / pi;
    survey->negative = (double)negative / (double)count;
    survey->least = HUGE_VAL;
    for (int view = 0; view < file->phi_count * file->theta_count; ++view) {
        double theta = fmin((double)file->theta_i[view % file->theta_count], 89.5 * pi / 180.0);
        double phi = (double)file->phi_i[view / file->theta_count];
        view_add(bsdf,
                 brdf_vec3_make((float)(sin(theta) * cos(phi)), (float)(sin(theta) * sin(phi)),
                                (float)cos(theta)),
                 survey);
    }
}
