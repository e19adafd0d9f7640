/*
 * azimuth.h - which way a direction leans: what models need that compare two azimuths.
 */
#ifndef BRDF_AZIMUTH_H
#define BRDF_AZIMUTH_H

#include "vec.h"

/* The unit vector below w in the tangent plane; where w is the normal, the tangent x. */
static inline brdf_vec3 brdf_azimuth(brdf_vec3 w)
{
    brdf_real square = w.x * w.x + w.y * w.y;
    brdf_mask leans = square > 1e-30f;
    brdf_real inverse = 1.0f / sqrtf(brdf_pick(leans, square, 1.0f));
    return brdf_vec3_make(brdf_pick(leans, w.x * inverse, 1.0f),
                          brdf_pick(leans, w.y * inverse, 0.0f), 0.0f);
}

#endif
