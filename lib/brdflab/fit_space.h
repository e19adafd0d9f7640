/*
 * fit_space.h - the parameters that a fit searches, as a point of a unit cube.
 */
#ifndef BRDFLAB_FIT_SPACE_H
#define BRDFLAB_FIT_SPACE_H

#include "fit.h"
#include "fit_part.h"

enum { FIT_COORDINATES = 96, FIT_TIED = 4, FIT_WEIGHT = -1 };

/* A coordinate: one number of a part, or several that are tied together; or a weight. */
struct fit_coordinate {
    int part;               /* or FIT_WEIGHT */
    int settings[FIT_TIED]; /* their numbers among the part's settings; of a weight its part */
    int tied;               /* how many of them there are */
    int channel;            /* of a colour, else 0 */
    int color;              /* it is one of a colour's three */
    double low;
    double high;
    int even; /* all of the range alike; else low values in more detail */
    int gray; /* it is all three of a colour's */
};

struct fit_space {
    struct fit_part parts[LAB_FIT_PARTS];
    int part_count;
    struct fit_coordinate coordinates[FIT_COORDINATES];
    int size;
};

/* What the options ask to be searched. */
brdf_status fit_space_make(const struct lab_fit_options *options, struct fit_space *space,
                           struct brdf_error *error);

/* The parts at a point in [0, 1]^size, which the caller destroys, and their weights. */
brdf_status fit_space_parts(const struct fit_space *space, const double *point,
                            struct brdf_bsdf **parts, double *weights, struct brdf_error *error);

/* Search a coordinate no more: what it stands for keeps its held value. */
void fit_space_drop(struct fit_space *space, int coordinate);

/*
 * Start number k: a point of a sequence that fills the cube evenly in all coordinates at once
 * [Roberts 2018], the channels of a colour being equal.
 */
void fit_space_start(const struct fit_space *space, unsigned long k, double *point);

#endif
