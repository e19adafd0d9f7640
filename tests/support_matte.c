/*
 * support_matte.c - see support_matte.h.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "angle.h"
#include "support_bsdf.h"
#include "support_matte.h"
#include "support_models.h"

/* The midpoint rule over cosines from low to high, and half a turn in two pieces: Oren-Nayar has
   creases at a quarter turn and where both cosines are equal. */
static double panel(const struct brdf_bsdf *bsdf, brdf_vec3 wo, double low, double high, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        double z = low + (high - low) * (i + 0.5) / count;
        for (int j = 0; j < 2 * count; ++j) {
            double phi = pi * (j + 0.5) / (2 * count);
            sum += z * (double)brdf_eval(bsdf, wo, energy_direction(z, phi)).g;
        }
    }
    return sum * (high - low) / count * pi / count;
}

/* The albedo for light from the cosine mu; isotropic models only. */
double matte_albedo(const struct brdf_bsdf *bsdf, double mu, int count)
{
    brdf_vec3 wo = energy_direction(mu, 0.0);
    return panel(bsdf, wo, 0.0, mu, count) + panel(bsdf, wo, mu, 1.0, count);
}

double matte_albedo_by_sampling(const struct brdf_bsdf *bsdf, double mu)
{
    size_t count = 1 << 14;
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        brdf_vec3 u = models_even_point(i, count);
        sum += (double)brdf_sample(bsdf, energy_direction(mu, 0.0), u).weight.g;
    }
    return sum / (double)count;
}

int matte_expect(const char *what, double mu, double found, double known, double tolerance)
{
    int wrong = !(fabs(found - known) <= tolerance);
    if (wrong) {
        print_error("%s at cos = %.3f: %.6f, known %.6f\n", what, mu, found, known);
    }
    return wrong;
}

/* The albedo at all five cosines, by quadrature and by sampling. */
int matte_expect_albedos(const char *description, const double known[ENERGY_COSINES],
                         double tolerance)
{
    struct brdf_bsdf *bsdf = bsdf_make(description);
    int failures = 0;
    for (int i = 0; i < ENERGY_COSINES; ++i) {
        double mu = energy_cosines[i];
        failures += matte_expect(description, mu, matte_albedo(bsdf, mu, 64), known[i], tolerance);
        failures +=
            matte_expect(description, mu, matte_albedo_by_sampling(bsdf, mu), known[i], 1e-3);
    }
    brdf_bsdf_destroy(bsdf);
    return failures;
}
