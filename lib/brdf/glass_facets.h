/*
 * glass_facets.h - what a rough interface does with light, by one facet: a quadrature (internal).
 */
#ifndef BRDF_GLASS_FACETS_H
#define BRDF_GLASS_FACETS_H

/* The surface; alpha >= 1e-4. */
struct glass_surface {
    int distribution; /* as in microfacet.h */
    int masking;
    double alpha;
    double eta; /* index of the far side over that of the near one */
};

struct glass_shares {
    double reflected;
    double passed;
};

/* Nodes and weights in [0, 1], dense at both ends. */
enum { GLASS_NODES = 8 };

struct glass_rule {
    double at[GLASS_NODES];
    double weight[GLASS_NODES];
};

struct glass_rule glass_rule_make(void);

/* The parts of light under the cosine 0 < mu <= 1, to 5e-4, mostly 1e-4. */
struct glass_shares glass_shares_of(const struct glass_surface *surface,
                                    const struct glass_rule *rule, double mu);

#endif
