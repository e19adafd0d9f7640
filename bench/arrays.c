/* arrays.c - what is evaluated in bulk, and whether both backends agree. */
#include "arrays.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"

/* Planes are some cache lines further apart than a power of two, as in libbrdfcl, for both sides.
 */
enum { PLANES = 9 + 2 * 13, BLOCK = 4096, APART = 96 };

static const struct kind {
    const char *name;
    int read, written; /* words */
} kinds[OPERATION_COUNT] = {
    {"sample", 6, 9}, {"eval", 6, 3}, {"pdf", 6, 1}, {"sample+eval+pdf", 6, 13}};

const char *operation_name(enum operation operation)
{
    return kinds[operation].name;
}

int operation_bytes(enum operation operation)
{
    return 4 * (kinds[operation].read + kinds[operation].written);
}

/* The planes of the memory, one after the other. */
static float *take(float **memory, size_t count)
{
    float *plane = *memory;
    *memory += count + APART;
    return plane;
}

static void take_results(struct arrays_out *out, float **memory, size_t count)
{
    for (int i = 0; i < 3; ++i) {
        out->f[i] = take(memory, count);
    }
    out->pdf = take(memory, count);
    for (int i = 0; i < 8; ++i) {
        out->sample[i] = take(memory, count);
    }
    out->delta = (int *)(void *)take(memory, count);
}

/* One direction in eight is below the surface. */
static void put_direction(float *const axes[3], size_t i, unsigned seed, uint64_t place)
{
    double z = (double)random_uniform(seed, place) * 8.0 / 7.0 - 1.0 / 7.0;
    double phi = (double)random_uniform(seed, place + 1) * 6.283185307179586;
    double r = sqrt(1.0 - z * z);
    axes[0][i] = (float)(r * cos(phi));
    axes[1][i] = (float)(r * sin(phi));
    axes[2][i] = (float)z;
}

brdf_status arrays_create(struct arrays *arrays, size_t count, unsigned seed,
                          struct brdf_error *error)
{
    memset(arrays, 0, sizeof *arrays);
    float *memory = malloc(PLANES * (count + APART) * sizeof(float));
    if (!memory) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu evaluations", count);
    }
    arrays->memory = memory;
    arrays->count = count;
    for (int i = 0; i < 3; ++i) {
        arrays->in.wo[i] = take(&memory, count);
        arrays->in.wi[i] = take(&memory, count);
        arrays->in.u[i] = take(&memory, count);
    }
    take_results(&arrays->c, &memory, count);
    take_results(&arrays->opencl, &memory, count);
    for (size_t i = 0; i < count; ++i) {
        uint64_t place = 7 * (uint64_t)i;
        put_direction(arrays->in.wo, i, seed, place);
        put_direction(arrays->in.wi, i, seed, place + 2);
        for (unsigned k = 0; k < 3; ++k) {
            arrays->in.u[k][i] = random_uniform(seed, place + 4 + k);
        }
    }
    return BRDF_OK;
}

void arrays_destroy(struct arrays *arrays)
{
    free(arrays->memory);
    memset(arrays, 0, sizeof *arrays);
}

static struct brdf_vectors vectors_at(float *const axes[3], size_t at)
{
    struct brdf_vectors vectors = {axes[0] + at, axes[1] + at, axes[2] + at};
    return vectors;
}

static struct brdf_colors colors_at(float *const channels[3], size_t at)
{
    struct brdf_colors colors = {channels[0] + at, channels[1] + at, channels[2] + at};
    return colors;
}

static struct brdf_samples samples_at(const struct arrays_out *out, size_t at)
{
    struct brdf_samples samples = {out->sample[0] + at, out->sample[1] + at,
                                   out->sample[2] + at, colors_at(out->sample + 3, at),
                                   out->sample[6] + at, out->sample[7] + at,
                                   out->delta + at};
    return samples;
}

/* Blocks stay in the cache between the three passes of a bounce. */
static void run_block(struct arrays *arrays, const struct brdf_bsdf *bsdf, enum operation operation,
                      size_t at, size_t count)
{
    struct arrays_out *out = &arrays->c;
    struct brdf_vectors wo = vectors_at(arrays->in.wo, at);
    struct brdf_vectors wi = vectors_at(arrays->in.wi, at);
    if (operation == OPERATION_SAMPLE || operation == OPERATION_BOUNCE) {
        brdf_sample_many(bsdf, count, wo, vectors_at(arrays->in.u, at), samples_at(out, at));
        wi = vectors_at(out->sample, at);
    }
    if (operation == OPERATION_EVAL || operation == OPERATION_BOUNCE) {
        brdf_eval_many(bsdf, count, wo, wi, colors_at(out->f, at));
    }
    if (operation == OPERATION_PDF || operation == OPERATION_BOUNCE) {
        brdf_pdf_many(bsdf, count, wo, wi, out->pdf + at);
    }
}

void arrays_run_c(struct arrays *arrays, const struct brdf_bsdf *bsdf, enum operation operation,
                  size_t first, size_t end)
{
    for (size_t at = first; at < end; at += BLOCK) {
        run_block(arrays, bsdf, operation, at, end - at < BLOCK ? end - at : BLOCK);
    }
}

brdf_status arrays_run_opencl(struct arrays *arrays, struct brdfcl_evaluator *evaluator,
                              enum operation operation, struct brdf_error *error)
{
    struct arrays_out *out = &arrays->opencl;
    struct brdf_vectors wo = vectors_at(arrays->in.wo, 0);
    struct brdf_vectors wi = vectors_at(arrays->in.wi, 0);
    struct brdf_vectors u = vectors_at(arrays->in.u, 0);
    struct brdf_colors f = colors_at(out->f, 0);
    switch (operation) {
    case OPERATION_SAMPLE:
        return brdfcl_evaluator_sample(evaluator, arrays->count, wo, u, samples_at(out, 0), error);
    case OPERATION_EVAL:
        return brdfcl_evaluator_eval(evaluator, arrays->count, wo, wi, f, error);
    case OPERATION_PDF:
        return brdfcl_evaluator_pdf(evaluator, arrays->count, wo, wi, out->pdf, error);
    default:
        return brdfcl_evaluator_bounce(evaluator, arrays->count, wo, u, samples_at(out, 0), f,
                                       out->pdf, error);
    }
}

/* The planes that an operation writes; how many. */
static int planes_of(const struct arrays_out *out, enum operation operation, const void *planes[13])
{
    int count = 0;
    if (operation != OPERATION_PDF && operation != OPERATION_SAMPLE) {
        for (int i = 0; i < 3; ++i) {
            planes[count++] = out->f[i];
        }
    }
    if (operation == OPERATION_PDF || operation == OPERATION_BOUNCE) {
        planes[count++] = out->pdf;
    }
    if (operation == OPERATION_SAMPLE || operation == OPERATION_BOUNCE) {
        for (int i = 0; i < 8; ++i) {
            planes[count++] = out->sample[i];
        }
        planes[count++] = out->delta;
    }
    return count;
}

/* The bits of a word in the order of the floats that they are. */
static int64_t order_of(const void *plane, size_t i)
{
    int32_t bits;
    memcpy(&bits, (const char *)plane + 4 * i, sizeof bits);
    return bits >= 0 ? bits : -(int64_t)2147483648 - bits - 1;
}

size_t arrays_compare(const struct arrays *arrays, enum operation operation, unsigned *max_ulp)
{
    const void *ours[13], *theirs[13];
    int planes = planes_of(&arrays->c, operation, ours);
    planes_of(&arrays->opencl, operation, theirs);
    size_t differing = 0;
    *max_ulp = 0;
    for (size_t i = 0; i < arrays->count; ++i) {
        int64_t worst = 0;
        for (int k = 0; k < planes; ++k) {
            int64_t apart = order_of(ours[k], i) - order_of(theirs[k], i);
            apart = apart < 0 ? -apart : apart;
            worst = apart > worst ? apart : worst;
        }
        differing += worst > 0;
        *max_ulp = worst > (int64_t)*max_ulp ? (unsigned)worst : *max_ulp;
    }
    return differing;
}
