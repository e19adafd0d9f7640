/*
 * test_merl_refused.c - MERL files that are none: everything that can be wrong.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <sys/stat.h>

#include <brdf/merl.h>

#include "merl_bytes.h"

static void expect_refusal(const char *path, brdf_status status, const char *words)
{
    struct brdf_merl_file file;
    struct brdf_error error = {0, ""};
    assert_int_equal(brdf_merl_read(path, BRDF_MERL_INVALID_FILL, &file, &error), status);
    assert_int_equal(error.status, status);
    if (!strstr(error.message, words) || !strstr(error.message, path)) {
        fail_msg("\"%s\" should name %s and say \"%s\"", error.message, path, words);
    }
    assert_null(file.rgb);
}

static void bad_sizes_and_headers_are_refused(void **state)
{
    const char *path = place.path;
    (void)state;
    expect_refusal(path, BRDF_IO, "No such file");
    merl_test_zeros(path, 90, 90, 180, 0);
    expect_refusal(path, BRDF_BAD_FILE, "0 bytes are too short");
    merl_test_zeros(path, 90, 90, 180, 11);
    expect_refusal(path, BRDF_BAD_FILE, "11 bytes are too short");
    merl_test_zeros(path, 90, 90, 180, MERL_BYTES - 1);
    expect_refusal(path, BRDF_BAD_FILE, "expected 34992012 bytes");
    expect_refusal(path, BRDF_BAD_FILE, "found 34992011");
    merl_test_zeros(path, 90, 90, 180, MERL_BYTES + 1);
    expect_refusal(path, BRDF_BAD_FILE, "found 34992013: the file is too long");
    merl_test_zeros(path, 90, 90, 360, MERL_BYTES);
    expect_refusal(path, BRDF_BAD_FILE, "expected 69984012 bytes");
    merl_test_zeros(path, 91, 90, -180, MERL_BYTES);
    expect_refusal(path, BRDF_BAD_FILE, "91 x 90 x -180");
    merl_test_zeros(path, 2147483647, 90, 180, MERL_BYTES);
    expect_refusal(path, BRDF_BAD_FILE, "2147483647 x 90 x 180");
    merl_test_patch(path, 0, "\3757zXZ\0", 6);
    expect_refusal(path, BRDF_BAD_FILE, "xz -dk");
}

static void bad_values_are_refused(void **state)
{
    const char *path = place.path;
    (void)state;
    merl_test_zeros(path, 90, 90, 180, MERL_BYTES);
    merl_test_put(path, 2000000, (double)NAN);
    expect_refusal(path, BRDF_BAD_FILE, "byte 16000012: the value is not a number");
    merl_test_put(path, 2000000, (double)INFINITY);
    expect_refusal(path, BRDF_BAD_FILE, "byte 16000012: the value is infinite");
    merl_test_put(path, 2000000, 1e300);
    expect_refusal(path, BRDF_BAD_FILE, "too large");
    merl_test_zeros(path, 90, 90, 180, MERL_BYTES);
    static unsigned char minus[8 * 180 * 90];
    for (size_t i = 0; i < sizeof minus / 8; ++i) {
        memcpy(minus + 8 * i, "\0\0\0\0\0\0\360\277", 8); /* -1 */
    }
    for (long k = 0; k < 90; ++k) {
        merl_test_patch(path, 12 + k * (long)sizeof minus, minus, sizeof minus);
    }
    expect_refusal(path, BRDF_BAD_FILE, "no bin is valid");
}

static void other_things_than_files_are_refused(void **state)
{
    (void)state;
    expect_refusal(place.folder, BRDF_IO, "a folder");
    expect_refusal("/dev/zero", BRDF_IO, "device");
    assert_int_equal(mkfifo(place.path, 0600), 0);
    expect_refusal(place.path, BRDF_IO, "a pipe"); /* and does not wait for a writer */
    struct brdf_merl_file file;
    assert_int_equal(brdf_merl_read(NULL, BRDF_MERL_INVALID_FILL, &file, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_FILL, NULL, NULL),
                     BRDF_BAD_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        MERL_TEST(bad_sizes_and_headers_are_refused),
        MERL_TEST(bad_values_are_refused),
        MERL_TEST(other_things_than_files_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
