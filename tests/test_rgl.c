/*
 * test_rgl.c - RGL files: made of a material, written and read back.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "rgl_files.h"
#include "support_bsdf.h"

static const float wavelengths[] = {360.0f, 420.0f, 480.0f, 560.0f, 640.0f, 720.0f, 830.0f};

static struct place place;

static int setup(void **state)
{
    (void)state;
    return place_make(&place, "material.bsdf");
}

static int teardown(void **state)
{
    (void)state;
    return place_remove(&place);
}

static void same_floats(const float *a, const float *b, size_t count)
{
    assert_memory_equal(a, b, count * sizeof *a);
}

static void expect_equal(const struct brdf_rgl_file *a, const struct brdf_rgl_file *b)
{
    size_t views = (size_t)a->phi_count * (size_t)a->theta_count;
    size_t square = (size_t)a->size * (size_t)a->size;
    assert_string_equal(a->description, b->description);
    assert_int_equal(a->phi_count, b->phi_count);
    assert_int_equal(a->theta_count, b->theta_count);
    assert_int_equal(a->channels, b->channels);
    assert_int_equal(a->size, b->size);
    assert_int_equal(a->jacobian, b->jacobian);
    same_floats(a->phi_i, b->phi_i, (size_t)a->phi_count);
    same_floats(a->theta_i, b->theta_i, (size_t)a->theta_count);
    same_floats(a->ndf, b->ndf, (size_t)a->ndf_rows * (size_t)a->ndf_columns);
    same_floats(a->sigma, b->sigma, (size_t)a->sigma_rows * (size_t)a->sigma_columns);
    same_floats(a->vndf, b->vndf, views * (size_t)a->vndf_rows * (size_t)a->vndf_columns);
    same_floats(a->luminance, b->luminance, views * square);
    same_floats(a->values, b->values, views * square * (size_t)a->channels);
    assert_int_equal(a->wavelengths != NULL, b->wavelengths != NULL);
    if (a->wavelengths) {
        same_floats(a->wavelengths, b->wavelengths, (size_t)a->channels);
    }
}

/* Isotropic and anisotropic, RGB and spectral. */
static void written_values_are_read_back(void **state)
{
    (void)state;
    for (int kind = 0; kind < 4; ++kind) {
        struct brdf_rgl_grid grid = {.thetas = 4, .normals = 12, .size = 6, .description = "kind"};
        struct brdf_rgl_file read;
        struct brdf_error error = {BRDF_OK, ""};
        grid.phis = kind & 1 ? 5 : 1;
        grid.symmetry = kind & 1 ? 2 : 1;
        grid.wavelengths = kind & 2 ? wavelengths : NULL;
        grid.channels = kind & 2 ? 7 : 3;
        struct brdf_rgl_file made = rgl_test_make("roughconductor:alpha_u=0.3,alpha_v=0.5", &grid);
        assert_int_equal(brdf_rgl_write(place.path, &made, NULL), BRDF_OK);
        if (brdf_rgl_read(place.path, &read, &error)) {
            fail_msg("%s", error.message);
        }
        expect_equal(&made, &read);
        brdf_rgl_free(&made);
        brdf_rgl_free(&read);
        assert_null(read.values);
    }
}

static void nothing_odd_is_made_or_written(void **state)
{
    (void)state;
    struct brdf_error error;
    struct brdf_rgl_file file = rgl_test_make("diffuse", &rgl_test_tiny), none;
    struct brdf_bsdf *bsdf = bsdf_make("diffuse");
    const struct brdf_rgl_grid two_phis = {.phis = 2}, third = {.phis = 4, .symmetry = 3};
    assert_int_equal(brdf_rgl_make(rgl_test_values, bsdf, &two_phis, &none, NULL),
                     BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_make(rgl_test_values, bsdf, &third, &none, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_make(NULL, bsdf, &rgl_test_tiny, &none, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_write(place.folder, &file, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "not a regular file"));
    file.vndf[3] = (float)NAN;
    assert_int_equal(brdf_rgl_write(place.path, &file, &error), BRDF_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "value 3 of \"vndf\" is not a number"));
    file.vndf[3] = 0.0f;
    file.size = 1;
    assert_int_equal(brdf_rgl_write(place.path, &file, &error), BRDF_BAD_ARGUMENT);
    brdf_rgl_free(&file);
    brdf_bsdf_destroy(bsdf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(written_values_are_read_back),
        cmocka_unit_test(nothing_odd_is_made_or_written),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
