/* variance.c - how much noise a material's sampling leaves, beside sampling the cosine. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/model.h>
#include <brdf/warp.h>

#include "angle.h"
#include "arrays.h"
#include "bench.h"
#include "brdflab/lattice.h"
#include "file_name.h"
#include "parse.h"
#include "random.h"

/*
 * One sample's estimate of the light that a viewer sees, under four lights: radiance 1 from
 * everywhere; a lobe cos^LOBE about an axis that is neither the normal nor the mirror direction of
 * the viewer, where sampling the material is right but not ideal; and small disks, cones of
 * radiance 1, one around the mirror direction and one 10 degrees off it.
 */
enum { LIGHTS = 4, LOBE = 16 };
static const double disk_degrees = 5.0; /* from a disk's centre to its rim */
static const struct angles viewer = {60.0, 0.0, 1};

static const struct light {
    const char *name, *key;
    enum { LIGHT_CONSTANT, LIGHT_LOBE, LIGHT_DISK } kind;
    struct angles axis; /* opposite the viewer: azimuth 180 */
} lights[LIGHTS] = {
    {"constant", "constant", LIGHT_CONSTANT, {0.0, 180.0, 1}},
    {"lobe", "lobe", LIGHT_LOBE, {30.0, 180.0, 1}},
    {"disk", "disk", LIGHT_DISK, {60.0, 180.0, 1}},
    {"disk, off", "disk_off", LIGHT_DISK, {50.0, 180.0, 1}},
};

/* Sums of an estimate. */
struct moments {
    double sum;
    double squares;
};

struct noise {
    double mean[LIGHTS];
    double sampled[LIGHTS]; /* variance over mean^2, NaN where there is no light */
    double cosine[LIGHTS];  /* NaN where cosine sampling cannot find the lobes */
};

static double mean_of(brdf_rgb c)
{
    return ((double)c.r + (double)c.g + (double)c.b) / 3.0;
}

static double radiance(const struct light *light, brdf_vec3 w)
{
    double cosine = (double)brdf_dot(w, direction_of_angles(light->axis));
    switch (light->kind) {
    case LIGHT_LOBE:
        return pow(fmax(cosine, 0.0), LOBE);
    case LIGHT_DISK:
        return cosine >= cos(disk_degrees * degree) ? 1.0 : 0.0;
    default:
        return 1.0;
    }
}

static void add(struct moments moments[LIGHTS], brdf_vec3 wi, double weight)
{
    for (int light = 0; light < LIGHTS; ++light) {
        double x = weight > 0.0 ? weight * radiance(&lights[light], wi) : 0.0;
        moments[light].sum += x;
        moments[light].squares += x * x;
    }
}

static const double rounding = 1e-9; /* of single precision; a variance below it is none */

/* Around a mean that may be known better than from the sums themselves. */
static double relative_variance(const struct moments *moments, double count, double mean)
{
    double variance = moments->squares / count / (mean * mean) - 1.0;
    return mean <= 0.0 ? (double)NAN : variance > rounding ? variance : 0.0;
}

/* f cos integrated over a disk, by a lattice in it: draws from all around hit it too seldom. */
static double disk_integral(const struct brdf_bsdf *bsdf, brdf_vec3 wo, const struct light *light)
{
    enum { POINTS = 1 << 16 };
    struct lab_lattice lattice = lab_lattice_make(2, 1);
    double height = 1.0 - cos(disk_degrees * degree); /* of the cap of the unit sphere */
    double tilt = light->axis.theta * degree, sum = 0.0;
    for (size_t i = 0; i < POINTS; ++i) {
        double z = 1.0 - height * (double)lab_lattice_at(&lattice, i, 0);
        double phi = 2.0 * pi * (double)lab_lattice_at(&lattice, i, 1);
        double r = sqrt(1.0 - z * z), x = r * cos(phi);
        brdf_vec3 wi = brdf_vec3_make((float)(x * cos(tilt) - z * sin(tilt)), (float)(r * sin(phi)),
                                      (float)(x * sin(tilt) + z * cos(tilt)));
        sum += mean_of(brdf_eval(bsdf, wo, wi)) * (double)wi.z;
    }
    return sum * 2.0 * pi * height / POINTS;
}

/* The estimate of one direction from the cosine, on both sides of a material that transmits. */
static double cosine_weight(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 u, int sides,
                            brdf_vec3 *wi)
{
    *wi = brdf_warp_cosine(u.x, u.y);
    wi->z = sides == 2 && u.z < 0.5f ? -wi->z : wi->z;
    return sides * pi * mean_of(brdf_eval(bsdf, wo, *wi));
}

static struct noise measure(const struct brdf_bsdf *bsdf, int count)
{
    struct moments sampled[LIGHTS] = {{0.0, 0.0}};
    struct moments cosine[LIGHTS] = {{0.0, 0.0}};
    struct noise noise;
    int sides = brdf_bsdf_material(bsdf)->flags & BRDF_TRANSMISSION ? 2 : 1;
    int deltas = 0;
    brdf_vec3 wo = direction_of_angles(viewer);
    for (int i = 0; i < count; ++i) {
        brdf_vec3 u, wi;
        uint64_t place = 3 * (uint64_t)i;
        u.x = random_uniform(1, place);
        u.y = random_uniform(1, place + 1);
        u.z = random_uniform(1, place + 2);
        struct brdf_sample s = brdf_sample(bsdf, wo, u);
        deltas += s.delta != 0;
        add(sampled, s.wi, mean_of(s.weight));
        double weight = cosine_weight(bsdf, wo, u, sides, &wi);
        add(cosine, wi, weight);
    }
    for (int light = 0; light < LIGHTS; ++light) {
        double mean = lights[light].kind == LIGHT_DISK && !deltas
                          ? disk_integral(bsdf, wo, &lights[light])
                          : sampled[light].sum / count;
        noise.mean[light] = mean;
        noise.sampled[light] = relative_variance(&sampled[light], count, mean);
        noise.cosine[light] = deltas ? (double)NAN
                                     : relative_variance(&cosine[light], count,
                                                         lights[light].kind == LIGHT_DISK
                                                             ? mean
                                                             : cosine[light].sum / count);
    }
    return noise;
}

static void print_value(double value)
{
    if (isnan(value) || isinf(value)) {
        printf(" %10s", "-");
    } else {
        printf(" %10.4g", value);
    }
}

static void put_light(struct json *json, const struct noise *noise, int light)
{
    json_object(json, lights[light].key);
    json_real(json, "mean", noise->mean[light]);
    json_real(json, "relative_variance", noise->sampled[light]);
    json_real(json, "relative_variance_cosine", noise->cosine[light]);
    json_object_end(json);
}

void bench_variance_begin(struct bench *bench)
{
    printf("relative variance of one sample, viewer at %g degrees; %d samples\n", viewer.theta,
           bench->count);
    printf(
        "constant: radiance 1 from everywhere; lobe: cos^%d about %g degrees on the other side;\n",
        LOBE, lights[1].axis.theta);
    printf(
        "disk: radiance 1 within %g degrees of the mirror direction; off: of %g degrees from it\n",
        disk_degrees, lights[2].axis.theta - lights[3].axis.theta);
    printf("cosine: what sampling the cosine leaves, \"-\" where it cannot find delta lobes\n\n");
    printf("%-40s %-9s %10s %10s %10s %8s\n", "material", "light", "mean", "sampled", "cosine",
           "ratio");
    json_object(&bench->json, NULL);
    json_text(&bench->json, "version", BRDFCL_VERSION);
    json_int(&bench->json, "samples", bench->count);
    json_real(&bench->json, "viewer_theta", viewer.theta);
    json_int(&bench->json, "lobe_exponent", LOBE);
    json_real(&bench->json, "lobe_theta", lights[1].axis.theta);
    json_real(&bench->json, "disk_radius", disk_degrees);
    json_array(&bench->json, "rows");
}

brdf_status bench_variance(struct bench *bench, const char *description, struct brdf_error *error)
{
    struct json *json = &bench->json;
    struct brdf_bsdf *bsdf;
    brdf_status status = measured_bsdf_create(description, &bsdf, error);
    if (status) {
        return status;
    }
    int is_path = strchr(description, ':') == NULL;
    const char *shown = is_path ? file_name_of(description) : description;
    struct noise noise = measure(bsdf, bench->count);
    brdf_bsdf_destroy(bsdf);
    json_object(json, NULL);
    json_text(json, "material", description);
    for (int light = 0; light < LIGHTS; ++light) {
        printf("%-40.40s %-9s %10.5g", light ? "" : shown, lights[light].name, noise.mean[light]);
        print_value(noise.sampled[light]);
        print_value(noise.cosine[light]);
        print_value(noise.cosine[light] / noise.sampled[light]);
        put_light(json, &noise, light);
        printf("\n");
    }
    fflush(stdout);
    json_object_end(json);
    return BRDF_OK;
}
