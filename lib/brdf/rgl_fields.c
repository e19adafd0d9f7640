/* rgl_fields.c - the fields of an RGL file: names, types, sizes, and what their values may be. */
#include "angle.h"
#include "rgl_format.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tensor.h"

const struct brdf_rgl_field_kind brdf_rgl_field_kinds[BRDF_RGL_FIELDS] = {
    {"description", BRDF_TENSOR_UINT8, 1},   {"phi_i", BRDF_TENSOR_FLOAT32, 1},
    {"theta_i", BRDF_TENSOR_FLOAT32, 1},     {"sigma", BRDF_TENSOR_FLOAT32, 2},
    {"ndf", BRDF_TENSOR_FLOAT32, 2},         {"vndf", BRDF_TENSOR_FLOAT32, 4},
    {"luminance", BRDF_TENSOR_FLOAT32, 4},   {"rgb", BRDF_TENSOR_FLOAT32, 5},
    {"wavelengths", BRDF_TENSOR_FLOAT32, 1}, {"spectra", BRDF_TENSOR_FLOAT32, 5},
    {"jacobian", BRDF_TENSOR_UINT8, 1},
};

size_t brdf_rgl_elements(const struct brdf_rgl_file *file, enum brdf_rgl_field field)
{
    size_t views = (size_t)file->phi_count * (size_t)file->theta_count;
    size_t square = (size_t)file->size * (size_t)file->size;
    switch (field) {
    case BRDF_RGL_PHI_I:
        return (size_t)file->phi_count;
    case BRDF_RGL_THETA_I:
        return (size_t)file->theta_count;
    case BRDF_RGL_SIGMA:
        return (size_t)file->sigma_rows * (size_t)file->sigma_columns;
    case BRDF_RGL_NDF:
        return (size_t)file->ndf_rows * (size_t)file->ndf_columns;
    case BRDF_RGL_VNDF:
        return views * (size_t)file->vndf_rows * (size_t)file->vndf_columns;
    case BRDF_RGL_LUMINANCE:
        return views * square;
    case BRDF_RGL_RGB:
    case BRDF_RGL_SPECTRA:
        return views * (size_t)file->channels * square;
    case BRDF_RGL_WAVELENGTHS:
        return (size_t)file->channels;
    default:
        return 0;
    }
}

float **brdf_rgl_array(struct brdf_rgl_file *file, enum brdf_rgl_field field)
{
    switch (field) {
    case BRDF_RGL_PHI_I:
        return &file->phi_i;
    case BRDF_RGL_THETA_I:
        return &file->theta_i;
    case BRDF_RGL_SIGMA:
        return &file->sigma;
    case BRDF_RGL_NDF:
        return &file->ndf;
    case BRDF_RGL_VNDF:
        return &file->vndf;
    case BRDF_RGL_LUMINANCE:
        return &file->luminance;
    case BRDF_RGL_WAVELENGTHS:
        return &file->wavelengths;
    case BRDF_RGL_RGB:
    case BRDF_RGL_SPECTRA:
        return &file->values;
    default:
        return NULL;
    }
}

brdf_status brdf_rgl_reserve(struct brdf_rgl_file *file, int spectral, struct brdf_error *error)
{
    for (int k = 0; k < BRDF_RGL_FIELDS; ++k) {
        enum brdf_rgl_field field = (enum brdf_rgl_field)k;
        float **array = brdf_rgl_array(file, field);
        int wanted = array && !*array && (spectral || field != BRDF_RGL_WAVELENGTHS);
        if (wanted) {
            size_t bytes = brdf_rgl_elements(file, field) * sizeof(float);
            *array = malloc(bytes);
            if (!*array) {
                return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for %zu bytes of %s", bytes,
                                 brdf_rgl_field_kinds[k].name);
            }
        }
    }
    return BRDF_OK;
}

const char *brdf_rgl_value_fault(enum brdf_rgl_field field, double value, double previous)
{
    const double slack = 1e-3; /* angles are rounded, and one end of theta_i may lie just beyond */
    if (value != value) {
        return "is not a number";
    }
    if (!(fabs(value) <= BRDF_RGL_VALUE_MAX)) {
        return "is infinite or too large";
    }
    switch (field) {
    case BRDF_RGL_PHI_I:
    case BRDF_RGL_THETA_I:
    case BRDF_RGL_WAVELENGTHS:
        if (!(value > previous)) {
            return "is not above the one before it";
        }
        if (field == BRDF_RGL_PHI_I && fabs(value) > pi + slack) {
            return "is not an angle in [-pi, pi]";
        }
        if (field == BRDF_RGL_THETA_I && (value < 0.0 || value > 0.5 * pi + slack)) {
            return "is not an angle in [0, pi / 2]";
        }
        if (field == BRDF_RGL_WAVELENGTHS && value <= 0.0) {
            return "is not above 0";
        }
        return NULL;
    case BRDF_RGL_SIGMA:
        return value < 0.0 ? "is negative" : NULL;
    default:
        return NULL; /* noise may be negative */
    }
}

void brdf_rgl_free(struct brdf_rgl_file *file)
{
    if (file) {
        free(file->description);
        free(file->phi_i);
        free(file->theta_i);
        free(file->ndf);
        free(file->sigma);
        free(file->vndf);
        free(file->luminance);
        free(file->wavelengths);
        free(file->values);
        memset(file, 0, sizeof *file);
    }
}
