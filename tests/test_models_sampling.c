/*
 * test_models_sampling.c - do the samples of every model have the density that pdf announces?
 *
 * brdflab/density.h over every case and direction; in the long form with a million samples. Only
 * lobes on which its quadrature does not converge are left out, and counted: of roughdielectric two
 * ridges 20000 times longer than wide.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "density.h"
#include "statistics.h"
#include "support_models.h"

/* The initial parameters from every direction, others from every third one in turns. */
static void samples_have_the_density(void **state)
{
    struct model_cases *cases = *state;
    double limit = lab_sidak(0.01, lab_suite_comparisons());
    size_t views = 0;
    size_t unresolved = 0;
    size_t samples = models_long() ? 1000000 : 100000;
    for (size_t i = 0; i < cases->set.count; ++i) {
        const struct lab_case *one = &cases->set.items[i];
        for (int number = 0; number < LAB_VIEWS; ++number) {
            struct lab_density found;
            if (i > 0 && !models_long() && (i + (size_t)number) % 3 != 0) {
                continue;
            }
            assert_int_equal(lab_try_density(&one->bsdf, number, samples, i, limit, &found, NULL),
                             BRDF_OK);
            views += found.chi2.verdict != LAB_NONE;
            unresolved += found.chi2.verdict == LAB_OPEN;
            models_expect(cases, one, &found.mass);
            models_expect(cases, one, &found.chi2);
        }
    }
    print_message("%s: %zu views, of which %zu are too narrow to be resolved\n",
                  cases->set.model->name, views, unresolved);
    if (2 * unresolved > views) {
        models_fail(cases, &cases->set.items[0], "too little could be checked");
    }
    models_verdict(cases);
}

int main(void)
{
    const struct model_check checks[] = {
        {"samples have the density (mass and chi-square)", samples_have_the_density, 0, BRDF_DELTA},
    };
    return models_run(checks, sizeof checks / sizeof checks[0]);
}
