/* plot_job.c - the scales that all materials of a picture share. */
#include <math.h>

#include "albedo.h"
#include "angle.h"
#include "plot_panels.h"

enum { SLICE_DECADES = 6, LOBE_DECADES = 5 };

struct lab_section plot_job_section(const struct plot_job *job, int material, int angle, int across)
{
    struct lab_section section = {job->materials[material].bsdf,
                                  job->settings->azimuth + (across ? pi / 2.0 : 0.0),
                                  job->settings->angle[angle], job->settings->channel};
    return section;
}

/* The largest f and f cos, and the smallest f that is not 0 short of grazing. */
struct extent {
    double peak;
    double lobe_peak;
    double least;
};

static void extend(struct extent *extent, const struct lab_section *section, double high)
{
    extent->peak = fmax(extent->peak, lab_section_peak(section, 0, lab_section_low(), high));
    extent->lobe_peak =
        fmax(extent->lobe_peak, lab_section_peak(section, 1, lab_section_low(), high));
    for (int i = -85; i <= 85; i += 5) {
        double f = lab_section_f(section, i * pi / 180.0);
        if (f > 0.0) {
            extent->least = fmin(extent->least, f);
        }
    }
}

void plot_job_prepare(struct plot_job *job)
{
    struct extent extent = {0.0, 0.0, 1e30};
    double albedo = 1.0;
    job->transmits = 0;
    job->anisotropic = 0;
    for (int m = 0; m < job->count; ++m) {
        job->transmits |= lab_transmits(job->materials[m].bsdf);
    }
    for (int m = 0; m < job->count; ++m) {
        int anisotropic = lab_anisotropic(job->materials[m].bsdf);
        job->anisotropic |= anisotropic;
        for (int i = 0; i < job->settings->angles; ++i) {
            for (int across = 0; across <= anisotropic; ++across) {
                struct lab_section section = plot_job_section(job, m, i, across);
                extend(&extent, &section, lab_section_high(job->transmits));
            }
        }
        for (double theta = 0.0; theta < 1.5; theta += 0.15) {
            struct lab_section section = {job->materials[m].bsdf, job->settings->azimuth, theta,
                                          job->settings->channel};
            struct lab_albedo at = lab_albedo_at(section.bsdf, lab_section_light(&section), 1024);
            for (int c = 0; c < 3; ++c) {
                albedo = fmax(albedo, at.reflection[c] + at.transmission[c]);
            }
        }
    }
    /* Where there are only delta lobes, nothing is known but where 0 is. */
    job->slice = extent.peak > 0.0 ? plot_scale_decades(fmin(extent.least, extent.peak),
                                                        extent.peak, SLICE_DECADES)
                                   : plot_scale_fixed(0.0, 1.0, 2.0);
    job->lobe_log = plot_scale_decades(0.0, extent.lobe_peak, LOBE_DECADES);
    /* Sampling may find a little more than 1 where a model gives back just that. */
    job->albedo = plot_scale_fixed(0.0, albedo < 1.01 ? 1.0 : 0.25 * ceil(4.0 * albedo), 0.25);
}
