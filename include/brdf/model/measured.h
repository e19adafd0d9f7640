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
 * cos(theta_i) = 1e-6 the division by the cosine stops; a density below 1e-9 counts as 0; within
 * 1.6e-5 rad of the mirror direction the density is that at this distance (theirs falls to 0).
 */
#ifndef BRDF_MODEL_MEASURED_H
#define BRDF_MODEL_MEASURED_H

#include "../measurement_view.h"
#include "../parameters.h"
#include "../sample.h"

#define BRDF_MEASURED_PARAMETERS(P)                                                                \
    P(REAL, scale, 1.0f, 0.0f, 100.0f, "1", "factor on the measured values")                       \
    P(FILE, filename, 0, 0, 0, "path", "the measurement, an RGL .bsdf file")

struct brdf_measured {
    BRDF_MEASURED_PARAMETERS(BRDF_FIELD)
};

/* A cell of D or sigma, whose corners lie side by side. */
static inline brdf_real brdf_measured_grid(int rows, int columns, brdf_real x, brdf_real y,
                                           BRDF_GLOBAL const float *words)
{
    brdf_real tx, ty;
    brdf_int column = brdf_grid_cell(x, columns, &tx);
    brdf_int row = brdf_grid_cell(y, rows, &ty);
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

/* Colours and density of luminance at the corners of a cell, all blended. */
static inline struct brdf_quad brdf_measured_corners(struct brdf_slices slices, int across,
                                                     int along, brdf_real tx, brdf_real ty,
                                                     BRDF_GLOBAL const float *words, brdf_int index)
{
    struct brdf_quad up = brdf_quad_spread(ty);
    struct brdf_quad left = brdf_quad_mix(brdf_thetas_blend(slices, 4, words, index),
                                          brdf_thetas_blend(slices, 4, words + across, index), up);
    words = words + along;
    struct brdf_quad right = brdf_quad_mix(brdf_thetas_blend(slices, 4, words, index),
                                           brdf_thetas_blend(slices, 4, words + across, index), up);
    return brdf_quad_mix(left, right, brdf_quad_spread(tx));
}

/* Colour and density of luminance at a point of the warped square. */
static inline struct brdf_quad brdf_measured_color(struct brdf_measured_layout layout,
                                                   struct brdf_slices slices,
                                                   struct brdf_point point,
                                                   BRDF_GLOBAL const float *table)
{
    brdf_real tx, ty;
    brdf_int column = brdf_grid_cell(point.x, layout.size, &tx);
    brdf_int row = brdf_grid_cell(point.y, layout.size, &ty);
    int along = 4 * layout.thetas * layout.phis;
    int across = along * layout.size;
    brdf_int index = (row * layout.size + column) * along + 4 * slices.first;
    BRDF_GLOBAL const float *words = table + layout.color_words;
    struct brdf_quad color = brdf_measured_corners(slices, across, along, tx, ty, words, index);
    if (layout.phis > 1) {
        words = words + 4 * layout.thetas;
        color =
            brdf_quad_mix(color, brdf_measured_corners(slices, across, along, tx, ty, words, index),
                          brdf_quad_spread(slices.phi_high));
    }
    return brdf_quad_transpose(color);
}

/*
 * The solid angle of wi over the area of the square: d(wi) = 4 (wo . h) d(h), and
 * d(h) = 2 pi^2 x sin(theta) dx dy. At the mirror direction, where x and theta are 0, the density
 * of the square is 0 too: there the quotient of both is that on a circle around it of 1.6e-5 rad.
 */
static inline brdf_real brdf_measured_jacobian(struct brdf_measured_facet facet)
{
    return 19.7392088f * facet.x * brdf_max(facet.sine, 1.594e-5f) * (4.0f * facet.cosine);
}

/* What the file says of a pair of directions: f cos(theta_i) [1/sr] and the density [1/sr]. */
struct brdf_measured_value {
    brdf_rgb color;
    brdf_real pdf;
};

/* `point` is where the warp has the facet, and the density of the warp at the facet. */
static inline struct brdf_measured_value brdf_measured_value_of(struct brdf_measured_layout layout,
                                                                struct brdf_measured_view view,
                                                                struct brdf_measured_facet facet,
                                                                struct brdf_point point,
                                                                BRDF_GLOBAL const float *table)
{
    brdf_real factor = brdf_measured_factor(layout, view, facet.x, facet.y, table);
    struct brdf_quad color = brdf_measured_color(layout, view.slices, point, table);
    struct brdf_measured_value value;
    value.color = brdf_rgb_make(brdf_max(color.a * factor, 0.0f), brdf_max(color.b * factor, 0.0f),
                                brdf_max(color.c * factor, 0.0f));
    value.pdf = point.pdf * color.d / brdf_measured_jacobian(facet);
    return value;
}

static inline struct brdf_measured_value brdf_measured_look(struct brdf_measured_layout layout,
                                                            struct brdf_measured_view view,
                                                            brdf_vec3 wi,
                                                            BRDF_GLOBAL const float *table)
{
    struct brdf_measured_facet facet = brdf_measured_facet_of(layout, view, wi);
    struct brdf_point point = brdf_map_invert(layout.vndf, view.slices, facet.x, facet.y, table);
    return brdf_measured_value_of(layout, view, facet, point, table);
}

static inline brdf_rgb brdf_measured_eval(struct brdf_measured p, brdf_vec3 wo, brdf_vec3 wi,
                                          BRDF_GLOBAL const float *table)
{
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
    brdf_rgb color = brdf_measured_look(layout, view, wi, table).color;
    brdf_mask above = (wo.z > 0.0f) & (wi.z > 0.0f);
    return brdf_rgb_pick(above, brdf_rgb_scale(color, p.scale / brdf_max(wi.z, 1e-6f)),
                         brdf_gray(0.0f));
}

static inline brdf_real brdf_measured_pdf(struct brdf_measured p, brdf_vec3 wo, brdf_vec3 wi,
                                          BRDF_GLOBAL const float *table)
{
    (void)p;
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
    struct brdf_measured_facet facet = brdf_measured_facet_of(layout, view, wi);
    struct brdf_point point = brdf_map_invert(layout.vndf, view.slices, facet.x, facet.y, table);
    brdf_real bright = brdf_map_density(layout.luminance, view.slices, point.x, point.y, table);
    brdf_real pdf = point.pdf * bright / brdf_measured_jacobian(facet);
    return brdf_pick((wo.z > 0.0f) & (wi.z > 0.0f) & (pdf > 1e-9f), pdf, 0.0f);
}

/* A normal of the file at a place of its square, turned to where wo is. */
static inline brdf_vec3 brdf_measured_normal(struct brdf_point place, brdf_vec3 axis)
{
    struct brdf_sincos turn = brdf_sincos_2pi(place.y - 0.5f);
    struct brdf_sincos tilt = brdf_sincos_2pi(0.25f * (place.x * place.x));
    return brdf_vec3_make(tilt.sin * (turn.cos * axis.x - turn.sin * axis.y),
                          tilt.sin * (turn.cos * axis.y + turn.sin * axis.x), tilt.cos);
}

/*
 * One of the slices that are blended, by u: what is sampled from it has the blended density, which
 * is a mixture of theirs, and costs half as much.
 */
static inline struct brdf_slices brdf_measured_slice(struct brdf_measured_layout layout,
                                                     struct brdf_slices slices, brdf_real u)
{
    if (layout.phis > 1) {
        brdf_mask next = u < slices.phi_high;
        brdf_real part = brdf_pick(next, slices.phi_high, 1.0f - slices.phi_high);
        u = brdf_pick(next, u, u - slices.phi_high) / brdf_max(part, 1e-9f);
        slices.first = slices.first + brdf_pick_int(next, layout.thetas, 0);
    }
    slices.first = slices.first + brdf_pick_int(u < slices.high, 1, 0);
    slices.alone = 1;
    return slices;
}

/*
 * Value and density are those of the way that led to wi. Where they hang on the last digits of wi
 * (both directions at the horizon, the mirror direction, normals that are hardly seen, the azimuth
 * where the square ends), they are those of eval and pdf.
 */
static inline struct brdf_sample brdf_measured_sample(struct brdf_measured p, brdf_vec3 wo,
                                                      brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    struct brdf_measured_layout layout = brdf_measured_layout_of(table);
    struct brdf_measured_view view = brdf_measured_view_of(layout, wo, table);
    struct brdf_slices slice = brdf_measured_slice(layout, view.slices, u.z);
    struct brdf_point point = brdf_map_sample(layout.luminance, slice, u.y, u.x, table);
    struct brdf_point place = brdf_map_sample(layout.vndf, view.slices, point.x, point.y, table);
    point.pdf = place.pdf;
    brdf_vec3 normal =
        brdf_measured_normal(place, brdf_normalize(brdf_measured_axis(layout, view)));
    struct brdf_measured_facet facet;
    facet.x = brdf_max(place.x, 1e-6f);
    facet.y = place.y;
    facet.sine = sqrtf(normal.x * normal.x + normal.y * normal.y);
    facet.cosine = brdf_dot(view.wo, normal);
    brdf_vec3 wi = brdf_sub(brdf_scale(normal, 2.0f * facet.cosine), view.wo);
    wi.x = wi.x * view.sx;
    wi.y = wi.y * view.sy;

    struct brdf_measured_value value = brdf_measured_value_of(layout, view, facet, point, table);
    brdf_mask valid = (wo.z > 0.0f) & (wi.z > 0.0f);
    brdf_mask doubtful = (facet.cosine < 0.02f) | (facet.sine < 1e-4f) | (place.pdf < 1e-3f) |
                         (value.pdf < 2e-4f) | (fabsf(place.y - 0.5f) > 0.499999f);
    doubtful = doubtful & valid;
    if (brdf_any(doubtful)) {
        struct brdf_measured_value back = brdf_measured_look(layout, view, wi, table);
        value.color = brdf_rgb_pick(doubtful, back.color, value.color);
        value.pdf = brdf_pick(doubtful, back.pdf, value.pdf);
    }
    valid = valid & (value.pdf > 1e-9f);
    brdf_real scale = p.scale * brdf_min(1.0f, wi.z * 1e6f); /* as eval divides by the cosine */
    brdf_rgb weight = brdf_rgb_scale(value.color, scale / brdf_pick(valid, value.pdf, 1.0f));
    return brdf_sample_where(valid, brdf_sample_make(wi, weight, value.pdf));
}

#endif

#ifdef BRDF_MODEL
BRDF_MODEL(measured, MEASURED, BRDF_REFLECTION | BRDF_TABULATED | BRDF_ANISOTROPIC,
           "a measured material, isotropic or not, from an RGL .bsdf file", "Dupuy and Jakob 2018")
#endif
