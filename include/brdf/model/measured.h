/*
 * measured - a measured isotropic or anisotropic BRDF: an RGL `.bsdf` file.
 *
 * Reference: Dupuy and Jakob, "An Adaptive Parameterization for Efficient Material Acquisition and
 * Rendering", 2018: section 4 (the parameterization), section 5 (the data). The file has the
 * distribution D of microfacet normals and their projected area sigma, and two warps of the unit
 * square for each measured wo: by the distribution of visible normals, and by luminance. Colours
 * lie on a grid of the square that the first warp turns into directions, so the grid is dense where
 * the material reflects. f cos(theta_i) is the colour times D / (4 sigma(wo)); sampling goes
 * through both warps, and its density is their product over the Jacobian of the half vector.
 * The same interpolation as in the authors' own renderer, so values and densities are the same.
 * Valid above the surface for every direction. Not reciprocal, by a few percent or more: the data
 * is not. No energy is added or removed. Deviations: spectral files are reduced to linear Rec. 709
 * when they are read; a colour out of its gamut (negative) becomes 0 after interpolation; below
 * cos(theta_i) = 1e-6 the division by the cosine stops; a density below 1e-9 counts as 0.
 */
#ifndef BRDF_MODEL_MEASURED_H
#define BRDF_MODEL_MEASURED_H

#include "../azimuth.h"
#include "../math.h"
#include "../measurement.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_MEASURED_PARAMETERS(P)                                                                \
    P(REAL, scale, 1.0f, 0.0f, 100.0f, "1", "factor on the measured values")                       \
    P(FILE, filename, 0, 0, 0, "path", "the measurement, an RGL .bsdf file")

struct brdf_measured {
    BRDF_MEASURED_PARAMETERS(BRDF_FIELD)
};

/* The interval of ascending knots around x, and the place in it, 0 to 1. */
struct brdf_measured_interval {
    brdf_int first;
    brdf_real blend;
};

static inline struct brdf_measured_interval brdf_measured_interval_of(brdf_real x, int knots,
                                                                      BRDF_GLOBAL const float *knot)
{
    struct brdf_measured_interval interval;
    brdf_real low = knot[0];
    brdf_real high = knot[1];
    interval.first = 0;
    for (int k = 1; k < knots - 1; ++k) {
        brdf_mask above = x > knot[k];
        interval.first = brdf_pick_int(above, interval.first + 1, interval.first);
        low = brdf_pick(above, knot[k], low);
        high = brdf_pick(above, knot[k + 1], high);
    }
    interval.blend = brdf_clamp((x - low) / (high - low), 0.0f, 1.0f);
    return interval;
}

/* wo as the file sees it. */
struct brdf_measured_view {
    brdf_vec3 wo;
    brdf_vec3 azimuth; /* of wo, a unit vector in the plane */
    brdf_real sx;      /* signs with which directions were mirrored into the measured part */
    brdf_real sy;
    brdf_real theta; /* of wo, as a place in [0, 1] along the columns of sigma */
    brdf_real phi;   /* as a place along its rows */
    struct brdf_slices slices;
};

static inline brdf_real brdf_measured_theta(brdf_vec3 w)
{
    return brdf_max(brdf_atan2(sqrtf(w.x * w.x + w.y * w.y), w.z), 0.0f);
}

/* Angles to places in [0, 1] and back: theta goes by its square root. */
static inline brdf_real brdf_measured_column(brdf_real theta)
{
    return sqrtf(theta * BRDF_TWO_OVER_PI);
}

static inline brdf_real brdf_measured_row(brdf_real phi)
{
    brdf_real turn = phi * (0.5f * BRDF_1_PI) + 0.5f;
    return brdf_pick(turn >= 1.0f, turn - 1.0f, brdf_max(turn, 0.0f));
}

static inline struct brdf_measured_view brdf_measured_view_of(struct brdf_measured_layout layout,
                                                              brdf_vec3 wo,
                                                              BRDF_GLOBAL const float *table)
{
    struct brdf_measured_view view;
    view.sx = 1.0f;
    view.sy = 1.0f;
    if (layout.symmetry > 1) { /* both angles end up negative, as they are in the files */
        view.sy = brdf_pick(wo.y >= 0.0f, -1.0f, 1.0f);
        view.sx = layout.symmetry == 4 ? brdf_pick(wo.x >= 0.0f, -1.0f, 1.0f) : view.sy;
        wo.x = layout.symmetry == 4 ? -fabsf(wo.x) : wo.x * view.sx;
        wo.y = -fabsf(wo.y);
    }
    view.wo = wo;
    view.azimuth = brdf_azimuth(wo);
    brdf_real theta = brdf_measured_theta(wo);
    struct brdf_measured_interval along =
        brdf_measured_interval_of(theta, layout.vndf.thetas, table + layout.theta_words);
    view.theta = brdf_measured_column(theta);
    view.phi = 0.0f * theta;
    view.slices.first = along.first;
    view.slices.high = along.blend;
    view.slices.low = 1.0f - along.blend;
    view.slices.phi_high = 0.0f * theta;
    view.slices.phi_low = 1.0f;
    if (layout.vndf.phis > 1) {
        brdf_real phi = brdf_atan2(wo.y, wo.x);
        struct brdf_measured_interval around =
            brdf_measured_interval_of(phi, layout.vndf.phis, table + layout.phi_words);
        view.phi = brdf_measured_row(phi);
        view.slices.first = view.slices.first + around.first * layout.vndf.thetas;
        view.slices.phi_high = around.blend;
        view.slices.phi_low = 1.0f - around.blend;
    }
    return view;
}

/* A cell of D or sigma, whose corners lie side by side. */
static inline brdf_real brdf_measured_grid(int rows, int columns, brdf_real x, brdf_real y,
                                           BRDF_GLOBAL const float *words)
{
    brdf_real tx, ty;
    brdf_int column = brdf_map_cell(x, columns, &tx);
    brdf_int row = brdf_map_cell(y, rows, &ty);
    struct brdf_quad q = brdf_gather_quad(words, 4 * (row * (columns - 1) + column));
    return brdf_mix(brdf_mix(q.a, q.b, tx), brdf_mix(q.c, q.d, tx), ty);
}

/* What the file's colours are to be multiplied by: D / (4 sigma), D at a place of the square. */
static inline brdf_real brdf_measured_factor(struct brdf_measured_layout layout,
                                             struct brdf_measured_view view, brdf_real x,
                                             brdf_real y, BRDF_GLOBAL const float *table)
{
    brdf_real factor = 1.0f;
    if (layout.jacobian) {
        brdf_real d =
            brdf_measured_grid(layout.ndf_rows, layout.ndf_columns, x, y, table + layout.ndf_words);
        brdf_real sigma = brdf_measured_grid(layout.sigma_rows, layout.sigma_columns, view.theta,
                                             view.phi, table + layout.sigma_words);
        factor = d / (4.0f * brdf_max(sigma, 1e-9f));
    }
    return factor;
}

/* Colour and density of luminance at a node, blended between the slices. */
static inline struct brdf_quad brdf_measured_node(struct brdf_measured_layout layout,
                                                  struct brdf_slices slices,
                                                  BRDF_GLOBAL const float *words, brdf_int index)
{
    struct brdf_quad p = brdf_gather_quad(words, index);
    struct brdf_quad q = brdf_gather_quad(words + 4, index);
    p.a = p.a * slices.low + q.a * slices.high;
    p.b = p.b * slices.low + q.b * slices.high;
    p.c = p.c * slices.low + q.c * slices.high;
    p.d = p.d * slices.low + q.d * slices.high;
    if (layout.vndf.phis > 1) {
        words = words + 4 * layout.vndf.thetas;
        struct brdf_quad r = brdf_gather_quad(words, index);
        q = brdf_gather_quad(words + 4, index);
        p.a = p.a * slices.phi_low + (r.a * slices.low + q.a * slices.high) * slices.phi_high;
        p.b = p.b * slices.phi_low + (r.b * slices.low + q.b * slices.high) * slices.phi_high;
        p.c = p.c * slices.phi_low + (r.c * slices.low + q.c * slices.high) * slices.phi_high;
        p.d = p.d * slices.phi_low + (r.d * slices.low + q.d * slices.high) * slices.phi_high;
    }
    return p;
}

static inline struct brdf_quad brdf_measured_between(struct brdf_quad p, struct brdf_quad q,
                                                     brdf_real t)
{
    p.a = brdf_mix(p.a, q.a, t);
    p.b = brdf_mix(p.b, q.b, t);
    p.c = brdf_mix(p.c, q.c, t);
    p.d = brdf_mix(p.d, q.d, t);
    return p;
}

/* Colour and density of luminance at a place of the square. */
static inline struct brdf_quad brdf_measured_color(struct brdf_measured_layout layout,
                                                   struct brdf_slices slices, brdf_real x,
                                                   brdf_real y, BRDF_GLOBAL const float *table)
{
    brdf_real tx, ty;
    int size = layout.luminance.columns;
    brdf_int column = brdf_map_cell(x, size, &tx);
    brdf_int row = brdf_map_cell(y, size, &ty);
    int apart = 4 * layout.vndf.thetas * layout.vndf.phis;
    brdf_int index = (row * size + column) * apart + 4 * slices.first;
    BRDF_GLOBAL const float *near = table + layout.color_words;
    BRDF_GLOBAL const float *far = near + apart * size;
    struct brdf_quad lower =
        brdf_measured_between(brdf_measured_node(layout, slices, near, index),
                              brdf_measured_node(layout, slices, near + apart, index), tx);
    struct brdf_quad upper =
        brdf_measured_between(brdf_measured_node(layout, slices, far, index),
                              brdf_measured_node(layout, slices, far + apart, index), tx);
    return brdf_measured_between(lower, upper, ty);
}

/* What the file says of a pair of directions: f cos(theta_i) [1/sr] and the density [1/sr]. */
struct brdf_measured_value {
    brdf_rgb color;
    brdf_real pdf;
};

static inline struct brdf_measured_value brdf_measured_look(brdf_vec3 wo, brdf_vec3 wi,
                                                            BRDF_GLOBAL const float *table)
{
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
    wi.x = wi.x * view.sx;
    wi.y = wi.y * view.sy;
    brdf_vec3 sum = brdf_add(view.wo, wi);
    brdf_vec3 axis = layout.isotropic ? view.azimuth : brdf_vec3_make(1.0f, 0.0f, 0.0f);
    brdf_real x = brdf_measured_column(brdf_measured_theta(sum));
    brdf_real y = brdf_measured_row(
        brdf_atan2(axis.x * sum.y - axis.y * sum.x, axis.x * sum.x + axis.y * sum.y));
    struct brdf_point point = brdf_map_invert(layout.vndf, view.slices, x, y, table);
    struct brdf_quad color = brdf_measured_color(layout, view.slices, point.x, point.y, table);

    struct brdf_measured_value value;
    brdf_real factor = brdf_measured_factor(layout, view, x, y, table);
    value.color = brdf_rgb_make(brdf_max(color.a * factor, 0.0f), brdf_max(color.b * factor, 0.0f),
                                brdf_max(color.c * factor, 0.0f));

    /* d(wi) = 4 (wo . h) d(h), and d(h) = 2 pi^2 x sin(theta) dx dy; wo . h is half of |sum|. */
    brdf_real length = sqrtf(brdf_max(brdf_dot(sum, sum), 1e-12f));
    brdf_real sine = sqrtf(sum.x * sum.x + sum.y * sum.y) / length;
    brdf_real jacobian = brdf_max(19.7392088f * x * sine, 1e-6f) * (2.0f * length);
    brdf_real pdf = point.pdf * color.d / jacobian;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    value.color = brdf_rgb_pick(above, value.color, brdf_gray(0.0f));
    value.pdf = brdf_pick(above & (pdf > 1e-9f), pdf, 0.0f);
    return value;
}

static inline brdf_rgb brdf_measured_eval(struct brdf_measured p, brdf_vec3 wo, brdf_vec3 wi,
                                          BRDF_GLOBAL const float *table)
{
    brdf_rgb color = brdf_measured_look(wo, wi, table).color;
    return brdf_rgb_scale(color, p.scale / brdf_max(wi.z, 1e-6f));
}

static inline brdf_real brdf_measured_pdf(struct brdf_measured p, brdf_vec3 wo, brdf_vec3 wi,
                                          BRDF_GLOBAL const float *table)
{
    (void)p;
    return brdf_measured_look(wo, wi, table).pdf;
}

/* A normal of the file at a place of its square, turned to where wo is. */
static inline brdf_vec3 brdf_measured_normal(struct brdf_point place, brdf_vec3 axis)
{
    struct brdf_sincos turn = brdf_sincos_2pi(place.y - 0.5f);
    struct brdf_sincos tilt = brdf_sincos_2pi(0.25f * (place.x * place.x));
    return brdf_vec3_make(tilt.sin * (turn.cos * axis.x - turn.sin * axis.y),
                          tilt.sin * (turn.cos * axis.y + turn.sin * axis.x), tilt.cos);
}

static inline struct brdf_sample brdf_measured_sample(struct brdf_measured p, brdf_vec3 wo,
                                                      brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
    struct brdf_point bright = brdf_map_sample(layout.luminance, view.slices, u.y, u.x, table);
    struct brdf_point place = brdf_map_sample(layout.vndf, view.slices, bright.x, bright.y, table);
    brdf_vec3 axis = layout.isotropic ? view.azimuth : brdf_vec3_make(1.0f, 0.0f, 0.0f);
    brdf_vec3 wi = brdf_reflect(view.wo, brdf_measured_normal(place, axis));
    wi.x = wi.x * view.sx;
    wi.y = wi.y * view.sy;
    struct brdf_measured_value value = brdf_measured_look(wo, wi, table);
    brdf_mask valid = value.pdf > 0.0f;
    brdf_real cosine = wi.z / brdf_max(wi.z, 1e-6f);
    brdf_rgb weight =
        brdf_rgb_scale(value.color, p.scale * cosine / brdf_pick(valid, value.pdf, 1.0f));
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, value.pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(measured, MEASURED, BRDF_REFLECTION | BRDF_TABULATED | BRDF_ANISOTROPIC,
           "a measured material, isotropic or not, from an RGL .bsdf file", "Dupuy and Jakob 2018")
#endif
