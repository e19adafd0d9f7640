/*
 * glass_table.c - what rough glass of given indices loses: the table of glass.h, by quadrature.
 *
 * Normals with density D cos lie on a lattice of Fibonacci's, the same for every direction; each
 * mirrors and refracts. Two million facets, a tenth of a second.
 */
#include "glass_table.h"

#include <math.h>
#include <stdlib.h>

#include "brdf/glass.h"
#include "brdf/microfacet.h"

enum { FACETS = 1024, STEPS = 256 };

struct facet {
    brdf_vec3 h;
    float weight; /* over cos(h) */
};

struct glass {
    int distribution;
    int masking;
    struct facet facets[FACETS]; /* of one alpha */
};

/* Slopes of the lattice, dense in the tail: they have unit roughness before they are scaled. */
static void facets_make(struct glass *glass, double alpha)
{
    for (int i = 0; i < FACETS; ++i) {
        double v = (i + 0.5) / FACETS;
        double left = (1.0 - v) * (1.0 - v);
        double slope2 = glass->distribution == BRDF_GGX ? (1.0 - left) / left : -log(left);
        double turn = 2.0 * 3.14159265358979323846 * 0.61803398874989485 * i;
        double tangent = alpha * sqrt(slope2);
        double z = 1.0 / sqrt(1.0 + tangent * tangent);
        struct facet *facet = &glass->facets[i];
        facet->h = brdf_vec3_make((float)(tangent * z * cos(turn)),
                                  (float)(tangent * z * sin(turn)), (float)z);
        facet->weight = (float)(2.0 * (1.0 - v) / FACETS / z);
    }
}

/* G2 / cos(wo) of a direction wi that one facet sends wo to; wi counts from its own side. */
static float seen(const struct glass *glass, float alpha, brdf_vec3 wo, float area_o, brdf_vec3 wi)
{
    if (wi.z <= 0.0f) {
        return 0.0f;
    }
    float area_i = brdf_microfacet_area(glass->distribution, wi, alpha, alpha);
    return wi.z * brdf_microfacet_visibility(glass->masking, wo.z, wi.z, area_o, area_i);
}

/* l of light under the cosine mu, eta being that of the far side over the near one's. */
static float loss(const struct glass *glass, float alpha, float eta, double mu)
{
    brdf_vec3 wo = brdf_vec3_make((float)sqrt(1.0 - mu * mu), 0.0f, (float)mu);
    float area_o = brdf_microfacet_area(glass->distribution, wo, alpha, alpha);
    double kept = 0.0;
    for (int i = 0; i < FACETS; ++i) {
        const struct facet *facet = &glass->facets[i];
        float cosine = brdf_min(brdf_dot(wo, facet->h), 1.0f);
        if (cosine > 0.0f) {
            struct brdf_fresnel fresnel = brdf_fresnel_dielectric(cosine, eta);
            brdf_vec3 mirrored = brdf_reflect(wo, facet->h);
            brdf_vec3 refracted = brdf_refract(wo, facet->h, cosine, fresnel.cos_t, eta);
            float sum = fresnel.reflectance * seen(glass, alpha, wo, area_o, mirrored) +
                        (1.0f - fresnel.reflectance) *
                            seen(glass, alpha, wo, area_o, brdf_negate(refracted));
            kept += (double)(facet->weight * cosine * sum);
        }
    }
    return (float)fmin(fmax(1.0 - kept, 0.0), 1.0);
}

/* The cosine of a column for a = 4 alpha^2; not quite 0, where areas are. */
static double cosine_of(int column, double a)
{
    double root = (double)column / (BRDF_GLASS_COSINES - 1);
    double some = fmax(root * root, 1e-5);
    return fmin(some * sqrt(a / (1.0 + a - some * some)), 1.0);
}

static double alpha_of(int row)
{
    double v = (double)row / (BRDF_GLASS_ALPHAS - 1) / 1.5;
    return fmax(v / (1.0 - v), (double)BRDF_GLASS_ALPHA_LOW);
}

/*
 * L from the rows, as brdf_glass_loss will read them: mu^2 goes by its logarithm, so that the loss
 * near the horizon is resolved.
 */
static double mean(const float *half, double alpha)
{
    double a = 4.0 * alpha * alpha;
    double scale = log(1.0 + 1.0 / a);
    double sum = 0.0;
    for (int i = 0; i < STEPS; ++i) {
        double mu2 = a * expm1(scale * (i + 0.5) / STEPS);
        float mu = (float)fmin(sqrt(mu2), 1.0);
        sum += (double)brdf_glass_loss(half, 1, (float)alpha, mu) * (mu2 + a);
    }
    return sum * scale / STEPS;
}

static void half_fill(struct glass *glass, float eta, float *half)
{
    for (int row = 0; row < BRDF_GLASS_ALPHAS; ++row) {
        double alpha = alpha_of(row);
        facets_make(glass, alpha);
        for (int k = 0; k < BRDF_GLASS_COSINES; ++k) {
            double mu = cosine_of(k, 4.0 * alpha * alpha);
            half[BRDF_GLASS_MEANS + row * BRDF_GLASS_COSINES + k] =
                loss(glass, (float)alpha, eta, mu);
        }
    }
    for (int i = 0; i < BRDF_GLASS_MEANS; ++i) {
        double x = (double)i / (BRDF_GLASS_MEANS - 1);
        double alpha = exp((double)BRDF_GLASS_LOG_LOW + (double)BRDF_GLASS_LOG_RANGE * x);
        half[i] = (float)(mean(half, alpha) * (1.0 + alpha * alpha) / (alpha * alpha));
    }
}

brdf_status brdf_glass_table_make(int distribution, int masking, float eta, float **table,
                                  size_t *words, struct brdf_error *error)
{
    struct glass *glass = malloc(sizeof *glass);
    float *made = malloc(BRDF_GLASS_WORDS * sizeof *made);
    if (!glass || !made) {
        free(glass);
        free(made);
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for what rough glass loses");
    }
    glass->distribution = distribution;
    glass->masking = masking;
    half_fill(glass, eta, made);
    half_fill(glass, 1.0f / eta, made + BRDF_GLASS_HALF);
    free(glass);
    *table = made;
    *words = BRDF_GLASS_WORDS;
    return BRDF_OK;
}
