/*
 * world_words.c - see world_words.h.
 */
#define _DEFAULT_SOURCE
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "world_words.h"

#define LINE_BYTES (WORLD_LINE * sizeof(float))
#define HUGE_PAGE ((size_t)2 << 20)

void *world_allocate(size_t bytes)
{
    void *memory = NULL;
    bytes = bytes > 0 ? bytes : LINE_BYTES;
    size_t alignment = bytes >= HUGE_PAGE ? HUGE_PAGE : LINE_BYTES;
    if (posix_memalign(&memory, alignment, bytes) != 0) {
        return NULL;
    }
#ifdef MADV_HUGEPAGE
    /* A hierarchy is walked at random: with large pages its addresses stay known to the core. Only
       advice, so whether it is taken does not matter. */
    if (bytes >= HUGE_PAGE) {
        madvise(memory, bytes, MADV_HUGEPAGE);
    }
#endif
    memset(memory, 0, bytes);
    return memory;
}

brdf_status world_append(struct world_words *words, const float *add, size_t count, int *at,
                         struct brdf_error *error)
{
    const size_t line = WORLD_LINE;
    size_t begin = (words->count + line - 1) / line * line;
    if (count > INT_MAX || begin + count > INT_MAX) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                         "the scene needs more than 2^31 words of memory; make it smaller");
    }
    if (begin + count > words->capacity) {
        size_t capacity = begin + count + words->capacity / 2;
        float *grown = world_allocate(capacity * sizeof(float));
        if (!grown) {
            return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for the scene (%zu MB)",
                             capacity * sizeof(float) >> 20);
        }
        if (words->count > 0) {
            memcpy(grown, words->words, words->count * sizeof(float));
        }
        free(words->words);
        words->words = grown;
        words->capacity = capacity;
    }
    if (add) {
        memcpy(words->words + begin, add, count * sizeof(float));
    }
    words->count = begin + count;
    *at = (int)begin;
    return BRDF_OK;
}

double world_luminance(const float *rgb)
{
    return 0.2126 * (double)rgb[0] + 0.7152 * (double)rgb[1] + 0.0722 * (double)rgb[2];
}

void world_cdf(const double *weights, size_t count, float *cdf)
{
    double total = 0.0;
    for (size_t i = 0; i < count; ++i) {
        total += weights[i];
    }
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        cdf[i] = (float)sum;
        sum += total > 0.0 ? weights[i] / total : 1.0 / (double)count;
    }
    /* The last bin of any mass ends at 1 exactly, so that a search never leaves the bins. */
    cdf[count] = 1.0f;
    for (size_t i = count; i > 0 && total > 0.0 && weights[i - 1] <= 0.0; --i) {
        cdf[i - 1] = 1.0f;
    }
}

int world_search_steps(int count)
{
    int steps = 0;
    while ((1 << steps) < count) {
        ++steps;
    }
    return steps;
}
