/*
 * rgl_header.h - what of a file the table of the model `measured` needs: how many slices, and which
 * symmetries leave rows out.
 */
#ifndef BRDF_LIB_RGL_HEADER_H
#define BRDF_LIB_RGL_HEADER_H

#include "brdf/rgl.h"

/* Slices along theta_i. A file with one theta_i holds for all of them: the table has it twice. */
int brdf_rgl_theta_slices(const struct brdf_rgl_file *file);

/* The first BRDF_MEASURED_HEADER words of the table (brdf/measurement.h). */
void brdf_rgl_header_build(float *table, const struct brdf_rgl_file *file);

#endif
