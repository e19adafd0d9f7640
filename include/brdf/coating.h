/*
 * coating.h - a rough dielectric interface over something: what of a direction gets through it, and
 * what it throws back of diffuse light from within.
 *
 * Neither has a closed form. Both are polynomials fitted to quadratures of the microfacet model of
 * refraction [Walter et al. 2007, eq. 21] with separable masking, light that meets one facet only:
 * tools/fit_coating.py, to 1e-3 at worst and 3e-4 on average. They hold for alpha in [1e-4, 2] and
 * eta in [1.1, 2.5], to which both are clamped.
 */
#ifndef BRDF_COATING_H
#define BRDF_COATING_H

#include "coating_fit.h"
#include "fresnel.h"
#include "math.h"
#include "microfacet.h"

#define BRDF_COATING_ETA_LOW 1.1f
#define BRDF_COATING_ETA_HIGH 2.5f

struct brdf_coating {
    int distribution;
    brdf_real alpha;
    brdf_real eta; /* below over above */
};

static inline struct brdf_coating brdf_coating_make(int distribution, brdf_real alpha,
                                                    brdf_real eta)
{
    struct brdf_coating coating;
    coating.distribution = distribution;
    coating.alpha = brdf_clamp(alpha, 1e-4f, 2.0f);
    coating.eta = brdf_clamp(eta, BRDF_COATING_ETA_LOW, BRDF_COATING_ETA_HIGH);
    return coating;
}

/* Where the fits have alpha and eta: sqrt(alpha) and sqrt((eta - 1) / (eta + 1)), to [-1, 1]. */
static inline brdf_real brdf_coating_y(struct brdf_coating coating)
{
    return 1.41421356f * sqrtf(coating.alpha) - 1.0f;
}

static inline brdf_real brdf_coating_z(struct brdf_coating coating)
{
    brdf_real root = sqrtf((coating.eta - 1.0f) / (coating.eta + 1.0f));
    return (root - 0.21821789f) * 4.58257569f - 1.0f;
}

/*
 * A first guess of what passes: that of a smooth interface under the mean angle at which facets
 * are met.
 */
static inline brdf_real brdf_coating_guess(struct brdf_coating coating, brdf_real cosine)
{
    brdf_real spread = 3.0f * coating.alpha * coating.alpha;
    brdf_real mean = sqrtf((cosine * cosine + spread) / (1.0f + spread));
    return 1.0f - brdf_fresnel_dielectric(brdf_min(mean, 1.0f), coating.eta).reflectance;
}

/* The fit's factor of the guess is a polynomial in x of degree 10; its coefficients. */
struct brdf_coating_curve {
    brdf_real c[11];
};

static inline struct brdf_coating_curve brdf_coating_curve_of(struct brdf_coating coating)
{
    struct brdf_coating_curve curve;
    brdf_real y = brdf_coating_y(coating);
    brdf_real z = brdf_coating_z(coating);
    int row = 0;
    for (int i = 0; i <= 10; ++i) {
        brdf_real power = 1.0f; /* of z */
        curve.c[i] = 0.0f;
        for (int k = 0; 105 - 7 * i - 14 * k >= 0 && k <= 5; ++k) {
            int most = (105 - 7 * i - 14 * k) / 5; /* power of y */
            most = most > 14 ? 14 : most;
            brdf_real sum = 0.0f;
            for (int j = most; j >= 0; --j) {
                sum = sum * y + (coating.distribution == BRDF_GGX
                                     ? brdf_coating_pass_ggx[row + j]
                                     : brdf_coating_pass_beckmann[row + j]);
            }
            curve.c[i] += power * sum;
            power = power * z;
            row += most + 1;
        }
    }
    return curve;
}

/* What of a direction gets through from above [1]; its cosine in [0, 1]. */
static inline brdf_real brdf_coating_pass(struct brdf_coating coating,
                                          struct brdf_coating_curve curve, brdf_real cosine)
{
    brdf_real cos2 = brdf_min(cosine * cosine, 1.0f);
    brdf_real spread = 2.0f * coating.alpha * coating.alpha;
    brdf_real below = brdf_max(cos2 + spread * (1.0f - cos2), 1e-20f);
    brdf_real x = 2.0f * cosine / sqrtf(below) - 1.0f;
    brdf_real factor = curve.c[10];
    for (int i = 9; i >= 0; --i) {
        factor = factor * x + curve.c[i];
    }
    return brdf_clamp(brdf_coating_guess(coating, cosine) * factor, 0.0f, 1.0f);
}

/* What of diffuse light from below is not thrown back [1]. */
static inline brdf_real brdf_coating_escape(struct brdf_coating coating)
{
    brdf_real y = brdf_coating_y(coating);
    brdf_real z = brdf_coating_z(coating);
    brdf_real inside = 0.0f;
    for (int k = 4; k >= 0; --k) {
        brdf_real sum = 0.0f;
        for (int j = 8; j >= 0; --j) {
            sum = sum * y + (coating.distribution == BRDF_GGX
                                 ? brdf_coating_inside_ggx[9 * k + j]
                                 : brdf_coating_inside_beckmann[9 * k + j]);
        }
        inside = inside * z + sum;
    }
    return brdf_clamp(1.0f - inside, 0.01f, 1.0f);
}

#endif
