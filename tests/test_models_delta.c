/*
 * test_models_delta.c - lobes of a single direction: their probabilities and their way back.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_models.h"

enum {
    LOBES = 8, /* at most, of one direction */
    STEPS = 2048
};

/* The delta lobes of a direction, found by going through the numbers that choose among lobes. */
struct lobes {
    struct brdf_sample lobe[LOBES];
    int hits[LOBES];
    int count;
    int nothing; /* numbers for which there is no sample, or none that is a delta */
};

static float distance(brdf_vec3 a, brdf_vec3 b)
{
    brdf_vec3 d = brdf_sub(a, b);
    return sqrtf(brdf_dot(d, d));
}

static struct lobes find_lobes(const struct brdf_bsdf *bsdf, brdf_vec3 wo)
{
    struct lobes found = {.count = 0};
    for (int step = 0; step < STEPS; ++step) {
        brdf_vec3 u = models_even_point((size_t)step, STEPS);
        u.z = ((float)step + 0.5f) / STEPS;
        struct brdf_sample s = brdf_sample(bsdf, wo, u);
        if (s.pdf <= 0.0f || !s.delta) {
            ++found.nothing;
            continue;
        }
        int i = 0;
        while (i < found.count && distance(found.lobe[i].wi, s.wi) > 1e-4f) {
            ++i;
        }
        if (i == found.count) {
            assert_true(found.count < LOBES);
            found.lobe[found.count] = s;
            found.hits[found.count++] = 0;
        }
        ++found.hits[i];
    }
    return found;
}

/* Most models have none: a few samples tell. */
static int has_lobes(const struct lab_case *one)
{
    struct brdfcl_random random = {30};
    for (size_t i = 0; i < 512; ++i) {
        brdf_vec3 wo = brdfcl_random_direction(&random);
        if (brdf_sample(&one->bsdf, wo, models_even_point(i, 512)).delta) {
            return 1;
        }
    }
    return 0;
}

/* What the lobe does to radiance [1]. */
static float coefficient(struct brdf_sample s)
{
    return s.weight.g * s.pdf;
}

static void values_are_zero(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {31};
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        for (int k = 0; k < 10000; ++k) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            struct brdf_sample s = brdf_sample(&one->bsdf, in.wo, in.u);
            brdf_vec3 wi = s.pdf > 0.0f ? s.wi : in.wi; /* even right on the lobe */
            if (brdf_rgb_largest(brdf_eval(&one->bsdf, in.wo, wi)) != 0.0f ||
                brdf_pdf(&one->bsdf, in.wo, wi) != 0.0f || (s.pdf > 0.0f && !s.delta)) {
                models_fail(cases, one, "f or the density is not 0, or a sample is no delta");
            }
        }
    }
    models_verdict(cases);
}

/* Each lobe comes up as often as it says, and all of them together always. */
static void probabilities_hold(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {32};
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        int tries = has_lobes(one) ? 200 : 0;
        for (int k = 0; k < tries; ++k) {
            brdf_vec3 wo = brdfcl_random_direction(&random);
            struct lobes found = find_lobes(&one->bsdf, wo);
            float sum = 0.0f;
            for (int j = 0; j < found.count; ++j) {
                float often = (float)found.hits[j] / STEPS;
                sum += found.lobe[j].pdf;
                if (!(fabsf(often - found.lobe[j].pdf) <= 2.0f / STEPS)) {
                    models_fail(cases, one, "a lobe of probability %.6f comes up in %.6f",
                                (double)found.lobe[j].pdf, (double)often);
                }
            }
            float rest = (float)found.nothing / STEPS;
            if (!(fabsf(sum + rest - 1.0f) <= 2.0f / STEPS)) {
                models_fail(cases, one, "the probabilities sum to %.6f", (double)(sum + rest));
            }
        }
    }
    models_verdict(cases);
}

/*
 * How far rounding may take the way back off: sin^2 = 1 - cos^2 has an absolute error of 1e-7, the
 * ratio of indices scales it, and it becomes that of a small cosine by division by it, twice.
 */
static float allowance(brdf_vec3 wo, struct brdf_sample there)
{
    float ratio = brdf_max(there.eta, 1.0f / there.eta);
    float cosine = brdf_min(fabsf(wo.z), fabsf(there.wi.z));
    return 1e-4f + 1e-6f * ratio * ratio / brdf_max(cosine * cosine, 1e-10f);
}

/* Along each lobe and back: the same path, and c eta^2 = c' eta'^2 [Veach 1997, 5.3]. */
static void way_back(struct model_cases *cases, const struct lab_case *one, brdf_vec3 wo,
                     struct brdf_sample there, float allowed)
{
    struct lobes found = find_lobes(&one->bsdf, there.wi);
    for (int i = 0; i < found.count; ++i) {
        struct brdf_sample back = found.lobe[i];
        if (distance(back.wi, wo) > allowed) {
            continue;
        }
        float a = coefficient(there) * there.eta * there.eta;
        float b = coefficient(back) * back.eta * back.eta;
        if (!(fabsf(there.eta * back.eta - 1.0f) <= 1e-5f) ||
            !(fabsf(a - b) <= allowed * brdf_max(a, b) + 1e-6f)) {
            models_fail(cases, one, "there %.6g (eta %.6g), back %.6g (eta %.6g)",
                        (double)coefficient(there), (double)there.eta, (double)coefficient(back),
                        (double)back.eta);
        }
        return;
    }
    models_fail(cases, one, "there is no way back from %.6g/%.6g/%.6g to %.6g/%.6g/%.6g",
                (double)there.wi.x, (double)there.wi.y, (double)there.wi.z, (double)wo.x,
                (double)wo.y, (double)wo.z);
}

static void lobes_are_reciprocal(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {33};
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        int tries = has_lobes(one) ? 100 : 0;
        for (int k = 0; k < tries; ++k) {
            brdf_vec3 wo = brdfcl_random_direction(&random);
            struct lobes found = find_lobes(&one->bsdf, wo);
            for (int j = 0; j < found.count; ++j) {
                float allowed = allowance(wo, found.lobe[j]);
                /* Lobes too rare to be found again are left alone. */
                if (found.lobe[j].pdf > 4.0f / STEPS && allowed < 0.01f) {
                    way_back(cases, one, wo, found.lobe[j], allowed);
                }
            }
        }
    }
    models_verdict(cases);
}

int main(void)
{
    const struct model_check checks[] = {
        {"f and pdf of delta lobes are 0", values_are_zero, BRDF_DELTA, 0},
        {"delta lobes come up as often as they say", probabilities_hold, 0, 0},
        {"delta lobes are reciprocal", lobes_are_reciprocal, BRDF_RECIPROCAL, 0},
    };
    return models_run(checks, sizeof checks / sizeof checks[0]);
}
