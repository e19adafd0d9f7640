/*
 * support_energy.c - albedos by sampling and by quadrature.
 */
#include "support_energy.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>

#include "angle.h"
#include "support_models.h"

const double energy_cosines[ENERGY_COSINES] = {0.1, 0.25, 0.5, 0.75, 1.0};

brdf_vec3 energy_direction(double cosine, double phi)
{
    double radius = sqrt(fmax(1.0 - cosine * cosine, 0.0));
    return brdf_normalize(
        brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cosine));
}

struct lab_energy energy_by_sampling(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    return lab_energy_sampled(bsdf, wo, models_long() ? 1 << 20 : 1 << 15);
}

struct lab_sphere_sum energy_by_quadrature(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    struct lab_sphere_sum sum;
    assert_int_equal(lab_energy_integrated(bsdf, wo, 1, &sum, NULL), BRDF_OK);
    return sum;
}

double energy_of_both_sides(const struct brdf_bsdf *bsdf, brdf_vec3 wo, double eta, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, models_even_point(i, count));
        sum += (double)s.weight.g * ((wo.z > 0.0f) == (s.wi.z > 0.0f) ? 1.0 : eta * eta);
    }
    return sum / (double)count;
}

double energy_missing(const struct brdf_bsdf *bsdf, const char *name, double degrees, double side,
                      double azimuth, double eta, size_t count, double at_most)
{
    brdf_vec3 wo = energy_direction(side * cos(degrees * pi / 180.0), azimuth);
    double albedo = energy_of_both_sides(bsdf, wo, eta, count);
    double missing = fabs(albedo - 1.0);
    if (!(missing <= at_most)) {
        print_error("%s, %g degrees, azimuth %g: %.5f\n", name,
                    side > 0.0 ? degrees : 180.0 - degrees, azimuth, albedo);
    }
    return missing;
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
