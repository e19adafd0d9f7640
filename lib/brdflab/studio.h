/*
 * studio.h - the light that spheres are looked at in.
 *
 * All of it is white, so that all colour is the material's. Radiance [1], with y up and the viewer
 * on +z:
 *
 *   sky      0.42 at the horizon, growing to 1 at the zenith
 *   ground   0.10 below, growing to 0.26 at the horizon
 *   key      a round softbox to the upper left, in front: 11 degrees from its centre to its edge,
 *            radiance 26, falling off over the outer fifth
 *   rim      another to the right, a little behind: 16 degrees, radiance 7
 */
#ifndef BRDFLAB_STUDIO_H
#define BRDFLAB_STUDIO_H

#include <brdf/frame.h>

enum { STUDIO_LAMPS = 2 };

struct studio_lamp {
    brdf_frame frame; /* n points to its centre */
    double cosine;    /* of the angle to its edge */
    double angle;     /* [rad] */
    double radiance;
    double density; /* [1/sr] of directions that are spread evenly over it */
};

struct studio {
    struct studio_lamp lamp[STUDIO_LAMPS];
};

struct studio studio_make(void);

/* The radiance [1] that comes from a direction: of a lamp, and of sky and ground. */
double studio_lamp_light(const struct studio_lamp *lamp, brdf_vec3 w);
double studio_sky_light(brdf_vec3 w);

/* Is the direction within the lamp's edge? */
int studio_lamp_holds(const struct studio_lamp *lamp, brdf_vec3 w);

/* A direction for the uniform numbers u, v: evenly spread over the lamp. */
brdf_vec3 studio_lamp_sample(const struct studio_lamp *lamp, double u, double v);

#endif
