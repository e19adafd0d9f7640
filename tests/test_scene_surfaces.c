/* test_scene_surfaces.c - materials, emitters and environments of scenes. */
#define _POSIX_C_SOURCE 200809L
#include "scene_files.h"

#include <locale.h>
#include <math.h>

#include <brdf/info.h>
#include <brdf/model.h>

/* The material of a primitive. */
static const struct brdf_material *material_of(const struct brdfcl_scene *scene, size_t primitive)
{
    int surface = scene_row_int(scene_row(scene, primitive), PT_SURFACE);
    assert_in_range(surface, 0, (int)scene->surface_count - 1);
    return brdf_bsdf_material(scene->surfaces[surface].bsdf);
}

static const float *radiance_of(const struct brdfcl_scene *scene, size_t primitive)
{
    return scene->surfaces[scene_row_int(scene_row(scene, primitive), PT_SURFACE)].radiance;
}

/* The first word of a parameter. */
static float value_of(const struct brdf_material *material, const char *name)
{
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    return material->word[brdf_parameter_place(model, brdf_parameter_find(model, name))];
}

/* The option that is chosen. */
static const char *choice_of(const struct brdf_material *material, const char *name)
{
    static char item[32];
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    const struct brdf_parameter_info *parameter = brdf_parameter_find(model, name);
    int place = brdf_parameter_place(model, parameter);
    int number = (int)(material->choices >> (4 * place) & 15u);
    assert_int_equal(brdf_parameter_item(parameter, number, item, sizeof item), 1);
    return item;
}

static void equal_surfaces_are_one(void **state)
{
    struct brdfcl_scene *scene = scene_content_load(
        "<bsdf type=\"diffuse\" id=\"a\"><rgb name=\"reflectance\" value=\"0.25\"/></bsdf>"
        "<bsdf type=\"diffuse\" id=\"b\"><float name=\"reflectance\" value=\"0.25\"/></bsdf>"
        "<shape type=\"disk\"><ref id=\"a\"/></shape>"
        "<shape type=\"disk\"><ref id=\"b\"/></shape>"
        "<shape type=\"disk\"><bsdf type=\"diffuse\">"
        "<rgb name=\"reflectance\" value=\"0.25 0.25, 0.25\"/></bsdf></shape>"
        "<shape type=\"disk\"><ref id=\"a\"/><emitter type=\"area\"/></shape>"
        "<shape type=\"disk\"><ref id=\"a\"/><emitter type=\"area\">"
        "<rgb name=\"radiance\" value=\"1\"/></emitter></shape>"
        "<shape type=\"disk\"><ref id=\"a\"/><emitter type=\"area\">"
        "<rgb name=\"radiance\" value=\"0\"/></emitter></shape>"
        "<shape type=\"disk\"><ref id=\"later\"/></shape>"
        "<bsdf type=\"diffuse\" id=\"later\"/><shape type=\"cube\"/>");
    static const int expected[] = {0, 0, 0, 1, 1, 0, 2, 2, 2};
    (void)state;
    assert_int_equal(scene->surface_count, 3);
    assert_int_equal(scene->bsdf_count, 2);
    for (size_t i = 0; i < 9; ++i) {
        assert_int_equal(scene_row_int(scene_row(scene, i), PT_SURFACE), expected[i]);
    }
    assert_false(scene->surfaces[0].emits);
    assert_true(scene->surfaces[1].emits);
    assert_true(value_of(material_of(scene, 0), "reflectance") == 0.25f);
    assert_true(value_of(material_of(scene, 6), "reflectance") == 0.5f);
    brdfcl_scene_destroy(scene);
}

static void emitting_shapes_are_black_by_default(void **state)
{
    struct brdfcl_scene *scene = scene_content_load(
        "<shape type=\"disk\"><emitter type=\"area\"/></shape><shape type=\"disk\"/>");
    (void)state;
    assert_true(value_of(material_of(scene, 0), "reflectance") == 0.0f);
    assert_true(value_of(material_of(scene, 1), "reflectance") == 0.5f);
    brdfcl_scene_destroy(scene);
}

static void colours(void **state)
{
    struct brdfcl_scene *scene =
        scene_content_load("<shape type=\"disk\"><emitter type=\"area\">"
                           "<rgb name=\"radiance\" value=\"1, 2.5, 3e1\"/></emitter></shape>"
                           "<shape type=\"disk\"><emitter type=\"area\">"
                           "<rgb name=\"radiance\" value=\"#ff8000\"/></emitter></shape>"
                           "<shape type=\"disk\"><emitter type=\"area\">"
                           "<spectrum name=\"radiance\" value=\"2\"/></emitter></shape>"
                           "<shape type=\"disk\"><emitter type=\"area\">"
                           "<float name=\"radiance\" value=\"2\"/></emitter></shape>");
    (void)state;
    assert_vector(radiance_of(scene, 0), 0, 1.0f, 2.5f, 30.0f);
    /* sRGB 128/255 = 0.50196 is ((0.50196 + 0.055) / 1.055)^2.4 = 0.215861 */
    assert_vector(radiance_of(scene, 1), 0, 1.0f, 0.2158605f, 0.0f);
    /* a constant spectrum is not white: what Mitsuba 3.9 makes of it */
    assert_true(fabsf(radiance_of(scene, 2)[0] - 2.40959f) < 1e-5f);
    assert_true(fabsf(radiance_of(scene, 2)[1] - 1.89658f) < 1e-5f);
    assert_true(fabsf(radiance_of(scene, 2)[2] - 1.81783f) < 1e-5f);
    assert_vector(radiance_of(scene, 3), 0, 2.0f, 2.0f, 2.0f);
    brdfcl_scene_destroy(scene);
}

static void parameters(void **state)
{
    struct brdfcl_scene *scene = scene_content_load(
        "<shape type=\"disk\"><bsdf type=\"roughconductor\" name=\"bsdf\">"
        "<string name=\"material\" value=\"Au\"/><float name=\"alpha_u\" value=\"0.3\"/>"
        "<float name=\"alpha_v\" value=\"0.05\"/>"
        "<string name=\"distribution\" value=\"beckmann\"/></bsdf></shape>"
        "<shape type=\"disk\"><bsdf type=\"twosided\"><bsdf type=\"roughconductor\">"
        "<rgb name=\"eta\" value=\"1 2 3\"/><rgb name=\"k\" value=\"4\"/>"
        "<float name=\"alpha\" value=\"0.125\"/></bsdf></bsdf></shape>"
        "<shape type=\"disk\"><bsdf type=\"dielectric\">"
        "<string name=\"int_ior\" value=\"water\"/></bsdf></shape>"
        "<shape type=\"disk\"><bsdf type=\"roughconductor\">"
        "<string name=\"distribution\" value=\"ggx\"/></bsdf></shape>");
    const struct brdf_material *m = material_of(scene, 0);
    (void)state;
    assert_int_equal(m->model, BRDF_MODEL_ROUGHCONDUCTOR);
    assert_true(value_of(m, "alpha_u") == 0.3f && value_of(m, "alpha_v") == 0.05f);
    assert_string_equal(choice_of(m, "distribution"), "beckmann");
    assert_int_equal(m->flags & BRDF_TWOSIDED, 0);
    m = material_of(scene, 1);
    assert_true(value_of(m, "eta") == 1.0f && value_of(m, "k") == 4.0f);
    assert_true(value_of(m, "alpha_u") == 0.125f && value_of(m, "alpha_v") == 0.125f);
    assert_int_equal(m->flags & BRDF_TWOSIDED, BRDF_TWOSIDED);
    assert_string_equal(choice_of(material_of(scene, 3), "distribution"), "ggx");
    m = material_of(scene, 2);
    assert_true(value_of(m, "int_ior") > 1.32f && value_of(m, "int_ior") < 1.34f);
    brdfcl_scene_destroy(scene);
}

static void constant_environment(void **state)
{
    struct brdfcl_scene *scene = scene_content_load(
        "<emitter type=\"constant\"><rgb name=\"radiance\" value=\"1 2 3\"/></emitter>");
    (void)state;
    assert_int_equal(scene->environment.kind, ENVIRONMENT_CONSTANT);
    assert_vector(scene->environment.radiance, 0, 1, 2, 3);
    brdfcl_scene_destroy(scene);
}

/* Write a picture beside the scene. */
static void write_picture(const char *name, int width, int height, float value)
{
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_create(&image, width, height, NULL), BRDF_OK);
    for (int i = 0; i < 3 * width * height; ++i) {
        image.rgb[i] = (float)i;
    }
    image.rgb[4] = value;
    assert_int_equal(brdfcl_image_write(&image, scene_file_write(name, ""), NULL, NULL), BRDF_OK);
    brdfcl_image_destroy(&image);
}

static void environment_map(void **state)
{
    struct brdfcl_scene *scene;
    (void)state;
    write_picture("map.exr", 4, 3, 4.0f);
    scene = scene_content_load("<emitter type=\"envmap\">"
                               "<string name=\"filename\" value=\"map.exr\"/>"
                               "<float name=\"scale\" value=\"0.5\"/>"
                               "<transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/>"
                               "</transform></emitter>");
    assert_int_equal(scene->environment.kind, ENVIRONMENT_MAP);
    assert_int_equal(scene->environment.image.width, 4);
    assert_int_equal(scene->environment.image.height, 3);
    assert_true(scene->environment.image.rgb[35] == 17.5f);
    assert_vector(scene->environment.to_world, 0, 0, 0, 1);
    assert_vector(scene->environment.to_world, 3, 0, 1, 0);
    assert_vector(scene->environment.to_world, 6, -1, 0, 0);
    brdfcl_scene_destroy(scene);
}

static void environment_map_refused(void **state)
{
    static const struct {
        int width;
        int height;
        float value;
        const char *says;
    } cases[] = {{1, 3, 0.0f, "2 x 3"},
                 {4, 2, 0.0f, "2 x 3"},
                 {4, 3, -1.0f, "pixel (1, 0)"},
                 {4, 3, INFINITY, "pixel (1, 0)"},
                 {4, 3, NAN, "pixel (1, 0)"}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdfcl_scene *scene = NULL;
        struct brdf_error error = {BRDF_OK, ""};
        write_picture("bad.exr", cases[i].width, cases[i].height, cases[i].value);
        assert_int_equal(
            scene_text_load("<scene version=\"3.0.0\"><sensor type=\"perspective\"/>\n"
                            "<emitter type=\"envmap\">\n"
                            "<string name=\"filename\" value=\"bad.exr\"/></emitter></scene>",
                            NULL, 0, &scene, &error),
            BRDF_BAD_FILE);
        assert_non_null(strstr(error.message, "scene.xml:3:"));
        assert_non_null(strstr(error.message, cases[i].says));
    }
}

/* An application in a language with decimal commas reads the same numbers. */
static void numbers_do_not_depend_on_the_locale(void **state)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "fr_FR"};
    const char *set = NULL;
    struct brdfcl_scene *scene;
    (void)state;
    for (size_t i = 0; i < 4 && !set; ++i) {
        set = setlocale(LC_NUMERIC, names[i]);
    }
    if (!set) {
        skip();
    }
    scene =
        scene_content_load("<shape type=\"sphere\"><float name=\"radius\" value=\"0.5\"/></shape>");
    assert_true(strtod("1,5", NULL) == 1.5); /* and its own are left alone */
    setlocale(LC_NUMERIC, "C");
    assert_true(scene_row(scene, 0)[PT_RADIUS] == 0.5f);
    brdfcl_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_surfaces_are_one),
        cmocka_unit_test(emitting_shapes_are_black_by_default),
        cmocka_unit_test(colours),
        cmocka_unit_test(parameters),
        cmocka_unit_test(constant_environment),
        cmocka_unit_test(environment_map),
        cmocka_unit_test(environment_map_refused),
        cmocka_unit_test(numbers_do_not_depend_on_the_locale),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
