/*
 * choices.h - which choices of the models are the same in a whole program: here, none are known.
 *
 * A program that is put together for certain materials replaces this file, as it does models.h
 * (source.h), and defines for each model two constants: BRDF_NAME_CHOSEN, the choices as a material
 * has them, 4 bits each; and BRDF_NAME_KNOWN, all bits of the choices that are the same in all of
 * the program's materials. Then the compiler drops options that nobody chose where they stand,
 * instead of taking them along through every function that the model is inlined into.
 */
#ifndef BRDF_CHOICES_H
#define BRDF_CHOICES_H

/* A statement: puts the choices that are known into the parameters `p` of a model. Dispatch says it
   for every model; one whose options are long may say it first in its functions as well. */
#define BRDF_KNOWN(NAME, p)

#endif
