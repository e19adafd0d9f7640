/*
 * model.h - any model by its tag: what the list of models generates.
 *
 * The parameters of a material (stored.h) unpack into the model's own struct, whose members are its
 * choices (int) and then its values (brdf_real, one or three each) in the order of the list; that
 * order is the whole format.
 *
 * Where the tag and the choices are constants, the switches below fold away and what is left is a
 * direct call of the model: kernels are specialised that way. What choices.h knows of the choices
 * is put in before the call, so that the folding is done once and not by each kernel.
 */
#ifndef BRDF_MODEL_H
#define BRDF_MODEL_H

#include "choices.h"
#include "frame.h"
#include "parameters.h"
#include "sample.h"
#include "stored.h"

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
};

union brdf_parameters {
    brdf_real first;
#define BRDF_MODEL(name, NAME, flags, summary, reference) struct brdf_##name name;
#include "models.h"
#undef BRDF_MODEL
};
typedef union brdf_parameters brdf_parameters;

/*
 * Of each model: its struct from a material, with one value of a parameter replaced, and with what
 * choices.h knows put in. One without parameters uses none of the arguments.
 */
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    static inline struct brdf_##name brdf_##name##_load(unsigned choices,                          \
                                                        BRDF_GLOBAL const float *word)             \
    {                                                                                              \
        struct brdf_##name p;                                                                      \
        (void)choices;                                                                             \
        (void)word;                                                                                \
        BRDF_##NAME##_PARAMETERS(BRDF_LOAD) return p;                                              \
    }                                                                                              \
    static inline struct brdf_##name brdf_##name##_set(struct brdf_##name p, int at,               \
                                                       brdf_real value)                            \
    {                                                                                              \
        (void)at;                                                                                  \
        (void)value;                                                                               \
        BRDF_##NAME##_PARAMETERS(BRDF_SET) return p;                                               \
    }                                                                                              \
    static inline struct brdf_##name brdf_##name##_known(struct brdf_##name p)                     \
    {                                                                                              \
        BRDF_KNOWN(NAME, p);                                                                       \
        return p;                                                                                  \
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
        return brdf_##name##_eval(brdf_##name##_known(p.name), wo, wi, table);
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
        return brdf_##name##_pdf(brdf_##name##_known(p.name), wo, wi, table);
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
        return brdf_##name##_sample(brdf_##name##_known(p.name), wo, u, table);
#include "models.h"
#undef BRDF_MODEL
    default:
        return brdf_sample_make(wo, brdf_gray(0.0f), 0.0f);
    }
}

#endif
