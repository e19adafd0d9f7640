/*
 * compare.h - how far one material is from another.
 */
#ifndef BRDFLAB_COMPARE_H
#define BRDFLAB_COMPARE_H

#include <brdf/material.h>
#include <brdf/merl.h>

/* Beyond this angle of either direction from the normal little light goes, and differences of what
   is next to nothing may be large [degrees]. */
enum { LAB_GRAZING = 80 };

/* The largest |f - g| / f of some directions, where f is above 0.001 1/sr, and where it is. */
struct lab_worst {
    double relative;
    brdf_vec3 wo, wi;
};

/*
 * The differences of f from g over pairs of directions above the surface: theta_o from 5 to 85
 * degrees in steps of 10, all the same weight, and all of wi; cos is that of theta_i. The integrals
 * are sums over a lattice, half of it drawn from f, so that highlights are not missed.
 */
struct lab_difference {
    double rms;    /* sqrt(integral of ((f - g) cos)^2 / integral of (f cos)^2), all channels in
                      one: Ngan, Durand, Matusik 2005, section 3.2, relative to f */
    double mean;   /* integral of |f - g| cos / integral of f cos: less of it is the peak's */
    double most;   /* 99 % of the light, f cos, goes where |f - g| / f is less than this */
    double albedo; /* the largest difference of albedos, of any theta_o and channel */
    struct lab_worst worst;   /* with both directions up to LAB_GRAZING degrees from the normal */
    struct lab_worst grazing; /* with one of them beyond */
};

struct lab_difference lab_compare(const struct brdf_bsdf *f, const struct brdf_bsdf *g);

/* The same where g is a table in memory, such as f baked. BRDF_OUT_OF_MEMORY; those of
   brdf_merl_fill. */
brdf_status lab_compare_merl(const struct brdf_bsdf *f, const struct brdf_merl_file *g,
                             struct lab_difference *difference, struct brdf_error *error);

#endif
