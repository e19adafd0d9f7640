/* variance.c - how much noise a material's sampling leaves, beside sampling the cosine. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/info.h>
#include <brdf/model.h>
#include <brdf/warp.h>

#include "arrays.h"
#include "bench.h"
#include "parse.h"
#include "random.h"

/*
 * One sample's estimate of the light that a viewer sees, under two lights: radiance 1 from
 * everywhere, and a lobe cos^LOBE about an axis that is neither the normal nor the mirror direction
 * of the viewer, where sampling the material is right but not ideal.
 */
enum { LIGHT_CONSTANT, LIGHT_LOBE, LIGHTS, LOBE = 16 };
static const struct angles viewer = {60.0, 0.0, 1};
static const struct angles axis_of_lobe = {30.0, 180.0, 1};

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

static double radiance(int light, brdf_vec3 w)
{
    if (light == LIGHT_CONSTANT) {
        return 1.0;
    }
    return pow(fmax((double)brdf_dot(w, direction_of_angles(axis_of_lobe)), 0.0), LOBE);
}

static void add(struct moments moments[LIGHTS], brdf_vec3 wi, double weight)
{
    for (int light = 0; light < LIGHTS; ++light) {
        double x = weight > 0.0 ? weight * radiance(light, wi) : 0.0;
        moments[light].sum += x;
        moments[light].squares += x * x;
    }
}

static double relative_variance(const struct moments *moments, double count)
{
    double mean = moments->sum / count;
    double variance = moments->squares / count - mean * mean;
    return mean > 0.0 ? fmax(variance, 0.0) / (mean * mean) : (double)NAN;
}

/* The estimate of one direction from the cosine, on both sides of a material that transmits. */
static double cosine_weight(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 u, int sides,
                            brdf_vec3 *wi)
{
    *wi = brdf_warp_cosine(u.x, u.y);
    wi->z = sides == 2 && u.z < 0.5f ? -wi->z : wi->z;
    return sides * 3.14159265358979323846 * mean_of(brdf_eval(bsdf, wo, *wi));
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
        noise.mean[light] = sampled[light].sum / count;
        noise.sampled[light] = relative_variance(&sampled[light], count);
        noise.cosine[light] = deltas ? (double)NAN : relative_variance(&cosine[light], count);
    }
    return noise;
}

static void print_value(double value)
{
    if (isnan(value)) {
        printf(" %9s", "-");
    } else {
        printf(" %9.4g", value);
    }
}

static void put_light(struct json *json, const char *name, const struct noise *noise, int light)
{
    json_object(json, name);
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
        "constant: radiance 1 from everywhere; lobe: cos^%d about %g degrees on the other side\n",
        LOBE, axis_of_lobe.theta);
    printf("cosine: what sampling the cosine leaves; '-' where it cannot find delta lobes\n\n");
    printf("%-32s %9s %9s %9s  %9s %9s %9s\n", "material", "constant", "variance", "cosine", "lobe",
           "variance", "cosine");
    json_object(&bench->json, NULL);
    json_text(&bench->json, "version", BRDFCL_VERSION);
    json_int(&bench->json, "samples", bench->count);
    json_real(&bench->json, "viewer_degrees", viewer.theta);
    json_int(&bench->json, "lobe_exponent", LOBE);
    json_real(&bench->json, "lobe_degrees", axis_of_lobe.theta);
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
    struct noise noise = measure(bsdf, bench->count);
    brdf_bsdf_destroy(bsdf);
    printf("%-32.32s", description);
    json_object(json, NULL);
    json_text(json, "subject", description);
    for (int light = 0; light < LIGHTS; ++light) {
        printf(light ? "  %9.5f" : " %9.5f", noise.mean[light]);
        print_value(noise.sampled[light]);
        print_value(noise.cosine[light]);
        put_light(json, light ? "lobe" : "constant", &noise, light);
    }
    printf("\n");
    fflush(stdout);
    json_object_end(json);
    return BRDF_OK;
}
