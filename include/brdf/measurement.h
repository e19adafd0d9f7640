/*
 * measurement.h - how the table of the model `measured` is laid out.
 */
#ifndef BRDF_MEASUREMENT_H
#define BRDF_MEASUREMENT_H

#include "warp2d.h"

/*
 * The table, in words: counts (below), the phi_i and theta_i of the slices, the map of visible
 * normals, that of luminance, for each node of the latter and each slice the colour and the
 * density of luminance, and for each cell of the grids of D and of sigma its corners. Every part
 * begins at a multiple of 16 words.
 */
enum brdf_measured_word {
    BRDF_MEASURED_PHIS,      /* of wo, >= 1 */
    BRDF_MEASURED_THETAS,    /* of wo, >= 2 */
    BRDF_MEASURED_VNDF_ROWS, /* azimuths of the normal */
    BRDF_MEASURED_VNDF_COLUMNS,
    BRDF_MEASURED_SIZE, /* of luminance and colours, along both sides */
    BRDF_MEASURED_NDF_ROWS,
    BRDF_MEASURED_NDF_COLUMNS,
    BRDF_MEASURED_SIGMA_ROWS,
    BRDF_MEASURED_SIGMA_COLUMNS,
    BRDF_MEASURED_ISOTROPIC, /* 1: normals are relative to the azimuth of wo */
    BRDF_MEASURED_SYMMETRY,  /* 2: azimuths of wo over half a turn, 4: a quarter; else 1 */
    BRDF_MEASURED_MIRRORED,  /* 1: of the visible normals only half is kept (warp2d.h) */
    BRDF_MEASURED_JACOBIAN,  /* 0: colours are f cos(theta_i) themselves */
    BRDF_MEASURED_HEADER = 16
};

/* Where everything is; one for all lanes. */
struct brdf_measured_layout {
    int phis;
    int thetas;
    int size; /* of luminance and colours */
    int phi_words;
    int theta_words;
    struct brdf_map vndf;
    struct brdf_map luminance;
    int color_words;
    int ndf_rows;
    int ndf_columns;
    int ndf_words;
    int sigma_rows;
    int sigma_columns;
    int sigma_words;
    int isotropic;
    int symmetry;
    int jacobian;
    int words; /* all */
};

/* The next multiple of 16, a cache line of words. */
static inline int brdf_measured_line(int words)
{
    return (words + 15) / 16 * 16;
}

/* Place `count` lines, from `words` on; where they end. A window may begin at the last node. */
static inline int brdf_lines_place(struct brdf_lines *lines, int count, int words)
{
    lines->words = words;
    lines->guess_words = lines->words + brdf_measured_line(count * brdf_lines_apart(*lines) + 8);
    return lines->guess_words + brdf_measured_line(count * brdf_guesses_apart(*lines));
}

/* Place a map with a density of rows by columns for each slice, from `words` on; where it ends. */
static inline int brdf_map_place(struct brdf_map *map, int thetas, int phis, int rows, int columns,
                                 int mirrored, int words)
{
    int kept = mirrored ? rows / 2 + 1 : rows;
    map->mirrored = mirrored;
    map->marginal.nodes = kept;
    map->marginal.cells = rows - 1;
    map->rows.nodes = columns;
    map->rows.cells = columns - 1;
    map->marginal.thetas = map->rows.thetas = thetas;
    map->marginal.phis = map->rows.phis = phis;
    return brdf_lines_place(&map->rows, kept, brdf_lines_place(&map->marginal, 1, words));
}

static inline struct brdf_measured_layout brdf_measured_layout_of(BRDF_GLOBAL const float *table)
{
    struct brdf_measured_layout layout;
    int phis = (int)table[BRDF_MEASURED_PHIS];
    int thetas = (int)table[BRDF_MEASURED_THETAS];
    int size = (int)table[BRDF_MEASURED_SIZE];
    layout.phi_words = BRDF_MEASURED_HEADER;
    layout.theta_words = layout.phi_words + brdf_measured_line(phis);
    layout.thetas = thetas;
    layout.phis = phis;
    layout.size = size;
    int words = layout.theta_words + brdf_measured_line(thetas);
    words = brdf_map_place(&layout.vndf, thetas, phis, (int)table[BRDF_MEASURED_VNDF_ROWS],
                           (int)table[BRDF_MEASURED_VNDF_COLUMNS],
                           (int)table[BRDF_MEASURED_MIRRORED], words);
    layout.color_words = brdf_map_place(&layout.luminance, thetas, phis, size, size, 0, words);
    layout.ndf_rows = (int)table[BRDF_MEASURED_NDF_ROWS];
    layout.ndf_columns = (int)table[BRDF_MEASURED_NDF_COLUMNS];
    layout.ndf_words = layout.color_words + brdf_measured_line(4 * phis * thetas * size * size);
    layout.sigma_rows = (int)table[BRDF_MEASURED_SIGMA_ROWS];
    layout.sigma_columns = (int)table[BRDF_MEASURED_SIGMA_COLUMNS];
    layout.sigma_words =
        layout.ndf_words + brdf_measured_line(4 * (layout.ndf_rows - 1) * (layout.ndf_columns - 1));
    layout.words = layout.sigma_words +
                   brdf_measured_line(4 * (layout.sigma_rows - 1) * (layout.sigma_columns - 1));
    layout.isotropic = (int)table[BRDF_MEASURED_ISOTROPIC];
    layout.symmetry = (int)table[BRDF_MEASURED_SYMMETRY];
    layout.jacobian = (int)table[BRDF_MEASURED_JACOBIAN];
    return layout;
}

#endif
