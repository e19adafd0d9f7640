/*
 * lanes.h - lanes as bits: which of 16 neighbours pass a test, and walking over those that do.
 *
 * A chunk is what one brdf_real holds of 16 neighbouring words. How a mask becomes bits is a
 * capability of the compiler, asked for here by name; without it a reduction with or does.
 */
#ifndef PT_LANES_H
#define PT_LANES_H

#include "brdf/dialect.h"

#define PT_WIDTH 16 /* neighbours: children of a node, primitives of a leaf */
#define PT_CHUNKS (PT_WIDTH / BRDF_LANES)

/* 16 values that are reached as chunks and one by one. */
union pt_sixteen {
    brdf_real chunk[PT_CHUNKS];
    float one[PT_WIDTH];
};

/* A chunk in memory; words is a multiple of the chunk's size from the start of an aligned array. */
static inline brdf_real pt_load_chunk(BRDF_GLOBAL const float *words)
{
    return *(BRDF_GLOBAL const brdf_real *)words;
}

static inline brdf_int pt_load_chunk_int(BRDF_GLOBAL const float *words)
{
    return brdf_bits(pt_load_chunk(words));
}

#ifdef __OPENCL_VERSION__

static inline int pt_int_bits(float word)
{
    return as_int(word);
}

static inline float pt_float_of_bits(int bits)
{
    return as_float(bits);
}

static inline int pt_count_bits(unsigned bits)
{
    return (int)popcount(bits);
}

/* The number of the lowest bit that is set; bits is not 0. */
static inline int pt_lowest_bit(unsigned bits)
{
    return 31 - (int)clz(bits & (0u - bits));
}

#else

static inline int pt_int_bits(float word)
{
    return brdf_bits(word);
}

static inline float pt_float_of_bits(int bits)
{
    return brdf_from_bits(bits);
}

static inline int pt_count_bits(unsigned bits)
{
    int count = 0;
    for (; bits; bits &= bits - 1u) {
        ++count;
    }
    return count;
}

static inline int pt_lowest_bit(unsigned bits)
{
#ifdef __GNUC__
    return __builtin_ctz(bits);
#else
    int i = 0;
    while (!(bits >> i & 1u)) {
        ++i;
    }
    return i;
#endif
}

#endif

/*
 * For a function with large arrays: it is called, not inlined. PoCL keeps a copy of a kernel's own
 * arrays for each work-item of a group, far more than the caches (or the stack) hold, but a called
 * function's arrays live while it runs.
 */
#ifdef __OPENCL_VERSION__
#define PT_OWN_FRAME static __attribute__((noinline))
#else
#define PT_OWN_FRAME static inline
#endif

/* Instructions that gather the sign bits of a vector: AVX-512 DQ, AVX, SSE. */
#if BRDF_LANES > 1 && defined(__clang__) && defined(__has_builtin)
#if BRDF_LANES == 16 && defined(__AVX512DQ__) && __has_builtin(__builtin_ia32_cvtd2mask512)
#define PT_SIGN_BITS(mask)                                                                         \
    (unsigned short)__builtin_ia32_cvtd2mask512(                                                   \
        __builtin_astype(mask, int __attribute__((__vector_size__(64)))))
#elif BRDF_LANES == 8 && defined(__AVX__) && __has_builtin(__builtin_ia32_movmskps256)
#define PT_SIGN_BITS(mask)                                                                         \
    __builtin_ia32_movmskps256(__builtin_astype(mask, float __attribute__((__vector_size__(32)))))
#elif BRDF_LANES == 4 && defined(__SSE__) && __has_builtin(__builtin_ia32_movmskps)
#define PT_SIGN_BITS(mask)                                                                         \
    __builtin_ia32_movmskps(__builtin_astype(mask, float __attribute__((__vector_size__(16)))))
#endif
#endif

/* Bit k tells whether lane k of the mask is true. */
static inline unsigned pt_mask_bits(brdf_mask mask)
{
#if BRDF_LANES == 1
    return mask != 0;
#elif defined(PT_SIGN_BITS)
    return (unsigned)PT_SIGN_BITS(mask);
#else
    return (unsigned)brdf_or_lanes(mask & ((brdf_mask)1 << brdf_lane_numbers()));
#endif
}

#endif
