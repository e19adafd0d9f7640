/* convert.c - brdfcl convert: a material into a measured file, and how far that took it away. */
#include <stdio.h>
#include <string.h>

#include "brdflab/bake.h"
#include "brdflab/compare.h"
#include "brdflab/complete.h"
#include "brdflab/open.h"
#include "brdflab/survey.h"
#include "commands.h"
#include "json.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Write a material, a measured file (.binary, .bsdf) or a description such as\n"
    "roughconductor:material=Au,alpha=0.2, as a measured file, and print how much it changed: the "
    "root\n"
    "mean square and the mean of the difference, relative to f and weighted by the cosine, the "
    "largest\n"
    "relative difference and its directions (theta,phi in degrees), and that of the albedos.";

struct convert_run {
    const char *in;
    const char *out;
    const char *json_path;
    int format; /* enum lab_format */
    int fill;
    struct brdf_rgl_grid grid;
    struct lab_difference difference;
    double reciprocity; /* of what was read, as lab_reciprocity tells it */
};

static int read_command_line(struct convert_run *run, int argc, char **argv)
{
    const struct option options[] = {
        {"format", 0, OPTION_CHOICE, &run->format, "by-name|merl|rgl", 0, 0,
         "of OUT; by its suffix, .binary or .bsdf, if not given"},
        {"no-fill", 0, OPTION_OFF, &run->fill, NULL, 0, 0,
         "MERL to MERL: 0, and not a value from its neighbours, for what was not measured"},
        {"thetas", 0, OPTION_INT, &run->grid.thetas, "N", 2, 256,
         "RGL: polar angles of the viewer; 17 if not given"},
        {"size", 0, OPTION_INT, &run->grid.size, "N", 2, 1024,
         "RGL: nodes along the sides of a view's square; 128, 64 if anisotropic"},
        {"json", 0, OPTION_TEXT, &run->json_path, "FILE", 0, 0,
         "write the differences as JSON; - is standard output, which then has nothing else"},
    };
    const struct usage usage = {
        "convert", "MATERIAL OUT", summary, options, sizeof options / sizeof options[0], 2, 2};
    enum lab_format format;
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    run->in = arguments.item[0];
    run->out = arguments.item[1];
    status = measured_format(run->out, run->format, &format);
    run->format = (int)format;
    return status;
}

static brdf_status write_merl(const struct convert_run *run, struct brdf_error *error)
{
    struct brdf_merl_file file;
    enum lab_format format;
    brdf_status status = lab_open_merl(run->in, &file, &format, error);
    if (!status && format == LAB_FORMAT_MERL) {
        status = lab_complete_merl(&file, run->fill, error);
    }
    if (!status) {
        status = measured_write(run->out, &file, error);
    }
    brdf_merl_free(&file);
    return status;
}

static brdf_status write_rgl(const struct convert_run *run, const struct brdf_bsdf *in,
                             struct brdf_error *error)
{
    struct brdf_rgl_file file;
    brdf_status status = lab_bake_rgl(in, &run->grid, &file, error);
    if (status) {
        return status;
    }
    status = measured_write_rgl(run->out, &file, error);
    brdf_rgl_free(&file);
    return status;
}

/* The difference is that of what is on the disk now. */
static brdf_status compare(struct convert_run *run, const struct brdf_bsdf *in,
                           struct brdf_error *error)
{
    struct brdf_bsdf *out = NULL;
    brdf_status status = lab_open(run->out, &out, NULL, error);
    if (!status) {
        run->difference = lab_compare(in, out);
        run->reciprocity = lab_reciprocity(in);
    }
    brdf_bsdf_destroy(out);
    return status;
}

static brdf_status convert(struct convert_run *run, struct brdf_error *error)
{
    struct brdf_bsdf *in = NULL;
    brdf_status status = measured_check(run->out, error);
    if (!status && run->json_path) {
        status = text_file_check(run->json_path, error);
    }
    if (!status) {
        status = lab_open(run->in, &in, NULL, error);
    }
    if (!status) {
        status = run->format == LAB_FORMAT_RGL ? write_rgl(run, in, error) : write_merl(run, error);
    }
    if (!status) {
        status = compare(run, in, error);
    }
    brdf_bsdf_destroy(in);
    return status;
}

static void print_difference(const struct convert_run *run)
{
    const struct lab_difference *d = &run->difference;
    struct angles wo = angles_of_direction(d->wo), wi = angles_of_direction(d->wi);
    printf("%s: %s, from %s\n", run->out, run->format == LAB_FORMAT_RGL ? "RGL" : "MERL", run->in);
    printf("difference  rms %.3g  mean %.3g  albedo %.2g\n", d->rms, d->mean, d->albedo);
    printf("largest     %.3g of f, at wo %.1f,%.1f wi %.1f,%.1f\n", d->worst, wo.theta, wo.phi,
           wi.theta, wi.phi);
    if (run->format == LAB_FORMAT_MERL && run->reciprocity > 0.01) {
        printf("reciprocity f(wo, wi) and f(wi, wo) differ by %.2g of f in %s; MERL has one value, "
               "their mean\n",
               run->reciprocity, run->in);
    }
}

static void put_angles(struct json *json, const char *key, brdf_vec3 w)
{
    struct angles angles = angles_of_direction(w);
    json_array(json, key);
    json_real(json, NULL, angles.theta);
    json_real(json, NULL, angles.phi);
    json_array_end(json);
}

static brdf_status write_json(const struct convert_run *run, struct brdf_error *error)
{
    struct json json = {0};
    const struct lab_difference *d = &run->difference;
    json_object(&json, NULL);
    json_text(&json, "in", run->in);
    json_text(&json, "out", run->out);
    json_text(&json, "format", run->format == LAB_FORMAT_RGL ? "rgl" : "merl");
    json_real(&json, "rms", d->rms);
    json_real(&json, "mean", d->mean);
    json_real(&json, "albedo", d->albedo);
    json_real(&json, "reciprocity", run->reciprocity);
    json_real(&json, "largest", d->worst);
    put_angles(&json, "largest_wo", d->wo);
    put_angles(&json, "largest_wi", d->wi);
    json_object_end(&json);
    brdf_status status = json_write(&json, run->json_path, error);
    json_free(&json);
    return status;
}

int command_convert(int argc, char **argv)
{
    struct convert_run run = {.fill = 1};
    struct brdf_error error = {BRDF_OK, ""};
    int exit_status = read_command_line(&run, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    brdf_status status = convert(&run, &error);
    if (!status && run.json_path) {
        status = write_json(&run, &error);
    }
    if (!status && !(run.json_path && strcmp(run.json_path, "-") == 0)) {
        print_difference(&run);
    }
    return measured_exit(status, &error);
}
