/* test_info.c - what the models say of themselves, names that were meant, and statuses. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include <brdf/brdf.h>
#include <brdf/model.h>

/* Holds for every model, the ones to come as well. */
static void models_are_well_formed(void **state)
{
    (void)state;
    assert_int_equal(brdf_model_count(), BRDF_MODEL_COUNT);
    assert_null(brdf_model_info(-1));
    assert_null(brdf_model_info(BRDF_MODEL_COUNT));
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *m = brdf_model_info(tag);
        assert_int_equal(m->tag, tag);
        assert_ptr_equal(brdf_model_find(m->name), m);
        assert_string_equal(brdf_model_nearest(m->name), m->name);
        assert_true(m->flags & (BRDF_REFLECTION | BRDF_TRANSMISSION));
        assert_int_equal(m->flags & 0xffff0000u, 0);
        assert_true(strlen(m->summary) > 0 && strlen(m->reference) > 0);
        int files = 0;
        for (size_t i = 0; i < m->parameter_count; ++i) {
            files += m->parameters[i].kind == BRDF_KIND_FILE;
        }
        assert_int_equal(files > 0, (m->flags & BRDF_TABULATED) != 0);
    }
}

/* An alias leads to its model, and is nobody's own name. */
static void aliases_lead_to_models(void **state)
{
    (void)state;
    const struct brdf_model_info *orennayar = brdf_model_find("orennayar");
    int aliases = 0;
    assert_ptr_equal(brdf_model_find("roughdiffuse"), orennayar);
    assert_string_equal(brdf_model_alias(orennayar, 0), "roughdiffuse");
    assert_string_equal(brdf_model_nearest("roughdifuse"), "roughdiffuse");
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *model = brdf_model_info(tag);
        const char *alias;
        for (int i = 0; (alias = brdf_model_alias(model, i)) != NULL; ++i, ++aliases) {
            assert_ptr_equal(brdf_model_find(alias), model);
            assert_string_not_equal(alias, model->name);
        }
    }
    assert_true(aliases >= 1);
    struct brdf_bsdf *bsdf;
    char text[512];
    assert_int_equal(brdf_bsdf_create("roughdiffuse:reflectance=0.3", &bsdf, NULL), BRDF_OK);
    brdf_bsdf_describe(bsdf, text, sizeof text);
    assert_int_equal(strncmp(text, "orennayar:", 10), 0); /* its own name comes out */
    brdf_bsdf_destroy(bsdf);
}

static int words_of(int kind)
{
    return kind == BRDF_KIND_REAL ? 1 : kind == BRDF_KIND_COLOR ? 3 : 0;
}

static void check_parameter(const struct brdf_model_info *m, const struct brdf_parameter_info *p)
{
    char item[64];
    int count = 0;
    assert_ptr_equal(brdf_parameter_find(m, p->name), p);
    assert_true(strlen(p->meaning) > 0);
    if (words_of(p->kind)) {
        assert_true(p->low <= p->initial && p->initial <= p->high);
    }
    while (brdf_parameter_item(p, count, item, sizeof item)) {
        assert_true(p->kind != BRDF_KIND_ALIAS || brdf_parameter_find(m, item));
        ++count;
    }
    if (p->kind == BRDF_KIND_CHOICE) {
        assert_in_range(count, 2, 16);
        assert_true((int)p->initial < count);
    } else if (p->kind == BRDF_KIND_METAL) {
        assert_non_null(brdf_metal_find(p->initial_text));
        assert_int_equal(brdf_parameter_find(m, "eta")->kind, BRDF_KIND_COLOR);
        assert_int_equal(brdf_parameter_find(m, "k")->kind, BRDF_KIND_COLOR);
    } else {
        assert_int_equal(count > 0, p->kind == BRDF_KIND_ALIAS);
    }
}

static void parameters_are_well_formed(void **state)
{
    (void)state;
    for (int tag = 0; tag < brdf_model_count(); ++tag) {
        const struct brdf_model_info *m = brdf_model_info(tag);
        int words = 0, choices = 0;
        for (size_t i = 0; i < m->parameter_count; ++i) {
            const struct brdf_parameter_info *p = &m->parameters[i];
            int place = p->kind == BRDF_KIND_CHOICE ? choices++ : words_of(p->kind) ? words : -1;
            assert_int_equal(brdf_parameter_place(m, p), place);
            words += words_of(p->kind);
            check_parameter(m, p);
        }
        assert_true(words <= BRDF_MATERIAL_WORDS && choices <= 8);
    }
}

static void one_parameter_in_full(void **state)
{
    (void)state;
    const struct brdf_model_info *m = brdf_model_find("roughconductor");
    const struct brdf_parameter_info *p = brdf_parameter_find(m, "alpha_v");
    char item[64];
    assert_int_equal(p->kind, BRDF_KIND_REAL);
    assert_string_equal(brdf_kind_name(p->kind), "real");
    assert_true(p->initial == 0.1f && p->low == 1e-4f && p->high == 2.0f);
    assert_int_equal(brdf_parameter_place(m, p), 7);
    assert_int_equal(brdf_parameter_item(brdf_parameter_find(m, "alpha"), 1, item, sizeof item), 1);
    assert_string_equal(item, "alpha_v");
    assert_int_equal(brdf_parameter_item(p, 0, item, sizeof item), 0);
    assert_string_equal(brdf_parameter_find(m, "material")->initial_text, "Cu");
    assert_string_equal(brdf_parameter_nearest(m, "alpha_w"), "alpha_u");
    assert_null(brdf_parameter_find(m, "alph"));
    assert_string_equal(brdf_kind_name(99), "unknown");
}

static void names_that_were_meant(void **state)
{
    (void)state;
    const char *const names[] = {"diffuse", "roughconductor", "ggx"};
    char longest[300];
    memset(longest, 'd', sizeof longest);
    longest[sizeof longest - 1] = '\0';
    assert_string_equal(brdf_name_nearest("difuse", names, 3), "diffuse");        /* deletion */
    assert_string_equal(brdf_name_nearest("diffusee", names, 3), "diffuse");      /* insertion */
    assert_string_equal(brdf_name_nearest("roughconducter", names, 3), names[1]); /* replacement */
    assert_string_equal(brdf_name_nearest("idffuse", names, 3), "diffuse");       /* exchange */
    assert_string_equal(brdf_name_nearest("GGX", names, 3), "ggx");
    assert_null(brdf_name_nearest("plastic", names, 3));
    assert_null(brdf_name_nearest("", names, 3));
    assert_null(brdf_name_nearest("ggx", names, 2));
    assert_null(brdf_name_nearest(longest, names, 3));
    assert_null(brdf_name_nearest("ggx", NULL, 0));
}

static void statuses_have_sentences(void **state)
{
    (void)state;
    struct brdf_error error = {0};
    char longest[3000];
    memset(longest, 'x', sizeof longest);
    longest[sizeof longest - 1] = '\0';
    for (int status = 0; status < BRDF_STATUS_COUNT; ++status) {
        assert_true(strlen(brdf_status_text(status)) > 0);
    }
    assert_string_equal(brdf_status_text(BRDF_OK), "success");
    assert_string_equal(brdf_status_text(-1), brdf_status_text(BRDF_STATUS_COUNT));
    assert_int_equal(brdf_fail(NULL, BRDF_IO, "%d", 1), BRDF_IO);
    assert_int_equal(brdf_fail(&error, BRDF_IO, "%s:%d", "a", 7), BRDF_IO);
    assert_int_equal(error.status, BRDF_IO);
    assert_string_equal(error.message, "a:7");
    brdf_fail(&error, BRDF_IO, "%s", longest);
    assert_int_equal(strlen(error.message), sizeof error.message - 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_are_well_formed),     cmocka_unit_test(aliases_lead_to_models),
        cmocka_unit_test(parameters_are_well_formed), cmocka_unit_test(one_parameter_in_full),
        cmocka_unit_test(names_that_were_meant),      cmocka_unit_test(statuses_have_sentences),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
