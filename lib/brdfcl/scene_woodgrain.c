/*
 * scene_woodgrain.c - <texture type="woodgrain">: its parameters, and which of its outputs sets
 * what.
 */
#include "angle.h"
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* enum pt_grain_output, and the parameters that are set by it if the file does not say. */
static const struct woodgrain_output {
    const char *name;
    const char *parameters;
} outputs[PT_GRAIN_OUTPUTS] = {
    {"color", "reflectance|diffuse_reflectance|base_color"},
    {"fiber_color", "fiber_reflectance"},
    {"fiber_axis", "fiber_axis"},
    {"beta", "beta"},
    {"alpha", "alpha|alpha_u|alpha_v|roughness"},
    {"late", ""},
};

static void put_numbers(float *to, const double *from, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        to[i] = (float)from[i];
    }
}

/* Where the wood is in the log, and back; the fibres are directions. */
static brdf_status put_place(const struct scene_loader *loader, const struct scene_slot *slot,
                             struct pt_texture *record)
{
    const double *to_world = slot->value;
    double inverse[16];
    if (scene_matrix_is_singular(to_world)) {
        return scene_fail(loader, slot->given, BRDF_OUT_OF_RANGE,
                          "to_world flattens the log: it has no inverse");
    }
    scene_matrix_inverse(to_world, inverse);
    put_numbers(record->log_from_world, inverse, 12);
    for (int i = 0; i < 3; ++i) {
        put_numbers(record->world_from_log + 3 * i, to_world + 4 * i, 3);
    }
    return BRDF_OK;
}

static brdf_status find_output(const struct scene_loader *loader, const struct scene_slot *slot,
                               struct scene_texture *texture)
{
    const char *names[COUNT(outputs)];
    const char *wanted = *(const char **)slot->value;
    if (!slot->given) {
        return BRDF_OK;
    }
    for (size_t i = 0; i < COUNT(outputs); ++i) {
        names[i] = outputs[i].name;
        if (strcmp(names[i], wanted) == 0) {
            texture->record.output = (int)i;
            texture->output_given = 1;
            return BRDF_OK;
        }
    }
    return scene_fail_unknown(loader, slot->given, "output", wanted, names, COUNT(outputs));
}

brdf_status scene_woodgrain_read(struct scene_loader *loader, struct xml_node *node,
                                 struct scene_texture *texture)
{
    double to_world[16];
    double sizes[PT_GRAIN_SIZES] = {0.06, 0.8, 4.0, 0.5, 0.3}; /* enum pt_grain_size */
    double early[3] = {0.52, 0.30, 0.14};
    double late[3] = {0.20, 0.085, 0.03};
    double fiber_early[3] = {0.34, 0.21, 0.10};
    double fiber_late[3] = {0.16, 0.08, 0.035};
    double beta[2] = {0.17, 0.25};
    double alpha[2] = {0.18, 0.10};
    int seed = 0;
    const char *output = NULL;
    const double least = (double)FLT_MIN;
    const double most = (double)FLT_MAX;
    struct scene_slot slots[] = {
        {"to_world", SLOT_TRANSFORM, to_world, 0.0, 0.0, NULL},
        {"output", SLOT_STRING, &output, 0.0, 0.0, NULL},
        {"ring_width", SLOT_REAL, &sizes[PT_GRAIN_RING], least, most, NULL},
        {"ring_wander", SLOT_REAL, &sizes[PT_GRAIN_WANDER], 0.0, 100.0, NULL},
        {"figure", SLOT_REAL, &sizes[PT_GRAIN_FIGURE], 0.0, 60.0, NULL},
        {"figure_length", SLOT_REAL, &sizes[PT_GRAIN_FIGURE_LENGTH], least, most, NULL},
        {"streaks", SLOT_REAL, &sizes[PT_GRAIN_STREAKS], 0.0, 1.0, NULL},
        {"early_color", SLOT_COLOR, early, 0.0, 0.0, NULL},
        {"late_color", SLOT_COLOR, late, 0.0, 0.0, NULL},
        {"early_fiber_color", SLOT_COLOR, fiber_early, 0.0, 0.0, NULL},
        {"late_fiber_color", SLOT_COLOR, fiber_late, 0.0, 0.0, NULL},
        {"early_beta", SLOT_REAL, &beta[0], 0.0, most, NULL},
        {"late_beta", SLOT_REAL, &beta[1], 0.0, most, NULL},
        {"early_alpha", SLOT_REAL, &alpha[0], 0.0, most, NULL},
        {"late_alpha", SLOT_REAL, &alpha[1], 0.0, most, NULL},
        {"seed", SLOT_INTEGER, &seed, 0.0, 1e9, NULL},
    };
    struct pt_texture *record = &texture->record;
    brdf_status status;
    scene_matrix_identity(to_world);
    status = scene_slots_read(loader, node, slots, COUNT(slots), "");
    if (!status) {
        status = put_place(loader, &slots[0], record);
    }
    if (!status) {
        status = find_output(loader, &slots[1], texture);
    }
    sizes[PT_GRAIN_FIGURE] = tan(sizes[PT_GRAIN_FIGURE] * pi / 180.0);
    record->kind = PT_TEXTURE_WOODGRAIN;
    record->seed = seed;
    put_numbers(record->sizes, sizes, COUNT(sizes));
    put_numbers(record->color0, early, 3);
    put_numbers(record->color1, late, 3);
    put_numbers(record->fiber0, fiber_early, 3);
    put_numbers(record->fiber1, fiber_late, 3);
    put_numbers(record->beta, beta, 2);
    put_numbers(record->alpha, alpha, 2);
    return status;
}

brdf_status scene_texture_output(const struct scene_loader *loader, const struct xml_node *node,
                                 int texture, const char *parameter, int *output)
{
    const struct scene_texture *from = &loader->scene->textures[texture];
    *output = from->record.output;
    if (from->record.kind != PT_TEXTURE_WOODGRAIN || from->output_given) {
        return BRDF_OK;
    }
    for (size_t i = 0; i < COUNT(outputs); ++i) {
        if (scene_list_has(outputs[i].parameters, parameter)) {
            *output = (int)i;
            return BRDF_OK;
        }
    }
    return scene_fail(loader, node, BRDF_BAD_FILE,
                      "a woodgrain has nothing that is meant for \"%s\": choose one of color, "
                      "fiber_color, fiber_axis, beta, alpha, late as its output",
                      parameter);
}

static void widen(const float *values, size_t count, float *least, float *most)
{
    for (size_t i = 0; i < count; ++i) {
        *least = values[i] < *least ? values[i] : *least;
        *most = values[i] > *most ? values[i] : *most;
    }
}

void scene_texture_range(const struct scene_texture *texture, int output, float *least, float *most)
{
    const struct pt_texture *record = &texture->record;
    float darkest = 1.0f - record->sizes[PT_GRAIN_STREAKS];
    *least = texture->least;
    *most = texture->most;
    if (record->kind != PT_TEXTURE_WOODGRAIN) {
        return;
    }
    *least = FLT_MAX;
    *most = -FLT_MAX;
    switch (output) {
    case PT_GRAIN_COLOR:
        widen(record->color0, 3, least, most);
        widen(record->color1, 3, least, most);
        *least *= darkest;
        break;
    case PT_GRAIN_FIBER_COLOR:
        widen(record->fiber0, 3, least, most);
        widen(record->fiber1, 3, least, most);
        *least *= darkest;
        break;
    case PT_GRAIN_BETA:
        widen(record->beta, 2, least, most);
        break;
    case PT_GRAIN_ALPHA:
        widen(record->alpha, 2, least, most);
        break;
    default:
        *least = 0.0f;
        *most = 1.0f;
        break;
    }
}
