/*
 * glass_facets.c - what a rough interface does with light, by one facet: a quadrature over the
 * slopes of the facets as they are seen.
 *
 * The share of each facet is smooth in its slopes (x along the direction, y across it, for unit
 * roughness) but for kinks: where total reflection begins, and where what leaves the facet sinks
 * below the horizon. For given y each of them is a root of a quadratic equation in x; the
 * integral is cut there, and over y where those roots begin to be. Between cuts, Gauss's rule with
 * a substitution that is flat at both ends, for behind total reflection all goes as a square root.
 */
#include "glass_facets.h"

#include <math.h>

#include "brdf/fresnel.h"
#include "brdf/microfacet.h"

enum { CUTS = 10 };

/* Slopes of a Gaussian nearly evenly: FALL atanh(t), |t| <= EDGE. */
#define FALL 0.83
#define EDGE 0.99985

struct view {
    const struct glass_surface *surface;
    float mu, sine, area;
    double critical2;           /* square of the cosine where total reflection ends; 0 if none */
    struct glass_shares shares; /* sums */
    double all;                 /* sum of the weights */
};

struct cuts {
    double at[CUTS];
    int count;
};

struct glass_rule glass_rule_make(void)
{
    /* Gauss and Legendre's, on [-1, 1], the positive half. */
    static const double x[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                               0.9602898564975363};
    static const double w[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                               0.1012285362903763};
    struct glass_rule rule;
    for (int i = 0; i < GLASS_NODES; ++i) {
        int k = i < 4 ? 3 - i : i - 4;
        double v = 0.5 + (i < 4 ? -0.5 : 0.5) * x[k];
        rule.at[i] = v * v * (3.0 - 2.0 * v);
        rule.weight[i] = 6.0 * v * (1.0 - v) * 0.5 * w[k];
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

/* Real roots of a x^2 + b x + c; returns how many. */
static int roots(double a, double b, double c, double x[2])
{
    double discriminant = b * b - 4.0 * a * c;
    double q = -0.5 * (b + copysign(sqrt(fmax(discriminant, 0.0)), b));
    int count = 0;
    if (discriminant > 0.0 && a != 0.0) {
        x[count++] = q / a;
    }
    if (discriminant > 0.0 && q != 0.0) {
        x[count++] = c / q;
    }
    return count;
}

static float area_of(const struct glass_surface *surface, float z)
{
    float alpha = (float)surface->alpha;
    brdf_vec3 w = brdf_vec3_make(sqrtf(brdf_max(1.0f - z * z, 0.0f)), 0.0f, z);
    return brdf_microfacet_area(surface->distribution, w, alpha, alpha);
}

/* G2 / G1(wo) of light that leaves under the cosine z. */
static float seen(const struct view *view, float z)
{
    if (!(z > 0.0f)) {
        return 0.0f;
    }
    float area = area_of(view->surface, z);
    return z * view->area *
           brdf_microfacet_visibility(view->surface->masking, view->mu, z, view->area, area);
}

/* One facet, which weighs its projected area. */
static void add_facet(struct view *view, float x, float y2, float weight)
{
    float alpha = (float)view->surface->alpha, eta = (float)view->surface->eta;
    float projected = view->mu - alpha * x * view->sine; /* its cosine over that of its normal */
    if (!(projected > 0.0f)) {
        return;
    }
    float z = 1.0f / sqrtf(1.0f + alpha * alpha * (x * x + y2));
    float cosine = brdf_min(projected * z, 1.0f);
    struct brdf_fresnel fresnel = brdf_fresnel_dielectric(cosine, eta);
    float share = weight * projected;
    float along = cosine / eta - fresnel.cos_t;
    view->all += (double)share;
    view->shares.reflected +=
        (double)(share * fresnel.reflectance * seen(view, 2.0f * cosine * z - view->mu));
    if (fresnel.reflectance < 1.0f) {
        view->shares.passed +=
            (double)(share * (1.0f - fresnel.reflectance) * seen(view, view->mu / eta - along * z));
    }
}

/*
 * Kinks over x: roots of 2 projected / length^2 = mu, of cosine = critical, and, beyond total
 * reflection, of what passes under the horizon. `length2` is 1 + (alpha y)^2.
 */
static int kinks(const struct view *view, double length2, double x[6])
{
    double mu = (double)view->mu, sine = (double)view->sine, alpha = view->surface->alpha;
    double square = alpha * alpha, slope = alpha * sine;
    int count = roots(mu * square, 2.0 * slope, mu * (length2 - 2.0), x);
    if (view->critical2 > 0.0) {
        double rest = view->critical2;
        double horizon[2];
        int found = roots(mu * square, 2.0 * slope, mu * (length2 - 2.0) + rest / mu, horizon);
        for (int i = 0; i < found; ++i) {
            if (mu - slope * horizon[i] >= mu * (length2 + square * horizon[i] * horizon[i])) {
                x[count++] = horizon[i];
            }
        }
        count += roots(square * (sine * sine - rest), -2.0 * mu * slope, mu * mu - rest * length2,
                       x + count);
    }
    return count;
}

/* Of GGX, whose scale is sqrt(1 + y^2), the density over t is a half circle. */
static void integrate_along(struct view *view, const struct glass_rule *rule, double y,
                            double weight)
{
    const struct glass_surface *surface = view->surface;
    int ggx = surface->distribution == BRDF_GGX;
    double scale = ggx ? sqrt(1.0 + y * y) : FALL;
    double x[7];
    int count = kinks(view, 1.0 + surface->alpha * surface->alpha * y * y, x);
    if (view->sine > 0.0f) {
        x[count++] =
            (double)view->mu / (surface->alpha * (double)view->sine); /* facets turn away */
    }
    double edge = ggx ? 1.0 : EDGE;
    struct cuts cuts = {{-edge, edge}, 2};
    for (int i = 0; i < count; ++i) {
        double t = x[i] / scale;
        cut(&cuts, ggx ? t / sqrt(1.0 + t * t) : tanh(t));
    }
    for (int i = 0; i + 1 < cuts.count; ++i) {
        double width = cuts.at[i + 1] - cuts.at[i];
        for (int k = 0; k < GLASS_NODES; ++k) {
            float t = (float)(cuts.at[i] + width * rule->at[k]);
            float left = brdf_max((1.0f - t) * (1.0f + t), 1e-12f);
            float share = (float)(weight * width * rule->weight[k]);
            if (ggx) {
                float root = sqrtf(left);
                add_facet(view, (float)scale * t / root, (float)(y * y), share * root);
            } else {
                float x = (float)(0.5 * FALL) * brdf_log((1.0f + t) * (1.0f + t) / left);
                add_facet(view, x, (float)(y * y), share * brdf_exp(-x * x) / left);
            }
        }
    }
}

/* Where over y >= 0 kinks over x begin or end: where their equations have one root. */
static void cut_across(const struct view *view, struct cuts *cuts)
{
    double mu2 = (double)(view->mu * view->mu), sine2 = (double)(view->sine * view->sine);
    double slope2[3] = {1.0 / mu2, 0.0, 0.0}; /* (alpha y)^2 */
    int count = 1;
    if (view->critical2 > 0.0) {
        slope2[count++] = 1.0 + (sine2 - view->critical2) / mu2;
    }
    if (view->critical2 > sine2) {
        slope2[count++] = mu2 / (view->critical2 - sine2) - 1.0;
    }
    for (int i = 0; i < count; ++i) {
        double y = sqrt(fmax(slope2[i], 0.0)) / view->surface->alpha;
        cut(cuts, view->surface->distribution == BRDF_GGX ? atan(y) : tanh(y / FALL));
    }
}

struct glass_shares glass_shares_of(const struct glass_surface *surface,
                                    const struct glass_rule *rule, double mu)
{
    int ggx = surface->distribution == BRDF_GGX;
    struct view view = {surface, (float)mu, 0.0f, 0.0f, 0.0, {0.0, 0.0}, 0.0};
    view.sine = (float)sqrt(fmax(1.0 - mu * mu, 0.0));
    struct cuts cuts = {{0.0, ggx ? asin(1.0) : EDGE}, 2};
    view.area = area_of(surface, (float)mu);
    view.critical2 = fmax((1.0 - surface->eta) * (1.0 + surface->eta), 0.0);
    cut_across(&view, &cuts);
    for (int i = 0; i + 1 < cuts.count; ++i) {
        double width = cuts.at[i + 1] - cuts.at[i];
        for (int k = 0; k < GLASS_NODES; ++k) {
            double t = cuts.at[i] + width * rule->at[k];
            double y = ggx ? tan(t) : FALL * atanh(t);
            /* Up to a constant. */
            double density = ggx ? cos(t) : exp(-y * y) / (1.0 - t * t);
            integrate_along(&view, rule, y, width * rule->weight[k] * density);
        }
    }
    view.shares.reflected /= view.all;
    view.shares.passed /= view.all;
    return view.shares;
}
