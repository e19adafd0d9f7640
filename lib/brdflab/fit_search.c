/*
 * fit_search.c - a fit in progress: the error at a point, and the ways down from one, by NLopt.
 *
 * BOBYQA [Powell 2009] builds a quadratic model of the error from its values alone, inside bounds:
 * with 4 to 20 parameters and errors that are smooth but have no derivative here, it needs the
 * fewest evaluations of NLopt's methods. It is begun anew from where it ended, until that gains
 * nothing, since a step that has become short ends it early in a narrow valley.
 */
#include <math.h>
#include <string.h>

#include "fit_search.h"

enum { WALKS = 8 };

double search_error(struct search *search, const double *point)
{
    struct brdf_bsdf *parts[LAB_FIT_PARTS];
    double weights[LAB_FIT_PARTS];
    ++search->evaluations;
    brdf_status status = fit_space_parts(&search->space, point, parts, weights, NULL);
    if (status == BRDF_OUT_OF_MEMORY) {
        search->status = brdf_fail(search->error, status, "out of memory");
    }
    if (status) {
        return HUGE_VAL;
    }
    double square = fit_samples_error(&search->samples, (const struct brdf_bsdf *const *)parts,
                                      weights, search->space.part_count);
    for (int i = 0; i < search->space.part_count; ++i) {
        brdf_bsdf_destroy(parts[i]);
    }
    return square;
}

int search_stops(struct search *search)
{
    const struct lab_fit_options *options = search->options;
    if (!search->status && search->evaluations % 64 == 0 && options->progress &&
        options->progress(&search->state, options->data)) {
        search->status = brdf_fail(search->error, BRDF_CANCELLED, "stopped on request");
    }
    return search->status != BRDF_OK;
}

/* NLopt minimises the root, whose valley is less flat than that of the square. */
static double walk_error(unsigned size, const double *point, double *gradient, void *data)
{
    struct search *search = data;
    (void)size;
    (void)gradient;
    double rms = sqrt(search_error(search, point));
    search->state.error = fmin(search->state.error, rms);
    if (search_stops(search)) {
        nlopt_force_stop(search->walk);
    }
    return isfinite(rms) ? rms : 1e30;
}

void search_walk(struct search *search, struct place *place)
{
    unsigned size = (unsigned)search->space.size;
    /* BOBYQA needs two coordinates at least. */
    nlopt_opt walk = nlopt_create(size > 1 ? NLOPT_LN_BOBYQA : NLOPT_LN_SBPLX, size);
    search->walk = walk;
    if (!walk) {
        search->status = brdf_fail(search->error, BRDF_OUT_OF_MEMORY, "out of memory");
        return;
    }
    nlopt_set_min_objective(walk, walk_error, search);
    nlopt_set_lower_bounds1(walk, 0.0);
    nlopt_set_upper_bounds1(walk, 1.0);
    nlopt_set_xtol_abs1(walk, 1e-7);
    nlopt_set_ftol_rel(walk, 1e-9);
    nlopt_set_maxeval(walk, (int)search->options->evaluations_max);
    double step = 0.1;
    for (int i = 0; i < WALKS && !search->status; ++i) {
        double before = place->error;
        double reached = before;
        double point[FIT_COORDINATES];
        memcpy(point, place->point, sizeof point);
        nlopt_set_initial_step1(walk, step);
        nlopt_optimize(walk, point, &reached);
        if (reached < before) {
            place->error = reached;
            memcpy(place->point, point, sizeof point);
        }
        if (!(reached < before * (1.0 - 1e-4))) {
            break;
        }
        step = fmax(0.3 * step, 1e-3);
    }
    nlopt_destroy(walk);
}

/* The mean square and, where asked for, its gradient by central differences. */
static double polish_error(unsigned size, const double *point, double *gradient, void *data)
{
    struct search *search = data;
    double moved[FIT_COORDINATES];
    memcpy(moved, point, size * sizeof *moved);
    for (unsigned i = 0; i < size && gradient; ++i) {
        double low = fmax(point[i] - 1e-4, 0.0);
        double high = fmin(point[i] + 1e-4, 1.0);
        moved[i] = low;
        double before = search_error(search, moved);
        moved[i] = high;
        gradient[i] = (search_error(search, moved) - before) / (high - low);
        moved[i] = point[i];
    }
    double square = search_error(search, point);
    search->state.error = fmin(search->state.error, sqrt(square));
    if (search_stops(search)) {
        nlopt_force_stop(search->walk);
    }
    return isfinite(square) ? square : 1e30;
}

/*
 * The last steps, along gradients: near its end the mean square is smooth, and SLSQP [Kraft 1988]
 * goes along valleys that are too narrow for BOBYQA.
 */
void search_polish(struct search *search, struct place *place)
{
    unsigned size = (unsigned)search->space.size;
    nlopt_opt walk = nlopt_create(NLOPT_LD_SLSQP, size);
    search->walk = walk;
    if (!walk) {
        search->status = brdf_fail(search->error, BRDF_OUT_OF_MEMORY, "out of memory");
        return;
    }
    double reached = place->error * place->error;
    double point[FIT_COORDINATES];
    memcpy(point, place->point, sizeof point);
    nlopt_set_min_objective(walk, polish_error, search);
    nlopt_set_lower_bounds1(walk, 0.0);
    nlopt_set_upper_bounds1(walk, 1.0);
    nlopt_set_ftol_rel(walk, 1e-10);
    nlopt_set_maxeval(walk, 300);
    nlopt_optimize(walk, point, &reached);
    if (sqrt(reached) < place->error) {
        place->error = sqrt(reached);
        memcpy(place->point, point, sizeof point);
    }
    nlopt_destroy(walk);
}
