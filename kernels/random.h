/*
 * random.h - the random numbers of a path: a function of (seed, pixel, sample, dimension).
 *
 * No state travels with a path, so any order of work gives the same numbers. Numbers come four at a
 * time: (a, b) and (c, d) are each a well-distributed pair when Sobol is on.
 */
#ifndef PT_RANDOM_H
#define PT_RANDOM_H

#include "brdf/dialect.h"

struct pt_random {
    brdf_real a;
    brdf_real b;
    brdf_real c;
    brdf_real d;
};

/* The top 24 bits as a number in [0, 1). */
static inline brdf_real pt_unit(brdf_uint bits)
{
    return brdf_to_real(brdf_int_of(bits >> 8u)) * 5.9604644775390625e-8f;
}

static inline brdf_uint pt_reverse_bits(brdf_uint x)
{
    x = (x >> 16u) | (x << 16u);
    x = ((x & 0xff00ff00u) >> 8u) | ((x & 0x00ff00ffu) << 8u);
    x = ((x & 0xf0f0f0f0u) >> 4u) | ((x & 0x0f0f0f0fu) << 4u);
    x = ((x & 0xccccccccu) >> 2u) | ((x & 0x33333333u) << 2u);
    x = ((x & 0xaaaaaaaau) >> 1u) | ((x & 0x55555555u) << 1u);
    return x;
}

struct pt_bits4 {
    brdf_uint x;
    brdf_uint y;
    brdf_uint z;
    brdf_uint w;
};

/* A hash of four words to four words, "pcg4d" [Jarzynski and Olano 2020, JCGT 9(3)]. */
static inline struct pt_bits4 pt_hash4(brdf_uint x, brdf_uint y, brdf_uint z, brdf_uint w)
{
    x = x * 1664525u + 1013904223u;
    y = y * 1664525u + 1013904223u;
    z = z * 1664525u + 1013904223u;
    w = w * 1664525u + 1013904223u;
    x = x + y * w;
    y = y + z * x;
    z = z + x * y;
    w = w + y * z;
    x = x ^ (x >> 16u);
    y = y ^ (y >> 16u);
    z = z ^ (z >> 16u);
    w = w ^ (w >> 16u);
    struct pt_bits4 h;
    h.x = x + y * w;
    h.y = y + z * h.x;
    h.z = z + h.x * h.y;
    h.w = w + h.y * h.z;
    return h;
}

/*
 * Owen scrambling of a number whose bits are reversed (lowest bit first decided), by a hash in
 * which every bit depends on lower ones only [Laine and Karras 2011; Burley 2020, JCGT 9(4)], with
 * the constants of Vegdahl 2021.
 */
static inline brdf_uint pt_scramble_reversed(brdf_uint x, brdf_uint seed)
{
    x = x ^ (x * 0x3d20adeau);
    x = x + seed;
    x = x * ((seed >> 16u) | 1u);
    x = x ^ (x * 0x05526c56u);
    x = x ^ (x * 0x53a22864u);
    return x;
}

/* Sobol's second dimension with its bits reversed: Pascal's triangle modulo 2 [Ahmed 2024]. */
static inline brdf_uint pt_sobol_reversed(brdf_uint index)
{
    index = index ^ ((index & 0xaaaaaaaau) >> 1u);
    index = index ^ ((index & 0xccccccccu) >> 2u);
    index = index ^ ((index & 0xf0f0f0f0u) >> 4u);
    index = index ^ ((index & 0xff00ff00u) >> 8u);
    index = index ^ ((index & 0xffff0000u) >> 16u);
    return index;
}

/*
 * Four numbers in [0, 1). `dimension` numbers the sets of four that a path asks for. Sobol: two
 * pairs of the (0,2)-sequence, each Owen-scrambled and its samples shuffled by the pixel and the
 * dimension [Burley 2020, section 4]; else: a hash.
 */
static inline struct pt_random pt_random4(int sobol, int seed, brdf_int pixel, brdf_int sample,
                                          int dimension)
{
    struct pt_random r;
    brdf_uint sample_bits = brdf_uint_of(sample);
    brdf_uint dimension_bits = brdf_uint_of((brdf_int)dimension);
    brdf_uint seed_bits = brdf_uint_of((brdf_int)seed);
    if (sobol) {
        struct pt_bits4 h = pt_hash4(brdf_uint_of(pixel), dimension_bits, seed_bits, seed_bits);
        brdf_uint reversed = pt_reverse_bits(sample_bits);
        brdf_uint i = pt_reverse_bits(pt_scramble_reversed(reversed, h.x));
        brdf_uint j = pt_reverse_bits(pt_scramble_reversed(reversed, h.z));
        r.a = pt_unit(pt_reverse_bits(pt_scramble_reversed(i, h.y)));
        r.b = pt_unit(pt_reverse_bits(pt_scramble_reversed(pt_sobol_reversed(i), h.y ^ h.w)));
        r.c = pt_unit(pt_reverse_bits(pt_scramble_reversed(j, h.w)));
        r.d = pt_unit(pt_reverse_bits(pt_scramble_reversed(pt_sobol_reversed(j), h.x ^ h.w)));
        return r;
    }
    struct pt_bits4 h = pt_hash4(brdf_uint_of(pixel), sample_bits, dimension_bits, seed_bits);
    r.a = pt_unit(h.x);
    r.b = pt_unit(h.y);
    r.c = pt_unit(h.z);
    r.d = pt_unit(h.w);
    return r;
}

#endif
