/* eval.c - brdfcl eval: f, f cos and pdf of a material for two directions, or for many. */
#include <math.h>
#include <stdio.h>

#include "backend.h"
#include "commands.h"
#include "evaluation.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "say.h"

static const char summary[] =
    "Evaluate a material, such as roughconductor:material=Cu,alpha=0.2, for a direction to the "
    "viewer\n"
    "and one to the light; degrees from the normal and around it. With --directions, for as many "
    "pairs\n"
    "as a file has; f and pdf [1/sr] of each are printed as CSV.";

/* f, f cos and pdf for two directions. */
static brdf_status print_pair(const struct evaluation *evaluation, brdf_vec3 wo, brdf_vec3 wi,
                              struct brdf_error *error)
{
    float f[3], pdf;
    struct brdf_vectors wo_array = {&wo.x, &wo.y, &wo.z};
    struct brdf_vectors wi_array = {&wi.x, &wi.y, &wi.z};
    struct brdf_colors colors = {&f[0], &f[1], &f[2]};
    brdf_status status = evaluation_run(evaluation, 1, wo_array, wi_array, colors, &pdf, error);
    if (!status) {
        double cosine = fabs((double)wi.z);
        printf("f      %.9g %.9g %.9g  1/sr\n", (double)f[0], (double)f[1], (double)f[2]);
        printf("f cos  %.9g %.9g %.9g  1/sr\n", (double)f[0] * cosine, (double)f[1] * cosine,
               (double)f[2] * cosine);
        printf("pdf    %.9g  1/sr\n", (double)pdf);
    }
    return status;
}

int command_eval(int argc, char **argv)
{
    struct angles wo_angles = {0.0, 0.0, 0}, wi_angles = {0.0, 0.0, 0};
    struct backend backend = {BACKEND_C, NULL, 0, 0};
    const char *directions = NULL;
    int fill = 1;
    const struct option options[] = {
        {"wo", 0, OPTION_ANGLES, &wo_angles, "THETA,PHI", 0, 0, "to the viewer [degrees]"},
        {"wi", 0, OPTION_ANGLES, &wi_angles, "THETA,PHI", 0, 0, "to the light [degrees]"},
        {"directions", 0, OPTION_TEXT, &directions, "FILE", 0, 0,
         "pairs of unit vectors instead, a line each: x,y,z,x,y,z; - is standard input"},
        {"backend", 0, OPTION_CHOICE, &backend.kind, BACKEND_NAMES, 0, 0,
         "where to compute; c if not given, both give the same bits"},
        {"device", 0, OPTION_TEXT, &backend.device, "D", 0, 0,
         "OpenCL device: its number or a part of its name"},
        {"lanes", 0, OPTION_INT, &backend.lanes, "N", 1, 32,
         "vector lanes of kernels: 1, 4, 8, 16, 32"},
        MEASURED_NO_FILL(&fill),
    };
    const struct usage usage = {
        "eval", "MATERIAL", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status == OPTIONS_GO_ON) {
        status = backend_check(&backend);
    }
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (directions && (wo_angles.given || wi_angles.given)) {
        return say_usage("eval takes --directions, or --wo and --wi, but not both");
    }
    if (!directions && (!wo_angles.given || !wi_angles.given)) {
        return say_usage("eval needs both --wo THETA,PHI and --wi THETA,PHI, or --directions FILE");
    }
    struct brdf_error error = {BRDF_OK, ""};
    struct evaluation evaluation;
    brdf_status failed = evaluation_open(&evaluation, &backend, arguments.item[0], fill, &error);
    if (!failed && directions) {
        failed = evaluation_print_file(&evaluation, directions, &error);
    } else if (!failed) {
        failed = print_pair(&evaluation, direction_of_angles(wo_angles),
                            direction_of_angles(wi_angles), &error);
    }
    evaluation_close(&evaluation);
    return failed ? say_error(&error) : EXIT_DONE;
}
