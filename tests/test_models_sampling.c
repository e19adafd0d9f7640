/*
 * test_models_sampling.c - do the samples of every model have the density that pdf announces?
 *
 * The sphere is cut into cells that follow a pilot of the samples themselves, so that narrow lobes
 * are resolved as well as wide ones; pdf is integrated over each cell by adaptive quadrature, and
 * Pearson's test compares with other samples. Only lobes on which the
 * quadrature does not converge are left out, and counted: of roughconductor, alpha below 3e-4.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_models.h"
#include "support_sphere.h"
#include "statistics.h"

enum { PILOT = 16384, DIRECTIONS = 8 };

/* Of pdf's integral: an error above which cells cannot be told from chance. */
#define UNRESOLVED 2e-4

/* Degrees from the normal; the last ones are from below. */
static const double angles[DIRECTIONS] = {0.0, 30.0, 60.0, 80.0, 88.0, 100.0, 135.0, 180.0};

/* One material seen from one direction. */
struct view {
    const struct model_case *one;
    int number;   /* of the direction */
    double angle; /* degrees */
    brdf_vec3 wo;
    struct sphere *sphere; /* its cells hold the integral of pdf */
    struct sphere_sum mass;
};

static double density(brdf_vec3 w, void *data)
{
    const struct view *view = data;
    return (double)brdf_pdf(&view->one->bsdf, view->wo, w);
}

static brdf_vec3 random_cube(struct brdfcl_random *random)
{
    float x = brdfcl_random_uniform(random);
    float y = brdfcl_random_uniform(random);
    return brdf_vec3_make(x, y, brdfcl_random_uniform(random));
}

static brdf_vec3 direction_of(int number)
{
    double theta = angles[number] * 3.14159265358979323846 / 180.0;
    double phi = 0.4 + number;
    double radius = angles[number] == 180.0 ? 0.0 : sin(theta);
    return brdf_normalize(
        brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cos(theta)));
}

/* Cells from pilot `pilots` of samples; 0 if there is nothing but deltas, or nothing at all. */
static int view_open(struct view *view, const struct model_case *one, int number,
                     unsigned long long pilots)
{
    view->one = one;
    view->number = number;
    view->angle = angles[number];
    view->wo = direction_of(number);
    view->sphere = NULL;
    if (view->wo.z < 0.0f && !models_seen_from_below(one)) {
        return 0;
    }
    struct brdfcl_random random = {(pilots << 20) + (unsigned long long)number};
    brdf_vec3 *pilot = calloc(PILOT, sizeof *pilot);
    assert_non_null(pilot);
    size_t count = 0;
    for (int i = 0; i < PILOT; ++i) {
        brdf_vec3 u = random_cube(&random);
        u.z = i % 16 ? u.z : 1e-3f * u.z; /* z chooses among lobes: rare ones need a pilot too */
        struct brdf_sample s = brdf_sample(&one->bsdf, view->wo, u);
        if (s.pdf > 0.0f && !s.delta) {
            pilot[count++] = s.wi;
        }
    }
    if (count) {
        view->sphere = sphere_create(pilot, count);
        view->mass = sphere_integrate(view->sphere, density, view, 1e-3, UNRESOLVED);
    }
    free(pilot);
    return count > 0;
}

/* The chance of a sample that pdf knows of: what the integral of pdf should be. */
static double chance_of_sample(const struct view *view)
{
    size_t samples = models_long() ? 1000000 : 32768;
    size_t found = 0;
    for (size_t k = 0; k < samples; ++k) {
        brdf_vec3 u = models_even_point(k, samples);
        struct brdf_sample s = brdf_sample(&view->one->bsdf, view->wo, u);
        found += s.pdf > 0.0f && !s.delta;
    }
    return (double)found / (double)samples;
}

/*
 * Count samples in cells; returns how many there were. The long form takes a million of the
 * materials that are described in words; random ones have ridges so thin that a million would test
 * the quadrature.
 */
static double count_samples(const struct view *view, struct statistics_bin *bins)
{
    struct brdfcl_random random = {0xc2};
    size_t samples = models_long() && view->one->is_made ? 1000000 : 100000;
    double found = 0.0;
    for (size_t k = 0; k < samples; ++k) {
        struct brdf_sample s = brdf_sample(&view->one->bsdf, view->wo, random_cube(&random));
        if (s.pdf > 0.0f && !s.delta) {
            bins[sphere_find(view->sphere, s.wi)].observed += 1.0;
            found += 1.0;
        }
    }
    return found;
}

static struct statistics_chi2 chi2_of_samples(const struct view *view)
{
    size_t count = view->sphere->count;
    struct statistics_bin *bins = calloc(count, sizeof *bins);
    assert_non_null(bins);
    double found = count_samples(view, bins);
    for (size_t i = 0; i < count; ++i) {
        const struct sphere_node *node = &view->sphere->nodes[i];
        bins[i].expected = node->child < 0 ? found * node->integral / view->mass.value : 0.0;
    }
    struct statistics_chi2 result = statistics_chi2_test(bins, count);
    free(bins);
    return result;
}

/*
 * Does pdf integrate to the same over other cells? Over a ridge a thousand times thinner than long
 * the quadrature can err without knowing; a wrong sampler or a wrong pdf does not depend on cells.
 */
static int is_resolved(const struct view *view)
{
    struct view other;
    if (!view_open(&other, view->one, view->number, 2)) {
        return 1;
    }
    int agrees = fabs(other.mass.value - view->mass.value) <= 5.0 * UNRESOLVED;
    sphere_destroy(other.sphere);
    return agrees;
}

/* Mass and distribution of one view; 0 if the quadrature is not good enough to tell. */
static int check_view(struct model_cases *cases, const struct view *view)
{
    if (view->mass.error > UNRESOLVED) {
        return 0;
    }
    double limit = statistics_sidak(0.01, models_case_count() * DIRECTIONS);
    double chance = chance_of_sample(view);
    struct statistics_chi2 result = chi2_of_samples(view);
    int mass_is_wrong = !(fabs(view->mass.value - chance) <= 2e-3);
    int cells_are_wrong = result.impossible || !(result.p >= limit);
    if ((mass_is_wrong || cells_are_wrong) && !is_resolved(view)) {
        return 0;
    }
    if (mass_is_wrong) {
        models_fail(cases, view->one,
                    "%g degrees: pdf integrates to %.5f, but the chance of a sample is %.5f",
                    view->angle, view->mass.value, chance);
    }
    if (cells_are_wrong) {
        models_fail(cases, view->one,
                    "%g degrees: chi2 = %.1f with %zu degrees of freedom, p = %.3g < %.3g%s",
                    view->angle, result.chi2, result.freedom, result.p, limit,
                    result.impossible ? "; samples where pdf is 0" : "");
    }
    return 1;
}

/* The initial parameters from every direction, others from every second one in turns. */
static void samples_have_the_density(void **state)
{
    struct model_cases *cases = *state;
    size_t views = 0;
    size_t unresolved = 0;
    for (size_t i = 0; i < cases->count; ++i) {
        for (int number = 0; number < DIRECTIONS; ++number) {
            struct view view;
            int taken = i == 0 || models_long() || (i + (size_t)number) % 2 == 0;
            if (!taken || !view_open(&view, &cases->items[i], number, 1)) {
                continue;
            }
            ++views;
            unresolved += !check_view(cases, &view);
            sphere_destroy(view.sphere);
        }
    }
    print_message("%s: %zu views, of which %zu are too narrow to be resolved\n", cases->model->name,
                  views, unresolved);
    if (2 * unresolved > views) {
        models_fail(cases, &cases->items[0], "too little could be checked");
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
