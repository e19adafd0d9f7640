/*
 * cltc.h - a clipped, linearly transformed cosine: directions for rough diffuse surfaces.
 *
 * Reference: Portsmouth, Kutz and Hill 2025 (EON: a practical energy-preserving rough diffuse
 * BRDF), their section on sampling, whose fit of the matrix these are the coefficients of; linearly
 * transformed cosines: Heitz et al. 2016. The disk of Malley's method is cut where the matrix would
 * send it below the horizon, so that no sample is lost.
 *
 * All directions here are in the frame whose x axis lies below wo.
 */
#ifndef BRDF_CLTC_H
#define BRDF_CLTC_H

#include "math.h"
#include "vec.h"

/* The matrix ((a, 0, b), (0, c, 0), (d, 0, 1)), its determinant, and what is left of the disk. */
struct brdf_cltc {
    brdf_real a;
    brdf_real b;
    brdf_real c;
    brdf_real d;
    brdf_real determinant;
    brdf_real part;
};

/* For a viewer at the cosine mu and a roughness r in [0, 1]; r = 0 is the plain cosine. */
static inline struct brdf_cltc brdf_cltc_make(brdf_real mu, brdf_real r)
{
    struct brdf_cltc m;
    m.a = 1.0f +
          r * (0.303392f + (-0.518982f + 0.111709f * mu) * mu + (-0.276266f + 0.335918f * mu) * r);
    m.b = r * (-1.16407f + 1.15859f * mu + (0.150815f - 0.150105f * mu) * r) /
          (mu * mu * mu - 1.43545f);
    m.c = 1.0f + (0.20013f + (-0.506373f + 0.261777f * mu) * mu) * r;
    m.d = (0.540852f + (-1.01625f + 0.475392f * mu) * mu) * r / (-1.0743f + mu * (0.0725628f + mu));
    /* The fit crosses 0 next to the normal, and a matrix that lifts the disk has nothing to cut. */
    m.d = brdf_min(m.d, 0.0f);
    m.determinant = m.c * (m.a - m.b * m.d);
    m.part = 0.5f + 0.5f / sqrtf(m.d * m.d + 1.0f);
    return m;
}

static inline brdf_vec3 brdf_cltc_sample(struct brdf_cltc m, brdf_real u, brdf_real v)
{
    struct brdf_sincos turn = brdf_sincos_2pi(v);
    brdf_real radius = sqrtf(u);
    brdf_real y = radius * turn.sin;
    brdf_real half_chord = sqrtf(brdf_max(1.0f - y * y, 0.0f));
    /* Chords along x shrink towards the side that stays above the horizon. */
    brdf_real x = -(half_chord * (1.0f - m.part) + radius * turn.cos * m.part);
    brdf_real z = sqrtf(brdf_max(1.0f - x * x - y * y, 0.0f));
    return brdf_normalize(brdf_vec3_make(m.a * x + m.b * z, m.c * y, m.d * x + z));
}

/* Density [1/sr] around the unit vector w, which must be above the horizon. */
static inline brdf_real brdf_cltc_pdf(struct brdf_cltc m, brdf_vec3 w)
{
    /* w through the adjugate of the matrix: the cosine that it came from, times the determinant. */
    brdf_vec3 from = brdf_vec3_make(m.c * (w.x - m.b * w.z), (m.a - m.b * m.d) * w.y,
                                    m.c * (m.a * w.z - m.d * w.x));
    brdf_real ratio = m.determinant / brdf_dot(from, from);
    return ratio * ratio * brdf_max(from.z, 0.0f) * (BRDF_1_PI / m.part);
}

#endif
