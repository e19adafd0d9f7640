/* plot.c - brdfcl plot: pictures of materials, side by side. */
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/material.h>

#include "angle.h"
#include "brdflab/open.h"
#include "brdflab/plot.h"
#include "commands.h"
#include "file_name.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "say.h"
#include "stop.h"

static const char summary[] =
    "Draw materials, such as roughconductor:material=Cu,alpha=0.2, side by side: a lit sphere, "
    "lobes,\nslices, albedo and the image over half and difference angle. A measured file (.binary "
    "or .bsdf)\nmay stand for a material.";

/* The next item of a list separated by commas; 0 at its end. */
static int next_item(const char **list, char *item, size_t size)
{
    if (!*list) {
        return 0;
    }
    size_t length = strcspn(*list, ",");
    snprintf(item, size, "%.*s", (int)(length < size - 1 ? length : size - 1), *list);
    *list = (*list)[length] ? *list + length + 1 : NULL;
    return 1;
}

/* "sphere,lobe" into the settings; an exit status, or OPTIONS_GO_ON. */
static int read_panels(const char *list, struct lab_plot_settings *settings)
{
    const char *names[LAB_PANEL_COUNT];
    char item[32];
    for (int i = 0; i < LAB_PANEL_COUNT; ++i) {
        names[i] = lab_panel_name((enum lab_panel)i);
    }
    settings->panels = 0;
    while (next_item(&list, item, sizeof item)) {
        int k = 0;
        while (k < LAB_PANEL_COUNT && strcmp(names[k], item) != 0) {
            ++k;
        }
        if (k == LAB_PANEL_COUNT) {
            return say_usage("--panels: no panel \"%s\"%s; there are sphere, lobe, slice, albedo, "
                             "image",
                             item,
                             say_nearest(brdf_name_nearest(item, names, LAB_PANEL_COUNT)).text);
        }
        for (int i = 0; i < settings->panels; ++i) {
            if ((int)settings->panel[i] == k) {
                return say_usage("--panels names \"%s\" twice", item);
            }
        }
        settings->panel[settings->panels++] = (enum lab_panel)k;
    }
    return OPTIONS_GO_ON;
}

/* Degrees into the settings; an exit status, or OPTIONS_GO_ON. */
static int read_angles(const struct numbers *degrees, struct lab_plot_settings *settings)
{
    if (degrees->count > LAB_PLOT_ANGLES_MOST) {
        return say_usage("--angles: more than %d are too many to tell apart", LAB_PLOT_ANGLES_MOST);
    }
    settings->angles = degrees->count;
    for (int i = 0; i < degrees->count; ++i) {
        settings->angle[i] = degrees->item[i] * degree;
    }
    return OPTIONS_GO_ON;
}

/* A material, and its caption: a file is called by its name, without its folder. */
static brdf_status open_material(const char *text, int fill, struct brdf_bsdf **bsdf,
                                 struct lab_plot_material *material, struct brdf_error *error)
{
    enum lab_format format = LAB_FORMAT_NONE;
    brdf_status status = lab_open_filled(text, fill, bsdf, &format, error);
    material->bsdf = *bsdf;
    material->name = format == LAB_FORMAT_NONE ? text : file_name_of(text);
    return status;
}

static int plot(const char *path, const struct texts *arguments, int fill,
                const struct lab_plot_settings *settings)
{
    struct brdf_bsdf *bsdf[LAB_PLOT_MATERIALS_MOST] = {NULL};
    struct lab_plot_material materials[LAB_PLOT_MATERIALS_MOST];
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = lab_plot_path_check(path, &error);
    for (int i = 0; i < arguments->count && !status; ++i) {
        status = open_material(arguments->item[i], fill, &bsdf[i], &materials[i], &error);
    }
    if (!status) {
        status = lab_plot_write(path, materials, arguments->count, settings, &error);
    }
    for (int i = 0; i < arguments->count; ++i) {
        brdf_bsdf_destroy(bsdf[i]);
    }
    return status ? say_error(&error) : EXIT_DONE;
}

int command_plot(int argc, char **argv)
{
    struct lab_plot_settings settings = lab_plot_settings_initial();
    const char *path = NULL, *panels = NULL;
    struct numbers angles = {.count = 0};
    struct size size = {0, 0};
    double phi = 0.0;
    int channel = LAB_CHANNEL_LUMINANCE, fill = 1;
    const struct option options[] = {
        {NULL, 'o', OPTION_TEXT, &path, "FILE", 0, 0, "where to write: .png or .svg"},
        {"panels", 0, OPTION_TEXT, &panels, "LIST", 0, 0,
         "of sphere, lobe, slice, albedo, image; all if not given"},
        {"angles", 0, OPTION_REALS, &angles, "A,B,...", 0, 89.9,
         "angles of incidence [degrees]; 0,30,60,80 if not given"},
        {"phi", 0, OPTION_REAL, &phi, "PHI", -360, 360,
         "azimuth of the plane of incidence [degrees]; 0, the tangent, if not given"},
        {"channel", 0, OPTION_CHOICE, &channel, "luminance|red|green|blue", 0, 0,
         "what curves show; luminance if not given"},
        {"log", 0, OPTION_ON, &settings.logarithmic, NULL, 0, 0,
         "lobes with a logarithmic radius, the same for all materials"},
        {"title", 0, OPTION_TEXT, &settings.title, "TEXT", 0, 0, "a line above all"},
        {"dark", 0, OPTION_ON, &settings.dark, NULL, 0, 0, "light lines on dark ground"},
        {"size", 0, OPTION_SIZE, &size, "WxH", 16, 16384,
         "of the picture: pixels of a PNG, points of an SVG; what it needs if not given"},
        {"scale", 0, OPTION_REAL, &settings.scale, "X", 0.5, 8,
         "pixels a point, how large everything in a PNG is; 2 if not given"},
        MEASURED_NO_FILL(&fill),
    };
    const struct usage usage = {
        "plot", "MATERIAL...",          summary, options, sizeof options / sizeof options[0],
        1,      LAB_PLOT_MATERIALS_MOST};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status == OPTIONS_GO_ON && !path) {
        return say_usage("plot needs -o FILE.png or -o FILE.svg");
    }
    if (status == OPTIONS_GO_ON && panels) {
        status = read_panels(panels, &settings);
    }
    if (status == OPTIONS_GO_ON && angles.count) {
        status = read_angles(&angles, &settings);
    }
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    settings.width = size.width;
    settings.height = size.height;
    settings.azimuth = phi * degree;
    settings.channel = (enum lab_channel)channel;
    settings.on_write = stop_wait;
    return plot(path, &arguments, fill, &settings);
}
