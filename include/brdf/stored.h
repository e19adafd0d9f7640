/*
 * stored.h - a material as it is stored: 128 bytes of 4-byte scalars, the same on host, device and
 * in a file. What does not evaluate materials needs no more than this, and none of the models.
 */
#ifndef BRDF_STORED_H
#define BRDF_STORED_H

#define BRDF_MATERIAL_WORDS 28

/* Material flags; the low 16 bits are the model's own (parameters.h). */
#define BRDF_TWOSIDED 0x10000u /* the side below the surface looks like the side above */

struct brdf_material {
    unsigned model;                  /* enum brdf_model_tag (model.h) */
    unsigned flags;                  /* BRDF_REFLECTION ..., BRDF_TWOSIDED */
    unsigned choices;                /* 4 bits a choice, the first lowest */
    unsigned table;                  /* first word of its table, if tabulated */
    float word[BRDF_MATERIAL_WORDS]; /* values in the order of the model's list */
};

#endif
