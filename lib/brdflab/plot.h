/*
 * plot.h - pictures of materials: lobes, slices, albedos and spheres, as PNG or SVG.
 *
 * One picture shows one or more materials under the same light. Panels of one material stand side
 * by side; of several, each material is a column and each panel a row, on the same scale, so that
 * what looks larger is larger. (Only the radial scale of linear lobes is each material's own, and
 * written at each: a diffuse lobe beside a glossy one would be a dot.)
 */
#ifndef BRDFLAB_PLOT_H
#define BRDFLAB_PLOT_H

#include <brdf/material.h>

#include "section.h"

/*
 * What a panel shows.
 *
 * SPHERE  the material on a sphere, lit as lit_sphere.h says
 * LOBE    f |cos theta_o| [1/sr] over the direction in which light leaves, in the plane of
 *         incidence, one curve for each angle at which it arrives; delta lobes are arrows with the
 *         share of the power that they take
 * SLICE   f [1/sr] over that angle, logarithmic
 * ALBEDO  the share of a beam's power that leaves again, over the angle at which it arrives
 * IMAGE   f over the half and the difference angle where phi_d = 90 degrees [Burley 2012],
 *         pi f tone mapped by L / (1 + L)
 */
enum lab_panel {
    LAB_PANEL_SPHERE,
    LAB_PANEL_LOBE,
    LAB_PANEL_SLICE,
    LAB_PANEL_ALBEDO,
    LAB_PANEL_IMAGE,
    LAB_PANEL_COUNT
};

enum { LAB_PLOT_ANGLES_MOST = 8, LAB_PLOT_MATERIALS_MOST = 8 };

struct lab_plot_material {
    const struct brdf_bsdf *bsdf;
    const char *name; /* "model" or "model:settings", as a caption; or anything else without ':' */
};

struct lab_plot_settings {
    enum lab_panel panel[LAB_PANEL_COUNT]; /* from left to right, or from top to bottom */
    int panels;
    double angle[LAB_PLOT_ANGLES_MOST]; /* of incidence [rad], 0 <= angle < pi / 2 */
    int angles;
    double azimuth;           /* of the plane of incidence, from the tangent [rad] */
    enum lab_channel channel; /* what curves show of a colour */
    int logarithmic;          /* radius of lobes: 5 decades of f cos, instead of linear */
    int dark;                 /* light lines on dark ground */
    const char *title;        /* UTF-8; NULL or "" for none */
    double width; /* of the picture: pixels of a PNG, points of an SVG; 0 for what the contents ask
                     for */
    double height;
    double scale; /* pixels for each point: of a PNG, and of the images within an SVG; 2 is sharp
                     on the screens of today */
    void (*on_write)(void); /* called when all is drawn, before there is a file; may be NULL */
};

/* All five panels, light at 0, 30, 60 and 80 degrees along the tangent, luminance, linear lobes. */
struct lab_plot_settings lab_plot_settings_initial(void);

/* The name of a panel, as on the command line: "sphere", "lobe", ... */
const char *lab_panel_name(enum lab_panel panel);

/* Can a picture be written there? Suffix .png or .svg. BRDF_UNSUPPORTED, BRDF_IO. */
brdf_status lab_plot_path_check(const char *path, struct brdf_error *error);

/*
 * Draw the materials and write the picture, whole or not at all, as PNG or SVG as the suffix says.
 * The same call gives the same bytes. BRDF_UNSUPPORTED (another suffix), BRDF_OUT_OF_RANGE (a
 * picture that is too small for what is to be in it, or too large), BRDF_IO, BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_plot_write(const char *path, const struct lab_plot_material *materials, int count,
                           const struct lab_plot_settings *settings, struct brdf_error *error);

#endif
