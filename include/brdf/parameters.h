/*
 * parameters.h - how a model lists its parameters, once, and what one line of the list becomes.
 *
 * A model lists its parameters as a macro over P, one line each, every CHOICE before the rest:
 *
 *   P(kind, name, initial, low, high, unit, meaning)
 *
 *   CHOICE  one of several named options, the same for all lanes; `unit` names them, as in
 *           "ggx|beckmann", and initial is the option's number. In the struct: int.
 *   DECIDED  as CHOICE, after the last of them, but libbrdf alone decides, by the parameters of a
 *           material: nobody can set it or sees it.
 *   REAL    one number in [low, high], `unit` as a string ("1" if it has none; "ior" also accepts
 *           the name of a dielectric). In the struct: brdf_real.
 *   COLOR   linear Rec. 709, each channel in [low, high]. In the struct: brdf_rgb.
 *   ALIAS   host only: a name that sets several others, named in `unit`: "alpha_u|alpha_v".
 *   METAL   host only: the name of a metal that sets the colours `eta` and `k`.
 *   FILE    host only: the path of a measurement, read into the model's table.
 *
 * From the list come the struct, the reflection table, the parser, validation, docs and tests.
 */
#ifndef BRDF_PARAMETERS_H
#define BRDF_PARAMETERS_H

#include "choices.h"
#include "vec.h"

/* The members of the parameter struct. */
#define BRDF_FIELD(kind, name, initial, low, high, unit, meaning) BRDF_FIELD_##kind(name)
#define BRDF_FIELD_CHOICE(name) int name;
#define BRDF_FIELD_DECIDED(name) int name;
#define BRDF_FIELD_REAL(name) brdf_real name;
#define BRDF_FIELD_COLOR(name) brdf_rgb name;
#define BRDF_FIELD_ALIAS(name)
#define BRDF_FIELD_METAL(name)
#define BRDF_FIELD_FILE(name)

/* "0 LIST(BRDF_PLUS_CHOICE)" counts the choices, "0 LIST(BRDF_PLUS_WORDS)" the 4-byte values. */
#define BRDF_PLUS_CHOICE(kind, name, initial, low, high, unit, meaning) BRDF_PLUS_CHOICE_##kind
#define BRDF_PLUS_CHOICE_CHOICE +1
#define BRDF_PLUS_CHOICE_DECIDED +1
#define BRDF_PLUS_CHOICE_REAL
#define BRDF_PLUS_CHOICE_COLOR
#define BRDF_PLUS_CHOICE_ALIAS
#define BRDF_PLUS_CHOICE_METAL
#define BRDF_PLUS_CHOICE_FILE

#define BRDF_PLUS_WORDS(kind, name, initial, low, high, unit, meaning) BRDF_PLUS_WORDS_##kind
#define BRDF_PLUS_WORDS_CHOICE
#define BRDF_PLUS_WORDS_DECIDED
#define BRDF_PLUS_WORDS_REAL +1
#define BRDF_PLUS_WORDS_COLOR +3
#define BRDF_PLUS_WORDS_ALIAS
#define BRDF_PLUS_WORDS_METAL
#define BRDF_PLUS_WORDS_FILE

/*
 * "LIST(BRDF_LOAD)" fills the struct `p` from the bits `choices` and from `word`, one value for all
 * lanes. Member by member, not in a loop over them: compilers keep a struct in registers, and know
 * its choices to be the constants that they are, only while nothing indexes into it.
 */
#define BRDF_LOAD(kind, name, initial, low, high, unit, meaning) BRDF_LOAD_##kind(name)
#define BRDF_LOAD_CHOICE(name)                                                                     \
    p.name = (int)(choices & 15u);                                                                 \
    choices >>= 4;
#define BRDF_LOAD_DECIDED(name) BRDF_LOAD_CHOICE(name)
#define BRDF_LOAD_REAL(name) p.name = *word++;
#define BRDF_LOAD_COLOR(name)                                                                      \
    p.name = brdf_rgb_make(word[0], word[1], word[2]);                                             \
    word += 3;
#define BRDF_LOAD_ALIAS(name)
#define BRDF_LOAD_METAL(name)
#define BRDF_LOAD_FILE(name)

/* "LIST(BRDF_SET)" puts `value` into the member of `p` that is word number `at`. */
#define BRDF_SET(kind, name, initial, low, high, unit, meaning) BRDF_SET_##kind(name)
#define BRDF_SET_CHOICE(name)
#define BRDF_SET_DECIDED(name)
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

/* "LIST(BRDF_KNOW)" replaces the choices of `p` that have bits in `known` by those of `chosen`
   (choices.h). */
#define BRDF_KNOW(kind, name, initial, low, high, unit, meaning) BRDF_KNOW_##kind(name)
#define BRDF_KNOW_CHOICE(name)                                                                     \
    p.name = known & 15u ? (int)(chosen & 15u) : p.name;                                           \
    known >>= 4;                                                                                   \
    chosen >>= 4;
#define BRDF_KNOW_DECIDED(name) BRDF_KNOW_CHOICE(name)
#define BRDF_KNOW_REAL(name)
#define BRDF_KNOW_COLOR(name)
#define BRDF_KNOW_ALIAS(name)
#define BRDF_KNOW_METAL(name)
#define BRDF_KNOW_FILE(name)

/* What a model is, as bits; each model's announcement line at the end of its file states them. */
#define BRDF_REFLECTION 1u /* scatters to wo's side */
#define BRDF_TRANSMISSION                                                                          \
    2u                      /* scatters to the other side; a model with a REAL `spec_trans` only   \
                               where that is above 0, and may be mirrored (twosided) where not */
#define BRDF_DELTA 4u       /* has delta lobes only: eval and pdf are 0 */
#define BRDF_ANISOTROPIC 8u /* can depend on the azimuth of wo */
#define BRDF_TABULATED 16u  /* reads a table made from a FILE */
#define BRDF_COMPUTED 64u   /* has options for which libbrdf computes its table */
#define BRDF_RECIPROCAL 32u /* f(wo, wi) = f(wi, wo), for transmission f / eta^2 */

#endif
