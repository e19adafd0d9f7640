/* section.c - where the light of a plane of incidence goes. */
#include "section.h"

#include <math.h>
#include <stdlib.h>

#include <brdf/model.h>

#include "angle.h"
#include "lattice.h"

double lab_channel_of(enum lab_channel channel, brdf_rgb color)
{
    switch (channel) {
    case LAB_CHANNEL_RED:
        return (double)color.r;
    case LAB_CHANNEL_GREEN:
        return (double)color.g;
    case LAB_CHANNEL_BLUE:
        return (double)color.b;
    default:
        return (double)brdf_rgb_luminance(color);
    }
}

brdf_vec3 lab_section_direction(const struct lab_section *section, double theta)
{
    double s = sin(theta);
    return brdf_vec3_make((float)(s * cos(section->azimuth)), (float)(s * sin(section->azimuth)),
                          (float)cos(theta));
}

brdf_vec3 lab_section_light(const struct lab_section *section)
{
    return lab_section_direction(section, -section->incidence);
}

double lab_section_f(const struct lab_section *section, double theta)
{
    brdf_vec3 wo = lab_section_direction(section, theta);
    return lab_channel_of(section->channel,
                          brdf_eval(section->bsdf, wo, lab_section_light(section)));
}

double lab_section_lobe(const struct lab_section *section, double theta)
{
    return lab_section_f(section, theta) * fabs(cos(theta));
}

double lab_section_low(void)
{
    return -0.5 * pi;
}

double lab_section_high(int transmits)
{
    return transmits ? 1.5 * pi : 0.5 * pi;
}

/* The angle from the normal of a direction, on the side of the plane that it is nearer to. */
static double angle_of(const struct lab_section *section, brdf_vec3 w)
{
    double along = (double)w.x * cos(section->azimuth) + (double)w.y * sin(section->azimuth);
    double theta = atan2(hypot((double)w.x, (double)w.y), (double)w.z);
    double angle = along < 0.0 ? -theta : theta;
    return angle < lab_section_low() ? angle + 2.0 * pi : angle;
}

/* Sample i of the light's beam. Sampling starts from a wo, and by reciprocity that is the light. */
static struct brdf_sample sample_at(const struct lab_section *section, size_t i)
{
    struct lab_lattice lattice = lab_lattice_make(3, 1);
    brdf_vec3 u = lab_lattice_cube(&lattice, i);
    return brdf_sample(section->bsdf, lab_section_light(section), u);
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a;
    double y = *(const double *)b;
    return (x > y) - (x < y);
}

int lab_section_seeds(const struct lab_section *section, double seed[LAB_SECTION_SEEDS])
{
    int count = 0;
    for (size_t i = 0; i < LAB_SECTION_SEEDS - 1; ++i) {
        struct brdf_sample s = sample_at(section, i);
        if (s.pdf > 0.0f && !s.delta) {
            seed[count++] = angle_of(section, s.wi);
        }
    }
    seed[count++] = section->incidence; /* where a mirror sends it */
    qsort(seed, (size_t)count, sizeof seed[0], ascending);
    return count;
}

/* The largest value between two angles, by golden sections: one peak at most lies between them. */
static double climb(const struct lab_section *section, double f(const struct lab_section *, double),
                    double low, double high)
{
    const double golden = 0.61803398874989485;
    double a = high - golden * (high - low);
    double b = low + golden * (high - low);
    double fa = f(section, a);
    double fb = f(section, b);
    for (int i = 0; i < 40; ++i) {
        if (fa > fb) {
            high = b;
            b = a;
            fb = fa;
            a = high - golden * (high - low);
            fa = f(section, a);
        } else {
            low = a;
            a = b;
            fa = fb;
            b = low + golden * (high - low);
            fb = f(section, b);
        }
    }
    return fa > fb ? fa : fb;
}

double lab_section_peak(const struct lab_section *section, int cosine, double low, double high)
{
    enum { GRID = 180 };
    double (*f)(const struct lab_section *, double) = cosine ? lab_section_lobe : lab_section_f;
    double angle[LAB_SECTION_SEEDS + GRID + 1];
    int count = lab_section_seeds(section, angle);
    for (int i = 0; i <= GRID; ++i) {
        angle[count++] = low + (high - low) * i / GRID;
    }
    qsort(angle, (size_t)count, sizeof angle[0], ascending);
    double best = 0.0;
    int at = 0;
    for (int i = 0; i < count; ++i) {
        double value = angle[i] < low || angle[i] > high ? 0.0 : f(section, angle[i]);
        if (value > best) {
            best = value;
            at = i;
        }
    }
    double from = at > 0 ? fmax(low, angle[at - 1]) : low;
    double to = at < count - 1 ? fmin(high, angle[at + 1]) : high;
    return fmax(best, climb(section, f, from, to));
}

int lab_section_deltas(const struct lab_section *section,
                       struct lab_delta delta[LAB_SECTION_DELTAS])
{
    int count = 0;
    for (size_t i = 0; i < 1024; ++i) {
        struct brdf_sample s = sample_at(section, i);
        if (!s.delta || !(s.pdf > 0.0f)) {
            continue;
        }
        double theta = angle_of(section, s.wi);
        int k = 0;
        while (k < count && fabs(delta[k].theta - theta) > 1e-4) {
            ++k;
        }
        if (k < count || k == LAB_SECTION_DELTAS) {
            continue;
        }
        /* Radiance that comes through is 1 / eta^2 of what went in; power is not. */
        double factor = (double)s.pdf * (double)s.eta * (double)s.eta;
        delta[count].theta = theta;
        delta[count].power = lab_channel_of(section->channel, s.weight) * factor;
        ++count;
    }
    return count;
}

int lab_transmits(const struct brdf_bsdf *bsdf)
{
    return (brdf_bsdf_material(bsdf)->flags & BRDF_TRANSMISSION) != 0;
}

int lab_anisotropic(const struct brdf_bsdf *bsdf)
{
    if (!(brdf_bsdf_material(bsdf)->flags & BRDF_ANISOTROPIC)) {
        return 0;
    }
    for (int i = 0; i < 16; ++i) {
        struct lab_section along = {bsdf, 0.0, 0.05 + 0.09 * i, LAB_CHANNEL_LUMINANCE};
        struct lab_section across = along;
        across.azimuth = pi / 2.0;
        double theta = along.incidence + 0.08;
        double a = lab_section_f(&along, theta);
        double b = lab_section_f(&across, theta);
        if (fabs(a - b) > 1e-3 * fmax(a, b)) {
            return 1;
        }
    }
    return 0;
}
