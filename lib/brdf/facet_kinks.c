/*
 * facet_kinks.c - where the share of a facet has kinks: where total reflection begins, where what
 * leaves the facet sinks below the horizon, and where the walls of V-cavities begin to mask.
 *
 * For given y nearly all of them are roots of quadratic equations in x. With P = mu - slope x -
 * lean y, length^2 = 1 + (rough x)^2 + (smooth y)^2 and z = 1 / length, the facet's normal has the
 * cosine z, and P z is that between it and the light.
 */
#include "facet_view.h"

#include <math.h>

/* a x^2 + b x + c = 0 for a given y. */
struct kink {
    double a, b, c;
    int passes; /* of light that passes: only roots where it leaves at all */
};

enum { KINKS = 4 };

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

static double cubic_at(const double c[4], double x)
{
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
}

/* The same of c[0] + c[1] x + c[2] x^2 + c[3] x^3, by bisection between its turning points; further
   out than this no facet matters. */
static int cubic_roots(const double c[4], double x[3])
{
    const double out = 40.0;
    double at[4] = {-out, 0.0, 0.0, 0.0}, turn[2] = {0.0, 0.0};
    int turns = roots(3.0 * c[3], 2.0 * c[2], c[1], turn), pieces = 1, count = 0;
    int swapped = turns == 2 && turn[0] > turn[1];
    for (int i = 0; i < turns; ++i) {
        at[pieces++] = fmin(fmax(turn[swapped ? 1 - i : i], -out), out);
    }
    at[pieces] = out;
    for (int i = 0; i < pieces; ++i) {
        double low = at[i], high = at[i + 1], sign = cubic_at(c, low);
        if (sign * cubic_at(c, high) >= 0.0) {
            continue;
        }
        for (int step = 0; step < 30; ++step) {
            double middle = 0.5 * (low + high);
            int before = sign * cubic_at(c, middle) > 0.0;
            low = before ? middle : low;
            high = before ? high : middle;
        }
        x[count++] = low;
    }
    return count;
}

/*
 * Where 2 P = mu length^2: what is reflected leaves along the horizon; where, beyond total
 * reflection, what passes does; where P^2 = critical^2 length^2; of V-cavities, where both cosines
 * are the same.
 */
static int kinks_of(const struct facet_view *view, double y, struct kink kink[KINKS])
{
    double mu = (double)view->mu, side = (double)view->wo.x, lean = view->lean * y;
    double square = view->rough * view->rough, slope = view->slope;
    double length2 = 1.0 + view->smooth * view->smooth * y * y;
    int count = 0;
    kink[count++] = (struct kink){mu * square, 2.0 * slope, mu * (length2 - 2.0) + 2.0 * lean, 0};
    if (view->critical2 > 0.0) {
        double rest = view->critical2, left = mu - lean;
        kink[count] = kink[0];
        kink[count].c += rest / mu;
        kink[count++].passes = 1;
        kink[count++] = (struct kink){square * (side * side - rest), -2.0 * left * slope,
                                      left * left - rest * length2, 0};
    }
    if (view->surface->masking == BRDF_MASKING_VCAVITY) {
        kink[count++] = (struct kink){mu * square, slope, mu * (length2 - 1.0) + lean, 0};
    }
    return count;
}

/* Where walls of V-cavities begin to hide what is seen of one another, P = 2 mu, and what is
   reflected, 2 (2 P z^2 - mu) = P. */
static int walls_along(const struct facet_view *view, double left, double length2, double x[4])
{
    double mu = (double)view->mu, square = view->rough * view->rough, slope = view->slope;
    double both = left + 2.0 * mu;
    double masked[4] = {both * length2 - 4.0 * left, slope * (4.0 - length2), both * square,
                        -slope * square};
    int count = cubic_roots(masked, x);
    if (slope > 0.0) {
        x[count++] = (left - 2.0 * mu) / slope;
    }
    return count;
}

/*
 * GGX has facets so steep that light which grazes along the smoother tangent meets them with x far
 * out. In their midst, about where light leaves within the plane of the normal, what is reflected
 * is masked by another scale: where it leans by as much as masking begins at.
 */
static int core_along(const struct facet_view *view, double left, double length2, double x[2])
{
    double square = view->rough * view->rough, twice = 2.0 * left / length2;
    if (view->round || view->surface->distribution != BRDF_GGX || !(twice > (double)view->mu)) {
        return 0;
    }
    double middle = -view->slope / (twice * square);
    double reach = (1.0 - (double)view->mu / twice) / square;
    x[0] = middle - reach;
    x[1] = middle + reach;
    return 2;
}

int facet_kinks_along(const struct facet_view *view, double y, double x[FACET_KINKS_ALONG])
{
    double mu = (double)view->mu, left = mu - view->lean * y;
    double square = view->rough * view->rough;
    double length2 = 1.0 + view->smooth * view->smooth * y * y;
    struct kink kink[KINKS];
    int count = 0;
    for (int i = 0, kinks = kinks_of(view, y, kink); i < kinks; ++i) {
        double root[2];
        int found = roots(kink[i].a, kink[i].b, kink[i].c, root);
        for (int k = 0; k < found; ++k) {
            if (!kink[i].passes ||
                left - view->slope * root[k] >= mu * (length2 + square * root[k] * root[k])) {
                x[count++] = root[k];
            }
        }
    }
    count += core_along(view, left, length2, x + count);
    if (view->slope > 0.0) {
        x[count++] = left / view->slope; /* facets turn away */
    }
    if (view->surface->masking == BRDF_MASKING_VCAVITY) {
        count += walls_along(view, left, length2, x + count);
    }
    return count;
}

/* Where the quadratic equations of a round surface have one root. */
static int across_round(const struct facet_view *view, double y[FACET_KINKS_ACROSS])
{
    double mu2 = (double)(view->mu * view->mu), sine2 = (double)(view->wo.x * view->wo.x);
    double slope2[3] = {1.0 / mu2, 0.0, 0.0}; /* (alpha y)^2 */
    int count = 1;
    if (view->critical2 > 0.0) {
        slope2[count++] = 1.0 + (sine2 - view->critical2) / mu2;
    }
    if (view->critical2 > sine2) {
        slope2[count++] = mu2 / (view->critical2 - sine2) - 1.0;
    }
    for (int i = 0; i < count; ++i) {
        y[i] = sqrt(fmax(slope2[i], 0.0)) / view->rough;
    }
    return count;
}

/* Walls as above, of light along the smoother tangent, where they do not depend on x. */
static int walls_across(const struct facet_view *view, double y[4])
{
    double mu = (double)view->mu, lean = view->lean, square = view->smooth * view->smooth;
    double masked[4] = {-mu, 3.0 * lean, 3.0 * mu * square, -lean * square};
    int count = cubic_roots(masked, y);
    if (lean != 0.0) {
        y[count++] = -mu / lean;
    }
    return count;
}

/* Of any: discriminants are quadratic in y, so that three of each tell where it is 0. */
int facet_kinks_across(const struct facet_view *view, double y[FACET_KINKS_ACROSS])
{
    struct kink kink[3][KINKS];
    double step = 1.0 / view->smooth;
    int count = 0, kinks = 0;
    if (view->round) {
        return across_round(view, y);
    }
    for (int i = 0; i < 3; ++i) {
        kinks = kinks_of(view, (i - 1) * step, kink[i]);
    }
    for (int k = 0; k < kinks; ++k) {
        double d[3];
        for (int i = 0; i < 3; ++i) {
            d[i] = kink[i][k].b * kink[i][k].b - 4.0 * kink[i][k].a * kink[i][k].c;
        }
        count += roots((0.5 * (d[0] + d[2]) - d[1]) / (step * step), 0.5 * (d[2] - d[0]) / step,
                       d[1], y + count);
    }
    if (view->lean != 0.0) {
        y[count++] = (double)view->mu / view->lean; /* facets turn away */
    }
    if (view->surface->masking == BRDF_MASKING_VCAVITY) {
        count += walls_across(view, y + count);
    }
    return count;
}
