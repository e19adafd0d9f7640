/*
 * trait.h - what a person would call a material, as numbers read off its table.
 */
#ifndef BRDFLAB_TRAIT_H
#define BRDFLAB_TRAIT_H

#include <brdf/merl.h>

/*
 * Each is an affine or logarithmic measure, so that steps of it look even; none needs a model.
 * Slices are at phi_d = 90 degrees, where both directions tilt alike; luminance is Rec. 709's.
 */
enum lab_trait {
    LAB_TRAIT_BRIGHTNESS, /* ln of the mean of f cos over the grid */
    LAB_TRAIT_GLOSS,      /* ln of the peak of the highlight over the base beside it */
    LAB_TRAIT_SHARPNESS,  /* -ln of the half width [rad] of the highlight in theta_h */
    LAB_TRAIT_METALLIC,   /* saturation of the highlight: 1 - least / greatest channel */
    LAB_TRAIT_SATURATION, /* saturation of the base */
    LAB_TRAIT_WARMTH,     /* ln of red over blue, of the mean */
    LAB_TRAIT_GRAZING,    /* ln of the peak at theta_d = 75 degrees over that at 5 */
    LAB_TRAITS
};

/* "brightness", ...; NULL beyond the last. */
const char *lab_trait_name(int trait);

/* What it measures, in a few words. */
const char *lab_trait_meaning(int trait);

/* All traits of a table without invalid bins above the surface (complete.h). */
void lab_traits_measure(const struct brdf_merl_file *file, double traits[LAB_TRAITS]);

#endif
