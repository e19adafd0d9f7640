/*
 * check_random.h - random numbers for checks: the same on every machine, from a seed.
 */
#ifndef BRDFCL_CHECK_RANDOM_H
#define BRDFCL_CHECK_RANDOM_H

struct brdfcl_random {
    unsigned long long state; /* the seed; any value */
};

/* 64 random bits: SplitMix64 [Steele, Lea, Flood 2014, figure 17]. */
static inline unsigned long long brdfcl_random_bits(struct brdfcl_random *random)
{
    unsigned long long z = random->state += 0x9e3779b97f4a7c15ull;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ z >> 27) * 0x94d049bb133111ebull;
    return z ^ z >> 31;
}

/* Uniform in [0, 1): a multiple of 2^-24, so that a float holds it exactly. */
static inline float brdfcl_random_uniform(struct brdfcl_random *random)
{
    return (float)(brdfcl_random_bits(random) >> 40) * 0x1p-24f;
}

/* A whole number in [0, count). */
static inline int brdfcl_random_below(struct brdfcl_random *random, int count)
{
    return (int)(brdfcl_random_bits(random) % (unsigned long long)count);
}

#endif
