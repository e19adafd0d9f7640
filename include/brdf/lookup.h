/*
 * lookup.h - tables over two numbers, read linearly between four words.
 */
#ifndef BRDF_LOOKUP_H
#define BRDF_LOOKUP_H

#include "vec.h"

/* Where a number lies: the word before it, and how far it is from there to the next one. */
struct brdf_place {
    brdf_int index;
    brdf_real rest;
};

/* Of x in [0, last], in words; what is outside counts as the end. */
static inline struct brdf_place brdf_place_of(brdf_real x, brdf_real last)
{
    struct brdf_place place;
    brdf_real inside = brdf_clamp(x, 0.0f, last);
    brdf_real whole = brdf_min(floorf(inside), last - 1.0f);
    place.index = brdf_to_int(whole);
    place.rest = inside - whole;
    return place;
}

static inline brdf_real brdf_between(brdf_real low, brdf_real high, brdf_real rest)
{
    return low + (high - low) * rest;
}

/* `word` and the one behind it, `row` words further on the same two, and what lies between. */
static inline brdf_real brdf_lookup(BRDF_GLOBAL const float *table, brdf_int word, int row,
                                    brdf_real row_rest, brdf_real column_rest)
{
    brdf_int next = word + row;
    brdf_real low =
        brdf_between(brdf_gather(table, word), brdf_gather(table, word + 1), column_rest);
    brdf_real high =
        brdf_between(brdf_gather(table, next), brdf_gather(table, next + 1), column_rest);
    return brdf_between(low, high, row_rest);
}

#endif
