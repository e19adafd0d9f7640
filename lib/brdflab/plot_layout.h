/*
 * plot_layout.h - where everything in a picture goes.
 *
 * One material: its panels fill rows of at most three. Several: a column each, a row for each
 * panel.
 */
#ifndef BRDFLAB_PLOT_LAYOUT_H
#define BRDFLAB_PLOT_LAYOUT_H

#include "plot_panels.h"

struct plot_layout {
    double width, height; /* of the picture [points] */
    double title;         /* height of the title's line; 0 if there is none */
    int legend_lines;
    double legend;   /* of the legend */
    double captions; /* of the columns' captions */
    struct {
        int row, column;
        int span;             /* columns */
    } place[LAB_PANEL_COUNT]; /* of each panel, for the first material */
    int columns;
    int rows;
    double cell_width;
    double row_height[LAB_PANEL_COUNT]; /* without the line above it that names the panel */
};

/* Distances [points]: around the picture, between columns, and above each row, for its name. */
extern const double plot_margin;
extern const double plot_gap;
extern const double plot_row_title;

/* Lay out a picture, of which a point is `unit` units of the size that is asked for;
 * BRDF_OUT_OF_RANGE where the size that is asked for has no room. */
brdf_status plot_layout_make(const struct plot_job *job, double unit, struct plot_layout *layout,
                             struct brdf_error *error);

/* Where the legend and the captions begin: one material's caption is above the legend. */
double plot_layout_legend_y(const struct plot_layout *layout, const struct plot_job *job);
double plot_layout_caption_y(const struct plot_layout *layout, const struct plot_job *job);

/* The cell of a panel (by its place in the settings) of a material. */
struct plot_box plot_layout_cell(const struct plot_layout *layout, const struct plot_job *job,
                                 int panel, int material);

#endif
