/*
 * hapke - a deep layer of grains with a rough surface: the Moon, asteroids, sand.
 *
 *   f = w / (4 pi) mu_i / (mu_i + mu_o) / cos(theta_i) ((1 + B) p + H(mu_i) H(mu_o) - 1) S
 *
 * Reference: Hapke 1993 (Theory of reflectance and emittance spectroscopy), eq. 12.55; the parts:
 *   p  scattering by one grain: two lobes of Henyey and Greenstein, McGuire and Hapke 1995, or a
 *      sum of Legendre polynomials, Hapke 1984
 *   B  opposition surge, for a grain hides its own shadow: Hapke 1986, B_0 / (1 + tan(g / 2) / h)
 *   H  scattering by many: Hapke 2002, or Hapke 1981, (1 + 2 x) / (1 + 2 x sqrt(1 - w))
 *   S, mu_i, mu_o  slopes, tilted and shadowed: Hapke 1984 (Bidirectional reflectance
 *      spectroscopy 3: correction for macroscopic roughness)
 * g is the angle between wo and wi. Light that has met many grains counts as even (the isotropic
 * multiple scattering approximation); coherent backscatter and porosity are left out.
 * Valid for mean slopes theta below about 40 degrees. Bright grains with a surge reflect more than
 * they receive: that is the model. Where a sum of Legendre polynomials is negative, p is 0.
 */
#ifndef BRDF_MODEL_HAPKE_H
#define BRDF_MODEL_HAPKE_H

#include "../azimuth.h"
#include "../frame.h"
#include "../henyeygreenstein.h"
#include "../parameters.h"
#include "../regolith.h"
#include "../sample.h"

#define BRDF_HAPKE_PARAMETERS(P)                                                                   \
    P(CHOICE, phase, 0, 0, 1, "henyeygreenstein|legendre", "scattering by one grain, p")           \
    P(CHOICE, multiple, 0, 0, 1, "2002|1981", "Hapke's H for scattering by many, of that year")    \
    P(COLOR, w, 0.3f, 0.0f, 1.0f, "1", "fraction that one grain scatters")                         \
    P(REAL, b, 0.3f, 0.0f, 0.95f, "1", "henyeygreenstein: how narrow its lobes are")               \
    P(REAL, c, 0.7f, 0.0f, 1.0f, "1", "henyeygreenstein: part that goes back to the light")        \
    P(REAL, legendre_1, 0.3f, -1.5f, 1.5f, "1", "legendre: factor of cos(g)")                      \
    P(REAL, legendre_2, 0.4f, -1.0f, 1.0f, "1", "legendre: factor of (3 cos(g)^2 - 1) / 2")        \
    P(REAL, theta, 20.0f, 0.0f, 60.0f, "deg", "mean slope of the surface")                         \
    P(REAL, B_0, 0.8f, 0.0f, 1.0f, "1", "opposition surge: height; 0 is none")                     \
    P(REAL, h, 0.07f, 1e-3f, 1.0f, "1", "opposition surge: width, tan(g / 2) at half its height")

struct brdf_hapke {
    BRDF_HAPKE_PARAMETERS(BRDF_FIELD)
};

#define BRDF_HAPKE_HENYEYGREENSTEIN 0
#define BRDF_HAPKE_2002 0

/* H(x): light that meets isotropic grains again and again, of albedo w. */
static inline brdf_real brdf_hapke_h(struct brdf_hapke p, brdf_real w, brdf_real x)
{
    brdf_real gamma = sqrtf(brdf_max(1.0f - w, 0.0f));
    if (p.multiple != BRDF_HAPKE_2002) {
        return (1.0f + 2.0f * x) / (1.0f + 2.0f * x * gamma);
    }
    brdf_real r0 = (1.0f - gamma) / (1.0f + gamma);
    brdf_real y = brdf_max(x, 1e-12f);
    brdf_real log = brdf_log((1.0f + y) / y);
    return 1.0f / (1.0f - w * y * (r0 + (0.5f - r0 * y) * log));
}

/* (1 + B) p. Half the lengths of wo - wi and wo + wi are sine and cosine of g / 2. */
static inline brdf_real brdf_hapke_once(struct brdf_hapke p, brdf_vec3 wo, brdf_vec3 wi)
{
    brdf_vec3 apart = brdf_sub(wo, wi);
    brdf_vec3 sum = brdf_add(wo, wi);
    brdf_real near = 0.5f * brdf_dot(apart, apart); /* 1 - cos g */
    brdf_real far = 0.5f * brdf_dot(sum, sum);      /* 1 + cos g */
    brdf_real phase;
    if (p.phase == BRDF_HAPKE_HENYEYGREENSTEIN) {
        phase =
            p.c * brdf_henyeygreenstein(near, p.b) + (1.0f - p.c) * brdf_henyeygreenstein(far, p.b);
    } else {
        brdf_real cosine = 0.5f * (far - near);
        phase = 1.0f + p.legendre_1 * cosine + p.legendre_2 * (1.5f * cosine * cosine - 0.5f);
        phase = brdf_max(phase, 0.0f);
    }
    brdf_real width = p.h * sqrtf(far);
    return phase * (1.0f + p.B_0 * width / (width + sqrtf(near)));
}

/* What a slope does to one direction, of cosine z: Hapke 1984, E1, E2 and eta. */
struct brdf_hapke_slope {
    brdf_real z;
    brdf_real sine; /* times the tangent of the mean slope */
    brdf_real e2;
    brdf_real lost_1; /* 1 - E1 and 1 - E2, which keep their digits where z is nearly 0 */
    brdf_real lost_2;
    brdf_real eta; /* over chi */
};

/* 1 - exp(-x) for x >= 0. */
static inline brdf_real brdf_hapke_lost(brdf_real x)
{
    brdf_real y = brdf_min(x, 0.2f);
    brdf_real series =
        y * (1.0f - y * (0.5f - y * (0.166666667f - y * (0.0416666667f - y * 0.00833333333f))));
    return brdf_pick(x < 0.2f, series, 1.0f - brdf_exp(-x));
}

static inline struct brdf_hapke_slope brdf_hapke_slope_make(brdf_real z, brdf_real tangent)
{
    struct brdf_hapke_slope s;
    brdf_real sine = sqrtf(brdf_max((1.0f - z) * (1.0f + z), 0.0f));
    brdf_real x = z / brdf_max(sine * tangent, 1e-12f); /* cot(slope) cot(theta) */
    s.z = z;
    s.sine = sine * tangent;
    s.lost_1 = brdf_hapke_lost(BRDF_TWO_OVER_PI * x);
    s.lost_2 = brdf_hapke_lost(BRDF_1_PI * x * x);
    s.e2 = 1.0f - s.lost_2;
    s.eta = z + s.sine * s.e2 / (1.0f + s.lost_1);
    return s;
}

/* The two effective cosines, and S / (chi cos cos) without their product. */
struct brdf_hapke_rough {
    brdf_real steep; /* of the direction nearer to the normal */
    brdf_real flat;
    brdf_real shadow;
};

/*
 * Hapke 1984, by the direction nearer to the normal and the other one instead of by
 * wi and wo, which makes reciprocity exact. Differences from azimuth pi, where terms cancel, come
 * from the sum and the difference of the two azimuths.
 */
static inline struct brdf_hapke_rough brdf_hapke_roughen(brdf_real slope, brdf_vec3 wo,
                                                         brdf_vec3 wi)
{
    struct brdf_sincos angle = brdf_sincos(slope * (BRDF_PI / 180.0f));
    brdf_real tangent = angle.sin / angle.cos;
    brdf_real chi = 1.0f / sqrtf(1.0f + BRDF_PI * tangent * tangent);
    struct brdf_hapke_slope n = brdf_hapke_slope_make(brdf_max(wo.z, wi.z), tangent);
    struct brdf_hapke_slope m = brdf_hapke_slope_make(brdf_min(wo.z, wi.z), tangent);
    brdf_vec3 a = brdf_azimuth(wo);
    brdf_vec3 b = brdf_azimuth(wi);
    brdf_vec3 sum = brdf_add(a, b);
    brdf_vec3 apart = brdf_sub(a, b);
    brdf_real cosine = 0.5f * sqrtf(brdf_dot(sum, sum)); /* of psi / 2 */
    brdf_real sine = 0.5f * sqrtf(brdf_dot(apart, apart));
    brdf_real opposite = BRDF_TWO_OVER_PI * brdf_atan2(cosine, sine); /* 1 - psi / pi */
    /* 2 - E1(m) - psi / pi E1(n) */
    brdf_real below = m.lost_1 + opposite + (1.0f - opposite) * n.lost_1;
    below = brdf_max(below, 1e-30f);
    /* cos(psi) E2(m) + sin^2(psi / 2) E2(n) */
    brdf_real steep = cosine * cosine * (2.0f * m.e2 - n.e2) + (m.lost_2 - n.lost_2);
    brdf_real flat = m.e2 - sine * sine * n.e2;
    struct brdf_hapke_rough r;
    r.steep = brdf_max(chi * (n.z + n.sine * steep / below), 1e-12f);
    r.flat = brdf_max(chi * (m.z + m.sine * flat / below), 1e-12f);
    brdf_real lit = brdf_exp(-2.0f * sine / brdf_max(cosine, 1e-6f)); /* f(psi) */
    brdf_real eta = brdf_max(chi * n.eta, 1e-12f);
    r.shadow = chi / (eta * brdf_max(chi * m.eta, 1e-12f) *
                      (1.0f - lit + lit * chi * brdf_max(n.z, 1e-12f) / eta));
    return r;
}

static inline brdf_real brdf_hapke_channel(struct brdf_hapke p, brdf_real w, brdf_real once,
                                           struct brdf_hapke_rough r)
{
    brdf_real many = brdf_hapke_h(p, w, r.steep) * brdf_hapke_h(p, w, r.flat) - 1.0f;
    return w * (once + brdf_max(many, 0.0f));
}

static inline brdf_rgb brdf_hapke_eval(struct brdf_hapke p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)table;
    BRDF_KNOWN(HAPKE, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_vec3 o = brdf_vec3_make(wo.x, wo.y, brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_vec3 i = brdf_vec3_make(wi.x, wi.y, brdf_clamp(wi.z, 0.0f, 1.0f));
    struct brdf_hapke_rough r = brdf_hapke_roughen(p.theta, o, i);
    brdf_real once = brdf_hapke_once(p, wo, wi);
    /* The cosines of S and of f cancel: what is left is the same in both directions. */
    brdf_real f = (0.25f * BRDF_1_PI) * r.shadow * (r.steep * r.flat / (r.steep + r.flat));
    brdf_rgb grains =
        brdf_rgb_make(brdf_hapke_channel(p, p.w.r, once, r), brdf_hapke_channel(p, p.w.g, once, r),
                      brdf_hapke_channel(p, p.w.b, once, r));
    return brdf_rgb_pick(above, brdf_rgb_scale(grains, f), brdf_gray(0.0f));
}

/* Probabilities of the lobe back to the light and of the one through the grain; what is left of 1
   goes as light that has met dark grains once. The power of b and the slope's factor are those that
   gave the least variance over the range of the parameters. */
struct brdf_hapke_shares {
    brdf_real back;
    brdf_real through;
    brdf_real even; /* the form of the rest: regolith.h */
};

static inline struct brdf_hapke_shares brdf_hapke_shares(struct brdf_hapke p, brdf_real mu)
{
    struct brdf_hapke_shares s;
    brdf_real h = brdf_hapke_h(p, brdf_rgb_largest(p.w), mu);
    brdf_real lobes =
        p.phase == BRDF_HAPKE_HENYEYGREENSTEIN ? p.b * sqrtf(p.b) / (h * h) : 0.0f * mu;
    s.back = lobes * p.c;
    s.through = lobes * (1.0f - p.c) * (1.0f - mu); /* seen from above, it is below */
    /* Slopes shade each other, which leaves less light near the horizon. */
    s.even = brdf_regolith_share(mu) / (1.0f + 0.1f * p.theta);
    return s;
}

static inline brdf_real brdf_hapke_pdf(struct brdf_hapke p, brdf_vec3 wo, brdf_vec3 wi,
                                       BRDF_GLOBAL const float *table)
{
    (void)table;
    BRDF_KNOWN(HAPKE, p);
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    struct brdf_hapke_shares s = brdf_hapke_shares(p, brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_vec3 apart = brdf_sub(wo, wi);
    brdf_vec3 sum = brdf_add(wo, wi);
    brdf_real back = brdf_henyeygreenstein(0.5f * brdf_dot(apart, apart), p.b);
    brdf_real through = brdf_henyeygreenstein(0.5f * brdf_dot(sum, sum), p.b);
    brdf_real pdf = (0.25f * BRDF_1_PI) * (s.back * back + s.through * through) +
                    (1.0f - s.back - s.through) * brdf_regolith_pdf(s.even, wi);
    return brdf_pick(above, pdf, 0.0f);
}

static inline struct brdf_sample brdf_hapke_sample(struct brdf_hapke p, brdf_vec3 wo, brdf_vec3 u,
                                                   BRDF_GLOBAL const float *table)
{
    BRDF_KNOWN(HAPKE, p);
    struct brdf_hapke_shares s = brdf_hapke_shares(p, brdf_clamp(wo.z, 0.0f, 1.0f));
    brdf_vec3 lobe = brdf_henyeygreenstein_sample(p.b, u.x, u.y);
    lobe = brdf_to_world(brdf_frame_from_normal(wo), lobe);
    lobe = brdf_vec3_pick(u.z < s.back, lobe, brdf_negate(lobe));
    brdf_vec3 even = brdf_regolith_sample(s.even, u.x, u.y);
    brdf_vec3 wi = brdf_vec3_pick(u.z < s.back + s.through, lobe, even);
    brdf_real pdf = brdf_hapke_pdf(p, wo, wi, table);
    return brdf_sample_weigh(pdf > 0.0f, wi, brdf_hapke_eval(p, wo, wi, table), pdf);
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(hapke, HAPKE, BRDF_REFLECTION | BRDF_RECIPROCAL,
           "grains under a rough surface, with opposition surge", "Hapke 1984, 1993, 2002")
#endif
