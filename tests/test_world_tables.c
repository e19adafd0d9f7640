/*
 * test_world_tables.c - measured materials in scenes: each table is on the device once, and where
 * there is only one it is not even copied.
 */
#define _XOPEN_SOURCE 700

#include "scene_files.h"

#include "bsdf.h"
#include "lab_files.h"
#include "world.h"

static int files_make(void **state)
{
    static const char *const names[] = {"a.binary", "b.binary"};
    static const char *const descriptions[] = {"diffuse:reflectance=0.5", "roughplastic"};
    if (scene_files_open(state)) {
        return -1;
    }
    for (int k = 0; k < 2; ++k) {
        struct brdf_merl_file file = lab_test_bake(descriptions[k]);
        const char *path = scene_file_write(names[k], "");
        assert_int_equal(brdf_merl_write(path, &file, NULL), BRDF_OK);
        brdf_merl_free(&file);
    }
    return 0;
}

#define SPHERE(x, bsdf)                                                                            \
    "<shape type='sphere'><point name='center' x='" x "' y='0' z='0'/>" bsdf "</shape>"
#define MERL(name, scale)                                                                          \
    "<bsdf type='merl'><string name='filename' value='" name "'/>"                                 \
    "<float name='scale' value='" scale "'/></bsdf>"

/* The words of the tables of a scene, and whether they are the bsdf's own memory. */
static size_t words_of(const char *content, int *is_own)
{
    struct brdfcl_scene *scene = scene_content_load(content);
    struct brdf_error error = {BRDF_OK, ""};
    struct world world;
    if (world_create(scene, 1, 1024, &world, &error)) {
        fail_msg("%s", error.message);
    }
    size_t words = world.table_words;
    *is_own = world.own_tables == NULL;
    world_destroy(&world);
    brdfcl_scene_destroy(scene);
    return words;
}

static void one_file_is_one_table(void **state)
{
    (void)state;
    int is_own = 0;
    assert_int_equal(words_of(SPHERE("0", MERL("a.binary", "1")), &is_own), BRDF_MERL_TABLE_WORDS);
    assert_true(is_own);
    assert_int_equal(words_of(SPHERE("0", MERL("a.binary", "1")) SPHERE(
                                  "3", MERL("a.binary", "0.5")) SPHERE("6", MERL("a.binary", "2")),
                              &is_own),
                     BRDF_MERL_TABLE_WORDS);
    assert_true(is_own);
}

static void two_files_are_two_tables(void **state)
{
    (void)state;
    int is_own = 1;
    size_t words = words_of(SPHERE("0", MERL("a.binary", "1")) SPHERE("3", MERL("b.binary", "1"))
                                SPHERE("6", MERL("a.binary", "2")),
                            &is_own);
    assert_in_range(words, 2 * BRDF_MERL_TABLE_WORDS, 2 * BRDF_MERL_TABLE_WORDS + 32);
    assert_false(is_own);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_file_is_one_table),
        cmocka_unit_test(two_files_are_two_tables),
    };
    return cmocka_run_group_tests(tests, files_make, scene_files_close);
}
