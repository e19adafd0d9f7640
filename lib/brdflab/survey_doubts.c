/* survey_doubts.c - where a measurement is not to be believed, in words. */
#include "survey.h"

#include <stdio.h>

/* Each writes a sentence and returns 1 if there is something to doubt. */
typedef int doubt(const struct lab_findings *findings, char *text, size_t size);

static int energy_above_one(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_survey *s = findings->all;
    snprintf(text, size,
             "reflects more than it receives from %g degrees on: an albedo of %.3f at %g degrees",
             s->energy_from, s->energy, s->energy_angle);
    return s->energy_from < 90.0;
}

static int not_reciprocal(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_survey *s = findings->all;
    snprintf(text, size,
             "exchanging viewer and light changes f by %.1f %% on average: it was measured in "
             "one order, and the other is not what the sample does",
             100.0 * s->reciprocity);
    return s->reciprocity > 0.1;
}

static int not_measured(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_merl_survey *m = findings->merl;
    if (!m || m->above_invalid == 0) {
        return 0;
    }
    snprintf(
        text, size,
        "%zu bins above the surface were not measured (%.2f %%), from %.1f degrees on: they %s",
        m->above_invalid, 100.0 * (double)m->above_invalid / (double)m->above, m->invalid_from,
        findings->fill ? "are filled from their neighbours" : "count as 0");
    return 1;
}

static int unlike_halves(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_merl_survey *m = findings->merl;
    if (!m || m->folding < 0.1) {
        return 0;
    }
    snprintf(text, size,
             "the half turns of phi_d that reciprocity makes equal differ by %.1f %% in the file: "
             "their mean is used",
             100.0 * m->folding);
    return 1;
}

static int black_bins(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_merl_survey *m = findings->merl;
    if (!m || m->zero == 0) {
        return 0;
    }
    snprintf(text, size,
             "%zu measured bins are exactly 0 in some channel (%.2f %%): too dark to be measured, "
             "or never measured and not marked so",
             m->zero, 100.0 * (double)m->zero / (double)m->valid);
    return 1;
}

static int peak_at_grazing(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_merl_survey *m = findings->merl;
    if (!m || m->most_at.theta_h < 10.0) {
        return 0;
    }
    snprintf(text, size,
             "the largest value, %.4g 1/sr, is far from the highlight (theta_h %.1f, theta_d %.1f "
             "degrees)",
             m->most, m->most_at.theta_h, m->most_at.theta_d);
    return 1;
}

static int peak_of_horizon(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_rgl_survey *r = findings->rgl;
    if (!r || r->most_at.theta_i < 88.0) {
        return 0;
    }
    snprintf(
        text, size,
        "the largest value, %.4g 1/sr, is at the horizon (wi at %.2f degrees), where the file's "
        "f cos is divided by next to nothing",
        r->most, r->most_at.theta_i);
    return 1;
}

static int noisy(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_merl_survey *m = findings->merl;
    if (!m || (m->noise < 0.05 && m->noise_grazing < 0.05)) {
        return 0;
    }
    snprintf(text, size,
             "noise from bin to bin: %.1f %% of f where both directions are within 60 degrees of "
             "the normal, %.1f %% beyond",
             100.0 * m->noise, 100.0 * m->noise_grazing);
    return 1;
}

static int out_of_gamut(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_rgl_survey *r = findings->rgl;
    if (!r || r->negative <= 0.0) {
        return 0;
    }
    snprintf(
        text, size,
        "%.2f %% of the values are below 0, colours that Rec. 709 does not have: they count as 0",
        100.0 * r->negative);
    return 1;
}

static int not_measured_at_grazing(const struct lab_findings *findings, char *text, size_t size)
{
    const struct lab_rgl_survey *r = findings->rgl;
    if (!r || r->theta_most > 89.0) {
        return 0;
    }
    snprintf(text, size, "measured up to %.1f degrees: beyond, that view stands in", r->theta_most);
    return 1;
}

const char *lab_survey_doubt(const struct lab_findings *findings, int number, char *text,
                             size_t size)
{
    static doubt *const doubts[] = {
        energy_above_one, not_reciprocal,  not_measured, unlike_halves, black_bins,
        peak_at_grazing,  peak_of_horizon, noisy,        out_of_gamut,  not_measured_at_grazing};
    for (size_t i = 0; i < sizeof doubts / sizeof doubts[0]; ++i) {
        if (doubts[i](findings, text, size) && number-- == 0) {
            return text;
        }
    }
    return NULL;
}
