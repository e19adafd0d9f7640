/*
 * rgl_format.h - what reader and writer of RGL files agree on (internal).
 */
#ifndef BRDF_RGL_FORMAT_H
#define BRDF_RGL_FORMAT_H

#include <stddef.h>

#include "brdf/rgl.h"

enum { BRDF_RGL_SIDE_MAX = 4096 }; /* of any dimension: far beyond what is measured */

/* Magnitudes above this are refused: products of several values must stay finite. */
#define BRDF_RGL_VALUE_MAX 1e9

/* The fields of a file, in the order in which they are written. */
enum brdf_rgl_field {
    BRDF_RGL_DESCRIPTION,
    BRDF_RGL_PHI_I,
    BRDF_RGL_THETA_I,
    BRDF_RGL_SIGMA,
    BRDF_RGL_NDF,
    BRDF_RGL_VNDF,
    BRDF_RGL_LUMINANCE,
    BRDF_RGL_RGB,
    BRDF_RGL_WAVELENGTHS, /* this and the next instead of rgb */
    BRDF_RGL_SPECTRA,
    BRDF_RGL_JACOBIAN,
    BRDF_RGL_FIELDS
};

struct brdf_rgl_field_kind {
    const char *name;
    int type;
    int rank;
};

extern const struct brdf_rgl_field_kind brdf_rgl_field_kinds[BRDF_RGL_FIELDS];

/* How many elements each array of the file has, by its counts. */
size_t brdf_rgl_elements(const struct brdf_rgl_file *file, enum brdf_rgl_field field);

/* The array of the file that a field of floats is stored in; NULL for the others. */
float **brdf_rgl_array(struct brdf_rgl_file *file, enum brdf_rgl_field field);

/* Allocate every array by the counts. */
brdf_status brdf_rgl_reserve(struct brdf_rgl_file *file, int spectral, struct brdf_error *error);

/*
 * What is wrong with a value of a field: NULL, or half a sentence. `previous` is the one before it,
 * which the angles and wavelengths must be above; -infinity for the first.
 */
const char *brdf_rgl_value_fault(enum brdf_rgl_field field, double value, double previous);

/* How much each channel of the file counts for red, green and blue, one for each in an RGB file. */
void brdf_rgl_weights_find(const struct brdf_rgl_file *file, double (*weights)[3]);

#endif
