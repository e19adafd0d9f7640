/*
 * facet_shares.c - what a rough surface does with light, by one facet: a quadrature over the
 * slopes of the facets as they are seen.
 *
 * The share of each facet is smooth in its slopes but for kinks (facet_kinks.c). The integral is
 * cut there. Between cuts, Gauss's rule with a substitution that is flat at both ends, for behind
 * total reflection all goes as a square root.
 */
#include "facet_shares.h"

#include <math.h>
#include <string.h>

#include "angle.h"
#include "brdf/fresnel.h"
#include "facet_view.h"

enum { CUTS = FACET_KINKS_ALONG + 2 };

/* Slopes of a Gaussian nearly evenly: FALL atanh(t), |t| <= EDGE. */
#define FALL 0.83
#define EDGE 0.99985

struct cuts {
    double at[CUTS];
    int count;
};

struct facet_rule facet_rule_make(int nodes)
{
    struct facet_rule rule;
    rule.count = nodes;
    for (int i = 0; i < nodes; ++i) {
        double x = cos(pi * (nodes - i - 0.25) / (nodes + 0.5)), slope = 1.0;
        for (int step = 0; step < 8; ++step) { /* a root of Legendre's polynomial, by Newton */
            double before = 1.0, p = x;
            for (int k = 2; k <= nodes; ++k) {
                double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
                before = p;
                p = next;
            }
            slope = nodes * (x * p - before) / (x * x - 1.0);
            x -= p / slope;
        }
        double v = 0.5 + 0.5 * x;
        rule.at[i] = v * v * (3.0 - 2.0 * v);
        rule.weight[i] = 6.0 * v * (1.0 - v) / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

/* Insert in order what lies between the first and the last cut. */
static void cut(struct cuts *cuts, double at)
{
    int i = cuts->count - 1;
    if (!(at > cuts->at[0] && at < cuts->at[i])) {
        return;
    }
    for (; cuts->at[i] > at; --i) {
        cuts->at[i + 1] = cuts->at[i];
    }
    cuts->at[i + 1] = at;
    ++cuts->count;
}

/* G2 over both cosines by the maskings that only metals have; apart, so that the others are quick.
 */
static float visibility_rare(const struct facet_view *view, brdf_vec3 w)
{
    return brdf_facets_visibility(view->facets, brdf_half_make(view->wo, w), view->wo, w);
}

/* G2 / G1(wo) of light that leaves towards w. */
static float seen(const struct facet_view *view, brdf_vec3 w)
{
    if (!(w.z > 0.0f)) {
        return 0.0f;
    }
    if (view->facets.masking > BRDF_MASKING_SEPARABLE) {
        return w.z * view->area * visibility_rare(view, w);
    }
    float area = brdf_microfacet_area(view->facets.distribution, w, view->facets.alpha_u,
                                      view->facets.alpha_v);
    return w.z * view->area *
           brdf_microfacet_visibility(view->facets.masking, view->mu, w.z, view->area, area);
}

/* Light that leaves under the cosine z: the facet's normal counts `along` times in its direction,
   wo counts `back` times against it. */
static brdf_vec3 leaving(const struct facet_view *view, float z, brdf_vec3 normal, float along,
                         float back)
{
    if (view->round) { /* any azimuth serves */
        return brdf_vec3_make(sqrtf(brdf_max(1.0f - z * z, 0.0f)), 0.0f, z);
    }
    return brdf_vec3_make(along * normal.x - back * view->wo.x,
                          along * normal.y - back * view->wo.y, z);
}

/* One facet, which weighs its projected area. */
static void add_facet(struct facet_view *view, float x, float y, float y2, float weight)
{
    float rough = view->facets.alpha_u, smooth = view->facets.alpha_v;
    float eta = (float)view->surface->eta;
    float projected = (view->mu - rough * x * view->wo.x) - (float)view->lean * y;
    if (!(projected > 0.0f)) {
        return;
    }
    float z = 1.0f / sqrtf(1.0f + rough * rough * (x * x + view->ratio2 * y2));
    brdf_vec3 normal = brdf_vec3_make(-z * rough * x, -z * smooth * y, z);
    float cosine = brdf_min(projected * z, 1.0f);
    float share = weight * projected;
    view->all += (double)share;
    brdf_vec3 up = leaving(view, 2.0f * cosine * z - view->mu, normal, 2.0f * cosine, 1.0f);
    if (view->surface->eta == 0.0) {
        view->shares.reflected += (double)(share * seen(view, up));
        return;
    }
    struct brdf_fresnel fresnel = brdf_fresnel_dielectric(cosine, eta);
    float along = cosine / eta - fresnel.cos_t;
    view->shares.reflected += (double)(share * fresnel.reflectance * seen(view, up));
    if (fresnel.reflectance < 1.0f) {
        brdf_vec3 down = leaving(view, view->mu / eta - along * z, normal, along, 1.0f / eta);
        view->shares.passed += (double)(share * (1.0f - fresnel.reflectance) * seen(view, down));
    }
}

/* Of GGX, whose scale is sqrt(1 + y^2), the density over t is a half circle. */
static void integrate_along(struct facet_view *view, const struct facet_rule *rule, double y,
                            double weight)
{
    int ggx = view->surface->distribution == BRDF_GGX;
    double scale = ggx ? sqrt(1.0 + y * y) : FALL;
    double edge = ggx ? 1.0 : EDGE;
    double kink[FACET_KINKS_ALONG];
    struct cuts cuts = {{-edge, edge}, 2};
    for (int i = 0, count = facet_kinks_along(view, y, kink); i < count; ++i) {
        double t = kink[i] / scale;
        cut(&cuts, ggx ? t / sqrt(1.0 + t * t) : tanh(t));
    }
    for (int i = 0; i + 1 < cuts.count; ++i) {
        double width = cuts.at[i + 1] - cuts.at[i];
        for (int k = 0; k < rule->count; ++k) {
            float t = (float)(cuts.at[i] + width * rule->at[k]);
            float left = brdf_max((1.0f - t) * (1.0f + t), 1e-12f);
            float share = (float)(weight * width * rule->weight[k]);
            if (ggx) {
                float root = sqrtf(left);
                add_facet(view, (float)scale * t / root, (float)y, (float)(y * y), share * root);
            } else {
                float x = (float)(0.5 * FALL) * brdf_log((1.0f + t) * (1.0f + t) / left);
                add_facet(view, x, (float)y, (float)(y * y), share * brdf_exp(-x * x) / left);
            }
        }
    }
}

/* Facets on the side of positive y. */
static void integrate_across(struct facet_view *view, const struct facet_rule *rule)
{
    int ggx = view->surface->distribution == BRDF_GGX;
    struct cuts cuts = {{0.0, ggx ? asin(1.0) : EDGE}, 2};
    double kink[FACET_KINKS_ACROSS];
    for (int i = 0, count = facet_kinks_across(view, kink); i < count; ++i) {
        cut(&cuts, ggx ? atan(kink[i]) : tanh(kink[i] / FALL));
    }
    for (int i = 0; i + 1 < cuts.count; ++i) {
        double width = cuts.at[i + 1] - cuts.at[i];
        for (int k = 0; k < rule->count; ++k) {
            double t = cuts.at[i] + width * rule->at[k];
            double y = ggx ? tan(t) : FALL * atanh(t);
            /* Up to a constant. */
            double density = ggx ? cos(t) : exp(-y * y) / (1.0 - t * t);
            integrate_along(view, rule, y, width * rule->weight[k] * density);
        }
    }
}

static struct facet_view view_of(const struct facet_surface *surface, struct facet_light light)
{
    struct facet_view view;
    float sine = (float)sqrt(fmax(1.0 - light.mu * light.mu, 0.0));
    int along_v = surface->alpha_v > surface->alpha_u;
    memset(&view, 0, sizeof view);
    view.surface = surface;
    view.round = surface->alpha_u == surface->alpha_v;
    view.rough = along_v ? surface->alpha_v : surface->alpha_u;
    view.smooth = along_v ? surface->alpha_u : surface->alpha_v;
    view.ratio2 = (float)(view.smooth * view.smooth / (view.rough * view.rough));
    view.facets.distribution = surface->distribution;
    view.facets.masking = surface->masking;
    view.facets.alpha_u = (float)view.rough;
    view.facets.alpha_v = (float)view.smooth;
    view.mu = (float)light.mu;
    view.wo = brdf_vec3_make(sine, 0.0f, view.mu);
    if (!view.round) { /* the surface is even about either tangent */
        view.wo.x *= (float)fabs(along_v ? light.along_v : light.along_u);
        view.wo.y = sine * (float)fabs(along_v ? light.along_u : light.along_v);
    }
    view.slope = view.rough * (double)view.wo.x;
    view.lean = view.smooth * (double)view.wo.y;
    brdf_vec3 w = view.round ? leaving(&view, view.mu, view.wo, 0.0f, 0.0f) : view.wo;
    view.area =
        brdf_microfacet_area(surface->distribution, w, view.facets.alpha_u, view.facets.alpha_v);
    if (surface->eta > 0.0) {
        view.critical2 = fmax((1.0 - surface->eta) * (1.0 + surface->eta), 0.0);
    }
    return view;
}

struct facet_shares facet_shares_of(const struct facet_surface *surface,
                                    const struct facet_rule *rule, struct facet_light light)
{
    struct facet_view view = view_of(surface, light);
    integrate_across(&view, rule);
    if (view.lean != 0.0) { /* the other side is not the mirror image */
        view.lean = -view.lean;
        view.wo.y = -view.wo.y;
        integrate_across(&view, rule);
    }
    view.shares.reflected /= view.all;
    view.shares.passed /= view.all;
    return view.shares;
}
