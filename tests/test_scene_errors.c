/* test_scene_errors.c - what is wrong in a scene is refused, with the line where it stands. */
#define _POSIX_C_SOURCE 200809L
#include "scene_files.h"

#include <unistd.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* Every text begins in line 1 and has its mistake in line 3, unless it says otherwise. */
#define HEAD                                                                                       \
    "<scene version=\"3.0.0\">\n<integrator type=\"path\"/><sensor type=\"perspective\"/>\n"
#define SHAPE(inside) HEAD "<shape type=\"sphere\">" inside "</shape></scene>"
#define BSDF(inside) HEAD "<bsdf type=\"roughconductor\">" inside "</bsdf></scene>"
#define TRANSFORM(inside)                                                                          \
    HEAD "<shape type=\"cube\"><transform name=\"to_world\">\n" inside                             \
         "</transform></shape></scene>"
#define SENSOR(inside)                                                                             \
    "<scene version=\"3.0.0\">\n<integrator type=\"path\"/>\n<sensor type=\"perspective\">" inside \
    "</sensor></scene>"
#define FILM(inside) SENSOR("<film type=\"hdrfilm\">" inside "</film>")
#define SAMPLER(inside) SENSOR("<sampler type=\"independent\">" inside "</sampler>")
#define PATH(inside)                                                                               \
    "<scene version=\"3.0.0\">\n<sensor type=\"perspective\"/>\n<integrator type=\"path\">" inside \
    "</integrator></scene>"

static void malformed_xml(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {"", 1, BRDF_BAD_FILE, "no element found"},
        {"hello", 1, BRDF_BAD_FILE, "syntax error"},
        {"<scene version=\"3.0.0\">\n<shape>\n</scene>", 3, BRDF_BAD_FILE, "mismatched tag"},
        {"<scene version=\"3.0.0\">\n\n<shape type=sphere/></scene>", 3, BRDF_BAD_FILE, "not well"},
        {"<scene version=\"3.0.0\">\n", 2, BRDF_BAD_FILE, "no element found"},
        {HEAD "<shape type=\"cube\" type=\"disk\"/></scene>", 3, BRDF_BAD_FILE, "duplicate"},
        {HEAD "radius = 3</scene>", 3, BRDF_BAD_FILE, "text"},
        {"<!DOCTYPE scene>\n<scene version=\"3.0.0\"/>", 1, BRDF_UNSUPPORTED, "DOCTYPE"},
        {"<bsdf version=\"3.0.0\" type=\"diffuse\"/>", 1, BRDF_BAD_FILE, "not <scene>"},
        {"<scene/>", 1, BRDF_BAD_FILE, "version"},
        {"<scene version=\"0.6.0\"/>", 1, BRDF_UNSUPPORTED, "0.6.0"},
        {"<scene version=\"3.0.0\">\n<integrator type=\"path\"/></scene>", 1, BRDF_BAD_FILE,
         "no <sensor>"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void deep_nesting(void **state)
{
    char text[8192] = "";
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error;
    (void)state;
    for (int i = 0; i < 1000; ++i) {
        strcat(text, "<scene>");
    }
    assert_int_equal(scene_text_load(text, NULL, 0, &scene, &error), BRDF_BAD_FILE);
    assert_non_null(strstr(error.message, "nested"));
}

static void unknown_names(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {HEAD "<shap type=\"sphere\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"shape\""},
        {HEAD "<shape typ=\"sphere\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"type\""},
        {HEAD "<shape id=\"a\"/></scene>", 3, BRDF_BAD_FILE, "lacks the attribute \"type\""},
        {HEAD "<shape type=\"spere\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"sphere\""},
        {HEAD "<shape type=\"cylinder\"/></scene>", 3, BRDF_UNKNOWN_NAME, "rectangle"},
        {HEAD "<bsdf type=\"roughconductr\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"roughconductor\""},
        {HEAD "<emitter type=\"sunsky\"/></scene>", 3, BRDF_UNKNOWN_NAME, "envmap"},
        {HEAD "<emitter type=\"constnt\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"constant\""},
        {HEAD "<medium type=\"homogeneous\"/></scene>", 3, BRDF_UNSUPPORTED, "<medium>"},
        {HEAD "<include filename=\"a.xml\"/></scene>", 3, BRDF_UNSUPPORTED, "<include>"},
        {HEAD "<float name=\"x\" value=\"1\"/></scene>", 3, BRDF_UNKNOWN_NAME, "\"x\""},
        {HEAD "<film type=\"hdrfilm\"/></scene>", 3, BRDF_BAD_FILE, "film"},
        {SHAPE("<float name=\"radus\" value=\"1\"/>"), 3, BRDF_UNKNOWN_NAME, "\"radius\""},
        {SHAPE("<float name=\"filename\" value=\"1\"/>"), 3, BRDF_UNKNOWN_NAME, "\"filename\""},
        {SHAPE("<ref id=\"nobody\"/>"), 3, BRDF_UNKNOWN_NAME, "nobody"},
        {SHAPE("<translate x=\"1\"/>"), 3, BRDF_BAD_FILE, "<translate> cannot stand in <shape>"},
        {SHAPE("<emitter type=\"constant\"/>"), 3, BRDF_BAD_FILE, "area"},
        {SHAPE("<sampler type=\"independent\"/>"), 3, BRDF_BAD_FILE, "sampler"},
        {BSDF("<float name=\"alpah\" value=\"1\"/>"), 3, BRDF_UNKNOWN_NAME, "\"alpha\""},
        {BSDF("<string name=\"material\" value=\"Cx\"/>"), 3, BRDF_UNKNOWN_NAME, "Cx"},
        {BSDF("<string name=\"distribution\" value=\"gxg\"/>"), 3, BRDF_UNKNOWN_NAME, "ggx"},
        {TRANSFORM("<translat x=\"1\"/>"), 4, BRDF_UNKNOWN_NAME, "\"translate\""},
        {TRANSFORM("<translate w=\"1\"/>"), 4, BRDF_UNKNOWN_NAME, "\"w\""},
        {SENSOR("<film type=\"specfilm\"/>"), 3, BRDF_UNKNOWN_NAME, "hdrfilm"},
        {SENSOR("<film type=\"hdrfilm\"><rfilter type=\"mitchell\"/></film>"), 3, BRDF_UNKNOWN_NAME,
         "gaussian"},
        {SENSOR("<sampler type=\"halton\"/>"), 3, BRDF_UNKNOWN_NAME, "ldsampler"},
        {SENSOR("<string name=\"fov_axis\" value=\"z\"/><float name=\"fov\" value=\"9\"/>"), 3,
         BRDF_UNKNOWN_NAME, "diagonal"},
        {"<scene version=\"3.0.0\">\n\n<sensor type=\"thinlens\"/></scene>", 3, BRDF_UNKNOWN_NAME,
         "perspective"},
        {"<scene version=\"3.0.0\">\n\n<integrator type=\"volpath\"/></scene>", 3,
         BRDF_UNKNOWN_NAME, "path"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void bad_numbers(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {SHAPE("<float name=\"radius\" value=\"nan\"/>"), 3, BRDF_BAD_FILE, "\"nan\""},
        {SHAPE("<float name=\"radius\" value=\"inf\"/>"), 3, BRDF_BAD_FILE, "\"inf\""},
        {SHAPE("<float name=\"radius\" value=\"1e999\"/>"), 3, BRDF_BAD_FILE, "1e999"},
        {SHAPE("<float name=\"radius\" value=\"1e39\"/>"), 3, BRDF_BAD_FILE, "1e39"},
        {SHAPE("<float name=\"radius\" value=\"1.5m\"/>"), 3, BRDF_BAD_FILE, "1.5m"},
        {SHAPE("<float name=\"radius\" value=\"1 2\"/>"), 3, BRDF_BAD_FILE, "1 2"},
        {SHAPE("<float name=\"radius\" value=\"\"/>"), 3, BRDF_BAD_FILE, "not a finite"},
        {SHAPE("<float name=\"radius\" value=\"0x10\"/>"), 3, BRDF_BAD_FILE, "0x10"},
        {SHAPE("<float name=\"radius\" value=\"-1\"/>"), 3, BRDF_OUT_OF_RANGE, "radius = -1"},
        {SHAPE("<float name=\"radius\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "more than 0"},
        {SHAPE("<string name=\"radius\" value=\"1\"/>"), 3, BRDF_BAD_FILE, "<float>"},
        {SHAPE("<float name=\"radius\" value=\"1\"/>\n<float name=\"radius\" value=\"1\"/>"), 4,
         BRDF_BAD_FILE, "line 3"},
        {SHAPE("<point name=\"center\" x=\"1\" y=\"2\"/>"), 3, BRDF_BAD_FILE, "\"z\""},
        {SHAPE("<point name=\"center\" value=\"1 2\"/>"), 3, BRDF_BAD_FILE, "three"},
        {SHAPE("<point name=\"center\" value=\"1 2 3\" x=\"1\"/>"), 3, BRDF_BAD_FILE, "exclude"},
        {SHAPE("<boolean name=\"flip_normals\" value=\"yes\"/>"), 3, BRDF_BAD_FILE, "\"yes\""},
        {SHAPE("<emitter type=\"area\"><rgb name=\"radiance\" value=\"1 -1 1\"/></emitter>"), 3,
         BRDF_OUT_OF_RANGE, "negative"},
        {SHAPE("<emitter type=\"area\"><rgb name=\"radiance\" value=\"#12345\"/></emitter>"), 3,
         BRDF_BAD_FILE, "#12345"},
        {SHAPE("<emitter type=\"area\"><rgb name=\"radiance\" value=\"1 2\"/></emitter>"), 3,
         BRDF_BAD_FILE, "1 2"},
        {SHAPE("<emitter type=\"area\"><spectrum name=\"radiance\" value=\"400:1 700:2\"/>"
               "</emitter>"),
         3, BRDF_BAD_FILE, "400:1"},
        {BSDF("<float name=\"alpha\" value=\"-0.1\"/>"), 3, BRDF_OUT_OF_RANGE, "-0.1"},
        {BSDF("<float name=\"alpha\" value=\"nan\"/>"), 3, BRDF_BAD_FILE, "nan"},
        {BSDF("<rgb name=\"alpha\" value=\"0.1\"/>"), 3, BRDF_BAD_FILE, "<float>"},
        {BSDF("<string name=\"eta\" value=\"0.1\"/>"), 3, BRDF_BAD_FILE, "<rgb>"},
        {HEAD "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.5 1.5 0.5\"/></bsdf>"
              "</scene>",
         3, BRDF_OUT_OF_RANGE, "reflectance"},
        {TRANSFORM("<rotate angle=\"10\"/>"), 4, BRDF_BAD_FILE, "axis"},
        {TRANSFORM("<rotate y=\"1\" angle=\"ten\"/>"), 4, BRDF_BAD_FILE, "ten"},
        {TRANSFORM("<matrix value=\"1 2 3\"/>"), 4, BRDF_BAD_FILE, "9 or 16"},
        {TRANSFORM("<matrix value=\"1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1\"/>"), 4, BRDF_UNSUPPORTED,
         "last row"},
        {TRANSFORM("<lookat origin=\"1 2 3\" target=\"1 2 3\" up=\"0 1 0\"/>"), 4, BRDF_BAD_FILE,
         "same point"},
        {TRANSFORM("<lookat origin=\"0 0 0\" target=\"0 1 0\" up=\"0 1 0\"/>"), 4, BRDF_BAD_FILE,
         "parallel"},
        {TRANSFORM("<lookat origin=\"0 0\" target=\"0 1 0\"/>"), 4, BRDF_BAD_FILE, "three"},
        {TRANSFORM("<scale x=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "flattens"},
        {SHAPE("<transform name=\"to_world\"><scale x=\"2\"/></transform>"), 3, BRDF_UNSUPPORTED,
         "same factor"},
        {SHAPE("<transform name=\"to_world\"><scale value=\"1e30\"/><scale value=\"1e30\"/>"
               "</transform>"),
         3, BRDF_OUT_OF_RANGE, "overflows"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void absurd_settings(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {FILM("<integer name=\"width\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "width = 0"},
        {FILM("<integer name=\"height\" value=\"-5\"/>"), 3, BRDF_OUT_OF_RANGE, "height = -5"},
        {FILM("<integer name=\"width\" value=\"65537\"/>"), 3, BRDF_OUT_OF_RANGE, "65536"},
        {FILM("<integer name=\"width\" value=\"99999999999999999999\"/>"), 3, BRDF_OUT_OF_RANGE,
         "width"},
        {FILM("<integer name=\"width\" value=\"3.5\"/>"), 3, BRDF_BAD_FILE, "3.5"},
        {FILM("<float name=\"width\" value=\"3\"/>"), 3, BRDF_BAD_FILE, "<integer>"},
        {FILM("<string name=\"component_format\" value=\"float17\"/>"), 3, BRDF_UNKNOWN_NAME,
         "float16"},
        {FILM("<integer name=\"crop_width\" value=\"5\"/>"), 3, BRDF_UNKNOWN_NAME, "crop_width"},
        {FILM("<rfilter type=\"gaussian\"><float name=\"stddev\" value=\"0\"/></rfilter>"), 3,
         BRDF_OUT_OF_RANGE, "stddev"},
        {SAMPLER("<integer name=\"sample_count\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE,
         "sample_count"},
        {SAMPLER("<integer name=\"sample_count\" value=\"16777217\"/>"), 3, BRDF_OUT_OF_RANGE,
         "16777216"},
        {PATH("<integer name=\"max_depth\" value=\"-2\"/>"), 3, BRDF_OUT_OF_RANGE, "max_depth"},
        {PATH("<integer name=\"rr_depth\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "rr_depth"},
        {PATH("<boolean name=\"hide_emitters\" value=\"true\"/>"), 3, BRDF_UNSUPPORTED, "hide"},
        {SENSOR("<float name=\"fov\" value=\"180\"/>"), 3, BRDF_OUT_OF_RANGE, "fov"},
        {SENSOR("<float name=\"fov\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "fov"},
        {SENSOR("<string name=\"focal_length\" value=\"long\"/>"), 3, BRDF_BAD_FILE, "long"},
        {SENSOR("<transform name=\"to_world\"><scale value=\"2\"/></transform>"), 3, BRDF_BAD_FILE,
         "scaled"},
        {SENSOR("<film type=\"hdrfilm\"/><film type=\"hdrfilm\"/>"), 3, BRDF_BAD_FILE, "one film"},
        {HEAD "<emitter type=\"constant\"/>\n<emitter type=\"constant\"/></scene>", 4,
         BRDF_BAD_FILE, "one environment"},
        {HEAD "<emitter type=\"area\"/></scene>", 3, BRDF_BAD_FILE, "<shape>"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void references(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {HEAD "<bsdf type=\"diffuse\" id=\"a\"/>\n<bsdf type=\"diffuse\" id=\"a\"/></scene>", 4,
         BRDF_BAD_FILE, "line 3"},
        {HEAD "<bsdf type=\"twosided\" id=\"a\">\n<ref id=\"a\"/></bsdf></scene>", 4, BRDF_BAD_FILE,
         "contains itself"},
        {HEAD "<bsdf type=\"twosided\" id=\"a\"><ref id=\"b\"/></bsdf>\n"
              "<bsdf type=\"twosided\" id=\"b\"><ref id=\"a\"/></bsdf></scene>",
         4, BRDF_BAD_FILE, "contains itself"},
        {HEAD "<bsdf type=\"twosided\"/></scene>", 3, BRDF_BAD_FILE, "holds one"},
        {HEAD "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/>\n"
              "<bsdf type=\"diffuse\"/></bsdf></scene>",
         4, BRDF_BAD_FILE, "one more"},
        {HEAD "<bsdf type=\"twosided\"><bsdf type=\"dielectric\"/></bsdf></scene>", 3,
         BRDF_BAD_ARGUMENT, "dielectric"},
        {HEAD "<bsdf type=\"diffuse\"><bsdf type=\"diffuse\"/></bsdf></scene>", 3, BRDF_UNSUPPORTED,
         "diffuse"},
        {SHAPE("<bsdf type=\"diffuse\"/>\n<bsdf type=\"diffuse\"/>"), 4, BRDF_BAD_FILE, "one bsdf"},
        {HEAD "<bsdf type=\"diffuse\" id=\"metal\"/>\n<shape type=\"cube\"><ref id=\"metall\"/>"
              "</shape></scene>",
         4, BRDF_UNKNOWN_NAME, "\"metal\""},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void substitution(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {HEAD "<shape type=\"$kind\"/></scene>", 3, BRDF_UNKNOWN_NAME, "$kind"},
        {HEAD "<default name=\"size\" value=\"1\"/>\n<shape type=\"$siz\"/></scene>", 4,
         BRDF_UNKNOWN_NAME, "$size"},
        {HEAD "<default name=\"a\" value=\"1\"/>\n<default name=\"a\" value=\"1\"/></scene>", 4,
         BRDF_BAD_FILE, "twice"},
        {HEAD "<default name=\"r\" value=\"x\"/><shape type=\"sphere\">\n"
              "<float name=\"radius\" value=\"$r\"/></shape></scene>",
         4, BRDF_BAD_FILE, "\"x\""},
    };
    static const struct brdfcl_define unused = {"ssp", "4"};
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error;
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
    assert_int_equal(scene_text_load(HEAD "<default name=\"spp\" value=\"1\"/></scene>", &unused, 1,
                                     &scene, &error),
                     BRDF_UNKNOWN_NAME);
    assert_non_null(strstr(error.message, "\"spp\""));
}

static void missing_files(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {HEAD "<shape type=\"obj\">\n<string name=\"filename\" value=\"no.obj\"/></shape></scene>",
         4, BRDF_IO, "no.obj"},
        {HEAD "<shape type=\"ply\"/></scene>", 3, BRDF_BAD_FILE, "filename"},
        {HEAD "<emitter type=\"envmap\">\n<string name=\"filename\" value=\"no.exr\"/></emitter>"
              "</scene>",
         4, BRDF_IO, "no.exr"},
        {HEAD "<emitter type=\"envmap\">\n<string name=\"filename\" value=\"scene.xml\"/>"
              "</emitter></scene>",
         4, BRDF_BAD_FILE, "scene.xml"},
        {HEAD "<emitter type=\"envmap\"/></scene>", 3, BRDF_BAD_FILE, "filename"},
        {HEAD "<emitter type=\"envmap\"><string name=\"filename\" value=\"a\"/>\n"
              "<transform name=\"to_world\"><scale value=\"2\"/></transform></emitter></scene>",
         4, BRDF_UNSUPPORTED, "scaled"},
        {HEAD "<bsdf type=\"merl\"><string name=\"filename\" value=\"no.binary\"/></bsdf></scene>",
         3, BRDF_IO, "no.binary"},
    };
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error;
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
    assert_int_equal(brdfcl_scene_load("/no/such/scene.xml", NULL, 0, &scene, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "/no/such/scene.xml"));
    assert_null(scene);
    assert_int_equal(brdfcl_scene_load("/", NULL, 0, &scene, &error), BRDF_IO);
    assert_int_equal(brdfcl_scene_load("/no/such/scene.xml", NULL, 0, &scene, NULL), BRDF_IO);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(malformed_xml),   cmocka_unit_test(deep_nesting),
        cmocka_unit_test(unknown_names),   cmocka_unit_test(bad_numbers),
        cmocka_unit_test(absurd_settings), cmocka_unit_test(references),
        cmocka_unit_test(substitution),    cmocka_unit_test(missing_files),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
