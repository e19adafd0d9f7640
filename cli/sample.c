/* sample.c - brdfcl sample: directions drawn from a material, as CSV. */
#include <stdint.h>
#include <stdio.h>

#include <brdf/material.h>

#include "brdflab/open.h"
#include "commands.h"
#include "measured.h"
#include "options.h"
#include "parse.h"
#include "random.h"
#include "say.h"

static const char summary[] =
    "Draw directions to the light for one to the viewer and print them as CSV: the random numbers, "
    "the\n"
    "direction (also as degrees), weight = f cos / pdf, pdf [1/sr], the relative refractive index, "
    "and\n"
    "whether the lobe is a delta (then pdf is the probability of having chosen it). A line with "
    "pdf 0\n"
    "is a draw that found no direction; such lines belong to the statistics.";

static void print_sample(brdf_vec3 u, struct brdf_sample s)
{
    struct angles angles = angles_of_direction(s.wi);
    printf("%.9g,%.9g,%.9g,", (double)u.x, (double)u.y, (double)u.z);
    printf("%.9g,%.9g,%.9g,%.6f,%.6f,", (double)s.wi.x, (double)s.wi.y, (double)s.wi.z,
           angles.theta, angles.phi);
    printf("%.9g,%.9g,%.9g,%.9g,%.9g,%d\n", (double)s.weight.r, (double)s.weight.g,
           (double)s.weight.b, (double)s.pdf, (double)s.eta, s.delta != 0);
}

int command_sample(int argc, char **argv)
{
    struct angles wo = {0.0, 0.0, 0};
    int count = 16, seed = 0, fill = 1;
    const struct option options[] = {
        {"wo", 0, OPTION_ANGLES, &wo, "THETA,PHI", 0, 0, "to the viewer [degrees]"},
        {"count", 0, OPTION_INT, &count, "N", 1, 2147483647, "how many; 16 if not given"},
        {"seed", 0, OPTION_INT, &seed, "N", 0, 2147483647, "another seed, other numbers"},
        MEASURED_NO_FILL(&fill),
    };
    const struct usage usage = {
        "sample", "MATERIAL", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    if (!wo.given) {
        return say_usage("sample needs --wo THETA,PHI");
    }
    struct brdf_error error = {BRDF_OK, ""};
    struct brdf_bsdf *bsdf;
    if (lab_open_filled(arguments.item[0], fill, &bsdf, NULL, &error)) {
        return say_error(&error);
    }
    brdf_vec3 viewer = direction_of_angles(wo);
    printf("u1,u2,u3,x,y,z,theta,phi,weight_r,weight_g,weight_b,pdf,eta,delta\n");
    for (int i = 0; i < count && !ferror(stdout); ++i) {
        uint64_t place = 3 * (uint64_t)i;
        brdf_vec3 u = brdf_vec3_make(random_uniform((unsigned)seed, place),
                                     random_uniform((unsigned)seed, place + 1),
                                     random_uniform((unsigned)seed, place + 2));
        print_sample(u, brdf_sample(bsdf, viewer, u));
    }
    brdf_bsdf_destroy(bsdf);
    return EXIT_DONE;
}
