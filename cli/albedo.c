/* albedo.c - brdfcl albedo: how much of the light a material sends back, and lets through. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/material.h>
#include <brdf/model.h>

#include "brdflab/albedo.h"
#include "brdflab/open.h"
#include "commands.h"
#include "json.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Print the albedo of a material: the share of a beam's power that it reflects (R) and, where "
    "it can,\n"
    "transmits (T), for red, green and blue, over angles of incidence, and the average over all "
    "directions\n"
    "of the side. \"error\" is one standard deviation of the worst of a row's numbers. A sum above "
    "1 "
    "is light\n"
    "from nowhere.";

struct albedo_run {
    const char *description;
    struct numbers theta; /* degrees */
    int angles;           /* how many, if theta is empty */
    double phi;           /* degrees */
    int inside;
    int fill;
    int samples; /* of each row */
    int csv;
    const char *json_path;
    int transmits;
    struct json json;
};

static int read_command_line(struct albedo_run *run, int argc, char **argv)
{
    const struct option options[] = {
        {"angles", 0, OPTION_INT, &run->angles, "N", 1, 256,
         "that many angles from 0 to 89 degrees; 10 if not given"},
        {"theta", 0, OPTION_REALS, &run->theta, "A,B,...", 0, 89.99,
         "these angles from the normal instead [degrees]"},
        {"phi", 0, OPTION_REAL, &run->phi, "PHI", -360, 360, "azimuth of them; 0 if not given"},
        {"inside", 0, OPTION_ON, &run->inside, NULL, 0, 0,
         "light arrives from below the surface, at these angles from -z"},
        {"samples", 0, OPTION_INT, &run->samples, "N", 1024, 1 << 30,
         "of each angle; 262144 if not given"},
        {"csv", 0, OPTION_ON, &run->csv, NULL, 0, 0, "print CSV instead of a table"},
        {"json", 0, OPTION_TEXT, &run->json_path, "FILE", 0, 0,
         "write everything as JSON; - is standard output, which then has no table"},
        MEASURED_NO_FILL(&run->fill),
    };
    const struct usage usage = {
        "albedo", "MATERIAL", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    run->description = status == OPTIONS_GO_ON ? arguments.item[0] : NULL;
    for (int i = 0; i < run->angles && !run->theta.count; ++i) {
        run->theta.item[i] = run->angles > 1 ? 89.0 * i / (run->angles - 1) : 0.0;
    }
    run->theta.count = run->theta.count ? run->theta.count : run->angles;
    return status;
}

static int is_printing(const struct albedo_run *run)
{
    return !run->json_path || strcmp(run->json_path, "-") != 0;
}

static void print_heading(const struct albedo_run *run)
{
    if (is_printing(run) && run->csv) {
        printf("theta,reflection_r,reflection_g,reflection_b,"
               "transmission_r,transmission_g,transmission_b,error\n");
    } else if (is_printing(run)) {
        printf("%7s  %8s %8s %8s", "theta", "R red", "green", "blue");
        if (run->transmits) {
            printf("  %8s %8s %8s", "T red", "green", "blue");
        }
        printf("  %8s\n", "error");
    }
}

static void print_row(const struct albedo_run *run, const char *name,
                      const struct lab_albedo *albedo)
{
    const double *r = albedo->reflection;
    const double *t = albedo->transmission;
    if (run->csv) {
        printf("%s,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.2g\n", name, r[0], r[1], r[2], t[0], t[1], t[2],
               albedo->error);
        return;
    }
    printf("%7s  %8.5f %8.5f %8.5f", name, r[0], r[1], r[2]);
    if (run->transmits) {
        printf("  %8.5f %8.5f %8.5f", t[0], t[1], t[2]);
    }
    printf("  %8.5f\n", albedo->error);
}

static void put_color(struct json *json, const char *key, const double color[3])
{
    json_array(json, key);
    for (int channel = 0; channel < 3; ++channel) {
        json_real(json, NULL, color[channel]);
    }
    json_array_end(json);
}

/* The members of an object that is open. */
static void put_albedo(struct json *json, const struct lab_albedo *albedo)
{
    put_color(json, "reflection", albedo->reflection);
    put_color(json, "transmission", albedo->transmission);
    json_real(json, "error", albedo->error);
    json_object_end(json);
}

static void measure(struct albedo_run *run, const struct brdf_bsdf *bsdf)
{
    struct json *json = &run->json;
    json_object(json, NULL);
    json_text(json, "material", run->description);
    json_text(json, "side", run->inside ? "inside" : "above");
    json_real(json, "phi", run->phi);
    json_int(json, "samples", run->samples);
    json_array(json, "albedo");
    print_heading(run);
    for (int i = 0; i < run->theta.count; ++i) {
        struct angles angles = {run->theta.item[i], run->phi, 1};
        brdf_vec3 wo = direction_of_angles(angles);
        wo.z = run->inside ? -wo.z : wo.z;
        struct lab_albedo albedo = lab_albedo_at(bsdf, wo, (size_t)run->samples);
        char name[32];
        snprintf(name, sizeof name, run->csv ? "%.9g" : "%.2f", angles.theta);
        if (is_printing(run)) {
            print_row(run, name, &albedo);
        }
        json_object(json, NULL);
        json_real(json, "theta", angles.theta);
        put_albedo(json, &albedo);
    }
    json_array_end(json);
    struct lab_albedo average = lab_albedo_average(bsdf, run->inside, (size_t)run->samples);
    if (is_printing(run)) {
        print_row(run, "average", &average);
    }
    json_object(json, "albedo_average");
    put_albedo(json, &average);
    json_object_end(json);
}

/* A model that shows nothing from below would fill a table with zeros. */
static brdf_status check_side(const struct albedo_run *run, const struct brdf_bsdf *bsdf,
                              struct brdf_error *error)
{
    const struct brdf_material *material = brdf_bsdf_material(bsdf);
    if (run->inside && !(material->flags & (BRDF_TRANSMISSION | BRDF_TWOSIDED))) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "%s neither transmits nor is twosided: from inside it is black; leave "
                         "--inside out, or add \"twosided\" to the description",
                         brdf_model_info((int)material->model)->name);
    }
    return BRDF_OK;
}

int command_albedo(int argc, char **argv)
{
    static const struct albedo_run initial = {
        .angles = 10, .fill = 1, .samples = 4 * LAB_ALBEDO_SAMPLES};
    struct albedo_run run = initial;
    int exit_status = read_command_line(&run, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = run.json_path ? text_file_check(run.json_path, &error) : BRDF_OK;
    status = status ? status : lab_open_filled(run.description, run.fill, &bsdf, NULL, &error);
    status = status ? status : check_side(&run, bsdf, &error);
    if (!status) {
        run.transmits = (brdf_bsdf_material(bsdf)->flags & BRDF_TRANSMISSION) != 0;
        measure(&run, bsdf);
        status = run.json_path ? json_write(&run.json, run.json_path, &error) : BRDF_OK;
    }
    json_free(&run.json);
    brdf_bsdf_destroy(bsdf);
    return status ? say_error(&error) : EXIT_DONE;
}
