/* info.c - what models.h and the lists in the model files say, as tables. */
#include "brdf/info.h"
#include "brdf/model.h"

#include <stdio.h>
#include <string.h>

/* One line of a model's list as a row of its table. What a kind has no use for is left out, and so
   is what nobody can set. */
#define INFO(kind, name, initial, low, high, unit, meaning)                                        \
    INFO_##kind(kind, name, initial, low, high, unit, meaning)
#define INFO_ROW(kind, name, initial_text, initial, low, high, unit, meaning)                      \
    {BRDF_KIND_##kind, #name, initial_text, initial, low, high, unit, meaning},
#define INFO_CHOICE(kind, name, initial, low, high, unit, meaning)                                 \
    INFO_ROW(kind, name, NULL, initial, 0.0f, 0.0f, unit, meaning)
#define INFO_REAL(kind, name, initial, low, high, unit, meaning)                                   \
    INFO_ROW(kind, name, NULL, initial, low, high, unit, meaning)
#define INFO_COLOR(kind, name, initial, low, high, unit, meaning)                                  \
    INFO_ROW(kind, name, NULL, initial, low, high, unit, meaning)
#define INFO_ALIAS(kind, name, initial, low, high, unit, meaning)                                  \
    INFO_ROW(kind, name, NULL, 0.0f, 0.0f, 0.0f, unit, meaning)
#define INFO_METAL(kind, name, initial, low, high, unit, meaning)                                  \
    INFO_ROW(kind, name, initial, 0.0f, 0.0f, 0.0f, unit, meaning)
#define INFO_FILE(kind, name, initial, low, high, unit, meaning)                                   \
    INFO_ROW(kind, name, NULL, 0.0f, 0.0f, 0.0f, unit, meaning)
#define INFO_DECIDED(kind, name, initial, low, high, unit, meaning)

/* The row of zeros at the end lets a model have no parameters at all. */
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    static const struct brdf_parameter_info parameters_of_##name[] = {                             \
        BRDF_##NAME##_PARAMETERS(INFO){0, NULL, NULL, 0.0f, 0.0f, 0.0f, NULL, NULL}};
#include "brdf/models.h"
#undef BRDF_MODEL

static const struct brdf_model_info models[] = {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    {BRDF_MODEL_##NAME,                                                                            \
     #name,                                                                                        \
     (flags),                                                                                      \
     summary,                                                                                      \
     reference,                                                                                    \
     sizeof parameters_of_##name / sizeof parameters_of_##name[0] - 1,                             \
     parameters_of_##name},
#include "brdf/models.h"
#undef BRDF_MODEL
};

static const struct alias {
    const char *name;
    int tag;
} aliases[] = {
#define BRDF_MODEL_ALIAS(alias, NAME) {#alias, BRDF_MODEL_##NAME},
#include "aliases.h"
#undef BRDF_MODEL_ALIAS
};

enum { ALIASES = sizeof aliases / sizeof aliases[0] };

int brdf_model_count(void)
{
    return BRDF_MODEL_COUNT;
}

const struct brdf_model_info *brdf_model_info(int tag)
{
    return tag >= 0 && tag < BRDF_MODEL_COUNT ? &models[tag] : NULL;
}

const struct brdf_model_info *brdf_model_find(const char *name)
{
    for (int tag = 0; tag < BRDF_MODEL_COUNT; ++tag) {
        if (strcmp(models[tag].name, name) == 0) {
            return &models[tag];
        }
    }
    for (int i = 0; i < ALIASES; ++i) {
        if (strcmp(aliases[i].name, name) == 0) {
            return &models[aliases[i].tag];
        }
    }
    return NULL;
}

const char *brdf_model_alias(const struct brdf_model_info *model, int number)
{
    for (int i = 0; i < ALIASES; ++i) {
        if (aliases[i].tag == model->tag && number-- == 0) {
            return aliases[i].name;
        }
    }
    return NULL;
}

const char *brdf_model_nearest(const char *name)
{
    const char *names[BRDF_MODEL_COUNT + ALIASES];
    for (int tag = 0; tag < BRDF_MODEL_COUNT; ++tag) {
        names[tag] = models[tag].name;
    }
    for (int i = 0; i < ALIASES; ++i) {
        names[BRDF_MODEL_COUNT + i] = aliases[i].name;
    }
    return brdf_name_nearest(name, names, BRDF_MODEL_COUNT + ALIASES);
}

const struct brdf_parameter_info *brdf_parameter_find(const struct brdf_model_info *model,
                                                      const char *name)
{
    for (size_t i = 0; i < model->parameter_count; ++i) {
        if (strcmp(model->parameters[i].name, name) == 0) {
            return &model->parameters[i];
        }
    }
    return NULL;
}

const char *brdf_parameter_nearest(const struct brdf_model_info *model, const char *name)
{
    const char *names[64]; /* at most 8 choices, 28 words, and a few that only the host knows */
    size_t count = 0;
    while (count < model->parameter_count && count < sizeof names / sizeof names[0]) {
        names[count] = model->parameters[count].name;
        ++count;
    }
    return brdf_name_nearest(name, names, count);
}

int brdf_parameter_place(const struct brdf_model_info *model,
                         const struct brdf_parameter_info *parameter)
{
    int choice = parameter->kind == BRDF_KIND_CHOICE;
    if (!choice && parameter->kind != BRDF_KIND_REAL && parameter->kind != BRDF_KIND_COLOR) {
        return -1;
    }
    int place = 0;
    for (const struct brdf_parameter_info *p = model->parameters; p != parameter; ++p) {
        if (choice) {
            place += p->kind == BRDF_KIND_CHOICE;
        } else {
            place += p->kind == BRDF_KIND_REAL ? 1 : p->kind == BRDF_KIND_COLOR ? 3 : 0;
        }
    }
    return place;
}

int brdf_parameter_item(const struct brdf_parameter_info *parameter, int number, char *item,
                        size_t size)
{
    int list = parameter->kind == BRDF_KIND_CHOICE || parameter->kind == BRDF_KIND_ALIAS;
    const char *start = parameter->unit;
    for (int i = 0; list && start && i < number; ++i) {
        start = strchr(start, '|');
        start = start ? start + 1 : NULL;
    }
    if (!list || !start || number < 0) {
        return 0;
    }
    snprintf(item, size, "%.*s", (int)strcspn(start, "|"), start);
    return 1;
}

const char *brdf_kind_name(int kind)
{
    static const char *const names[] = {"choice", "real", "color", "alias", "metal", "file"};
    return kind >= 0 && kind <= BRDF_KIND_FILE ? names[kind] : "unknown";
}
