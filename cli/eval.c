/* eval.c - brdfcl eval: f, f cos and pdf of a material for two directions. */
#include <math.h>
#include <stdio.h>

#include <brdf/material.h>
#include <brdfcl/evaluate.h>

#include "backend.h"
#include "commands.h"
#include "options.h"
#include "parse.h"
#include "say.h"

static const char summary[] = "Evaluate a material, such as roughconductor:material=Cu,alpha=0.2, "
                              "for a direction to the viewer\n"
                              "and one to the light; degrees from the normal and around it.";

struct values {
    float f[3]; /* 1/sr */
    float pdf;  /* 1/sr */
};

static brdf_status evaluate_opencl(const struct backend *backend, const struct brdf_bsdf *bsdf,
                                   brdf_vec3 wo, brdf_vec3 wi, struct values *values,
                                   struct brdf_error *error)
{
    struct brdf_vectors wo_array = {&wo.x, &wo.y, &wo.z};
    struct brdf_vectors wi_array = {&wi.x, &wi.y, &wi.z};
    struct brdf_colors f = {&values->f[0], &values->f[1], &values->f[2]};
    struct brdfcl_device *device = NULL;
    struct brdfcl_evaluator *evaluator = NULL;
    brdf_status status = backend_open(backend, &device, error);
    if (!status) {
        status = brdfcl_evaluator_create(device, bsdf, &evaluator, error);
    }
    if (!status) {
        status = brdfcl_evaluator_eval(evaluator, 1, wo_array, wi_array, f, error);
    }
    if (!status) {
        status = brdfcl_evaluator_pdf(evaluator, 1, wo_array, wi_array, &values->pdf, error);
    }
    brdfcl_evaluator_destroy(evaluator);
    brdfcl_device_close(device);
    return status;
}

static brdf_status evaluate(const struct backend *backend, const char *description, brdf_vec3 wo,
                            brdf_vec3 wi, struct values *values, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = brdf_bsdf_create(description, &bsdf, error);
    if (!status && backend->kind == BACKEND_OPENCL) {
        status = evaluate_opencl(backend, bsdf, wo, wi, values, error);
    } else if (!status) {
        brdf_rgb f = brdf_eval(bsdf, wo, wi);
        values->f[0] = f.r;
        values->f[1] = f.g;
        values->f[2] = f.b;
        values->pdf = brdf_pdf(bsdf, wo, wi);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}

int command_eval(int argc, char **argv)
{
    struct angles wo_angles = {0.0, 0.0, 0}, wi_angles = {0.0, 0.0, 0};
    struct backend backend = {BACKEND_C, NULL, 0, 0};
    const struct option options[] = {
        {"wo", 0, OPTION_ANGLES, &wo_angles, "THETA,PHI", 0, 0, "to the viewer [degrees]"},
        {"wi", 0, OPTION_ANGLES, &wi_angles, "THETA,PHI", 0, 0, "to the light [degrees]"},
        {"backend", 0, OPTION_CHOICE, &backend.kind, BACKEND_NAMES, 0, 0,
         "where to compute; c if not given, both give the same bits"},
        {"device", 0, OPTION_TEXT, &backend.device, "D", 0, 0,
         "OpenCL device: its number or a part of its name"},
        {"lanes", 0, OPTION_INT, &backend.lanes, "N", 1, 16,
         "vector lanes of kernels: 1, 4, 8, 16"},
    };
    const struct usage usage = {
        "eval", "BSDF", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status == OPTIONS_GO_ON) {
        status = backend_check(&backend);
    }
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (!wo_angles.given || !wi_angles.given) {
        return say_usage("eval needs both --wo THETA,PHI and --wi THETA,PHI");
    }
    struct brdf_error error = {BRDF_OK, ""};
    struct values values;
    brdf_vec3 wi = direction_of_angles(wi_angles);
    if (evaluate(&backend, arguments.item[0], direction_of_angles(wo_angles), wi, &values,
                 &error)) {
        return say_error(&error);
    }
    double cosine = fabs((double)wi.z);
    double f[3] = {(double)values.f[0], (double)values.f[1], (double)values.f[2]};
    printf("f      %.9g %.9g %.9g  1/sr\n", f[0], f[1], f[2]);
    printf("f cos  %.9g %.9g %.9g  1/sr\n", f[0] * cosine, f[1] * cosine, f[2] * cosine);
    printf("pdf    %.9g  1/sr\n", (double)values.pdf);
    return EXIT_DONE;
}
