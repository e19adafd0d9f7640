/* survey.c - albedo, reciprocity and energy of a material, by sampling it. */
#include "survey.h"

#include <math.h>
#include <string.h>

#include <brdf/warp.h>

#include "albedo.h"
#include "angle.h"
#include "draw.h"
#include "lattice.h"

const double lab_survey_angles[LAB_SURVEY_ANGLES] = {0, 15, 30, 45, 60, 70, 80, 85, 88};

enum { SAMPLES = 1 << 13, PAIRS = 1 << 16 };

static void albedos_find(const struct brdf_bsdf *bsdf, struct lab_survey *survey)
{
    survey->energy = 0.0;
    survey->energy_from = 90.0;
    for (int k = 0; k < LAB_SURVEY_ANGLES; ++k) {
        double theta = lab_survey_angles[k] * pi / 180.0;
        brdf_vec3 wo = brdf_vec3_make((float)sin(theta), 0.0f, (float)cos(theta));
        struct lab_albedo albedo = lab_albedo_at(bsdf, wo, SAMPLES);
        for (int c = 0; c < 3; ++c) {
            double a = albedo.reflection[c];
            survey->albedo[k][c] = a;
            if (a > survey->energy) {
                survey->energy = a;
                survey->energy_angle = lab_survey_angles[k];
            }
            if (a > 1.0 + 3.0 * albedo.error && lab_survey_angles[k] < survey->energy_from) {
                survey->energy_from = lab_survey_angles[k];
            }
        }
    }
    struct lab_albedo all = lab_albedo_average(bsdf, 0, SAMPLES);
    memcpy(survey->albedo_diffuse, all.reflection, sizeof survey->albedo_diffuse);
}

double lab_reciprocity(const struct brdf_bsdf *bsdf)
{
    struct lab_lattice lattice = lab_lattice_make(5, 3);
    double difference = 0.0, sum = 0.0;
    for (size_t i = 0; i < PAIRS; ++i) {
        brdf_vec3 wo =
            brdf_warp_cosine(lab_lattice_at(&lattice, i, 0), lab_lattice_at(&lattice, i, 1));
        brdf_vec3 u = brdf_vec3_make(lab_lattice_at(&lattice, i, 2), lab_lattice_at(&lattice, i, 3),
                                     lab_lattice_at(&lattice, i, 4));
        struct lab_draw draw = lab_draw_make(bsdf, wo, i, u);
        if (wo.z > 0.0f && draw.weight > 0.0) {
            brdf_rgb f = brdf_eval(bsdf, wo, draw.wi), g = brdf_eval(bsdf, draw.wi, wo);
            difference +=
                draw.weight * (fabs((double)f.r - (double)g.r) + fabs((double)f.g - (double)g.g) +
                               fabs((double)f.b - (double)g.b));
            sum += draw.weight * ((double)f.r + (double)f.g + (double)f.b);
        }
    }
    return sum > 0.0 ? difference / sum : 0.0;
}

void lab_survey_make(const struct brdf_bsdf *bsdf, struct lab_survey *survey)
{
    memset(survey, 0, sizeof *survey);
    albedos_find(bsdf, survey);
    survey->reciprocity = lab_reciprocity(bsdf);
}
