/*
 * draft.h - settings on their way into a bsdf (internal to settings.c and values.c).
 */
#ifndef BRDF_DRAFT_H
#define BRDF_DRAFT_H

#include "brdf/substance.h"
#include "bsdf.h"

/* The settings on their way into the bsdf. */
struct brdf_draft {
    struct brdf_bsdf *bsdf;
    const struct brdf_model_info *model;
    const struct brdf_setting *setting; /* the one at work; NULL before and after */
    size_t place;                       /* its byte in the description */
    const char *description;            /* NULL if there is none */
    const char **set_by;                /* for each parameter the name of what set it, or NULL */
    int twosided_set;
    struct brdf_error *error;
};

/* Fail with a sentence that begins with the place of the setting at work. */
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
brdf_status
brdf_draft_refuse(const struct brdf_draft *d, brdf_status status, const char *format, ...);

/* "; did you mean "a"?" if there is a nearest name, else "; known: a, b, c". */
void brdf_draft_suggest(char *text, size_t size, const char *nearest, const char *known);

/* Append to a list of names: "a, b". */
void brdf_draft_list(char *list, size_t size, const char *name);

/* Say that the parameter is set, by `by` and by nothing else. */
brdf_status brdf_draft_claim(const struct brdf_draft *d, const struct brdf_parameter_info *p,
                             const char *by);

/* Set eta and k, claimed by `by`. */
brdf_status brdf_draft_put_metal(const struct brdf_draft *d, const struct brdf_metal *metal,
                                 const char *by);

/* Set a parameter of any kind but ALIAS from the setting at work. */
brdf_status brdf_draft_set(const struct brdf_draft *d, const struct brdf_parameter_info *p);

#endif
