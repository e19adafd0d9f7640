/* compare.c - two materials compared by quadrature over pairs of directions. */
#include "compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <brdf/warp.h>

#include "brdf/bsdf.h"
#include "brdf/merl_table.h"
#include "lattice.h"

static const double pi = 3.14159265358979323846;

enum { INCIDENCES = 9, POINTS = 1 << 14 };

static const double seen = 1e-3; /* 1/sr: relative differences of less than this say nothing */

/* Sums over the points of one incidence. */
struct sums {
    double square, square_of_f;
    double absolute, of_f;
    double albedo_f[3], albedo_g[3];
};

/* Keep the largest relative difference. */
static void worst_update(struct lab_difference *worst, double f, double g, brdf_vec3 wo,
                         brdf_vec3 wi)
{
    double relative = f > seen ? fabs(f - g) / f : 0.0;
    if (relative > worst->worst) {
        worst->worst = relative;
        worst->wo = wo;
        worst->wi = wi;
    }
}

static void point_add(struct sums *sums, struct lab_difference *worst, brdf_rgb f, brdf_rgb g,
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
        worst_update(worst, fs[c], gs[c], wo, wi);
    }
}

/* Every other wi is drawn from f, the rest by the cosine; both are weighted by the mixture. */
static void incidence_add(struct sums *sums, struct lab_difference *worst,
                          const struct brdf_bsdf *f, const struct brdf_bsdf *g, brdf_vec3 wo)
{
    struct lab_lattice lattice = lab_lattice_make(3, 1);
    for (size_t i = 0; i < POINTS; ++i) {
        float x = lab_lattice_at(&lattice, i, 0), y = lab_lattice_at(&lattice, i, 1);
        brdf_vec3 wi = brdf_warp_cosine(x, y);
        if (i % 2 == 1) {
            struct brdf_sample sample =
                brdf_sample(f, wo, brdf_vec3_make(x, y, lab_lattice_at(&lattice, i, 2)));
            if (sample.pdf <= 0.0f || sample.delta) {
                continue;
            }
            wi = sample.wi;
        }
        if (wi.z <= 0.0f) {
            continue;
        }
        double cosine = (double)wi.z;
        double density = 0.5 * cosine / pi + 0.5 * (double)brdf_pdf(f, wo, wi);
        point_add(sums, worst, brdf_eval(f, wo, wi), brdf_eval(g, wo, wi), wo, wi,
                  cosine / (density * POINTS));
    }
}

struct lab_difference lab_compare(const struct brdf_bsdf *f, const struct brdf_bsdf *g)
{
    struct lab_difference result = {0};
    struct sums all = {0};
    for (int k = 0; k < INCIDENCES; ++k) {
        double theta = (5.0 + 10.0 * k) * pi / 180.0;
        struct sums sums = {0};
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
    return result;
}

/* A table as the model merl reads it from a file, without the file. */
static brdf_status bsdf_of_merl(const struct brdf_merl_file *file, struct brdf_bsdf *bsdf,
                                struct brdf_error *error)
{
    struct brdf_setting name = brdf_setting_text("filename", "a table in memory");
    const struct brdf_model_info *model = brdf_model_info(BRDF_MODEL_MERL);
    brdf_status status = brdf_settings_apply(bsdf, model, &name, 1, NULL, error);
    if (!status) {
        bsdf->parameters =
            brdf_parameters_load(bsdf->material.model, bsdf->material.choices, bsdf->material.word);
        status = brdf_merl_table_build(file, &bsdf->table, &bsdf->table_words, error);
    }
    return status;
}

brdf_status lab_compare_merl(const struct brdf_bsdf *f, const struct brdf_merl_file *g,
                             struct lab_difference *difference, struct brdf_error *error)
{
    struct brdf_merl_file filled = {0};
    struct brdf_bsdf bsdf = {0};
    brdf_status status = brdf_merl_create(&filled, error);
    if (!status) {
        memcpy(filled.rgb, g->rgb, g->bins * 3 * sizeof *g->rgb);
        filled.invalid = g->invalid;
        status = brdf_merl_fill(&filled, error);
    }
    if (!status) {
        status = bsdf_of_merl(&filled, &bsdf, error);
    }
    if (!status) {
        *difference = lab_compare(f, &bsdf);
    }
    free(bsdf.table);
    free(bsdf.file[0]);
    brdf_merl_free(&filled);
    return status;
}
