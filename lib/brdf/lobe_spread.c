/* lobe_spread.c - how to sample the lobe of what a surface has lost. */
#include "lobe_spread.h"

#include <math.h>

/* The greatest weight, up to a factor. */
static double weight_most(const float *losses, const double *cosine2, int count, double spread)
{
    double most = 0.0;
    for (int i = 0; i < count; ++i) {
        most = fmax(most, (double)losses[i] * (cosine2[i] + spread));
    }
    return most * log1p(1.0 / spread);
}

double brdf_lobe_spread(const struct facet_surface *surface, const float *losses,
                        const double *cosine2, int count)
{
    enum { STEPS = 32 };
    double low = 4.0 * pow(fmin(surface->alpha_u, surface->alpha_v), 2.0);
    double high = 4.0 * pow(fmax(surface->alpha_u, surface->alpha_v), 2.0);
    double best = high, least = HUGE_VAL;
    for (int i = 0; i <= STEPS; ++i) {
        double spread = low * pow(high / low, (double)i / STEPS);
        double most = weight_most(losses, cosine2, count, spread);
        best = most < least ? spread : best;
        least = fmin(least, most);
    }
    return best;
}
