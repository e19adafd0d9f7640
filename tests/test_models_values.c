/*
 * test_models_values.c - what every value of every model must be: finite, non-negative, reciprocal,
 * consistent with the others and with the flags (brdflab/values.h).
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_models.h"
#include "values.h"

typedef struct lab_finding try_function(const struct brdf_bsdf *bsdf, size_t calls,
                                        unsigned long long seed);

static void try_all(struct model_cases *cases, try_function *try, size_t calls,
                    unsigned long long seed)
{
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        struct lab_finding finding = try(&one->bsdf, calls, seed + (i << 8));
        models_expect(cases, one, &finding);
    }
    models_verdict(cases);
}

/* A million calls a model (ten in the long form), at limits of everything half of the time. */
static void finite_and_not_negative(void **state)
{
    struct model_cases *cases = *state;
    size_t calls = (models_long() ? 10000000 : 1000000) / (3 * cases->set.count) + 1;
    try_all(cases, lab_try_finite, calls, 11);
}

static void reciprocal_where_announced(void **state)
{
    try_all(*state, lab_try_reciprocal, 20000, 12);
}

static void weight_is_f_cos_over_pdf(void **state)
{
    try_all(*state, lab_try_weight, 20000, 13);
}

static void isotropic_unless_announced(void **state)
{
    try_all(*state, lab_try_isotropic, 10000, 14);
}

/* What the case says of itself makes the same bytes again: reflection, text and parser agree. */
static void described_and_made_again(void **state)
{
    struct model_cases *cases = *state;
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        if (one->bsdf.table && i > 1) {
            break; /* reading the table again and again takes long */
        }
        struct brdf_bsdf *again;
        struct brdf_error error;
        char text[1024];
        brdfcl_check_material_describe(&one->bsdf.material, cases->set.model, text, sizeof text);
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
