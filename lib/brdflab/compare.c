/* compare.c - two materials compared by quadrature over pairs of directions. */
#include "compare.h"

#include <math.h>

#include "angle.h"
#include "draw.h"
#include "lattice.h"
#include "tabulated.h"

enum { INCIDENCES = 9, POINTS = 1 << 14 };

static const double seen = 1e-3; /* 1/sr: relative differences of less than this say nothing */

/* Light by how large the relative difference is where it goes: 32 steps a decade from 1e-8 on. */
enum { STEPS_A_DECADE = 32, DECADES = 12, STEPS = STEPS_A_DECADE * DECADES };
static const double least_step = 1e-8;

/* Sums over the points of one incidence; `light` over those of all. */
struct sums {
    double square, square_of_f;
    double absolute, of_f;
    double albedo_f[3], albedo_g[3];
    double *light; /* [STEPS] */
};

static void light_add(double *light, double relative, double weight)
{
    double step = STEPS_A_DECADE * log10(fmax(relative, least_step) / least_step);
    light[(int)fmin(step, STEPS - 1.0)] += weight;
}

/* The relative difference that this share of the light stays below, to one step. */
static double light_below(const double *light, double share)
{
    double all = 0.0, sum = 0.0;
    int step = 0;
    for (int k = 0; k < STEPS; ++k) {
        all += light[k];
    }
    while (step < STEPS && sum < share * all) {
        sum += light[step++];
    }
    return step <= 1 ? 0.0 : least_step * pow(10.0, (double)step / STEPS_A_DECADE);
}

/* Keep the largest relative difference. */
static void worst_update(struct lab_difference *result, double relative, brdf_vec3 wo, brdf_vec3 wi)
{
    int grazing = fmin((double)wo.z, (double)wi.z) < cos(LAB_GRAZING * pi / 180.0);
    struct lab_worst *worst = grazing ? &result->grazing : &result->worst;
    if (relative > worst->relative) {
        worst->relative = relative;
        worst->wo = wo;
        worst->wi = wi;
    }
}

static void point_add(struct sums *sums, struct lab_difference *result, brdf_rgb f, brdf_rgb g,
                      brdf_vec3 wo, brdf_vec3 wi, double weight)
{
    const double fs[3] = {(double)f.r, (double)f.g, (double)f.b};
    const double gs[3] = {(double)g.r, (double)g.g, (double)g.b};
    for (int c = 0; c < 3; ++c) {
        double difference = fs[c] - gs[c];
        sums->square += weight * (double)wi.z * difference * difference;
        sums->square_of_f += weight * (double)wi.z * fs[c] * fs[c];
        sums->absolute += weight * fabs(difference);
        sums->of_f += weight * fs[c];
        sums->albedo_f[c] += weight * fs[c];
        sums->albedo_g[c] += weight * gs[c];
        if (fs[c] > 0.0) {
            light_add(sums->light, fabs(difference) / fs[c], weight * fs[c]);
        }
        if (fs[c] > seen) {
            worst_update(result, fabs(difference) / fs[c], wo, wi);
        }
    }
}

static void incidence_add(struct sums *sums, struct lab_difference *result,
                          const struct brdf_bsdf *f, const struct brdf_bsdf *g, brdf_vec3 wo)
{
    struct lab_lattice lattice = lab_lattice_make(3, 1);
    for (size_t i = 0; i < POINTS; ++i) {
        struct lab_draw draw = lab_draw_make(f, wo, i, lab_lattice_cube(&lattice, i));
        if (draw.weight > 0.0) {
            point_add(sums, result, brdf_eval(f, wo, draw.wi), brdf_eval(g, wo, draw.wi), wo,
                      draw.wi, draw.weight / POINTS);
        }
    }
}

struct lab_difference lab_compare(const struct brdf_bsdf *f, const struct brdf_bsdf *g)
{
    struct lab_difference result = {0};
    struct sums all = {0};
    double light[STEPS] = {0.0};
    for (int k = 0; k < INCIDENCES; ++k) {
        double theta = (5.0 + 10.0 * k) * pi / 180.0;
        struct sums sums = {.light = light};
        incidence_add(&sums, &result, f, g,
                      brdf_vec3_make((float)sin(theta), 0.0f, (float)cos(theta)));
        all.square += sums.square;
        all.square_of_f += sums.square_of_f;
        all.absolute += sums.absolute;
        all.of_f += sums.of_f;
        for (int c = 0; c < 3; ++c) {
            result.albedo = fmax(result.albedo, fabs(sums.albedo_f[c] - sums.albedo_g[c]));
        }
    }
    result.rms = all.square_of_f > 0.0 ? sqrt(all.square / all.square_of_f) : sqrt(all.square);
    result.mean = all.of_f > 0.0 ? all.absolute / all.of_f : all.absolute;
    result.most = light_below(light, 0.99);
    return result;
}

brdf_status lab_compare_merl(const struct brdf_bsdf *f, const struct brdf_merl_file *g,
                             struct lab_difference *difference, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = lab_bsdf_of_merl(g, &bsdf, error);
    if (!status) {
        *difference = lab_compare(f, bsdf);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}
