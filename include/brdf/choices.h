/*
 * choices.h - which choices of the models are the same in a whole program: here, none are known.
 *
 * A program that is put together for certain materials replaces this file, as it does models.h
 * (source.h), by the same constants with other values: 4 bits a choice, the first lowest, in KNOWN
 * all four bits of each choice that has one value in all of the program's materials, in CHOSEN
 * those values. The compiler then meets options that nobody chose in the models alone, and not
 * again in every function that a model is inlined into.
 */
#ifndef BRDF_CHOICES_H
#define BRDF_CHOICES_H

#include "models.h"

enum brdf_model_choices {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    BRDF_##NAME##_KNOWN = 0, BRDF_##NAME##_CHOSEN = 0,
#include "models.h"
#undef BRDF_MODEL
};

#endif
