/*
 * albedo.h - how much light a material sends back and lets through: for one direction, and averaged
 * over all of a side.
 *
 * The albedo of a direction wo is the share of a beam's power that leaves the surface again, when
 * the beam arrives along wo. It is computed by way of reciprocity, as the integral over wi of
 * f(wo, wi) |cos wi|, which is also how bright the surface looks from wo under a uniform sky of
 * radiance 1. For a model that is not reciprocal (a published one may not be) it is the latter.
 * Through the surface f is eta^2 times less than in the other direction (radiance thins out in a
 * denser medium); power is conserved, and so transmission counts weight times eta^2: what is
 * neither reflected nor transmitted has been absorbed, or lost by the model.
 *
 * The integral is the mean weight of samples, deltas included, over even points (lattice.h)
 * with LAB_ALBEDO_SHIFTS shifts, whose spread is the error. Nothing is random: the same call gives
 * the same bits.
 */
#ifndef BRDFLAB_ALBEDO_H
#define BRDFLAB_ALBEDO_H

#include <stddef.h>

#include <brdf/material.h>

enum {
    LAB_ALBEDO_SHIFTS = 16,
    LAB_ALBEDO_SAMPLES = 1 << 16 /* of one direction: errors of 1e-4 to 6e-4, in 10 to 50 ms */
};

struct lab_albedo {
    double reflection[3];   /* red, green, blue: to the side of wo */
    double transmission[3]; /* to the other side, as power */
    double error;           /* of the worst of the six: one standard deviation, estimated */
};

/* Of a direction, by so many samples (rounded up to a multiple of LAB_ALBEDO_SHIFTS). */
struct lab_albedo lab_albedo_at(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t samples);

/*
 * The average over all directions of a side, each with the weight of its cosine / pi: what a
 * surface does to diffuse light. From above, or (inside = 1) from below.
 */
struct lab_albedo lab_albedo_average(const struct brdf_bsdf *bsdf, int inside, size_t samples);

#endif
