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
    const char *where_ggx; /* the value where the file says distribution = ggx; NULL: the same */
};

static const struct assumption assumptions[] = {
    /* Of Beckmann's masking Mitsuba has Walter's approximation. */
    {"roughconductor", "masking", "rational", {"masking", NULL, NULL}, "separable"},
    {"roughconductor", "material", "none", {"material", "eta", "k"}, NULL},
    {"conductor", "material", "none", {"material", "eta", "k"}, NULL},
    {"roughdielectric", "masking", "separable", {"masking", NULL, NULL}, NULL},
};

static const struct brdf_setting *find(const struct brdf_setting *settings, size_t count,
                                       const char *name)
{
    for (size_t i = 0; i < count; ++i) {
        if (strcmp(settings[i].name, name) == 0) {
            return &settings[i];
        }
    }
    return NULL;
}

static int is_ggx(const struct brdf_setting *settings, size_t count)
{
    const struct brdf_setting *distribution = find(settings, count, "distribution");
    return distribution && distribution->value && strcmp(distribution->value, "ggx") == 0;
}

size_t scene_mitsuba_assume(const char *model, struct brdf_setting *settings, size_t count,
                            size_t max)
{
    for (size_t i = 0; i < sizeof assumptions / sizeof assumptions[0] && count < max; ++i) {
        const struct assumption *assumption = &assumptions[i];
        int applies = strcmp(assumption->model, model) == 0;
        for (int k = 0; k < UNLESS_MAX && assumption->unless[k]; ++k) {
            applies = applies && !find(settings, count, assumption->unless[k]);
        }
        if (applies) {
            int other = assumption->where_ggx && is_ggx(settings, count);
            settings[count++] = brdf_setting_text(assumption->name, other ? assumption->where_ggx
                                                                          : assumption->value);
        }
    }
    return count;
}
