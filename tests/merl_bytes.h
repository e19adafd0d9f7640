/*
 * merl_bytes.h - MERL files byte by byte: a place for one, sparse ones of zeros, and values put
 * into them.
 */
#ifndef TEST_MERL_BYTES_H
#define TEST_MERL_BYTES_H

#include <fcntl.h>
#include <stdint.h>
#include <string.h>
#include <unistd.h>

#include "support_place.h"

enum { MERL_BYTES = 34992012, FULL_TURN_BYTES = 69984012 };

/* The place of a test's file; each has its own. */
static struct place place;

static inline int merl_test_setup(void **state)
{
    (void)state;
    return place_make(&place, "material.binary");
}

static inline int merl_test_teardown(void **state)
{
    (void)state;
    return place_remove(&place);
}

#define MERL_TEST(name) cmocka_unit_test_setup_teardown(name, merl_test_setup, merl_test_teardown)

/* A file of a header and, sparsely, zeros: a valid black material if the numbers are MERL's. */
static inline void merl_test_zeros(const char *path, int theta_h, int theta_d, int phi_d, long size)
{
    unsigned char header[12] = {0};
    const int bins[3] = {theta_h, theta_d, phi_d};
    for (int i = 0; i < 12; ++i) {
        header[i] = (unsigned char)((unsigned)bins[i / 4] >> (8 * (i % 4)) & 255u);
    }
    int file = open(path, O_CREAT | O_TRUNC | O_WRONLY, 0600);
    assert_true(file >= 0);
    assert_int_equal(write(file, header, sizeof header), sizeof header);
    assert_int_equal(ftruncate(file, size), 0);
    close(file);
}

static inline void merl_test_patch(const char *path, long at, const void *bytes, size_t count)
{
    int file = open(path, O_WRONLY);
    assert_true(file >= 0);
    assert_int_equal(pwrite(file, bytes, count, at), count);
    close(file);
}

/* A double as the file stores it, on whatever machine. */
static inline void merl_test_put(const char *path, size_t number, double value)
{
    unsigned char bytes[8];
    uint64_t word;
    memcpy(&word, &value, 8);
    for (int i = 0; i < 8; ++i) {
        bytes[i] = (unsigned char)(word >> (8 * i) & 255u);
    }
    merl_test_patch(path, 12 + 8 * (long)number, bytes, 8);
}

#endif
