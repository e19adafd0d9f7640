/*
 * fit_space.c - the parameters that a fit searches, as a point of a unit cube.
 */
#include <math.h>
#include <string.h>

#include "brdf/bsdf.h"
#include "fit_space.h"

/*
 * A coordinate t in [0, 1] is low + s ((1 + (high - low) / s)^t - 1): even for values below s, a
 * thousandth of the range, and by factors above. Roughness and exponents need that.
 */
static double coordinate_value(const struct fit_coordinate *c, double t)
{
    double scale = 1e-3 * (c->high - c->low);
    if (t < 1e-9) {
        return c->low; /* as good as at the end */
    }
    if (c->even) {
        return c->low + t * (c->high - c->low);
    }
    return fmin(c->high, c->low + scale * expm1(t * log1p(1e3)));
}

/*
 * A metal is searched by its reflectance r at the normal and the tint g of its edge, in place of
 * eta and k, and turned back [Gulbrandsen 2014]: r is what a measurement shows,
 * while eta and k of a bright metal can change by factors and hardly change the picture.
 */
#define REFLECTANCE_MAX 0.9999
#define REFLECTANCE_MAX_CLEAR 0.96 /* of an index of 99 without k; indices end at 100 */

static void metal_of_reflectance(float *eta, float *k)
{
    for (int c = 0; c < 3; ++c) {
        double r = (double)eta[c];
        double g = (double)k[c];
        double root = sqrt(r);
        if (g <= 0.0) { /* of all indices with this reflectance the one that absorbs nothing */
            eta[c] = (float)((1.0 + root) / (1.0 - root));
            k[c] = 0.0f;
            continue;
        }
        double n = g * (1.0 - r) / (1.0 + r) + (1.0 - g) * (1.0 + root) / (1.0 - root);
        n = fmin(n, 100.0);
        double square = (r * (n + 1.0) * (n + 1.0) - (n - 1.0) * (n - 1.0)) / (1.0 - r);
        eta[c] = (float)n;
        k[c] = (float)fmin(sqrt(fmax(square, 0.0)), 100.0);
    }
}

/* Let a coordinate of the setting that this one is tied to move both; 1 if there is one. */
static int tie(struct fit_space *space, int part, int setting)
{
    int first = space->parts[part].tied_to[setting];
    for (int i = 0; i < space->size && first >= 0; ++i) {
        struct fit_coordinate *c = &space->coordinates[i];
        if (c->part == part && c->settings[0] == first && c->tied < FIT_TIED) {
            c->settings[c->tied++] = setting;
            return 1;
        }
    }
    return 0;
}

static void add_coordinates(struct fit_space *space, int part, int setting)
{
    const struct fit_part *from = &space->parts[part];
    const struct brdf_parameter_info *parameter = fit_part_info(from, setting);
    int gray = from->gray && setting == from->eta;
    int color = parameter->kind == BRDF_KIND_COLOR && !gray;
    int metal = setting == from->eta || setting == from->k;
    for (int channel = 0; channel < (color ? 3 : 1) && space->size < FIT_COORDINATES; ++channel) {
        struct fit_coordinate *c = &space->coordinates[space->size++];
        memset(c, 0, sizeof *c);
        c->part = part;
        c->settings[0] = setting;
        c->tied = 1;
        c->channel = channel;
        c->color = color;
        c->gray = gray;
        c->low = metal ? 0.0 : (double)parameter->low;
        c->high = !metal                 ? (double)parameter->high
                  : gray                 ? REFLECTANCE_MAX_CLEAR
                  : setting == from->eta ? REFLECTANCE_MAX
                                         : 1.0;
        c->even = metal;
    }
}

/* Another part of the blend; NULL for a diffuse one. */
static brdf_status part_add(struct fit_space *space, const char *model,
                            const struct lab_fit_options *options, struct brdf_error *error)
{
    struct fit_part *part = &space->parts[space->part_count];
    brdf_status status = fit_part_make(part, model, options, error);
    if (status) {
        return status;
    }
    int base = fit_part_find(part, "diffuse_reflectance");
    if (base >= 0 && part->searched[base] && options->diffuse) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "%s has a diffuse part itself; set diffuse_reflectance=0, or ask for no "
                         "other",
                         part->model->name);
    }
    if (base >= 0 && space->part_count > 0) { /* one is enough: the first lobe's */
        part->settings[base] = brdf_setting_color("diffuse_reflectance", 0.0f, 0.0f, 0.0f);
        part->searched[base] = 0;
    }
    for (int i = 0; i < part->count; ++i) {
        if (part->searched[i] && !tie(space, space->part_count, i)) {
            add_coordinates(space, space->part_count, i);
        }
    }
    ++space->part_count;
    return BRDF_OK;
}

/* A weight for each part but one: nested blends, of the first part and of what comes after it. */
static void weights_add(struct fit_space *space)
{
    for (int i = 0; i + 1 < space->part_count; ++i) {
        struct fit_coordinate c = {FIT_WEIGHT, {i}, 1, 0, 0, 0.0, 1.0, 1, 0};
        space->coordinates[space->size++] = c;
    }
}

brdf_status fit_space_make(const struct lab_fit_options *options, struct fit_space *space,
                           struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    memset(space, 0, sizeof *space);
    if (options->diffuse) {
        status = part_add(space, NULL, options, error);
    }
    for (int i = 0; i < options->lobes && !status; ++i) {
        status = part_add(space, options->model, options, error);
    }
    if (!status && space->size == 0) {
        status =
            brdf_fail(error, BRDF_UNSUPPORTED,
                      "\"%s\" sets every parameter: there is nothing to search", options->model);
    }
    weights_add(space);
    return status;
}

static void space_weights(const struct fit_space *space, const double *point, double *weights)
{
    double left = 1.0;
    for (int i = 0; i < space->size; ++i) {
        if (space->coordinates[i].part == FIT_WEIGHT) {
            weights[space->coordinates[i].settings[0]] = left * (1.0 - point[i]);
            left *= point[i];
        }
    }
    weights[space->part_count - 1] = left;
}

brdf_status fit_space_parts(const struct fit_space *space, const double *point,
                            struct brdf_bsdf **parts, double *weights, struct brdf_error *error)
{
    struct brdf_setting settings[LAB_FIT_PARTS][FIT_SETTINGS];
    brdf_status status = BRDF_OK;
    for (int i = 0; i < space->part_count; ++i) {
        memcpy(settings[i], space->parts[i].settings, sizeof settings[i]);
        parts[i] = NULL;
    }
    space_weights(space, point, weights);
    for (int i = 0; i < space->size; ++i) {
        const struct fit_coordinate *c = &space->coordinates[i];
        for (int k = 0; k < c->tied && c->part != FIT_WEIGHT; ++k) {
            float *number = settings[c->part][c->settings[k]].number;
            number[c->channel] = (float)coordinate_value(c, point[i]);
            if (c->gray) {
                number[1] = number[2] = number[0];
            }
        }
    }
    for (int i = 0; i < space->part_count && !status; ++i) {
        const struct fit_part *part = &space->parts[i];
        if (part->eta >= 0) {
            metal_of_reflectance(settings[i][part->eta].number, settings[i][part->k].number);
        }
        status = brdf_bsdf_build(part->model->name, settings[i], (size_t)part->count, NULL, 1,
                                 &parts[i], error);
    }
    for (int i = 0; i < space->part_count && status; ++i) {
        brdf_bsdf_destroy(parts[i]);
        parts[i] = NULL;
    }
    return status;
}

void fit_space_drop(struct fit_space *space, int coordinate)
{
    --space->size;
    for (int i = coordinate; i < space->size; ++i) {
        space->coordinates[i] = space->coordinates[i + 1];
    }
}

void fit_space_start(const struct fit_space *space, unsigned long k, double *point)
{
    int dimensions = 0;
    for (int i = 0; i < space->size; ++i) {
        dimensions += !space->coordinates[i].color || space->coordinates[i].channel == 0;
    }
    double ratio = 1.5; /* the root of x^(d + 1) = x + 1 */
    for (int i = 0; i < 60; ++i) {
        ratio = pow(1.0 + ratio, 1.0 / (dimensions + 1));
    }
    double step = 1.0;
    double t = 0.0;
    for (int i = 0; i < space->size; ++i) {
        const struct fit_coordinate *c = &space->coordinates[i];
        if (!c->color || c->channel == 0) {
            double whole;
            step /= ratio;
            t = modf(0.5 + (double)(k + 1) * step, &whole);
        }
        point[i] = t;
    }
}
