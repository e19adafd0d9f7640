/* edit.c - each bin taken apart, its parts changed, and put together again. */
#include "edit.h"

#include <math.h>
#include <string.h>

#include "angle.h"
#include "bins.h"
#include "oklab.h"
#include "separate.h"

struct editor {
    const struct lab_edit *edit;
    struct brdf_merl_file filled; /* what is edited, without holes to interpolate over */
    struct lab_diffuse diffuse;
};

struct lab_edit lab_edit_nothing(void)
{
    struct lab_edit edit = {1.0, 1.0, 1.0, 0.0, 1.0, LAB_EDIT_ALL, 0};
    return edit;
}

int lab_edit_is_nothing(const struct lab_edit *edit)
{
    return edit->gloss == 1.0 && edit->specular == 1.0 && edit->diffuse == 1.0 &&
           edit->hue == 0.0 && edit->saturation == 1.0;
}

static int needs_parts(const struct lab_edit *edit)
{
    return edit->gloss != 1.0 || edit->specular != 1.0 || edit->diffuse != 1.0 ||
           edit->part != LAB_EDIT_ALL;
}

static double diffuse_of(const struct editor *editor, double f, int theta_d, int c)
{
    return editor->edit->metal ? 0.0 : fmin(f, editor->diffuse.level[theta_d][c]);
}

/* The highlight at a place between bins of theta_h, clamped to the first and last. */
static double specular_at(const struct editor *editor, double place, int theta_d, int phi_d, int c)
{
    const struct brdf_merl_file *file = &editor->filled;
    double at = fmin(fmax(place - 0.5, 0.0), file->theta_h - 1.0);
    int low = at < file->theta_h - 2.0 ? (int)at : file->theta_h - 2;
    double value[2];
    for (int i = 0; i < 2; ++i) {
        struct lab_bin bin = {low + i, theta_d, phi_d};
        double f = (double)file->rgb[3 * lab_bin_number(file, bin) + (size_t)c];
        value[i] = f - diffuse_of(editor, f, theta_d, c);
    }
    return value[0] + (at - low) * (value[1] - value[0]);
}

/* Where the highlight of a theta_h comes from, and by how much it is scaled. */
struct remap {
    double theta, from; /* theta_h of now and then [rad] */
    double place;       /* of the latter, in bins */
    double factor;      /* stretched slopes over the old ones, and the projections of both facets */
};

/* The cosines of the two directions at some angles, the lower direction first. */
struct cosines {
    double least, most;
};

static struct cosines cosines_at(double theta_h, double theta_d, double phi_d)
{
    double middle = cos(theta_d) * cos(theta_h);
    double aside = fabs(sin(theta_d) * cos(phi_d) * sin(theta_h));
    struct cosines cosines = {middle - aside, middle + aside};
    return cosines;
}

/*
 * Masking in V-shaped grooves over the cosines of both directions, G / (cos(theta_o)
 * cos(theta_i)) [Torrance and Sparrow 1967].
 */
static double visibility(double theta_h, double theta_d, double phi_d)
{
    struct cosines cosines = cosines_at(theta_h, theta_d, phi_d);
    double least = fmax(cosines.least, 1e-6); /* grazing may round to below */
    double masking = fmin(1.0, 2.0 * cos(theta_h) * least / cos(theta_d));
    return masking / (least * cosines.most);
}

static struct remap remap_of(const struct brdf_merl_file *file, int theta_h, double gloss)
{
    double theta = lab_bin_theta_h(file, theta_h);
    double from = atan(gloss * tan(theta));
    double projection = cos(from) / cos(theta);
    struct remap remap = {theta, from, file->theta_h * sqrt(from / (0.5 * pi)),
                          gloss * gloss * projection * projection * projection * projection};
    return remap;
}

/*
 * The highlight moved in theta_h. Where it comes from below the surface there is no value; there
 * the distribution of normals is known from where both directions are equally high, in the middle
 * of phi_d.
 */
static void specular_move(const struct editor *editor, const struct remap *remap, int theta_d,
                          int phi_d, double specular[3])
{
    double d = 0.5 * pi * (theta_d + 0.5) / editor->filled.theta_d;
    double step = pi / editor->filled.phi_d;
    int beyond = (int)fmin(floor(remap->place - 0.5) + 1.0, editor->filled.theta_h - 1.0);
    double upper = lab_bin_theta_h(&editor->filled, beyond);
    int from =
        cosines_at(upper, d, step * (phi_d + 0.5)).least > 0.0 ? phi_d : editor->filled.phi_d / 2;
    double factor = remap->factor * visibility(remap->theta, d, step * (phi_d + 0.5)) /
                    visibility(remap->from, d, step * (from + 0.5));
    for (int c = 0; c < 3; ++c) {
        specular[c] = factor * specular_at(editor, remap->place, theta_d, from, c);
    }
}

static void bin_edit(const struct editor *editor, size_t bin, const struct remap *remap,
                     float rgb[3])
{
    const struct lab_edit *edit = editor->edit;
    struct lab_bin at = lab_bin_of(&editor->filled, bin);
    double diffuse[3], specular[3], all[3];
    for (int c = 0; c < 3; ++c) {
        specular[c] = (double)rgb[c] - diffuse_of(editor, (double)rgb[c], at.theta_d, c);
    }
    if (edit->gloss != 1.0) {
        specular_move(editor, remap, at.theta_d, at.phi_d, specular);
    }
    for (int c = 0; c < 3; ++c) {
        diffuse[c] = edit->diffuse * diffuse_of(editor, (double)rgb[c], at.theta_d, c);
        specular[c] *= edit->specular;
        all[c] = diffuse[c] + specular[c];
    }
    if (edit->hue != 0.0 || edit->saturation != 1.0) {
        double *part = edit->part == LAB_EDIT_DIFFUSE    ? diffuse
                       : edit->part == LAB_EDIT_SPECULAR ? specular
                                                         : all;
        lab_color_change(part, edit->hue, edit->saturation);
    }
    for (int c = 0; c < 3; ++c) {
        rgb[c] = (float)(edit->part == LAB_EDIT_ALL ? all[c] : diffuse[c] + specular[c]);
    }
}

/* Only the colour of all of it: nothing is taken apart, so nothing is lost in between. */
static void bin_recolor(const struct lab_edit *edit, float rgb[3])
{
    double all[3] = {(double)rgb[0], (double)rgb[1], (double)rgb[2]};
    lab_color_change(all, edit->hue, edit->saturation);
    for (int c = 0; c < 3; ++c) {
        rgb[c] = (float)all[c];
    }
}

static void bins_edit(const struct editor *editor, struct brdf_merl_file *edited)
{
    const struct lab_edit *edit = editor->edit;
    size_t row = (size_t)edited->theta_d * (size_t)edited->phi_d;
    int parts = needs_parts(edit);
    for (int h = 0; h < edited->theta_h; ++h) {
        struct remap remap = remap_of(edited, h, edit->gloss);
        for (size_t bin = (size_t)h * row; bin < ((size_t)h + 1) * row; ++bin) {
            float *rgb = edited->rgb + 3 * bin;
            if (rgb[0] >= 0.0f && parts) {
                bin_edit(editor, bin, &remap, rgb);
            } else if (rgb[0] >= 0.0f) {
                bin_recolor(edit, rgb);
            }
        }
    }
}

static brdf_status edit_check(const struct lab_edit *edit, struct brdf_error *error)
{
    const struct {
        const char *name;
        double value;
    } factors[] = {{"gloss", edit->gloss},
                   {"specular", edit->specular},
                   {"diffuse", edit->diffuse},
                   {"saturation", edit->saturation}};
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; ++i) {
        if (!(factors[i].value >= 0.0 && isfinite(factors[i].value)) ||
            (i == 0 && factors[i].value == 0.0)) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "%s = %g: a factor is finite and not %s",
                             factors[i].name, factors[i].value, i ? "negative" : "below or at 0");
        }
    }
    return isfinite(edit->hue) ? BRDF_OK
                               : brdf_fail(error, BRDF_BAD_ARGUMENT, "hue is not a finite angle");
}

static brdf_status copy_make(const struct brdf_merl_file *file, struct brdf_merl_file *copy,
                             struct brdf_error *error)
{
    brdf_status status = brdf_merl_create(copy, error);
    if (status == BRDF_OK) {
        memcpy(copy->rgb, file->rgb, file->bins * 3 * sizeof *file->rgb);
        copy->invalid = file->invalid;
    }
    return status;
}

brdf_status lab_edit_merl(const struct brdf_merl_file *file, const struct lab_edit *edit,
                          struct brdf_merl_file *edited, struct brdf_error *error)
{
    struct editor editor = {.edit = edit};
    memset(edited, 0, sizeof *edited);
    brdf_status status = edit_check(edit, error);
    if (status == BRDF_OK) {
        status = copy_make(file, edited, error);
    }
    if (status != BRDF_OK || lab_edit_is_nothing(edit)) {
        return status;
    }
    status = copy_make(file, &editor.filled, error);
    if (status == BRDF_OK) {
        status = brdf_merl_fill(&editor.filled, error);
    }
    if (status == BRDF_OK && needs_parts(edit) && !edit->metal) {
        status = lab_separate(file, &editor.diffuse, error);
    }
    if (status == BRDF_OK) {
        bins_edit(&editor, edited);
    } else {
        brdf_merl_free(edited);
    }
    brdf_merl_free(&editor.filled);
    return status;
}
