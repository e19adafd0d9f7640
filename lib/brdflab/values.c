/*
 * values.c - tests of single values over random inputs.
 */
#include "values.h"

#include <math.h>
#include <stdio.h>

#include <brdf/model.h>

#include "brdfcl/check_cases.h"

static int is_positive_number(float x)
{
    return x >= 0.0f && x <= BRDF_LARGEST;
}

static int is_color(brdf_rgb c)
{
    return is_positive_number(c.r) && is_positive_number(c.g) && is_positive_number(c.b);
}

static int is_unit(brdf_vec3 w)
{
    return fabsf(brdf_dot(w, w) - 1.0f) < 1e-4f;
}

static int is_black(brdf_rgb c)
{
    return brdf_rgb_largest(c) == 0.0f;
}

static unsigned flags_of(const struct brdf_bsdf *bsdf)
{
    return brdf_bsdf_material(bsdf)->flags;
}

int lab_seen_from_below(const struct brdf_bsdf *bsdf)
{
    return (flags_of(bsdf) & (BRDF_TRANSMISSION | BRDF_TWOSIDED)) != 0;
}

/* Is the pair on sides of the surface that the model's flags allow? */
static int is_allowed(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 wi)
{
    int same_side = (wo.z > 0.0f) == (wi.z > 0.0f);
    if (wo.z < 0.0f && !lab_seen_from_below(bsdf)) {
        return 0;
    }
    return (flags_of(bsdf) & (same_side ? BRDF_REFLECTION : BRDF_TRANSMISSION)) != 0;
}

static const char *sample_fault(const struct brdf_bsdf *bsdf, brdf_vec3 wo, struct brdf_sample s)
{
    if (!is_positive_number(s.pdf)) {
        return "the density of a sample is not a number >= 0";
    }
    if (!is_color(s.weight)) {
        return "the weight of a sample is not a number >= 0";
    }
    if (!(s.eta > 0.0f && s.eta <= BRDF_LARGEST)) {
        return "eta of a sample is not a number > 0";
    }
    if (s.pdf == 0.0f) {
        return is_black(s.weight) && !s.delta ? NULL : "no sample, but a weight or a delta";
    }
    if (!is_unit(s.wi)) {
        return "a sampled direction is not a unit vector";
    }
    if (!is_black(s.weight) && !is_allowed(bsdf, wo, s.wi)) {
        return "a sample on a side that the flags of the model exclude";
    }
    return NULL;
}

static const char *value_fault(const struct brdf_bsdf *bsdf, struct brdfcl_check_input in)
{
    brdf_rgb f = brdf_eval(bsdf, in.wo, in.wi);
    float pdf = brdf_pdf(bsdf, in.wo, in.wi);
    if (!is_color(f)) {
        return "f is not a number >= 0";
    }
    if (!is_positive_number(pdf)) {
        return "the density is not a number >= 0";
    }
    if (in.wo.z != 0.0f && in.wi.z != 0.0f && !is_allowed(bsdf, in.wo, in.wi) &&
        (!is_black(f) || pdf != 0.0f)) {
        return "f or the density is not 0 where the flags of the model say so";
    }
    return sample_fault(bsdf, in.wo, brdf_sample(bsdf, in.wo, in.u));
}

struct lab_finding lab_try_finite(const struct brdf_bsdf *bsdf, size_t calls,
                                  unsigned long long seed)
{
    struct lab_finding finding = lab_finding_make(LAB_TEST_FINITE, (double)NAN, 0.0);
    struct brdfcl_random random = {seed};
    for (size_t k = 0; k < calls; ++k) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&random);
        const char *fault = value_fault(bsdf, in);
        if (fault && finding.measured == 0.0) {
            snprintf(finding.detail, sizeof finding.detail, "%s", fault);
            lab_finding_note(&finding, in.wo, in.wi, &in.u);
        }
        finding.measured += fault != NULL;
    }
    if (finding.measured == 0.0) {
        snprintf(finding.detail, sizeof finding.detail, "inputs at fault, of %zu", calls);
    }
    lab_finding_judge(&finding);
    return finding;
}

static double apart(float a, float b, float least)
{
    return (double)(fabsf(a - b) / brdf_max(brdf_max(a, b), least));
}

/* Relative, of the channel that differs most; numbers below `least` count as if they were that. */
static double difference(brdf_rgb a, brdf_rgb b, float least)
{
    double red_green = fmax(apart(a.r, b.r, least), apart(a.g, b.g, least));
    return fmax(red_green, apart(a.b, b.b, least));
}

/* 1 where a difference is the largest so far, which is noted; one that is no number stays. */
static int is_worse(struct lab_finding *finding, double found)
{
    int worse = !(found <= finding->measured) && !isnan(finding->measured);
    finding->measured = worse ? found : finding->measured;
    return worse;
}

static void try_pair(struct lab_finding *finding, const struct brdf_bsdf *bsdf, brdf_vec3 wo,
                     brdf_vec3 wi, float eta)
{
    brdf_rgb there = brdf_rgb_scale(brdf_eval(bsdf, wo, wi), eta * eta);
    brdf_rgb back = brdf_eval(bsdf, wi, wo);
    if (is_worse(finding, difference(there, back, 1e-10f))) {
        snprintf(finding->detail, sizeof finding->detail, "relative: f = %.9g there, %.9g back",
                 (double)there.r, (double)back.r);
        lab_finding_note(finding, wo, wi, NULL);
    }
}

struct lab_finding lab_try_reciprocal(const struct brdf_bsdf *bsdf, size_t calls,
                                      unsigned long long seed)
{
    struct lab_finding finding = lab_finding_make(LAB_TEST_RECIPROCAL, (double)NAN, 1e-4);
    if (!(flags_of(bsdf) & BRDF_RECIPROCAL)) {
        lab_finding_set(&finding, LAB_NONE, "the model does not claim it");
        return finding;
    }
    struct brdfcl_random random = {seed};
    int opaque = !(flags_of(bsdf) & BRDF_TRANSMISSION);
    for (size_t k = 0; k < calls; ++k) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&random);
        struct brdf_sample s = brdf_sample(bsdf, in.wo, in.u);
        /* Through the surface only by a sample, which knows eta. */
        if (opaque || (in.wo.z > 0.0f) == (in.wi.z > 0.0f)) {
            try_pair(&finding, bsdf, in.wo, in.wi, 1.0f);
        }
        if (s.pdf > 0.0f && !s.delta) {
            try_pair(&finding, bsdf, in.wo, s.wi, s.eta);
        }
    }
    lab_finding_judge(&finding);
    return finding;
}

/* A sample that carries a millionth of the light may be off by as much as it likes, and a channel
   of it that has a hundredth of its light, by a hundred times as much as the others. */
#define LEAST_WEIGHT 1e-6f
#define LEAST_CHANNEL 1e-2f

static void try_sample(struct lab_finding *finding, const struct brdf_bsdf *bsdf, brdf_vec3 wo,
                       brdf_vec3 u, struct brdf_sample s)
{
    float pdf = brdf_pdf(bsdf, wo, s.wi);
    brdf_rgb f = brdf_eval(bsdf, wo, s.wi);
    brdf_rgb weight = brdf_rgb_scale(f, fabsf(s.wi.z) / brdf_max(pdf, 1e-30f));
    double of_pdf = (double)(fabsf(pdf - s.pdf) / s.pdf);
    if (is_worse(finding, of_pdf)) {
        snprintf(finding->detail, sizeof finding->detail,
                 "relative: sampled with density %.9g, pdf says %.9g", (double)s.pdf, (double)pdf);
        lab_finding_note(finding, wo, s.wi, &u);
    }
    float least = brdf_max(LEAST_WEIGHT, LEAST_CHANNEL * brdf_rgb_largest(s.weight));
    if (of_pdf <= finding->limit && is_worse(finding, difference(weight, s.weight, least))) {
        snprintf(finding->detail, sizeof finding->detail,
                 "relative: weight %.9g, f cos / pdf = %.9g", (double)s.weight.r, (double)weight.r);
        lab_finding_note(finding, wo, s.wi, &u);
    }
}

struct lab_finding lab_try_weight(const struct brdf_bsdf *bsdf, size_t calls,
                                  unsigned long long seed)
{
    struct lab_finding finding = lab_finding_make(LAB_TEST_WEIGHT, (double)NAN, 1e-3);
    struct brdfcl_random random = {seed};
    size_t samples = 0;
    for (size_t k = 0; k < calls; ++k) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&random);
        struct brdf_sample s = brdf_sample(bsdf, in.wo, in.u);
        if (s.pdf > 0.0f && !s.delta) {
            ++samples;
            try_sample(&finding, bsdf, in.wo, in.u, s);
        }
    }
    lab_finding_judge(&finding);
    if (!samples) {
        lab_finding_set(&finding, LAB_NONE, "there are only delta lobes");
    }
    return finding;
}

static brdf_vec3 quarter_turn(brdf_vec3 w)
{
    return brdf_vec3_make(-w.y, w.x, w.z); /* exact */
}

struct lab_finding lab_try_isotropic(const struct brdf_bsdf *bsdf, size_t calls,
                                     unsigned long long seed)
{
    struct lab_finding finding = lab_finding_make(LAB_TEST_ISOTROPIC, (double)NAN, 1e-4);
    if (flags_of(bsdf) & BRDF_ANISOTROPIC) {
        lab_finding_set(&finding, LAB_NONE, "the model does not claim it");
        return finding;
    }
    struct brdfcl_random random = {seed};
    for (size_t k = 0; k < calls; ++k) {
        struct brdfcl_check_input in = brdfcl_check_input_make(&random);
        brdf_rgb f = brdf_eval(bsdf, in.wo, in.wi);
        brdf_rgb turned = brdf_eval(bsdf, quarter_turn(in.wo), quarter_turn(in.wi));
        if (is_worse(&finding, difference(f, turned, 1e-10f))) {
            snprintf(finding.detail, sizeof finding.detail,
                     "relative: f = %.9g, turned by 90 degrees %.9g", (double)f.r,
                     (double)turned.r);
            lab_finding_note(&finding, in.wo, in.wi, NULL);
        }
    }
    lab_finding_judge(&finding);
    return finding;
}
