/*
 * model.h - any model by its tag: what the list of models generates.
 *
 * A material is 128 bytes of 4-byte scalars, the same on host, device and in a file. Its parameters
 * unpack into the model's own struct, whose members are its choices (int) and then its values
 * (brdf_real, one or three each) in the order of the list; that order is the whole format.
 *
 * Where the tag and the choices are constants, the switches below fold away and what is left is a
 * direct call of the model: kernels are specialised that way.
 */
#ifndef BRDF_MODEL_H
#define BRDF_MODEL_H

#include "frame.h"
#include "parameters.h"
#include "sample.h"

/* First reading of the list: the models themselves, and their tags in the order of the list. */
#include "models.h"

enum brdf_model_tag {
#define BRDF_MODEL(name, NAME, flags, summary, reference) BRDF_MODEL_##NAME,
#include "models.h"
#undef BRDF_MODEL
    BRDF_MODEL_COUNT
};

/* How many choices and values each model has. */
enum brdf_model_size {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    BRDF_##NAME##_CHOICES = 0 BRDF_##NAME##_PARAMETERS(BRDF_PLUS_CHOICE),                          \
    BRDF_##NAME##_WORDS = 0 BRDF_##NAME##_PARAMETERS(BRDF_PLUS_WORDS),
#include "models.h"
#undef BRDF_MODEL
    BRDF_MATERIAL_WORDS = 28
};

/* Material flags; the low 16 bits are the model's own (parameters.h). */
#define BRDF_TWOSIDED 0x10000u /* the side below the surface looks like the side above */

struct brdf_material {
    unsigned model;                  /* enum brdf_model_tag */
    unsigned flags;                  /* BRDF_REFLECTION ..., BRDF_TWOSIDED */
    unsigned choices;                /* 4 bits a choice, the first lowest */
    unsigned table;                  /* first word of its table, if tabulated */
    float word[BRDF_MATERIAL_WORDS]; /* values in the order of the list */
};

union brdf_parameters {
    brdf_real first;
#define BRDF_MODEL(name, NAME, flags, summary, reference) struct brdf_##name name;
#include "models.h"
#undef BRDF_MODEL
};
typedef union brdf_parameters brdf_parameters;

/*
 * One value for all lanes from each word, one int from each 4 bits: a model's struct, filled.
 * Member by member, not in a loop over them: compilers keep a struct in registers, and know its
 * choices to be the constants that they are, only while nothing indexes into it.
 */
#define BRDF_LOAD(kind, name, initial, low, high, unit, meaning) BRDF_LOAD_##kind(name)
#define BRDF_LOAD_CHOICE(name)                                                                     \
    p.name = (int)(choices & 15u);                                                                 \
    choices >>= 4;
#define BRDF_LOAD_REAL(name) p.name = *word++;
#define BRDF_LOAD_COLOR(name)                                                                      \
    p.name = brdf_rgb_make(word[0], word[1], word[2]);                                             \
    word += 3;
#define BRDF_LOAD_ALIAS(name)
#define BRDF_LOAD_METAL(name)
#define BRDF_LOAD_FILE(name)

/* Replace the value of word number `at`. */
#define BRDF_SET(kind, name, initial, low, high, unit, meaning) BRDF_SET_##kind(name)
#define BRDF_SET_CHOICE(name)
#define BRDF_SET_REAL(name)                                                                        \
    p.name = at == 0 ? value : p.name;                                                             \
    at -= 1;
#define BRDF_SET_COLOR(name)                                                                       \
    p.name.r = at == 0 ? value : p.name.r;                                                         \
    p.name.g = at == 1 ? value : p.name.g;                                                         \
    p.name.b = at == 2 ? value : p.name.b;                                                         \
    at -= 3;
#define BRDF_SET_ALIAS(name)
#define BRDF_SET_METAL(name)
#define BRDF_SET_FILE(name)

/* Both of them for each model. One without parameters uses none of the arguments. */
#define BRDF_MODEL(model, NAME, flags, summary, reference)                                         \
    static inline struct brdf_##model brdf_##model##_load(unsigned choices,                        \
                                                          BRDF_GLOBAL const float *word)           \
    {                                                                                              \
        struct brdf_##model p;                                                                     \
        (void)choices;                                                                             \
        (void)word;                                                                                \
        BRDF_##NAME##_PARAMETERS(BRDF_LOAD) return p;                                              \
    }                                                                                              \
    static inline struct brdf_##model brdf_##model##_set(struct brdf_##model p, int at,            \
                                                         brdf_real value)                          \
    {                                                                                              \
        (void)at;                                                                                  \
        (void)value;                                                                               \
        BRDF_##NAME##_PARAMETERS(BRDF_SET) return p;                                               \
    }
#include "models.h"
#undef BRDF_MODEL

static inline brdf_parameters brdf_parameters_load(unsigned model, unsigned choices,
                                                   BRDF_GLOBAL const float *word)
{
    brdf_parameters p = {0.0f}; /* one model's members do not fill the union */
    switch (model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        p.name = brdf_##name##_load(choices, word);                                                \
        break;
#include "models.h"
#undef BRDF_MODEL
    default:
        break;
    }
    return p;
}

/* Replace what came from one word by a value for each lane, which must be in the parameter's range:
   how a parameter varies over a surface. */
static inline brdf_parameters brdf_parameters_set(brdf_parameters p, unsigned model, int word,
                                                  brdf_real value)
{
    switch (model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        p.name = brdf_##name##_set(p.name, word, value);                                           \
        break;
#include "models.h"
#undef BRDF_MODEL
    default:
        break;
    }
    return p;
}

/* f(wo, wi) [1/sr], without the cosine. */
static inline brdf_rgb brdf_model_eval(unsigned model, brdf_parameters p, brdf_vec3 wo,
                                       brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    switch (model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        return brdf_##name##_eval(p.name, wo, wi, table);
#include "models.h"
#undef BRDF_MODEL
    default:
        return brdf_gray(0.0f);
    }
}

/* Density [1/sr] with which sample() returns wi. */
static inline brdf_real brdf_model_pdf(unsigned model, brdf_parameters p, brdf_vec3 wo,
                                       brdf_vec3 wi, BRDF_GLOBAL const float *table)
{
    switch (model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        return brdf_##name##_pdf(p.name, wo, wi, table);
#include "models.h"
#undef BRDF_MODEL
    default:
        return 0.0f;
    }
}

/* A direction wi for the uniform numbers u in [0, 1)^3: x, y place it, z chooses among lobes. */
static inline struct brdf_sample brdf_model_sample(unsigned model, brdf_parameters p, brdf_vec3 wo,
                                                   brdf_vec3 u, BRDF_GLOBAL const float *table)
{
    switch (model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        return brdf_##name##_sample(p.name, wo, u, table);
#include "models.h"
#undef BRDF_MODEL
    default:
        return brdf_sample_make(wo, brdf_gray(0.0f), 0.0f);
    }
}

#endif
