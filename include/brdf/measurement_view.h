/*
 * measurement_view.h - directions as the files of the model `measured` have them: places along
 * theta_i and phi_i, and places of a square for the normals of facets.
 */
#ifndef BRDF_MEASUREMENT_VIEW_H
#define BRDF_MEASUREMENT_VIEW_H

#include "measurement.h"
#include "trigonometry.h"
#include "vec.h"

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
    brdf_real radius; /* of wo in the plane: the sine of its theta */
    brdf_real sx;     /* signs with which directions were mirrored into the measured part */
    brdf_real sy;
    brdf_real theta; /* of wo, as a place in [0, 1] along the columns of sigma */
    brdf_real phi;   /* as a place along its rows */
    struct brdf_slices slices;
};

/* The angle from the normal to (radius, z), where z >= 0. */
static inline brdf_real brdf_measured_theta(brdf_real radius, brdf_real z)
{
    return brdf_max(brdf_atan2(radius, z), 0.0f);
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
    view.radius = sqrtf(wo.x * wo.x + wo.y * wo.y);
    brdf_real theta = brdf_measured_theta(view.radius, wo.z);
    struct brdf_measured_interval along =
        brdf_measured_interval_of(theta, layout.thetas, table + layout.theta_words);
    view.theta = brdf_measured_column(theta);
    view.phi = 0.0f * theta;
    view.slices.first = along.first;
    view.slices.high = along.blend;
    view.slices.phi_high = 0.0f * theta;
    view.slices.alone = 0;
    if (layout.phis > 1) {
        brdf_real phi = brdf_atan2(wo.y, wo.x);
        struct brdf_measured_interval around =
            brdf_measured_interval_of(phi, layout.phis, table + layout.phi_words);
        view.phi = brdf_measured_row(phi);
        view.slices.first = view.slices.first + around.first * layout.thetas;
        view.slices.phi_high = around.blend;
    }
    return view;
}

/* What azimuths of normals are relative to, in the plane: wo, of length view.radius, or x. */
static inline brdf_vec3 brdf_measured_axis(struct brdf_measured_layout layout,
                                           struct brdf_measured_view view)
{
    brdf_mask leans = brdf_mask_of(layout.isotropic) & (view.radius > 1e-15f);
    return brdf_vec3_make(brdf_pick(leans, view.wo.x, 1.0f), brdf_pick(leans, view.wo.y, 0.0f),
                          0.0f);
}

/* The normal halfway between two directions, as a place of the file's square. */
struct brdf_measured_facet {
    brdf_real x; /* not 0: the square has no area there */
    brdf_real y;
    brdf_real sine;   /* of its theta */
    brdf_real cosine; /* from it to wo */
};

static inline struct brdf_measured_facet brdf_measured_facet_of(struct brdf_measured_layout layout,
                                                                struct brdf_measured_view view,
                                                                brdf_vec3 wi)
{
    brdf_vec3 sum = brdf_add(view.wo, brdf_vec3_make(wi.x * view.sx, wi.y * view.sy, wi.z));
    brdf_vec3 axis = brdf_measured_axis(layout, view);
    brdf_real square = sum.x * sum.x + sum.y * sum.y;
    brdf_real radius = sqrtf(square);
    brdf_real length = sqrtf(brdf_max(square + sum.z * sum.z, 1e-12f));
    struct brdf_measured_facet facet;
    facet.x = brdf_max(brdf_measured_column(brdf_measured_theta(radius, sum.z)), 1e-6f);
    facet.y = brdf_measured_row(
        brdf_atan2(axis.x * sum.y - axis.y * sum.x, axis.x * sum.x + axis.y * sum.y));
    facet.sine = radius / length;
    facet.cosine = 0.5f * length;
    return facet;
}

#endif
