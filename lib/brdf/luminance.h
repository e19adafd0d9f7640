/*
 * luminance.h - relative luminance in double precision, for what is computed once on the host.
 */
#ifndef BRDF_LUMINANCE_H
#define BRDF_LUMINANCE_H

/* Of linear Rec. 709 [ITU-R BT.709-6, section 3], as brdf_rgb_luminance. */
static inline double brdf_luminance(double r, double g, double b)
{
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

#endif
