/*
 * many.c - evaluation over arrays: one loop for each model, in which the model is a constant.
 *
 * The loops are plain C over the same functions, so they give the same bits. `restrict` tells that
 * results do not overlap inputs; small models become SIMD code that way, the larger ones stay
 * scalar (for those OpenCL is the fast way).
 */
#include "bsdf.h"

#include "brdf/surface.h"

#ifdef __GNUC__
#define ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define ALWAYS_INLINE inline
#endif

static ALWAYS_INLINE void eval_loop(unsigned model, const struct brdf_bsdf *bsdf, size_t count,
                                    struct brdf_vectors wo, struct brdf_vectors wi,
                                    struct brdf_colors f)
{
    const brdf_parameters p = bsdf->parameters;
    const unsigned flags = bsdf->material.flags;
    const float *table = bsdf->table;
    float *restrict r = f.r, *restrict g = f.g, *restrict b = f.b;
    for (size_t i = 0; i < count; ++i) {
        brdf_rgb value =
            brdf_surface_eval(model, flags, p, brdf_vec3_make(wo.x[i], wo.y[i], wo.z[i]),
                              brdf_vec3_make(wi.x[i], wi.y[i], wi.z[i]), table);
        r[i] = value.r;
        g[i] = value.g;
        b[i] = value.b;
    }
}

static ALWAYS_INLINE void pdf_loop(unsigned model, const struct brdf_bsdf *bsdf, size_t count,
                                   struct brdf_vectors wo, struct brdf_vectors wi, float *out)
{
    const brdf_parameters p = bsdf->parameters;
    const unsigned flags = bsdf->material.flags;
    const float *table = bsdf->table;
    float *restrict pdf = out;
    for (size_t i = 0; i < count; ++i) {
        pdf[i] = brdf_surface_pdf(model, flags, p, brdf_vec3_make(wo.x[i], wo.y[i], wo.z[i]),
                                  brdf_vec3_make(wi.x[i], wi.y[i], wi.z[i]), table);
    }
}

static ALWAYS_INLINE void sample_loop(unsigned model, const struct brdf_bsdf *bsdf, size_t count,
                                      struct brdf_vectors wo, struct brdf_vectors u,
                                      struct brdf_samples out)
{
    const brdf_parameters p = bsdf->parameters;
    const unsigned flags = bsdf->material.flags;
    const float *table = bsdf->table;
    float *restrict x = out.x, *restrict y = out.y, *restrict z = out.z;
    float *restrict r = out.weight.r, *restrict g = out.weight.g, *restrict b = out.weight.b;
    float *restrict pdf = out.pdf, *restrict eta = out.eta;
    int *restrict delta = out.delta;
    for (size_t i = 0; i < count; ++i) {
        struct brdf_sample s =
            brdf_surface_sample(model, flags, p, brdf_vec3_make(wo.x[i], wo.y[i], wo.z[i]),
                                brdf_vec3_make(u.x[i], u.y[i], u.z[i]), table);
        x[i] = s.wi.x;
        y[i] = s.wi.y;
        z[i] = s.wi.z;
        r[i] = s.weight.r;
        g[i] = s.weight.g;
        b[i] = s.weight.b;
        pdf[i] = s.pdf;
        if (eta) {
            eta[i] = s.eta;
        }
        if (delta) {
            delta[i] = s.delta != 0;
        }
    }
}

void brdf_eval_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                    struct brdf_vectors wi, struct brdf_colors f)
{
    switch (bsdf->material.model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        eval_loop(BRDF_MODEL_##NAME, bsdf, count, wo, wi, f);                                      \
        break;
#include "brdf/models.h"
#undef BRDF_MODEL
    default:
        break;
    }
}

void brdf_pdf_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                   struct brdf_vectors wi, float *pdf)
{
    switch (bsdf->material.model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        pdf_loop(BRDF_MODEL_##NAME, bsdf, count, wo, wi, pdf);                                     \
        break;
#include "brdf/models.h"
#undef BRDF_MODEL
    default:
        break;
    }
}

void brdf_sample_many(const struct brdf_bsdf *bsdf, size_t count, struct brdf_vectors wo,
                      struct brdf_vectors u, struct brdf_samples samples)
{
    switch (bsdf->material.model) {
#define BRDF_MODEL(name, NAME, flags, summary, reference)                                          \
    case BRDF_MODEL_##NAME:                                                                        \
        sample_loop(BRDF_MODEL_##NAME, bsdf, count, wo, u, samples);                               \
        break;
#include "brdf/models.h"
#undef BRDF_MODEL
    default:
        break;
    }
}
