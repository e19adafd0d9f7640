/* plot.c - a picture from its settings: captions, legend, panels. */
#include "plot.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "angle.h"
#include "plot_file.h"
#include "plot_layout.h"
#include "plot_panels.h"

static const struct panel {
    const char *name;
    const char *title;
    const char *note;
    plot_panel_function *draw;
} panels[LAB_PANEL_COUNT] = {
    {"sphere", "Sphere", "two softboxes and sky", plot_panel_sphere},
    {"lobe", "Lobe", "f cos \xce\xb8_o in the plane of incidence", plot_panel_lobe},
    {"slice", "Slice", "f over the angle at which light leaves", plot_panel_slice},
    {"albedo", "Albedo", "over the angle at which light arrives", plot_panel_albedo},
    {"image", "Half and difference angle", "\xcf\x86_d = 90\xc2\xb0, tone mapped",
     plot_panel_image},
};

struct lab_plot_settings lab_plot_settings_initial(void)
{
    struct lab_plot_settings settings = {
        {LAB_PANEL_SPHERE, LAB_PANEL_LOBE, LAB_PANEL_SLICE, LAB_PANEL_ALBEDO, LAB_PANEL_IMAGE},
        LAB_PANEL_COUNT,
        {0.0, 30.0 * degree, 60.0 * degree, 80.0 * degree},
        4,
        0.0,
        LAB_CHANNEL_LUMINANCE,
        0,
        0,
        NULL,
        0.0,
        0.0,
        2.0,
        NULL};
    return settings;
}

const char *lab_panel_name(enum lab_panel panel)
{
    return panels[panel].name;
}

/* A text on one line; what does not fit ends in an ellipsis. Returns how many bytes were written
   in full. */
static size_t write_line(struct plot_canvas *canvas, struct plot_font font, double x, double y,
                         double width, const char *text, int last)
{
    char line[256];
    size_t length = strlen(text);
    length = length < sizeof line - 8 ? length : sizeof line - 8;
    for (;;) {
        memcpy(line, text, length);
        strcpy(line + length, text[length] && last ? "\xe2\x80\xa6" : "");
        if (length == 0 || plot_text_width(canvas, font, line) <= width) {
            break;
        }
        do { /* a shorter one: whole letters, and whole settings if more lines follow */
            --length;
        } while (length && (((unsigned char)text[length] & 0xC0u) == 0x80u ||
                            (!last && text[length - 1] != ',' && text[length - 1] != '/')));
        if (length == 0 && !last) {
            return write_line(canvas, font, x, y, width, text, 1);
        }
    }
    plot_text(canvas, x, y, 0.0, font, line);
    return length;
}

/* The model's name, and its settings in grey on up to two lines. */
static void draw_caption(struct plot_canvas *canvas, double x, double y, double width,
                         const char *name)
{
    struct plot_font bold = {11.5, PLOT_BOLD, canvas->theme->ink, 1};
    struct plot_font grey = {8.5, PLOT_REGULAR, canvas->theme->text, 1};
    char model[128];
    const char *colon = strchr(name, ':');
    size_t length = colon ? (size_t)(colon - name) : strlen(name);
    snprintf(model, sizeof model, "%.*s", (int)(length < 127 ? length : 127), name);
    write_line(canvas, bold, x, y + 11.0, width, model, 1);
    if (colon) {
        const char *rest = colon + 1;
        rest += write_line(canvas, grey, x, y + 23.0, width, rest, 0);
        write_line(canvas, grey, x, y + 34.0, width, rest, 1);
    }
}

static double draw_swatch(struct plot_canvas *canvas, double x, double y, struct plot_color color,
                          double dash, const char *text)
{
    struct lab_point from = {x, y - 3.0}, to = {x + 16.0, y - 3.0};
    plot_line(canvas, from, to, 1.8, color, dash);
    plot_text(canvas, x + 20.0, y, 0.0, plot_font_small(canvas), text);
    return x + 20.0 + plot_text_width(canvas, plot_font_small(canvas), text) + 12.0;
}

static void draw_legend(struct plot_canvas *canvas, const struct plot_job *job, double y, int lines)
{
    static const char *const channel[] = {"luminance", "red", "green", "blue"};
    const struct lab_plot_settings *settings = job->settings;
    struct plot_font small = plot_font_small(canvas);
    char text[64];
    snprintf(text, sizeof text, "%s, light at \xce\xb8_i =", channel[settings->channel]);
    plot_text(canvas, plot_margin, y, 0.0, small, text);
    double x = plot_margin + plot_text_width(canvas, small, text) + 8.0;
    for (int i = 0; i < settings->angles; ++i) {
        snprintf(text, sizeof text, "%.3g\xc2\xb0", settings->angle[i] / degree);
        x = draw_swatch(canvas, x, y, plot_color_of(canvas->theme, i, settings->angles), 0.0, text);
    }
    if (lines > 1) {
        x = plot_margin - 8.0;
        y += 14.0;
    }
    if (job->anisotropic || settings->azimuth != 0.0) {
        snprintf(text, sizeof text, "\xcf\x86 = %.3g\xc2\xb0", settings->azimuth / degree);
        x = draw_swatch(canvas, x + 8.0, y, canvas->theme->text, 0.0, text);
    }
    if (job->anisotropic) {
        snprintf(text, sizeof text, "\xcf\x86 = %.3g\xc2\xb0", settings->azimuth / degree + 90.0);
        draw_swatch(canvas, x, y, canvas->theme->text, 3.0, text);
    }
}

static void draw_row_title(struct plot_canvas *canvas, struct plot_box cell,
                           const struct panel *panel)
{
    struct plot_font bold = {10.0, PLOT_BOLD, canvas->theme->ink, 0};
    double y = cell.y - 6.0;
    plot_text(canvas, cell.x, y, 0.0, bold, panel->title);
    double x = cell.x + plot_text_width(canvas, bold, panel->title) + 6.0;
    plot_text(canvas, x, y, 0.0, plot_font_small(canvas), panel->note);
}

static void draw_header(struct plot_canvas *canvas, const struct plot_layout *layout,
                        const struct plot_job *job)
{
    if (layout->title > 0.0) {
        struct plot_font font = {16.0, PLOT_BOLD, canvas->theme->ink, 1};
        write_line(canvas, font, plot_margin, plot_margin + 14.0, layout->width - 2.0 * plot_margin,
                   job->settings->title, 1);
    }
    if (layout->legend > 0.0) {
        draw_legend(canvas, job, plot_layout_legend_y(layout, job) + 8.0, layout->legend_lines);
    }
    double width = job->count > 1 ? layout->cell_width : layout->width - 2.0 * plot_margin;
    for (int m = 0; m < job->count; ++m) {
        draw_caption(canvas, plot_margin + m * (layout->cell_width + plot_gap),
                     plot_layout_caption_y(layout, job), width, job->materials[m].name);
    }
}

static brdf_status draw(struct plot_canvas *canvas, const struct plot_layout *layout,
                        const struct plot_job *job, struct brdf_error *error)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(canvas->cairo, options);
    cairo_font_options_destroy(options);
    plot_set_color(canvas, canvas->theme->paper);
    cairo_paint(canvas->cairo);
    draw_header(canvas, layout, job);
    for (int i = 0; i < job->settings->panels; ++i) {
        const struct panel *panel = &panels[job->settings->panel[i]];
        for (int m = 0; m < job->count; ++m) {
            struct plot_box cell = plot_layout_cell(layout, job, i, m);
            if (m == 0) {
                draw_row_title(canvas, cell, panel);
            }
            brdf_status status = panel->draw(canvas, cell, job, m, error);
            if (status) {
                return status;
            }
        }
    }
    return BRDF_OK;
}

brdf_status lab_plot_write(const char *path, const struct lab_plot_material *materials, int count,
                           const struct lab_plot_settings *settings, struct brdf_error *error)
{
    struct plot_job job = {.settings = settings, .materials = materials, .count = count};
    struct plot_layout layout;
    struct plot_file file;
    plot_job_prepare(&job);
    brdf_status status =
        plot_layout_make(&job, plot_file_is_svg(path) ? 1.0 : settings->scale, &layout, error);
    if (!status) {
        status = plot_file_open(&file, path, layout.width, layout.height, settings->scale, error);
    }
    if (status) {
        return status;
    }
    file.on_write = settings->on_write;
    struct plot_canvas canvas = {cairo_create(file.surface), plot_theme(settings->dark),
                                 settings->scale};
    status = draw(&canvas, &layout, &job, error);
    cairo_destroy(canvas.cairo);
    return plot_file_close(&file, status);
}
