/*
 * energy.c - albedos by sampling, by quadrature, and against 1.
 */
#include "energy.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <brdf/model.h>

#include "albedo.h"
#include "angle.h"
#include "lattice.h"
#include "pilot.h"

enum { PILOT = 8192, MORE = 8 };

struct view {
    const struct brdf_bsdf *bsdf;
    brdf_vec3 wo;
};

static double mean(brdf_rgb c)
{
    return ((double)c.r + (double)c.g + (double)c.b) / 3.0;
}

static double f_cos(brdf_vec3 wi, void *data)
{
    const struct view *view = data;
    return mean(brdf_eval(view->bsdf, view->wo, wi)) * fabs((double)wi.z);
}

struct lab_energy lab_energy_sampled(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples)
{
    struct lab_lattice lattice = lab_lattice_make(3, 0);
    double sum = 0.0;
    double heavy = 0.0;
    for (size_t i = 0; i < samples; ++i) {
        struct brdf_sample s = brdf_sample(bsdf, wo, lab_lattice_cube(&lattice, i));
        double weight = s.delta ? 0.0 : mean(s.weight);
        sum += weight;
        heavy += pow(fmax(weight - 1.0, 0.0), 2.0);
    }
    struct lab_energy result = {sum / (double)samples, sqrt(heavy) / (double)samples};
    return result;
}

brdf_status lab_energy_integrated(const struct brdf_bsdf *bsdf, brdf_vec3 wo, int finer,
                                  struct lab_sphere_sum *sum, struct brdf_error *error)
{
    struct view view = {bsdf, wo};
    struct lab_sphere *sphere;
    brdf_status status = lab_pilot_fly(bsdf, wo, finer * PILOT, (unsigned)finer, &sphere, error);
    sum->value = sum->error = 0.0;
    if (!status && sphere) {
        /* What is 18 by its parameters may be off by more than what is 1. */
        double scale = fmax(lab_energy_sampled(bsdf, wo, 4096).value, 1.0);
        *sum = lab_sphere_integrate(sphere, f_cos, &view, 1e-4, 1e-3 * scale);
    }
    lab_sphere_destroy(sphere);
    return status;
}

static double angle_of(brdf_vec3 wo)
{
    double sine = sqrt((double)wo.x * (double)wo.x + (double)wo.y * (double)wo.y);
    return atan2(sine, (double)wo.z) * 180.0 / pi;
}

/* Sampling against the integral. */
static void judge_albedo(struct lab_finding *finding, struct lab_energy sampled, double integral)
{
    finding->measured = fabs(sampled.value - integral);
    finding->limit = 1e-3 + 3.0 * sampled.error + 2e-3 * integral;
    snprintf(finding->detail, sizeof finding->detail, "%.5f by sampling, %.5f by quadrature",
             sampled.value, integral);
    lab_finding_judge(finding);
}

/*
 * The same over cells from MORE times as many pilots, which follow samples and not light: of a
 * ridge that few samples carry much light to, coarse cells miss a part without knowing. What
 * depends on the cells even so is no evidence.
 */
static brdf_status second_opinion(const struct brdf_bsdf *bsdf, brdf_vec3 wo,
                                  struct lab_energy sampled, double integral,
                                  struct lab_finding *finding, struct brdf_error *error)
{
    struct lab_sphere_sum other;
    brdf_status status = lab_energy_integrated(bsdf, wo, MORE, &other, error);
    if (status) {
        return status;
    }
    judge_albedo(finding, sampled, other.value);
    if (finding->verdict == LAB_FAIL && (other.error > 0.5 * finding->limit ||
                                         !(fabs(other.value - integral) <= 0.5 * finding->limit))) {
        lab_finding_set(finding, LAB_OPEN,
                        "another integral over other cells: too narrow to be resolved");
    }
    return BRDF_OK;
}

brdf_status lab_try_albedo(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples,
                           struct lab_finding *finding, struct brdf_error *error)
{
    struct lab_sphere_sum integral;
    struct lab_energy sampled = lab_energy_sampled(bsdf, wo, samples);
    brdf_status status = lab_energy_integrated(bsdf, wo, 1, &integral, error);
    *finding = lab_finding_make(LAB_TEST_ALBEDO, angle_of(wo), 0.0);
    if (status) {
        return status;
    }
    judge_albedo(finding, sampled, integral.value);
    if (sampled.value == 0.0 && integral.value == 0.0) {
        lab_finding_set(finding, LAB_NONE, "black but for deltas");
    } else if (integral.error > 0.5 * finding->limit) {
        lab_finding_set(finding, LAB_OPEN, "too narrow to be resolved");
    } else if (finding->verdict == LAB_FAIL) {
        /* A sample in 100,000 may weigh 1000: into a medium that is 30 times thinner. */
        sampled = lab_energy_sampled(bsdf, wo, 64 * samples);
        judge_albedo(finding, sampled, integral.value);
    }
    if (finding->verdict == LAB_FAIL) {
        status = second_opinion(bsdf, wo, sampled, integral.value, finding, error);
    }
    return status;
}

struct lab_finding lab_try_energy(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples)
{
    struct lab_albedo albedo = lab_albedo_at(bsdf, wo, samples);
    struct lab_finding finding = lab_finding_make(LAB_TEST_ENERGY, angle_of(wo), 0.0);
    for (int channel = 0; channel < 3; ++channel) {
        double all = albedo.reflection[channel] + albedo.transmission[channel];
        int more = !(all <= finding.measured) && !isnan(finding.measured);
        finding.measured = more ? all : finding.measured; /* what is not a number stays */
    }
    finding.limit = 1.0 + 1e-3 + 4.0 * albedo.error;
    snprintf(finding.detail, sizeof finding.detail, "of the light leaves again, largest channel");
    lab_finding_judge(&finding);
    int is_measured = (brdf_bsdf_material(bsdf)->flags & BRDF_TABULATED) != 0;
    if (is_measured && finding.verdict == LAB_FAIL && isfinite(finding.measured)) {
        lab_finding_set(&finding, LAB_NOTE,
                        "more light leaves than comes: so it was measured, largest channel");
    }
    return finding;
}
