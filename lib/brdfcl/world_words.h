/*
 * world_words.h - what the parts of a world are made with: words that grow, and tables of
 * probabilities.
 */
#ifndef BRDFCL_LIB_WORLD_WORDS_H
#define BRDFCL_LIB_WORLD_WORDS_H

#include <stddef.h>

#include <brdf/status.h>

/* Words of a cache line, on which parts of arrays begin. */
enum { WORLD_LINE = 16 };

/* A part of the scene array while it grows. */
struct world_words {
    float *words;
    size_t count;
    size_t capacity;
};

/* Memory on 64 bytes, zeroed; to be freed by free(). NULL if there is none. */
void *world_allocate(size_t bytes);

/* Append `count` words (zeros if NULL) on the next 64 bytes; *at is their first word. */
brdf_status world_append(struct world_words *words, const float *add, size_t count, int *at,
                         struct brdf_error *error);

/* Relative luminance of linear Rec. 709, by which lights and pixels are chosen. */
double world_luminance(const float *rgb);

/* A CDF of count + 1 words from weights, from 0 to 1; uniform where all weights are 0. */
void world_cdf(const double *weights, size_t count, float *cdf);

/* Steps of a binary search among `count` bins. */
int world_search_steps(int count);

#endif
