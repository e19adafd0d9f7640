/*
 * fit.h - the parameters of analytic models that bring them nearest to a given material.
 *
 * The error is the root mean square of g(f cos(theta_i)) - g(f' cos(theta_i)) over the three
 * channels and a fixed set of directions (fit_samples.c), with g the cube root or log(1 + x)
 * [Loew, Kronander, Ynnerman, Unger 2012, E2 and E1] or x itself [Ngan, Durand, Matusik 2005].
 *
 * The fit is a blend, as blendbsdf makes one, so that it keeps the energy that its parts keep: an
 * optional diffuse part, and one or two lobes of the same model. Searched are the weights of the
 * blend and the lobe's numbers and colours, but not: what the description sets; the index outside
 * ("ext_..."), since only the ratio counts; and factors of the reflection ("specular_...") of
 * interfaces and metals, whose indices set it already.
 */
#ifndef BRDFLAB_FIT_H
#define BRDFLAB_FIT_H

#include <stddef.h>

#include <brdf/material.h>

enum lab_fit_metric { LAB_FIT_CUBE_ROOT, LAB_FIT_LOG, LAB_FIT_LINEAR };

/* A fit has so many parts at most: a diffuse one and two lobes. */
#define LAB_FIT_PARTS 3

struct lab_fit_progress {
    int start; /* of the local searches, counted from 0 */
    int starts;
    double error; /* the least so far */
};

struct lab_fit_options {
    const char *model; /* "ward" or "ward:variant=ward"; what is set there is held */
    const char *free;  /* names, separated by ",", of parameters to search though they are not by
                          default; NULL: none */
    int lobes;         /* 1 or 2, of that model */
    int diffuse;       /* 1: add a diffuse part, which the model must not have itself */
    int anisotropic;   /* 1: directions all around, and both roughnesses apart */
    enum lab_fit_metric metric;
    int starts;             /* local searches, each from another place; 1 to 1000 */
    unsigned seed;          /* where the places begin */
    size_t evaluations_max; /* of the error, in each walk of a local search; its last steps
                               come on top */
    int (*progress)(const struct lab_fit_progress *state, void *data); /* not 0: stop; or NULL */
    void *data;                                                        /* for `progress` */
};

struct lab_fit_result {
    struct brdf_bsdf *parts[LAB_FIT_PARTS]; /* the diffuse part is first */
    double weights[LAB_FIT_PARTS];          /* of each; their sum is 1 */
    int part_count;
    double error;       /* the root mean square */
    double error_black; /* that of f' = 0, to compare with */
    double agreement;   /* fraction of the local searches that ended within 1 % of the least */
    size_t samples;     /* pairs of directions */
    size_t evaluations; /* of the error, in all */
};

/* The options that a person gets who sets nothing but the model. */
struct lab_fit_options lab_fit_defaults(const char *model);

/*
 * Fit. On success the caller ends the result with lab_fit_free. Errors: those of brdf_bsdf_create
 * for the model; BRDF_UNSUPPORTED (nothing to search, a tabulated model, a delta lobe; nothing but
 * black to fit), BRDF_BAD_ARGUMENT, BRDF_OUT_OF_MEMORY, BRDF_CANCELLED (with the best so far lost).
 */
brdf_status lab_fit(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                    struct lab_fit_result *result, struct brdf_error *error);

/* The error of `count` parts times their weights, under the same metric and directions. */
brdf_status lab_fit_error(const struct brdf_bsdf *target, const struct lab_fit_options *options,
                          const struct brdf_bsdf *const *parts, const double *weights, int count,
                          double *rms, struct brdf_error *error);

void lab_fit_free(struct lab_fit_result *result);

#endif
