/*
 * test_program_text.c - the text of a program has the models of its materials, and knows the
 * choices that are the same in all of them.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <brdf/model.h>

#include "opencl.h"

static const char surface[] = "#include \"brdf/surface.h\"\n";

static void only_models_that_are_used(void **state)
{
    (void)state;
    struct opencl_materials materials = {0};
    opencl_materials_add(&materials, BRDF_MODEL_PHONG, 0);
    char *text;
    assert_int_equal(opencl_expand(&materials, surface, "test", &text, NULL), BRDF_OK);
    assert_non_null(strstr(text, "brdf_phong_eval("));
    assert_null(strstr(text, "brdf_diffuse_eval("));
    free(text);
}

static void one_material_is_known(void **state)
{
    (void)state;
    struct opencl_materials materials = {0};
    opencl_materials_add(&materials, BRDF_MODEL_ROUGHCONDUCTOR, 0x1021u);
    opencl_materials_add(&materials, BRDF_MODEL_ROUGHCONDUCTOR, 0x1021u);
    char *text;
    assert_int_equal(opencl_expand(&materials, surface, "test", &text, NULL), BRDF_OK);
    assert_non_null(strstr(text, "BRDF_ROUGHCONDUCTOR_KNOWN = (int)0xffffffffu, "
                                 "BRDF_ROUGHCONDUCTOR_CHOSEN = (int)0x1021u"));
    /* Once, before the first model that asks. */
    const char *first = strstr(text, "BRDF_KNOWN(ROUGHCONDUCTOR, p)");
    const char *definition = strstr(text, "#define BRDF_KNOWN(");
    assert_true(first && definition && definition < first);
    assert_null(strstr(definition + 1, "#define BRDF_KNOWN("));
    free(text);
}

/* What differs between two materials is not known, whichever comes first, and stays unknown;
   another model's choices do not matter. */
static void what_differs_is_not(void **state)
{
    (void)state;
    static const unsigned choices[3] = {0x1021u, 0x1030u, 0x1021u};
    struct opencl_materials materials = {0};
    for (int i = 0; i < 3; ++i) {
        opencl_materials_add(&materials, BRDF_MODEL_ROUGHCONDUCTOR, choices[i]);
        opencl_materials_add(&materials, BRDF_MODEL_WARD, 1u);
    }
    assert_int_equal(materials.model[BRDF_MODEL_ROUGHCONDUCTOR].known, 0xffffff00u);
    assert_int_equal(materials.model[BRDF_MODEL_ROUGHCONDUCTOR].chosen & 0xffffff00u, 0x1000u);
    assert_int_equal(materials.model[BRDF_MODEL_WARD].known, 0xffffffffu);
    assert_int_equal(materials.model[BRDF_MODEL_WARD].chosen, 1u);
    assert_false(materials.model[BRDF_MODEL_PHONG].used);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(only_models_that_are_used),
        cmocka_unit_test(one_material_is_known),
        cmocka_unit_test(what_differs_is_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
