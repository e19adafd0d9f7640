/*
 * test_merl.c - MERL files: written and read back, and what becomes of bins that are invalid.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "merl_bake.h"
#include "merl_bytes.h"

static void written_values_are_read_back(void **state)
{
    (void)state;
    struct brdf_merl_file made, read;
    double alpha = 0.4;
    assert_int_equal(brdf_merl_make(test_glossy, &alpha, &made, NULL), BRDF_OK);
    assert_int_equal(brdf_merl_write(place.path, &made, NULL), BRDF_OK);
    struct stat info;
    assert_int_equal(stat(place.path, &info), 0);
    assert_int_equal(info.st_size, MERL_BYTES);
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_KEEP, &read, NULL), BRDF_OK);
    assert_int_equal(read.bins, 90 * 90 * 180);
    assert_int_equal(read.invalid, made.invalid);
    assert_true(made.invalid > 0 && made.invalid < made.bins / 2);
    for (size_t i = 0; i < made.bins * 3; ++i) {
        if (fabsf(made.rgb[i] - read.rgb[i]) > 1e-6f * fabsf(made.rgb[i])) {
            fail_msg("value %zu: wrote %g, read %g", i, (double)made.rgb[i], (double)read.rgb[i]);
        }
    }
    brdf_merl_free(&made);
    brdf_merl_free(&read);
    assert_null(read.rgb);
}

/* Plane, bin and unit of single values, put into the file by the published index formula. */
static void values_lie_where_the_format_says(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    size_t bin = 97 + 180 * (31 + 90 * (size_t)12);
    merl_test_zeros(place.path, 90, 90, 180, MERL_BYTES);
    for (size_t c = 0; c < 3; ++c) {
        merl_test_put(place.path, bin + c * 90 * 90 * 180, 3000.0);
    }
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_FILL, &file, NULL), BRDF_OK);
    assert_float_equal(file.rgb[3 * bin], 2.0f, 1e-6f);
    assert_float_equal(file.rgb[3 * bin + 1], 2.0f * 1.15f, 1e-6f);
    assert_float_equal(file.rgb[3 * bin + 2], 2.0f * 1.66f, 1e-6f);
    double sum = 0.0;
    for (size_t i = 0; i < file.bins * 3; ++i) {
        sum += (double)file.rgb[i];
    }
    assert_true(fabs(sum - 2.0 * (1.0 + 1.15 + 1.66)) < 1e-5);
    assert_int_equal(file.invalid, 0);
    brdf_merl_free(&file);
}

/* A column with values 1.0 at bin 10 and 3.0 at bin 14, invalid between and from 15 on. */
static void invalid_bins_are_counted_and_filled(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    size_t plane = 90 * 90 * 180, column = 5 + 180 * (size_t)7, stride = 180 * 90;
    merl_test_zeros(place.path, 90, 90, 180, MERL_BYTES);
    merl_test_put(place.path, column + 10 * stride, 1500.0);
    merl_test_put(place.path, column + 14 * stride, 4500.0);
    for (size_t k = 11; k < 90; ++k) {
        if (k != 14) { /* one negative channel makes the bin invalid */
            merl_test_put(place.path, column + k * stride + (k % 3) * plane, -1.0);
        }
    }
    for (size_t k = 0; k < 90; ++k) { /* a whole column without a value, beside another */
        merl_test_put(place.path, column + 1 + k * stride, -1.0);
    }
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_FILL, &file, NULL), BRDF_OK);
    assert_int_equal(file.invalid, 78 + 90);
    const float *red = file.rgb + 3 * column;
    assert_float_equal(red[3 * 12 * stride], 2.0f, 1e-6f);
    assert_float_equal(red[3 * 13 * stride], 2.5f, 1e-6f);
    assert_float_equal(red[3 * 15 * stride], 3.0f, 1e-6f);
    assert_float_equal(red[3 * 89 * stride], 3.0f, 1e-6f);
    for (size_t i = 0; i < file.bins * 3; ++i) {
        assert_true(file.rgb[i] >= 0.0f);
    }
    brdf_merl_free(&file);
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_ZERO, &file, NULL), BRDF_OK);
    assert_int_equal(file.invalid, 78 + 90);
    assert_float_equal(file.rgb[3 * (column + 12 * stride)], 0.0f, 0.0f);
    assert_float_equal(file.rgb[3 * (column + 14 * stride)], 3.0f, 1e-6f);
    brdf_merl_free(&file);
}

/* Where a whole phi_d has no value, or a small theta_d has none, the neighbours stand in. */
static void empty_planes_are_filled_from_neighbours(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    double half = 0.5;
    assert_int_equal(brdf_merl_make(test_lambert, &half, &file, NULL), BRDF_OK);
    for (size_t bin = 0; bin < file.bins; ++bin) {
        size_t theta_d = bin / 180 % 90, phi_d = bin % 180;
        if (theta_d < 3 || (phi_d >= 40 && phi_d < 50)) {
            file.rgb[3 * bin] = -1.0f;
        }
    }
    assert_int_equal(brdf_merl_write(place.path, &file, NULL), BRDF_OK);
    brdf_merl_free(&file);
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_FILL, &file, NULL), BRDF_OK);
    for (size_t i = 0; i < file.bins * 3; ++i) {
        assert_float_equal(file.rgb[i], (float)(0.5 / pi), 1e-6f);
    }
    brdf_merl_free(&file);
}

/* 360 bins of phi_d: opposite azimuths are averaged, a valid one wins over an invalid one. */
static void a_whole_turn_is_folded(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    merl_test_zeros(place.path, 90, 90, 360, FULL_TURN_BYTES);
    merl_test_put(place.path, 20, 1500.0);
    merl_test_put(place.path, 200, 4500.0);
    merl_test_put(place.path, 360 + 30, -1.0);
    merl_test_put(place.path, 360 + 210, 1500.0);
    merl_test_put(place.path, 720 + 40, 1500.0);
    merl_test_put(place.path, 720 + 220, -1.0);
    assert_int_equal(brdf_merl_read(place.path, BRDF_MERL_INVALID_KEEP, &file, NULL), BRDF_OK);
    assert_int_equal(file.phi_d, 180);
    assert_true(file.folded);
    assert_true(fabs(file.folding - 2.0 * (3.0 - 1.0) / (3.0 + 1.0)) < 1e-6);
    assert_int_equal(file.invalid, 0);
    assert_float_equal(file.rgb[3 * 20], 2.0f, 1e-6f);
    assert_float_equal(file.rgb[3 * (180 + 30)], 1.0f, 1e-6f);
    assert_float_equal(file.rgb[3 * (360 + 40)], 1.0f, 1e-6f);
    brdf_merl_free(&file);
}

static void writing_is_whole_or_not_at_all(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    struct brdf_error error;
    struct stat info;
    double albedo = 0.25;
    assert_int_equal(brdf_merl_make(test_lambert, &albedo, &file, NULL), BRDF_OK);
    assert_int_equal(brdf_merl_write(place.folder, &file, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "not a regular file"));
    assert_int_equal(brdf_merl_write("/nowhere/at/all.binary", &file, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "No such file"));

    /* A disk that is full, by other means: a limit of 1 MB on files. The old file must survive. */
    merl_test_zeros(place.path, 1, 2, 3, 100);
    struct rlimit old, small;
    getrlimit(RLIMIT_FSIZE, &old);
    small = old;
    small.rlim_cur = 1000000;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    brdf_status status = brdf_merl_write(place.path, &file, &error);
    setrlimit(RLIMIT_FSIZE, &old);
    assert_int_equal(status, BRDF_IO);
    assert_int_equal(stat(place.path, &info), 0);
    assert_int_equal(info.st_size, 100);

    file.rgb[4711] = (float)NAN;
    assert_int_equal(brdf_merl_write(place.path, &file, &error), BRDF_BAD_ARGUMENT);
    file.rgb[4711] = 0.0f;
    file.theta_d = 91;
    assert_int_equal(brdf_merl_write(place.path, &file, &error), BRDF_BAD_ARGUMENT);
    file.theta_d = 90;
    assert_int_equal(brdf_merl_write(place.path, &file, &error), BRDF_OK);
    assert_int_equal(stat(place.path, &info), 0);
    assert_int_equal(info.st_size, MERL_BYTES);
    brdf_merl_free(&file);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        MERL_TEST(written_values_are_read_back),
        MERL_TEST(values_lie_where_the_format_says),
        MERL_TEST(invalid_bins_are_counted_and_filled),
        MERL_TEST(empty_planes_are_filled_from_neighbours),
        MERL_TEST(a_whole_turn_is_folded),
        MERL_TEST(writing_is_whole_or_not_at_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
