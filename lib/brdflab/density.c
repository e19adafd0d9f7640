/*
 * density.c - mass of the density, and Pearson's test of samples against it.
 */
#include "density.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <brdf/model.h>

#include "angle.h"
#include "lattice.h"
#include "pilot.h"
#include "sphere.h"
#include "statistics.h"

enum { PILOT = 16384, MORE = 8 };

/* Of pdf's integral: an error above which cells cannot be told from chance. */
#define UNRESOLVED 2e-4

const double lab_view_angle[LAB_VIEWS] = {0.0, 30.0, 60.0, 80.0, 88.0, 100.0, 135.0, 180.0};

/* One material seen from one direction. */
struct view {
    const struct brdf_bsdf *bsdf;
    int number; /* of the direction */
    brdf_vec3 wo;
    struct lab_sphere *sphere; /* its cells hold the integral of pdf; NULL if there is nothing */
    struct lab_sphere_sum mass;
};

brdf_vec3 lab_view_direction(int number)
{
    double theta = lab_view_angle[number] * pi / 180.0;
    double phi = 0.4 + number;
    double radius = lab_view_angle[number] == 180.0 ? 0.0 : sin(theta);
    return brdf_normalize(
        brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)), (float)cos(theta)));
}

int lab_view_count(unsigned flags)
{
    int inside = (flags & (BRDF_TRANSMISSION | BRDF_TWOSIDED)) != 0;
    int count = 0;
    while (count < LAB_VIEWS && (lab_view_angle[count] < 90.0 || inside)) {
        ++count;
    }
    return count;
}

static double density(brdf_vec3 w, void *data)
{
    const struct view *view = data;
    return (double)brdf_pdf(view->bsdf, view->wo, w);
}

/* Cells from a pilot of so many samples; so many others watch for peaks, none if that is 0. */
static brdf_status view_open(struct view *view, const struct brdf_bsdf *bsdf, int number,
                             int pilots, size_t watch, struct brdf_error *error)
{
    view->bsdf = bsdf;
    view->number = number;
    view->wo = lab_view_direction(number);
    view->mass.value = view->mass.error = 0.0;
    unsigned long long seed = ((unsigned long long)pilots << 20) + (unsigned long long)number;
    brdf_status status = lab_pilot_fly(bsdf, view->wo, pilots, seed, &view->sphere, error);
    if (!status && view->sphere && watch) {
        status = lab_pilot_watch(bsdf, view->wo, watch, ~seed, view->sphere, error);
    }
    if (!status && view->sphere) {
        view->mass = lab_sphere_integrate(view->sphere, density, view, 1e-3, UNRESOLVED);
    }
    return status;
}

/* The chance of a sample that pdf knows of: what the integral of pdf should be. */
static double chance_of_sample(const struct view *view, size_t samples)
{
    struct lab_lattice lattice = lab_lattice_make(3, 0);
    size_t found = 0;
    for (size_t k = 0; k < samples; ++k) {
        struct brdf_sample s = brdf_sample(view->bsdf, view->wo, lab_lattice_cube(&lattice, k));
        found += s.pdf > 0.0f && !s.delta;
    }
    return (double)found / (double)samples;
}

/* Count samples in cells; returns how many there were. */
static double count_samples(const struct view *view, size_t samples, unsigned long long seed,
                            struct lab_bin *bins)
{
    struct brdfcl_random random = {0xc2 + 0x9e3779b97f4a7c15ull * (LAB_VIEWS * seed + 1) +
                                   (unsigned long long)view->number};
    double found = 0.0;
    for (size_t k = 0; k < samples; ++k) {
        struct brdf_sample s = brdf_sample(view->bsdf, view->wo, lab_random_cube(&random));
        if (s.pdf > 0.0f && !s.delta) {
            bins[lab_sphere_find(view->sphere, s.wi)].observed += 1.0;
            found += 1.0;
        }
    }
    return found;
}

/* The middle of the cell that departs most from what is expected there. */
static brdf_vec3 worst_cell(const struct lab_sphere *sphere, const struct lab_bin *bins)
{
    size_t worst = 0;
    double most = -1.0;
    for (size_t i = 0; i < sphere->count; ++i) {
        double apart = bins[i].observed - bins[i].expected;
        double chi2 = apart * apart / fmax(bins[i].expected, 1.0);
        worst = chi2 > most ? i : worst;
        most = fmax(most, chi2);
    }
    const struct lab_sphere_node *node = &sphere->nodes[worst];
    double q = 0.5 * (node->low[0] + node->high[0]);
    double phi = pi * (node->low[1] + node->high[1]);
    double radius = 2.0 * sqrt(q * (1.0 - q));
    return brdf_vec3_make((float)(radius * cos(phi)), (float)(radius * sin(phi)),
                          (float)(1.0 - 2.0 * q));
}

static brdf_status find_chi2(const struct view *view, size_t samples, unsigned long long seed,
                             struct lab_density *result, struct brdf_error *error)
{
    struct lab_finding *finding = &result->chi2;
    size_t count = view->sphere->count;
    struct lab_bin *bins = calloc(count, sizeof *bins);
    if (!bins) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu bins", count);
    }
    double found = count_samples(view, samples, seed, bins);
    for (size_t i = 0; i < count; ++i) {
        const struct lab_sphere_node *node = &view->sphere->nodes[i];
        bins[i].expected = node->child < 0 ? found * node->integral / view->mass.value : 0.0;
    }
    lab_finding_note(finding, view->wo, worst_cell(view->sphere, bins), NULL);
    struct lab_chi2 chi2 = lab_chi2_test(bins, count);
    free(bins);
    result->departure = chi2.chi2 - (double)chi2.freedom;
    finding->measured = chi2.impossible ? 0.0 : chi2.p;
    snprintf(finding->detail, sizeof finding->detail, "p: chi2 = %.1f, %zu degrees of freedom%s",
             chi2.chi2, chi2.freedom, chi2.impossible ? "; samples where pdf is 0" : "");
    lab_finding_judge(finding);
    return BRDF_OK;
}

static brdf_status find_both(const struct view *view, size_t samples, unsigned long long seed,
                             struct lab_density *result, struct brdf_error *error)
{
    double chance = chance_of_sample(view, samples / 4 + 16384);
    result->mass.measured = fabs(view->mass.value - chance);
    snprintf(result->mass.detail, sizeof result->mass.detail,
             "pdf integrates to %.5f, the chance of a sample is %.5f", view->mass.value, chance);
    lab_finding_judge(&result->mass);
    return find_chi2(view, samples, seed, result, error);
}

static int is_doubtful(const struct lab_density *result)
{
    return result->mass.verdict == LAB_FAIL || result->chi2.verdict == LAB_FAIL;
}

/*
 * The same over cells from MORE times as many pilots, with as many watching for peaks as samples
 * are counted. Of a ridge hundreds of times thinner than long, a cell may hold a tip that falls
 * between the places where pdf is asked for; then other cells have other answers. A wrong sampler
 * or a wrong pdf does not depend on cells.
 */
static brdf_status second_opinion(const struct view *view, size_t samples, unsigned long long seed,
                                  struct lab_density *result, struct brdf_error *error)
{
    static const char reason[] = "depends on the cells: too narrow to be resolved";
    struct view other;
    double departure = result->departure;
    brdf_status status = view_open(&other, view->bsdf, view->number, MORE * PILOT, samples, error);
    if (!status && other.sphere) {
        status = find_both(&other, samples, seed, result, error);
    }
    if (!status && is_doubtful(result) &&
        (!(fabs(other.mass.value - view->mass.value) <= 5.0 * UNRESOLVED) ||
         other.mass.error > UNRESOLVED || result->departure < 0.5 * departure)) {
        lab_finding_set(&result->mass, LAB_OPEN, reason);
        lab_finding_set(&result->chi2, LAB_OPEN, reason);
    }
    lab_sphere_destroy(other.sphere);
    return status;
}

brdf_status lab_try_density(const struct brdf_bsdf *bsdf, int number, size_t samples,
                            unsigned long long seed, double limit, struct lab_density *result,
                            struct brdf_error *error)
{
    struct view view;
    result->mass = lab_finding_make(LAB_TEST_MASS, lab_view_angle[number], 2e-3);
    result->chi2 = lab_finding_make(LAB_TEST_CHI2, lab_view_angle[number], limit);
    result->chi2.at_least = 1;
    brdf_status status = view_open(&view, bsdf, number, PILOT, 0, error);
    if (!status && !view.sphere) {
        lab_finding_set(&result->mass, LAB_NONE, "no samples but deltas");
        lab_finding_set(&result->chi2, LAB_NONE, "no samples but deltas");
    } else if (!status && view.mass.error > UNRESOLVED) {
        lab_finding_set(&result->mass, LAB_OPEN, "too narrow to be resolved");
        lab_finding_set(&result->chi2, LAB_OPEN, "too narrow to be resolved");
    } else if (!status) {
        status = find_both(&view, samples, seed, result, error);
        if (!status && is_doubtful(result)) {
            status = second_opinion(&view, samples, seed, result, error);
        }
    }
    lab_sphere_destroy(view.sphere);
    return status;
}
