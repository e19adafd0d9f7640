/* convert.c - brdfcl convert: a material into a measured file, and how far that took it away. */
#include <stdio.h>
#include <string.h>

#include "brdflab/complete.h"
#include "brdflab/open.h"
#include "brdflab/survey.h"
#include "commands.h"
#include "difference.h"
#include "json.h"
#include "measured.h"
#include "options.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Write a material, a measured file (.binary, .bsdf) or a description such as\n"
    "roughconductor:material=Au,alpha=0.2, as a measured file, and print how much that changed it: "
    "root\n"
    "mean square and mean of the difference, relative to f and weighted by the cosine; what it is "
    "below\n"
    "for 99 % of the light; the largest of the albedos; and the largest relative difference with "
    "its\n"
    "directions (theta,phi in degrees), up to 80 degrees from the normal and, \"grazing\", beyond.";

struct convert_run {
    const char *in;
    struct measured_out out;
    const char *json_path;
    int fill;
    struct lab_difference difference;
    double reciprocity; /* of what was read, as lab_reciprocity tells it */
};

static int read_command_line(struct convert_run *run, int argc, char **argv)
{
    const struct option options[] = {
        MEASURED_OUT_OPTIONS(run->out),
        MEASURED_NO_FILL(&run->fill),
        {"json", 0, OPTION_TEXT, &run->json_path, "FILE", 0, 0,
         "write the differences as JSON; - is standard output, which then has nothing else"},
    };
    const struct usage usage = {
        "convert", "MATERIAL OUT", summary, options, sizeof options / sizeof options[0], 2, 2};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    run->in = arguments.item[0];
    return measured_out_set(&run->out, arguments.item[1], arguments.item, 1);
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
        status = measured_write_merl(&run->out, &file, error);
    }
    brdf_merl_free(&file);
    return status;
}

/* The difference is that of what is on the disk now. */
static brdf_status compare(struct convert_run *run, const struct brdf_bsdf *in,
                           struct brdf_error *error)
{
    struct brdf_bsdf *out = NULL;
    brdf_status status = lab_open(run->out.path, &out, NULL, error);
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
    brdf_status status = measured_check(&run->out, error);
    if (!status && run->json_path) {
        status = text_file_check(run->json_path, error);
    }
    if (!status) {
        status = lab_open_filled(run->in, run->fill, &in, NULL, error);
    }
    if (!status) {
        status = run->out.format == LAB_FORMAT_RGL ? measured_write_rgl(&run->out, in, error)
                                                   : write_merl(run, error);
    }
    if (!status) {
        status = compare(run, in, error);
    }
    brdf_bsdf_destroy(in);
    return status;
}

static void print_report(const struct convert_run *run)
{
    printf("%s: %s, from %s\n", run->out.path, run->out.format == LAB_FORMAT_RGL ? "RGL" : "MERL",
           run->in);
    difference_print(&run->difference);
    if (run->out.format == LAB_FORMAT_MERL && run->reciprocity > 0.01) {
        printf("reciprocity f(wo, wi) and f(wi, wo) differ by %.2g of f in %s; MERL has one value, "
               "their mean\n",
               run->reciprocity, run->in);
    }
}

static brdf_status write_json(const struct convert_run *run, struct brdf_error *error)
{
    struct json json = {0};
    json_object(&json, NULL);
    json_text(&json, "material", run->in);
    json_text(&json, "out", run->out.path);
    json_text(&json, "format", run->out.format == LAB_FORMAT_RGL ? "rgl" : "merl");
    difference_put(&json, &run->difference);
    json_real(&json, "reciprocity", run->reciprocity);
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
        print_report(&run);
    }
    return measured_exit(status, &error);
}
