/*
 * random.h - random numbers by number: the same seed and place give the same one, in any order.
 */
#ifndef BRDFCL_CLI_RANDOM_H
#define BRDFCL_CLI_RANDOM_H

#include <stdint.h>

/* Uniform in [0, 1), 24 bits: the finaliser of splitmix64 [Steele, Lea, Flood 2014], twice. */
static inline float random_uniform(unsigned seed, uint64_t place)
{
    uint64_t x = place * UINT64_C(0x9e3779b97f4a7c15) + seed;
    for (int i = 0; i < 2; ++i) {
        x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
        x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
        x = (x ^ (x >> 31)) + UINT64_C(0x9e3779b97f4a7c15);
    }
    return (float)(x >> 40) * (1.0f / 16777216.0f);
}

#endif
