/*
 * logrelative.h - the log-relative mapping of BRDF values, in which differences are about as large
 * as they look.
 *
 *   map(f) = ln((f c + epsilon) / (r + epsilon)),  c = max(cos(theta_o) cos(theta_i), 0.01)
 *
 * where r is a reference value of f c for the same pair of directions, the median of a database
 * where there is one, and epsilon = 0.001 keeps what is nearly black finite. Reference: Nielsen,
 * Jensen, Ramamoorthi, "On Optimal, Minimal BRDF Sampling for Reflectance Acquisition", ACM TOG
 * 34(6), 2015, section 4.1; the constants are those of the code that the authors published.
 */
#ifndef BRDFLAB_LOGRELATIVE_H
#define BRDFLAB_LOGRELATIVE_H

#include <math.h>

#define LAB_LOGRELATIVE_EPSILON 0.001 /* 1/sr */
#define LAB_LOGRELATIVE_COSINE 0.01   /* the least c */

/* c of a pair of directions, from their cosines. */
static inline double lab_logrelative_cosine(double cos_o, double cos_i)
{
    double product = cos_o * cos_i;
    return product > LAB_LOGRELATIVE_COSINE ? product : LAB_LOGRELATIVE_COSINE;
}

/* f [1/sr] >= 0 mapped, with the weight c and the reference r = (reference f) c. */
static inline double lab_logrelative_map(double f, double c, double r)
{
    return log((f * c + LAB_LOGRELATIVE_EPSILON) / (r + LAB_LOGRELATIVE_EPSILON));
}

/* The inverse: f [1/sr]; what maps to less than black is black. */
static inline double lab_logrelative_unmap(double mapped, double c, double r)
{
    double f = (exp(mapped) * (r + LAB_LOGRELATIVE_EPSILON) - LAB_LOGRELATIVE_EPSILON) / c;
    return f > 0.0 ? f : 0.0;
}

#endif
