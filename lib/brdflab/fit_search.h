/*
 * fit_search.h - a fit in progress: the error at a point, and the ways down from one.
 */
#ifndef BRDFLAB_FIT_SEARCH_H
#define BRDFLAB_FIT_SEARCH_H

#include <nlopt.h>

#include "fit.h"
#include "fit_samples.h"
#include "fit_space.h"

struct search {
    const struct lab_fit_options *options;
    struct fit_samples samples;
    struct fit_space space;
    struct lab_fit_progress state;
    size_t evaluations;
    nlopt_opt walk;     /* the one in progress */
    brdf_status status; /* of the evaluations */
    struct brdf_error *error;
};

struct place {
    double error;
    double point[FIT_COORDINATES];
};

/* The mean square at a point; HUGE_VAL where the model refuses the parameters. */
double search_error(struct search *search, const double *point);

/* Tell how far it is, now and then; 1 if it is to stop. */
int search_stops(struct search *search);

/* Walk down from a place, which becomes where the walk ended. */
void search_walk(struct search *search, struct place *place);

/* The last steps from a place near the end. */
void search_polish(struct search *search, struct place *place);

#endif
