/*
 * facet_shares.h - what a rough surface does with light, by one facet: a quadrature (internal).
 */
#ifndef BRDF_FACET_SHARES_H
#define BRDF_FACET_SHARES_H

/* The surface, of facets as GGX or Beckmann has them; both alphas >= 1e-4. */
struct facet_surface {
    int distribution; /* as in microfacet.h */
    int masking;      /* as in facets.h; where light passes, one of Smith's exact ones */
    double alpha_u;
    double alpha_v;
    double eta; /* index of the far side over that of the near one; 0 where facets are mirrors */
};

struct facet_shares {
    double reflected;
    double passed;
};

/* Nodes and weights in [0, 1], dense at both ends. */
enum { FACET_NODES = 16 };

struct facet_rule {
    int count;
    double at[FACET_NODES];
    double weight[FACET_NODES];
};

/* With so many nodes, FACET_NODES at most. */
struct facet_rule facet_rule_make(int nodes);

/* Light under the cosine 0 < mu <= 1, from the azimuth whose cosine and sine are told. */
struct facet_light {
    double mu;
    double along_u;
    double along_v;
};

/*
 * The parts of that light. Of round surfaces to 5e-4 with 8 nodes, mostly 1e-4; of brushed ones to
 * 1e-3 with 12, mostly 1e-4.
 */
struct facet_shares facet_shares_of(const struct facet_surface *surface,
                                    const struct facet_rule *rule, struct facet_light light);

#endif
