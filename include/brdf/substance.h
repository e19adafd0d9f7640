/*
 * substance.h - metals and dielectrics by name: refractive indices from measurements.
 */
#ifndef BRDF_SUBSTANCE_H
#define BRDF_SUBSTANCE_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A metal: the complex refractive index eta + i k [1] for linear Rec. 709 red, green and blue. */
struct brdf_metal {
    const char *name; /* chemical symbol, or "none": reflects everything */
    float eta[3];
    float k[3];
    const char *source; /* who measured it, and when */
};

/* A dielectric: the refractive index [1] against vacuum. */
struct brdf_dielectric_substance {
    const char *name;
    float ior;
};

/* The metal or dielectric number i, in the order of their tables; NULL from their count on. */
BRDF_API const struct brdf_metal *brdf_metal_at(int i);
BRDF_API const struct brdf_dielectric_substance *brdf_dielectric_at(int i);

/* By name, letter by letter; NULL if there is none. */
BRDF_API const struct brdf_metal *brdf_metal_find(const char *name);
BRDF_API const struct brdf_dielectric_substance *brdf_dielectric_find(const char *name);

/* The name nearest to one that is not known; NULL if none is near enough to be meant. */
BRDF_API const char *brdf_metal_nearest(const char *name);
BRDF_API const char *brdf_dielectric_nearest(const char *name);

#ifdef __cplusplus
}
#endif

#endif
