/*
 * check_cases.c - materials, directions and random numbers for checks.
 */
#include "check_cases.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <brdf/warp.h>

brdf_vec3 brdfcl_random_direction(struct brdfcl_random *random)
{
    float u = brdfcl_random_uniform(random);
    return brdf_normalize(brdf_warp_sphere(u, brdfcl_random_uniform(random)));
}

/* A direction with the given cosine and a random azimuth. */
static brdf_vec3 direction_at(struct brdfcl_random *random, float z)
{
    struct brdf_sincos turn = brdf_sincos_2pi(brdfcl_random_uniform(random));
    float radius = sqrtf(brdf_max(1.0f - z * z, 0.0f));
    return brdf_vec3_make(radius * turn.cos, radius * turn.sin, z);
}

static float sign_of(struct brdfcl_random *random)
{
    return brdfcl_random_below(random, 4) ? 1.0f : -1.0f;
}

/* 10^-x for x uniform in [0, decades). */
static float small(struct brdfcl_random *random, float decades)
{
    return powf(10.0f, -decades * brdfcl_random_uniform(random));
}

/* The upper side more often than the lower: most models are black below. */
static brdf_vec3 direction_make(struct brdfcl_random *random)
{
    brdf_vec3 w = brdfcl_random_direction(random);
    switch (brdfcl_random_below(random, 16)) {
    case 0:
        return brdf_vec3_make(0.0f, 0.0f, sign_of(random));
    case 1:
        return direction_at(random, 0.0f);
    case 2:
    case 3:
        return direction_at(random, sign_of(random) * small(random, 8.0f));
    case 4: /* along an axis */
        return brdf_normalize(brdf_vec3_make(sign_of(random), 0.0f, small(random, 8.0f)));
    case 5: /* nearly the normal */
        return brdf_normalize(brdf_vec3_make(small(random, 8.0f), -small(random, 8.0f), 1.0f));
    case 6: /* so near the plane that squares and products of cosines vanish */
        return direction_at(random, sign_of(random) * small(random, 37.0f));
    case 7:
        return w;
    default:
        w.z = fabsf(w.z);
        return w;
    }
}

/* wi: on its own, or in a special place with respect to wo. */
static brdf_vec3 second_direction_make(struct brdfcl_random *random, brdf_vec3 wo)
{
    brdf_vec3 mirror = brdf_vec3_make(-wo.x, -wo.y, wo.z);
    switch (brdfcl_random_below(random, 16)) {
    case 0:
        return wo;
    case 1:
        return brdf_negate(wo);
    case 2:
        return mirror;
    case 3:
        return brdf_vec3_make(wo.x, wo.y, -wo.z);
    case 4:
    case 5:
    case 6:
        return brdf_normalize(brdf_add(
            mirror, brdf_scale(brdfcl_random_direction(random), 0.9f * small(random, 7.0f))));
    default:
        return direction_make(random);
    }
}

static float number_make(struct brdfcl_random *random)
{
    float u = brdfcl_random_uniform(random);
    switch (brdfcl_random_below(random, 16)) {
    case 0:
        return 0.0f;
    case 1:
        return BRDF_ONE_MINUS_ULP;
    case 2:
        return small(random, 10.0f) * BRDF_ONE_MINUS_ULP;
    case 3:
        return 1.0f - 0x1p-24f - u * small(random, 8.0f) * 0.9f;
    case 4:
        return 0.5f;
    default:
        return u;
    }
}

struct brdfcl_check_input brdfcl_check_input_make(struct brdfcl_random *random)
{
    struct brdfcl_check_input input;
    input.wo = direction_make(random);
    input.wi = second_direction_make(random, input.wo);
    input.u.x = number_make(random);
    input.u.y = number_make(random);
    input.u.z = number_make(random);
    return input;
}

/* Anywhere in the range: its limits, its initial value, evenly, or evenly in orders of magnitude.
 */
static float value_make(struct brdfcl_random *random, const struct brdf_parameter_info *parameter)
{
    float low = parameter->low;
    float range = parameter->high - low;
    switch (brdfcl_random_below(random, 8)) {
    case 0:
        return low;
    case 1:
        return parameter->high;
    case 2:
        return brdf_clamp(parameter->initial, low, parameter->high);
    case 3:
    case 4:
    case 5:
        return brdf_clamp(low + range * small(random, 5.0f), low, parameter->high);
    default:
        return brdf_clamp(low + range * brdfcl_random_uniform(random), low, parameter->high);
    }
}

void brdfcl_check_material_change(struct brdf_material *material,
                                  const struct brdf_model_info *model, struct brdfcl_random *random)
{
    for (size_t i = 0; i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        int place = brdf_parameter_place(model, parameter);
        if (parameter->kind == BRDF_KIND_REAL || parameter->kind == BRDF_KIND_COLOR) {
            int channels = parameter->kind == BRDF_KIND_COLOR ? 3 : 1;
            for (int channel = 0; channel < channels; ++channel) {
                material->word[place + channel] = value_make(random, parameter);
            }
        }
    }
}

static void describe_one(const struct brdf_material *material, int place,
                         const struct brdf_parameter_info *parameter, char *text, size_t size)
{
    const float *word = material->word + place;
    char option[64] = "";
    switch (parameter->kind) {
    case BRDF_KIND_CHOICE:
        brdf_parameter_item(parameter, (int)(material->choices >> 4 * place & 15u), option,
                            sizeof option);
        snprintf(text, size, "%s=%s,", parameter->name, option);
        break;
    case BRDF_KIND_REAL:
        snprintf(text, size, "%s=%.9g,", parameter->name, (double)word[0]);
        break;
    case BRDF_KIND_COLOR:
        snprintf(text, size, "%s=%.9g/%.9g/%.9g,", parameter->name, (double)word[0],
                 (double)word[1], (double)word[2]);
        break;
    default:
        break;
    }
}

void brdfcl_check_material_describe(const struct brdf_material *material,
                                    const struct brdf_model_info *model, char *text, size_t size)
{
    snprintf(text, size, "%s:", model->name);
    for (size_t i = 0; i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *parameter = &model->parameters[i];
        size_t used = strlen(text);
        describe_one(material, brdf_parameter_place(model, parameter), parameter, text + used,
                     size - used);
    }
    size_t used = strlen(text);
    snprintf(text + used, size - used, "twosided=%s",
             material->flags & BRDF_TWOSIDED ? "true" : "false");
}
