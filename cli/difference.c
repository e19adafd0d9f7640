/* difference.c - what tabulating a material changed. */
#include "difference.h"

#include <stdio.h>

#include "parse.h"

static void print_worst(const char *name, const struct lab_worst *worst)
{
    struct angles wo = angles_of_direction(worst->wo), wi = angles_of_direction(worst->wi);
    if (worst->relative > 0.0) {
        printf("%-11s %.3g of f, at wo %.1f,%.1f wi %.1f,%.1f\n", name, worst->relative, wo.theta,
               wo.phi, wi.theta, wi.phi);
    }
}

void difference_print(const struct lab_difference *d)
{
    printf("difference  rms %.3g  mean %.3g  99%% below %.2g  albedo %.2g\n", d->rms, d->mean,
           d->most, d->albedo);
    print_worst("largest", &d->worst);
    print_worst("grazing", &d->grazing);
}

static void put_direction(struct json *json, const char *key, brdf_vec3 w)
{
    struct angles angles = angles_of_direction(w);
    json_object(json, key);
    json_real(json, "theta", angles.theta);
    json_real(json, "phi", angles.phi);
    json_object_end(json);
}

static void put_worst(struct json *json, const char *key, const struct lab_worst *worst)
{
    json_object(json, key);
    json_real(json, "value", worst->relative);
    put_direction(json, "wo", worst->wo);
    put_direction(json, "wi", worst->wi);
    json_object_end(json);
}

void difference_put(struct json *json, const struct lab_difference *d)
{
    json_object(json, "difference");
    json_real(json, "rms", d->rms);
    json_real(json, "mean", d->mean);
    json_real(json, "below_99_percent", d->most);
    json_real(json, "albedo", d->albedo);
    put_worst(json, "largest", &d->worst);
    put_worst(json, "largest_grazing", &d->grazing);
    json_object_end(json);
}
