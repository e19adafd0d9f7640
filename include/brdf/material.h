/*
 * material.h - a bsdf: one model with its parameters, checked once and then ready to be evaluated.
 *
 * A bsdf is made from a description, a model's name and its settings:
 *
 *   diffuse
 *   diffuse:reflectance=0.2/0.4/0.6,twosided
 *   roughconductor:material=Cu,alpha=0.2
 *
 *   number    0.2, -1, 1e-3; where the unit is "ior" also a dielectric by name (bk7, water, ...)
 *   colour    one number (gray), three separated by "/" or spaces, or #rrggbb (sRGB, made linear)
 *   option    one of the parameter's names: distribution=beckmann
 *   metal     a chemical symbol (substance.h), sets `eta` and `k`
 *   file      a path
 *   twosided  true (also if no value follows) or false: the side below looks like the side above
 *
 * A value with commas or outer spaces goes in double quotes, a quote inside them is written twice.
 * What is not set keeps the initial value that info.h tells. Nothing unknown is ignored.
 *
 * Directions: wo to the viewer, wi to the light, local frame with z = normal, both unit and
 * pointing away from the surface. A bsdf never changes after its creation, so any number of threads
 * may use one. The evaluating functions cannot fail and check nothing.
 */
#ifndef BRDF_MATERIAL_H
#define BRDF_MATERIAL_H

#include <stddef.h>

#include "sample.h"
#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

struct brdf_bsdf;
struct brdf_material; /* model.h */

/* One setting: a text as in a description, or, with a NULL text, one or three numbers. */
struct brdf_setting {
    const char *name;
    const char *value; /* colours may also be separated by commas here; no quotes */
    float number[3];   /* the value where `value` is NULL: linear Rec. 709 for a colour */
    int numbers;       /* 1 or 3 */
    int varies;        /* not 0: the value stands for others, as a texture has them, which go into
                          the parameters by brdf_parameters_set (model.h); tables must serve all */
};

static inline struct brdf_setting brdf_setting_text(const char *name, const char *value)
{
    struct brdf_setting setting = {name, value, {0.0f, 0.0f, 0.0f}, 0, 0};
    return setting;
}

static inline struct brdf_setting brdf_setting_real(const char *name, float x)
{
    struct brdf_setting setting = {name, NULL, {x, 0.0f, 0.0f}, 1, 0};
    return setting;
}

static inline struct brdf_setting brdf_setting_color(const char *name, float r, float g, float b)
{
    struct brdf_setting setting = {name, NULL, {r, g, b}, 3, 0};
    return setting;
}

/*
 * Make a bsdf from a description. On success *out is the caller's, to be given to
 * brdf_bsdf_destroy; on failure it is NULL and the error names the place in the description.
 * A parameter of kind FILE is read now, and never again.
 */
BRDF_API brdf_status brdf_bsdf_create(const char *description, struct brdf_bsdf **out,
                                      struct brdf_error *error);

/* The same from a model's name and `count` settings, which are not kept. */
BRDF_API brdf_status brdf_bsdf_create_from(const char *model, const struct brdf_setting *settings,
                                           size_t count, struct brdf_bsdf **out,
                                           struct brdf_error *error);

/* Free the bsdf and its table; NULL is fine. */
BRDF_API void brdf_bsdf_destroy(struct brdf_bsdf *bsdf);

/*
 * Write a description with every value, from which brdf_bsdf_create makes the same bits again (a
 * metal becomes its eta and k). Like snprintf: at most `size` bytes with the terminator, and the
 * length that the whole description has is returned.
 */
BRDF_API size_t brdf_bsdf_describe(const struct brdf_bsdf *bsdf, char *text, size_t size);

/* f(wo, wi) [1/sr], without the cosine; 0 for a delta lobe. */
BRDF_API brdf_rgb brdf_eval(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 wi);

/* The density [1/sr] with which brdf_sample returns wi; 0 for a delta lobe. */
BRDF_API float brdf_pdf(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 wi);

/* A direction for the uniform numbers u in [0, 1)^3: x, y place it, z chooses among lobes. */
BRDF_API struct brdf_sample brdf_sample(const struct brdf_bsdf *bsdf, brdf_vec3 wo, brdf_vec3 u);

/* Arrays to read: directions, or the uniform numbers of sampling. */
struct brdf_vectors {
    const float *x;
    const float *y;
    const float *z;
};

/* Arrays to write. */
struct brdf_colors {
    float *r;
    float *g;
    float *b;
};

/* Arrays to write, the members of struct brdf_sample; `eta` and `delta` may be NULL. */
struct brdf_samples {
    float *x; /* wi */
    float *y;
    float *z;
    struct brdf_colors weight;
    float *pdf;
    float *eta;
    int *delta; /* 1 or 0 */
};

/*
 * The same functions over arrays of `count` elements each, chosen once a call and not once an
 * element; the results have the same bits. What is written must not overlap what is read.
 */
BRDF_API void brdf_eval_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                             struct brdf_vectors wi, struct brdf_colors f);
BRDF_API void brdf_pdf_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                            struct brdf_vectors wi, float *pdf);
BRDF_API void brdf_sample_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                               struct brdf_vectors u, struct brdf_samples samples);

/*
 * For renderers: the 128 bytes that a device gets (model.h), flags filled in from the model and
 * BRDF_TWOSIDED where set; `table` is 0. Valid as long as the bsdf.
 */
BRDF_API const struct brdf_material *brdf_bsdf_material(const struct brdf_bsdf *bsdf);

/*
 * The table of the material, read from a file or computed; *words 4-byte words of it, NULL and 0 if
 * it has none. Valid as long as the bsdf. In memory shared by several materials it begins at word
 * material.table.
 */
BRDF_API const float *brdf_bsdf_table(const struct brdf_bsdf *bsdf, size_t *words);

#ifdef __cplusplus
}
#endif

#endif
