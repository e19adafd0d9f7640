/* plot_layout.c - sizes that the contents ask for, stretched to what is asked for. */
#include "plot_layout.h"

#include <math.h>
#include <string.h>

const double plot_margin = 22.0;
const double plot_gap = 20.0;
const double plot_row_title = 18.0;

static const double cell_width = 264.0;
static const double single = 1.5; /* how much larger a panel is that stands alone */

static double height_of(enum lab_panel panel, int transmits)
{
    switch (panel) {
    case LAB_PANEL_LOBE:
        return transmits ? 254.0 : 160.0;
    case LAB_PANEL_SLICE:
    case LAB_PANEL_ALBEDO:
        return 210.0;
    default:
        return 254.0;
    }
}

/* One material: panels in the order of reading. */
static void flow(const struct lab_plot_settings *settings, struct plot_layout *layout)
{
    int all = settings->panels == LAB_PANEL_COUNT;
    int row = 0, column = 0;
    layout->columns = settings->panels < 4 ? settings->panels : settings->panels == 4 ? 2 : 3;
    for (int i = 0; i < settings->panels; ++i) {
        int span = all && settings->panel[i] == LAB_PANEL_LOBE ? 2 : 1;
        if (column + span > layout->columns) {
            column = 0;
            ++row;
        }
        layout->place[i].row = row;
        layout->place[i].column = column;
        layout->place[i].span = span;
        column += span;
    }
    layout->rows = row + 1;
}

static void arrange(const struct plot_job *job, struct plot_layout *layout)
{
    const struct lab_plot_settings *settings = job->settings;
    if (job->count == 1) {
        flow(settings, layout);
    } else {
        layout->columns = job->count;
        layout->rows = settings->panels;
        for (int i = 0; i < settings->panels; ++i) {
            layout->place[i].row = i;
            layout->place[i].column = 0;
            layout->place[i].span = 1;
        }
    }
    for (int row = 0; row < layout->rows; ++row) {
        layout->row_height[row] = 0.0;
    }
    for (int i = 0; i < settings->panels; ++i) {
        double *height = &layout->row_height[layout->place[i].row];
        double asked = height_of(settings->panel[i], job->transmits);
        *height = fmax(*height, layout->columns > 1 ? asked : single * asked);
    }
}

/* Everything that is not a panel, from top to bottom. */
static double height_around(const struct plot_layout *layout)
{
    return 2.0 * plot_margin + layout->title + layout->legend + layout->captions +
           layout->rows * (plot_row_title + plot_gap) - plot_gap;
}

static brdf_status stretch(struct plot_layout *layout, double width, double height,
                           struct brdf_error *error)
{
    double sum = 0.0;
    for (int row = 0; row < layout->rows; ++row) {
        sum += layout->row_height[row];
    }
    double around = height_around(layout);
    layout->height = height > 0.0 ? height : around + sum;
    double factor = (layout->height - around) / sum;
    for (int row = 0; row < layout->rows; ++row) {
        layout->row_height[row] *= factor;
    }
    double gaps = 2.0 * plot_margin + (layout->columns - 1) * plot_gap;
    double wide = layout->columns > 1 ? cell_width : single * cell_width;
    layout->width = width > 0.0 ? width : gaps + layout->columns * wide;
    layout->cell_width = (layout->width - gaps) / layout->columns;
    if (layout->cell_width < 0.4 * cell_width || factor < 0.4) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%.0f x %.0f points have no room for %d x %d panels: at least %.0f x %.0f "
                         "are needed, %.0f x %.0f are comfortable",
                         layout->width, layout->height, layout->columns, layout->rows,
                         ceil(gaps + 0.4 * cell_width * layout->columns), ceil(around + 0.4 * sum),
                         gaps + cell_width * layout->columns, around + sum);
    }
    return BRDF_OK;
}

brdf_status plot_layout_make(const struct plot_job *job, double unit, struct plot_layout *layout,
                             struct brdf_error *error)
{
    const struct lab_plot_settings *settings = job->settings;
    int curves = 0;
    for (int i = 0; i < settings->panels; ++i) {
        curves |= settings->panel[i] == LAB_PANEL_LOBE || settings->panel[i] == LAB_PANEL_SLICE;
    }
    layout->title = settings->title && settings->title[0] ? 28.0 : 0.0;
    layout->captions = 20.0;
    for (int m = 0; m < job->count; ++m) {
        const char *settings_of = strchr(job->materials[m].name, ':');
        if (settings_of) {
            layout->captions =
                fmax(layout->captions, strlen(settings_of) > 40 && job->count > 1 ? 44.0 : 34.0);
        }
    }
    arrange(job, layout);
    /* In a narrow picture the planes have a line of their own. */
    layout->legend_lines = !curves ? 0 : job->anisotropic && layout->columns < 2 ? 2 : 1;
    layout->legend = curves ? 10.0 + 14.0 * layout->legend_lines : 0.0;
    return stretch(layout, settings->width / unit, settings->height / unit, error);
}

double plot_layout_caption_y(const struct plot_layout *layout, const struct plot_job *job)
{
    return plot_margin + layout->title + (job->count > 1 ? layout->legend : 0.0);
}

double plot_layout_legend_y(const struct plot_layout *layout, const struct plot_job *job)
{
    return plot_margin + layout->title + (job->count > 1 ? 0.0 : layout->captions);
}

struct plot_box plot_layout_cell(const struct plot_layout *layout, const struct plot_job *job,
                                 int panel, int material)
{
    int row = layout->place[panel].row;
    int span = layout->place[panel].span;
    double pitch = layout->cell_width + plot_gap;
    double y = plot_margin + layout->title + layout->legend + layout->captions;
    for (int i = 0; i < row; ++i) {
        y += plot_row_title + layout->row_height[i] + plot_gap;
    }
    int column = job->count > 1 ? material : layout->place[panel].column;
    struct plot_box cell = {plot_margin + column * pitch, y + plot_row_title,
                            span * pitch - plot_gap, layout->row_height[row]};
    return cell;
}
