/*
 * section.h - a material cut by a plane of incidence: where in that plane the light goes.
 *
 * Light arrives along theta_i, from the left (negative angles); theta is the angle from the normal
 * at which it leaves: from -90 degrees, the horizon on the left, to 90, the horizon on the right,
 * where mirrors send it, and on through the surface, where 180 is straight down, to 270.
 */
#ifndef BRDFLAB_SECTION_H
#define BRDFLAB_SECTION_H

#include <stddef.h>

#include <brdf/material.h>

/* What a curve shows of a colour. */
enum lab_channel { LAB_CHANNEL_LUMINANCE, LAB_CHANNEL_RED, LAB_CHANNEL_GREEN, LAB_CHANNEL_BLUE };

double lab_channel_of(enum lab_channel channel, brdf_rgb color);

struct lab_section {
    const struct brdf_bsdf *bsdf;
    double azimuth;   /* of the plane, from the tangent [rad] */
    double incidence; /* theta_i [rad], 0 <= theta_i < pi / 2 */
    enum lab_channel channel;
};

/* The direction [1] to the light, and the one that leaves at theta. */
brdf_vec3 lab_section_light(const struct lab_section *section);
brdf_vec3 lab_section_direction(const struct lab_section *section, double theta);

/* The range of theta [rad]: to pi / 2, or to 3 pi / 2 where the material lets light through. */
double lab_section_low(void);
double lab_section_high(int transmits);

/* f [1/sr] where light leaves at theta [rad]. */
double lab_section_f(const struct lab_section *section, double theta);

/* The same times |cos theta|: its integral over all directions is a share of the power. */
double lab_section_lobe(const struct lab_section *section, double theta);

/* How many angles lab_section_seeds writes. */
enum { LAB_SECTION_SEEDS = 256 };

/*
 * Angles [rad] near which f may be large, found by sampling the material: a peak narrower than any
 * grid has its seeds. Returns their number; they ascend.
 */
int lab_section_seeds(const struct lab_section *section, double seed[LAB_SECTION_SEEDS]);

/* The largest value of lab_section_f, or of lab_section_lobe (cosine = 1), within [low, high]. */
double lab_section_peak(const struct lab_section *section, int cosine, double low, double high);

enum { LAB_SECTION_DELTAS = 4 };

struct lab_delta {
    double theta; /* [rad] */
    double power; /* the share of the beam that it takes, of the section's channel */
};

/* The delta lobes; returns their number. */
int lab_section_deltas(const struct lab_section *section,
                       struct lab_delta delta[LAB_SECTION_DELTAS]);

/* Does the material send light through the surface? */
int lab_transmits(const struct brdf_bsdf *bsdf);

/* Does f change where the surface turns by 90 degrees? (By more than rounding.) */
int lab_anisotropic(const struct brdf_bsdf *bsdf);

#endif
