/*
 * scene_mitsuba.c - what Mitsuba 3's plugins assume where a file says nothing, and our models
 * assume something else. With these, the same file gives the same picture in both.
 */
#include "scene_loader.h"

#include <string.h>

#define UNLESS_MAX 3

/* A setting of a model; left out where the file gives one of these parameters. */
struct assumption {
    const char *model;
    const char *name;
    const char *value;
    const char *unless[UNLESS_MAX];
};

static const struct assumption assumptions[] = {
    {"roughconductor", "masking", "separable", {"masking", NULL, NULL}},
    {"roughconductor", "material", "none", {"material", "eta", "k"}},
    {"conductor", "material", "none", {"material", "eta", "k"}},
    {"roughdielectric", "masking", "separable", {"masking", NULL, NULL}},
};

static int is_given(const struct brdf_setting *settings, size_t count, const char *name)
{
    for (size_t i = 0; i < count; ++i) {
        if (strcmp(settings[i].name, name) == 0) {
            return 1;
        }
    }
    return 0;
}

size_t scene_mitsuba_assume(const char *model, struct brdf_setting *settings, size_t count,
                            size_t max)
{
    for (size_t i = 0; i < sizeof assumptions / sizeof assumptions[0] && count < max; ++i) {
        const struct assumption *assumption = &assumptions[i];
        int applies = strcmp(assumption->model, model) == 0;
        for (int k = 0; k < UNLESS_MAX && assumption->unless[k]; ++k) {
            applies = applies && !is_given(settings, count, assumption->unless[k]);
        }
        if (applies) {
            settings[count++] = brdf_setting_text(assumption->name, assumption->value);
        }
    }
    return count;
}
