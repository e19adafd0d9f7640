/*
 * test_models_values.c - what every value of every model must be: finite, non-negative, reciprocal,
 * consistent with the others and with the flags.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "support_models.h"

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

static void show_input(char *text, size_t size, struct brdfcl_check_input in)
{
    snprintf(text, size, "wo %.9g/%.9g/%.9g wi %.9g/%.9g/%.9g u %.9g/%.9g/%.9g", (double)in.wo.x,
             (double)in.wo.y, (double)in.wo.z, (double)in.wi.x, (double)in.wi.y, (double)in.wi.z,
             (double)in.u.x, (double)in.u.y, (double)in.u.z);
}

/* Is the pair on sides of the surface that the model's flags allow? */
static int is_allowed(const struct model_case *one, brdf_vec3 wo, brdf_vec3 wi)
{
    unsigned flags = one->bsdf.material.flags;
    int same_side = (wo.z > 0.0f) == (wi.z > 0.0f);
    if (wo.z < 0.0f && !models_seen_from_below(one)) {
        return 0;
    }
    return (flags & (same_side ? BRDF_REFLECTION : BRDF_TRANSMISSION)) != 0;
}

static const char *sample_fault(const struct model_case *one, brdf_vec3 wo, struct brdf_sample s)
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
    if (!is_black(s.weight) && !is_allowed(one, wo, s.wi)) {
        return "a sample on a side that the flags of the model exclude";
    }
    return NULL;
}

static const char *value_fault(const struct model_case *one, struct brdfcl_check_input in)
{
    brdf_rgb f = brdf_eval(&one->bsdf, in.wo, in.wi);
    float pdf = brdf_pdf(&one->bsdf, in.wo, in.wi);
    if (!is_color(f)) {
        return "f is not a number >= 0";
    }
    if (!is_positive_number(pdf)) {
        return "the density is not a number >= 0";
    }
    if (in.wo.z != 0.0f && in.wi.z != 0.0f && !is_allowed(one, in.wo, in.wi) &&
        (!is_black(f) || pdf != 0.0f)) {
        return "f or the density is not 0 where the flags of the model say so";
    }
    return sample_fault(one, in.wo, brdf_sample(&one->bsdf, in.wo, in.u));
}

/* A million calls a model (ten in the long form), at limits of everything half of the time. */
static void finite_and_not_negative(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {11};
    size_t calls = (models_long() ? 10000000 : 1000000) / (3 * cases->count) + 1;
    for (size_t i = 0; i < cases->count; ++i) {
        const struct model_case *one = &cases->items[i];
        for (size_t k = 0; k < calls; ++k) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            const char *fault = value_fault(one, in);
            if (fault) {
                char text[256];
                show_input(text, sizeof text, in);
                models_fail(cases, one, "%s: %s", fault, text);
            }
        }
    }
    models_verdict(cases);
}

static float difference(brdf_rgb a, brdf_rgb b)
{
    float r = fabsf(a.r - b.r) / brdf_max(brdf_max(a.r, b.r), 1e-10f);
    float g = fabsf(a.g - b.g) / brdf_max(brdf_max(a.g, b.g), 1e-10f);
    return brdf_max(brdf_max(r, g), fabsf(a.b - b.b) / brdf_max(brdf_max(a.b, b.b), 1e-10f));
}

/* f(wo, wi) eta^2 = f(wi, wo), eta being the index of wi's side over that of wo's [Veach
 * 1997, 5.2].
 */
static void check_reciprocal(struct model_cases *cases, const struct model_case *one, brdf_vec3 wo,
                             brdf_vec3 wi, float eta)
{
    brdf_rgb there = brdf_rgb_scale(brdf_eval(&one->bsdf, wo, wi), eta * eta);
    brdf_rgb back = brdf_eval(&one->bsdf, wi, wo);
    if (difference(there, back) > 1e-4f) {
        models_fail(cases, one, "%.9g there, %.9g back: wo %.9g/%.9g/%.9g wi %.9g/%.9g/%.9g",
                    (double)there.r, (double)back.r, (double)wo.x, (double)wo.y, (double)wo.z,
                    (double)wi.x, (double)wi.y, (double)wi.z);
    }
}

static void reciprocal_where_announced(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {12};
    for (size_t i = 0; i < cases->count; ++i) {
        const struct model_case *one = &cases->items[i];
        int one_sided = !(one->bsdf.material.flags & BRDF_TRANSMISSION);
        for (int k = 0; k < 20000; ++k) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            struct brdf_sample s = brdf_sample(&one->bsdf, in.wo, in.u);
            /* Through the surface only by a sample, which knows eta. */
            if ((in.wo.z > 0.0f) == (in.wi.z > 0.0f) || one_sided) {
                check_reciprocal(cases, one, in.wo, in.wi, 1.0f);
            }
            if (s.pdf > 0.0f && !s.delta) {
                check_reciprocal(cases, one, in.wo, s.wi, s.eta);
            }
        }
    }
    models_verdict(cases);
}

/* f |cos| / pdf and the density itself, as the other two functions have them. */
static void check_weight(struct model_cases *cases, const struct model_case *one, brdf_vec3 wo,
                         brdf_vec3 u)
{
    struct brdf_sample s = brdf_sample(&one->bsdf, wo, u);
    if (s.pdf <= 0.0f || s.delta) {
        return;
    }
    float pdf = brdf_pdf(&one->bsdf, wo, s.wi);
    brdf_rgb f = brdf_eval(&one->bsdf, wo, s.wi);
    brdf_rgb weight = brdf_rgb_scale(f, fabsf(s.wi.z) / brdf_max(pdf, 1e-30f));
    if (fabsf(pdf - s.pdf) > 1e-3f * s.pdf) {
        models_fail(cases, one,
                    "sampled with density %.9g, which pdf says is %.9g; wo %.9g/%.9g/%.9g"
                    " wi %.9g/%.9g/%.9g",
                    (double)s.pdf, (double)pdf, (double)wo.x, (double)wo.y, (double)wo.z,
                    (double)s.wi.x, (double)s.wi.y, (double)s.wi.z);
    } else if (difference(weight, s.weight) > 1e-3f) {
        models_fail(cases, one,
                    "weight %.9g, but f cos / pdf = %.9g; wo %.9g/%.9g/%.9g wi "
                    "%.9g/%.9g/%.9g",
                    (double)s.weight.r, (double)weight.r, (double)wo.x, (double)wo.y, (double)wo.z,
                    (double)s.wi.x, (double)s.wi.y, (double)s.wi.z);
    }
}

static void weight_is_f_cos_over_pdf(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {13};
    for (size_t i = 0; i < cases->count; ++i) {
        for (int k = 0; k < 20000; ++k) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            check_weight(cases, &cases->items[i], in.wo, in.u);
        }
    }
    models_verdict(cases);
}

static brdf_vec3 quarter_turn(brdf_vec3 w)
{
    return brdf_vec3_make(-w.y, w.x, w.z); /* exact */
}

static void isotropic_unless_announced(void **state)
{
    struct model_cases *cases = *state;
    struct brdfcl_random random = {14};
    for (size_t i = 0; i < cases->count; ++i) {
        const struct model_case *one = &cases->items[i];
        for (int k = 0; k < 10000; ++k) {
            struct brdfcl_check_input in = brdfcl_check_input_make(&random);
            brdf_rgb f = brdf_eval(&one->bsdf, in.wo, in.wi);
            brdf_rgb turned = brdf_eval(&one->bsdf, quarter_turn(in.wo), quarter_turn(in.wi));
            if (difference(f, turned) > 1e-4f) {
                char text[256];
                show_input(text, sizeof text, in);
                models_fail(cases, one, "f = %.9g, turned by 90 degrees %.9g: %s", (double)f.r,
                            (double)turned.r, text);
            }
        }
    }
    models_verdict(cases);
}

/* What the case says of itself makes the same bytes again: reflection, text and parser agree. */
static void described_and_made_again(void **state)
{
    struct model_cases *cases = *state;
    for (size_t i = 0; i < cases->count; ++i) {
        const struct model_case *one = &cases->items[i];
        if (one->bsdf.table && i > 1) {
            break; /* reading the table again and again takes long */
        }
        struct brdf_bsdf *again;
        struct brdf_error error;
        char text[1024];
        brdfcl_check_material_describe(&one->bsdf.material, cases->model, text, sizeof text);
        if (brdfcl_check_bsdf_create(text, &again, &error)) {
            models_fail(cases, one, "%s", error.message);
            continue;
        }
        if (memcmp(&again->material, &one->bsdf.material, sizeof again->material) != 0) {
            models_fail(cases, one, "made again from %s, its bytes differ", text);
        }
        brdf_bsdf_destroy(again);
    }
    models_verdict(cases);
}

int main(void)
{
    const struct model_check checks[] = {
        {"finite and not negative", finite_and_not_negative, 0, 0},
        {"reciprocal where announced", reciprocal_where_announced, BRDF_RECIPROCAL, 0},
        {"weight is f cos / pdf", weight_is_f_cos_over_pdf, 0, 0},
        {"isotropic unless announced", isotropic_unless_announced, 0, BRDF_ANISOTROPIC},
        {"described and made again", described_and_made_again, 0, 0},
    };
    return models_run(checks, sizeof checks / sizeof checks[0]);
}
