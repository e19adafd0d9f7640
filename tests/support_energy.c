/*
 * support_energy.c - albedos by sampling and by quadrature.
 */
#include "support_energy.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_models.h"

enum { PILOT = 8192 };

const double energy_cosines[ENERGY_COSINES] = {0.1, 0.25, 0.5, 0.75, 1.0};

struct view {
    const struct brdf_bsdf *bsdf;
    brdf_vec3 wo;
};

static double mean(brdf_rgb c)
{
    return ((double)c.r + (double)c.g + (double)c.b) / 3.0;
}

static double f_cos(brdf_vec3 wi, void *data)
{
    const struct view *view = data;
    return mean(brdf_eval(view->bsdf, view->wo, wi)) * fabs((double)wi.z);
}

brdf_vec3 energy_direction(double cosine, double phi)
{
    double radius = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    return brdf_normalize(
        brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cosine));
}

struct energy_mean energy_by_sampling(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    size_t count = models_long() ? 1 << 20 : 1 << 15;
    double sum = 0.0;
    double heavy = 0.0;
    for (size_t i = 0; i < count; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, count));
        double weight = s.delta ? 0.0 : mean(s.weight);
        sum += weight;
        heavy += pow(fmax(weight - 1.0, 0.0), 2.0);
    }
    struct energy_mean result = {sum / (double)count, sqrt(heavy) / (double)count};
    return result;
}

struct sphere_sum energy_by_quadrature(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    struct view view = {bsdf, wo};
    brdf_vec3 *pilot = calloc(PILOT, sizeof *pilot);
    assert_non_null(pilot);
    size_t count = 0;
    for (size_t i = 0; i < PILOT; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, PILOT));
        if (s.pdf > 0.0f && !s.delta) {
            pilot[count++] = s.wi;
        }
    }
    struct sphere *sphere = sphere_create(pilot, count);
    struct sphere_sum sum = sphere_integrate(sphere, f_cos, &view, 1e-4, 1e-3);
    sphere_destroy(sphere);
    free(pilot);
    return sum;
}

/* One row, both ways; returns the number of failures. */
static int check_row(const struct energy_known *row)
{
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    if (brdf_bsdf_create(row->description, &bsdf, &error)) {
        print_error("%s\n", error.message);
        return 1;
    }
    int failures = 0;
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        brdf_vec3 wo = energy_direction(energy_cosines[i], 0.7);
        double tolerance = i == 0 ? row->tolerance_grazing : row->tolerance;
        double sampled = energy_by_sampling(bsdf, wo).value;
        double integral = energy_by_quadrature(bsdf, wo).value;
        if (!(fabs(sampled - row->albedo[i]) <= tolerance) ||
            !(fabs(integral - row->albedo[i]) <= tolerance)) {
            print_error("%s at cos = %.2f: %.5f by sampling, %.5f by quadrature, known %.5f\n",
                        row->description, energy_cosines[i], sampled, integral, row->albedo[i]);
            ++failures;
        }
    }
    brdf_bsdf_destroy(bsdf);
    return failures;
}

int energy_check_known(const struct energy_known *rows, size_t count)
{
    int failures = 0;
    for (size_t i = 0; i < count; ++i) {
        failures += check_row(&rows[i]);
    }
    return failures;
}
