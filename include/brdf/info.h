/*
 * info.h - what can be asked of the models: their names and, of each parameter, all there is to
 * know.
 *
 * Everything here comes from models.h and the list in each model's file. Nothing fails, nothing is
 * to be freed.
 */
#ifndef BRDF_INFO_H
#define BRDF_INFO_H

#include <stddef.h>

#include "parameters.h"
#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The kinds of parameters.h. */
enum brdf_parameter_kind {
    BRDF_KIND_CHOICE,
    BRDF_KIND_REAL,
    BRDF_KIND_COLOR,
    BRDF_KIND_ALIAS,
    BRDF_KIND_METAL,
    BRDF_KIND_FILE
};

struct brdf_parameter_info {
    int kind;                 /* enum brdf_parameter_kind */
    const char *name;         /* as in a description */
    const char *initial_text; /* METAL: the metal if neither it nor eta and k are set; else NULL */
    float initial; /* REAL, COLOR (each channel): the value; CHOICE: the option's number */
    float low;     /* REAL, COLOR: least and greatest value, both allowed; else 0 */
    float high;
    const char *unit;    /* REAL, COLOR: "1", "ior", ...; CHOICE: the options, ALIAS: the names that
                            it sets, each separated by "|" */
    const char *meaning; /* one line */
};

struct brdf_model_info {
    int tag;               /* enum brdf_model_tag of model.h */
    const char *name;      /* as in a description */
    unsigned flags;        /* BRDF_REFLECTION ... of parameters.h */
    const char *summary;   /* a few words */
    const char *reference; /* authors and year */
    size_t parameter_count;
    const struct brdf_parameter_info *parameters;
};

/* How many models there are; their tags are 0 ... count - 1. */
BRDF_API int brdf_model_count(void);

/* The model of a tag; NULL if there is none. */
BRDF_API const struct brdf_model_info *brdf_model_info(int tag);

/* The model of a name, its own or an alias; NULL if there is none. */
BRDF_API const struct brdf_model_info *brdf_model_find(const char *name);

/* Alias `number`, from 0, of a model: what other programs call it. NULL if it has no more. */
BRDF_API const char *brdf_model_alias(const struct brdf_model_info *model, int number);

/* The name or alias nearest to one that is not known; NULL if none is near enough to be meant. */
BRDF_API const char *brdf_model_nearest(const char *name);

/* The same for the parameters of a model. */
BRDF_API const struct brdf_parameter_info *brdf_parameter_find(const struct brdf_model_info *model,
                                                               const char *name);
BRDF_API const char *brdf_parameter_nearest(const struct brdf_model_info *model, const char *name);

/*
 * Where a parameter of the model lies in struct brdf_material: for REAL and COLOR the number of its
 * first word, for CHOICE the number of its 4 bits; -1 for the other kinds.
 */
BRDF_API int brdf_parameter_place(const struct brdf_model_info *model,
                                  const struct brdf_parameter_info *parameter);

/*
 * The item of a list such as "ggx|beckmann": option `number` of a CHOICE, or a name that an ALIAS
 * sets. Writes at most `size` bytes with the terminator; 0 if there is no such item, else 1.
 */
BRDF_API int brdf_parameter_item(const struct brdf_parameter_info *parameter, int number,
                                 char *item, size_t size);

/*
 * Why the options that `choices` holds (model.h) cannot go together, as a sentence written to
 * `text`, at most `size` bytes with the terminator; NULL if they can.
 */
BRDF_API const char *brdf_choices_refused(const struct brdf_model_info *model, unsigned choices,
                                          char *text, size_t size);

/*
 * Why a REAL or a channel of a COLOR cannot have a value, as a sentence written to `text`, at most
 * `size` bytes with the terminator; NULL if it can. `name` is what the parameter was called: its
 * own name or that of an alias.
 */
BRDF_API const char *brdf_value_refused(const struct brdf_parameter_info *parameter,
                                        const char *name, float value, char *text, size_t size);

/* The kind in small letters: "choice", "real", ...; "unknown" if it is none of the above. */
BRDF_API const char *brdf_kind_name(int kind);

/*
 * The one of `count` names that differs least from `name` (insertions, deletions, replacements and
 * exchanges of neighbours, small and large letters alike); NULL if none is near enough to be meant.
 */
BRDF_API const char *brdf_name_nearest(const char *name, const char *const *names, size_t count);

#ifdef __cplusplus
}
#endif

#endif
