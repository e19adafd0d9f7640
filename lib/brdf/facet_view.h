/*
 * facet_view.h - a rough surface as light sees it, and where what its facets do with that light has
 * kinks (internal to facet_shares.c and facet_kinks.c).
 *
 * A facet is told by its slopes for unit roughness: x along the rougher tangent, of a round surface
 * along the light, and y across it.
 */
#ifndef BRDF_FACET_VIEW_H
#define BRDF_FACET_VIEW_H

#include "brdf/facets.h"
#include "facet_shares.h"

struct facet_view {
    const struct facet_surface *surface;
    struct brdf_facets facets; /* the first tangent is that of x */
    int round;                 /* both alphas are the same */
    brdf_vec3 wo;              /* where the light is */
    double rough, smooth;      /* alphas along x and y */
    float ratio2;              /* square of smooth over rough */
    double slope, lean;        /* P = mu - slope x - lean y is a facet's area as it is seen */
    float mu;
    float area;                 /* of all facets that face the light, as it is seen */
    double critical2;           /* square of the cosine where total reflection ends; 0 if none */
    struct facet_shares shares; /* sums */
    double all;                 /* sum of the weights */
};

enum { FACET_KINKS_ALONG = 15, FACET_KINKS_ACROSS = 13 };

/* Where over x there are kinks for a given y; returns how many. */
int facet_kinks_along(const struct facet_view *view, double y, double x[FACET_KINKS_ALONG]);

/* Where over y >= 0 kinks over x begin or end. */
int facet_kinks_across(const struct facet_view *view, double y[FACET_KINKS_ACROSS]);

#endif
