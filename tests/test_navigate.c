/*
 * test_navigate.c - maps of materials: places that are known come back, and traits go where they
 * say.
 */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <math.h>
#include <string.h>

#include "basis.h"
#include "complete.h"
#include "open.h"
#include "place.h"

static const char *const materials[] = {
    "phong:exponent=10,specular_reflectance=0.3,diffuse_reflectance=0.1",
    "phong:exponent=40,specular_reflectance=0.2,diffuse_reflectance=0.4/0.2/0.1",
    "phong:exponent=90,specular_reflectance=0.5/0.3/0.1,diffuse_reflectance=0.05",
    "diffuse:reflectance=0.2/0.3/0.6",
};
enum { COUNT = sizeof materials / sizeof materials[0], ALL = COUNT - 1 };

static void table_of(const char *material, struct brdf_merl_file *file)
{
    enum lab_format format;
    assert_int_equal(lab_open_merl(material, file, &format, NULL), BRDF_OK);
    assert_int_equal(lab_complete_merl(file, 1, NULL), BRDF_OK);
}

static int basis_make(void **state)
{
    struct lab_basis *basis = NULL;
    brdf_status status = lab_basis_create(materials, COUNT, 10, NULL, NULL, &basis, NULL);
    *state = basis;
    return status;
}

static int basis_end(void **state)
{
    lab_basis_destroy(*state);
    return 0;
}

/* No more components than there can be; uncorrelated coordinates of mean 0 and variance 1. */
static void test_components(void **state)
{
    const struct lab_basis *basis = *state;
    double explained = 0.0;
    assert_int_equal(basis->components, ALL);
    for (int k = 0; k < ALL; ++k) {
        explained += basis->explained[k];
        assert_true(k == 0 || basis->explained[k] <= basis->explained[k - 1]);
        for (int l = 0; l <= k; ++l) {
            double sum = 0.0, product = 0.0;
            for (int i = 0; i < COUNT; ++i) {
                sum += basis->coordinate[i * ALL + k];
                product += basis->coordinate[i * ALL + k] * basis->coordinate[i * ALL + l];
            }
            assert_true(fabs(sum) < 1e-5);
            assert_true(fabs(product / (COUNT - 1) - (k == l)) < 1e-9);
        }
    }
    assert_true(fabs(explained - 1.0) < 1e-6);
}

/* A material of the map is found where the map has it, with nothing left over. */
static void test_project(void **state)
{
    const struct lab_basis *basis = *state;
    struct brdf_merl_file file;
    double found[ALL], residual = 1.0;
    table_of(materials[2], &file);
    assert_int_equal(lab_basis_project(basis, &file, found, &residual, NULL), BRDF_OK);
    for (int k = 0; k < ALL; ++k) {
        assert_true(fabs(found[k] - basis->coordinate[2 * ALL + k]) < 1e-4);
    }
    assert_true(residual < 1e-2);
    brdf_merl_free(&file);
}

/* The largest difference of valid bins, relative to the values (or to the mapping's epsilon). */
static double difference(const struct brdf_merl_file *a, const struct brdf_merl_file *b)
{
    double most = 0.0;
    for (size_t i = 0; i < 3 * a->bins; ++i) {
        if (a->rgb[i] >= 0.0f && b->rgb[i] >= 0.0f) {
            double off = fabs((double)a->rgb[i] - (double)b->rgb[i]);
            most = fmax(most, off / fmax((double)b->rgb[i], 0.01));
        }
    }
    return most;
}

/* At the coordinates of a material, from the mean or from another one, lies that material. */
static void test_place(void **state)
{
    const struct lab_basis *basis = *state;
    struct brdf_merl_file wanted, made;
    double step[ALL];
    table_of(materials[1], &wanted);
    memcpy(step, basis->coordinate + ALL, sizeof step);
    assert_int_equal(lab_place_make(basis, materials, NULL, step, NULL, NULL, &made, NULL),
                     BRDF_OK);
    assert_int_equal(made.invalid, wanted.invalid);
    assert_true(difference(&made, &wanted) < 1e-3);
    brdf_merl_free(&made);
    for (int k = 0; k < ALL; ++k) {
        step[k] = basis->coordinate[ALL + k] - basis->coordinate[3 * ALL + k];
    }
    assert_int_equal(lab_place_make(basis, materials, materials[3], step, NULL, NULL, &made, NULL),
                     BRDF_OK);
    assert_true(difference(&made, &wanted) < 1e-3);
    brdf_merl_free(&made);
    brdf_merl_free(&wanted);
}

/* One deviation of a trait along its own step changes it by about that, and in that direction. */
static void test_trait(void **state)
{
    const struct lab_basis *basis = *state;
    struct brdf_merl_file file;
    double step[ALL] = {0}, before[LAB_TRAITS], after[LAB_TRAITS];
    assert_true(lab_basis_step(basis, LAB_TRAIT_BRIGHTNESS, 0.5, step));
    table_of(materials[0], &file);
    lab_traits_measure(&file, before);
    brdf_merl_free(&file);
    assert_int_equal(lab_place_make(basis, materials, materials[0], step, NULL, NULL, &file, NULL),
                     BRDF_OK);
    lab_traits_measure(&file, after);
    brdf_merl_free(&file);
    double change = (after[LAB_TRAIT_BRIGHTNESS] - before[LAB_TRAIT_BRIGHTNESS]) /
                    basis->trait_deviation[LAB_TRAIT_BRIGHTNESS];
    assert_true(change > 0.2 && change < 1.0);
}

/* Measured on materials whose traits are known. */
static void test_traits_of_known_materials(void **state)
{
    (void)state;
    struct brdf_merl_file file;
    double red[LAB_TRAITS], shiny[LAB_TRAITS];
    table_of("diffuse:reflectance=0.8/0.2/0.2", &file);
    lab_traits_measure(&file, red);
    brdf_merl_free(&file);
    table_of("phong:exponent=200,specular_reflectance=0.5,diffuse_reflectance=0.1", &file);
    lab_traits_measure(&file, shiny);
    brdf_merl_free(&file);
    assert_true(fabs(red[LAB_TRAIT_SATURATION] - 0.75) < 1e-4);
    assert_true(fabs(red[LAB_TRAIT_WARMTH] - log(4.0)) < 1e-4);
    assert_true(fabs(red[LAB_TRAIT_GLOSS]) < 1e-4);
    assert_true(fabs(red[LAB_TRAIT_GRAZING]) < 1e-4);
    assert_true(fabs(shiny[LAB_TRAIT_METALLIC]) < 1e-4);
    assert_true(shiny[LAB_TRAIT_GLOSS] > 1.0);
    assert_true(shiny[LAB_TRAIT_SHARPNESS] > red[LAB_TRAIT_SHARPNESS]);
}

static int stop_at_once(size_t done, size_t count, void *data)
{
    (void)done;
    (void)count;
    (void)data;
    return 1;
}

static void test_failures(void **state)
{
    (void)state;
    static const char *const same[] = {"diffuse", "diffuse", "diffuse"};
    static const char *const missing[] = {"diffuse", "phong", "/nonexistent.binary"};
    struct lab_basis *basis = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(lab_basis_create(same, 2, 1, NULL, NULL, &basis, &error), BRDF_BAD_ARGUMENT);
    assert_int_equal(lab_basis_create(same, 3, 1, NULL, NULL, &basis, &error), BRDF_UNSUPPORTED);
    assert_int_equal(lab_basis_create(missing, 3, 1, NULL, NULL, &basis, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "/nonexistent.binary"));
    assert_int_equal(lab_basis_create(same, 3, 1, stop_at_once, NULL, &basis, &error),
                     BRDF_CANCELLED);
    assert_null(basis);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_components),
        cmocka_unit_test(test_project),
        cmocka_unit_test(test_place),
        cmocka_unit_test(test_trait),
        cmocka_unit_test(test_traits_of_known_materials),
        cmocka_unit_test(test_failures),
    };
    return cmocka_run_group_tests(tests, basis_make, basis_end);
}
