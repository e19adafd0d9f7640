/* test_texture_errors.c - textures that are refused, with the line where the mistake stands. */
#include "scene_files.h"

#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* Every text has its mistake in line 3. */
#define HEAD                                                                                       \
    "<scene version=\"3.0.0\">\n<integrator type=\"path\"/><sensor type=\"perspective\"/>\n"
#define IN_SCENE(inside) HEAD inside "</scene>"
#define BITMAP(inside) IN_SCENE("<texture type=\"bitmap\" id=\"t\">" inside "</texture>")
#define FILE_NAME(name) "<string name=\"filename\" value=\"" name "\"/>"
#define METAL(inside) IN_SCENE("<bsdf type=\"roughconductor\">" inside "</bsdf>")
#define BOARD(name) "<texture type=\"checkerboard\" name=\"" name "\"/>"
#define WOOD(inside) IN_SCENE("<texture type=\"woodgrain\" id=\"w\">" inside "</texture>")

static void textures(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {IN_SCENE("<texture type=\"chekerboard\" id=\"t\"/>"), 3, BRDF_UNKNOWN_NAME,
         "did you mean \"checkerboard\"?"},
        {IN_SCENE("<texture type=\"checkerboard\"><rgb name=\"color2\" value=\"1\"/></texture>"), 3,
         BRDF_UNKNOWN_NAME, "color"},
        {IN_SCENE("<texture type=\"checkerboard\">" BOARD("color0") "</texture>"), 3, BRDF_BAD_FILE,
         "a texture has no place in a checkerboard"},
        {IN_SCENE("<shape type=\"sphere\">" BOARD("radius") "</shape>"), 3, BRDF_BAD_FILE,
         "a texture has no place in a sphere"},
        {IN_SCENE("<shape type=\"sphere\"><emitter type=\"area\">" BOARD(
             "radiance") "</emitter></shape>"),
         3, BRDF_BAD_FILE, "a texture has no place in a area"},
        {IN_SCENE("<texture type=\"checkerboard\" id=\"t\"><transform name=\"to_world\"/>"
                  "</texture>"),
         3, BRDF_UNKNOWN_NAME, "to_world"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void bitmaps(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {BITMAP(""), 3, BRDF_BAD_FILE, "a bitmap needs a filename"},
        {BITMAP("<string name='filename' value=''/>"), 3, BRDF_BAD_FILE,
         "a bitmap needs a filename"},
        {BITMAP(FILE_NAME("missing.png")), 3, BRDF_IO, "missing.png"},
        {BITMAP(FILE_NAME("text.png")), 3, BRDF_BAD_FILE, "text.png"},
        {BITMAP(FILE_NAME("nan.exr")), 3, BRDF_BAD_FILE, "pixel (1, 0)"},
        {BITMAP(FILE_NAME("good.png") "<string name=\"filter_type\" value=\"cubic\"/>"), 3,
         BRDF_UNKNOWN_NAME, "known: bilinear, nearest"},
        {BITMAP(FILE_NAME("good.png") "<string name=\"wrap_mode\" value=\"miror\"/>"), 3,
         BRDF_UNKNOWN_NAME, "did you mean \"mirror\"?"},
        {BITMAP(FILE_NAME("good.png") "<boolean name=\"raw\" value=\"1\"/>"), 3, BRDF_BAD_FILE,
         "neither \"true\" nor \"false\""},
        {BITMAP(FILE_NAME("good.png") "<float name=\"raw\" value=\"1\"/>"), 3, BRDF_BAD_FILE,
         "expected <boolean>"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void parameters(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {METAL(BOARD("alhpa")), 3, BRDF_UNKNOWN_NAME, "did you mean \"alpha\"?"},
        {METAL("<texture type=\"checkerboard\"/>"), 3, BRDF_BAD_FILE, "needs a name"},
        {METAL(BOARD("distribution")), 3, BRDF_BAD_FILE, "\"distribution\" cannot be a <texture>"},
        {METAL(BOARD("material")), 3, BRDF_BAD_FILE, "\"material\" cannot be a <texture>"},
        {METAL(BOARD("alpha") "<float name=\"alpha\" value=\"0.1\"/>"), 3, BRDF_BAD_ARGUMENT,
         "alpha is set twice"},
        {METAL(BOARD("alpha") BOARD("alpha_u")), 3, BRDF_BAD_ARGUMENT, "alpha_u is set"},
        {METAL("<ref id=\"nothing\" name=\"alpha\"/>"), 3, BRDF_UNKNOWN_NAME, "nothing"},
        {METAL("<texture type=\"checkerboard\" name=\"alpha\">"
               "<float name=\"color0\" value=\"3\"/></texture>"),
         3, BRDF_OUT_OF_RANGE, "alpha: the texture's values are 0.2 to 3: expected"},
        {IN_SCENE("<bsdf type=\"merl\">" BOARD("filename") "</bsdf>"), 3, BRDF_BAD_FILE,
         "\"filename\" cannot be a <texture>"},
        {IN_SCENE(
             "<bsdf type=\"twosided\">" BOARD("reflectance") "<bsdf type=\"diffuse\"/></bsdf>"),
         3, BRDF_BAD_FILE, "texture"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void woodgrains(void **state)
{
    static const struct scene_mistake mistakes[] = {
        {WOOD("<string name=\"output\" value=\"colour\"/>"), 3, BRDF_UNKNOWN_NAME,
         "did you mean \"color\"?"},
        {WOOD("<float name=\"ring_width\" value=\"0\"/>"), 3, BRDF_OUT_OF_RANGE, "more than 0"},
        {WOOD("<float name=\"figure\" value=\"70\"/>"), 3, BRDF_OUT_OF_RANGE, "0 to 60"},
        {WOOD("<transform name=\"to_world\"><scale x=\"0\"/></transform>"), 3, BRDF_OUT_OF_RANGE,
         "flattens the log"},
        {METAL("<texture type=\"woodgrain\" name=\"eta\"/>"), 3, BRDF_BAD_FILE,
         "nothing that is meant for \"eta\""},
        {METAL("<texture type=\"woodgrain\" name=\"alpha\"><float name=\"late_alpha\" value=\"9\"/>"
               "</texture>"),
         3, BRDF_OUT_OF_RANGE, "alpha: the texture's values are 0.18 to 9"},
    };
    (void)state;
    scene_mistakes_check(mistakes, COUNT(mistakes));
}

static void write_picture(const char *name, float value)
{
    float pixels[6] = {0.5f, 0.5f, 0.5f, 0.5f, value, 0.5f};
    struct brdfcl_image image = {2, 1, pixels};
    struct brdf_error error;
    if (brdfcl_image_write(&image, scene_file_write(name, ""), NULL, &error) != BRDF_OK) {
        fail_msg("%s", error.message);
    }
}

static int open_files(void **state)
{
    int status = scene_files_open(state);
    if (!status) {
        scene_file_write("text.png", "not a picture");
        write_picture("good.png", 0.5f);
        write_picture("nan.exr", NAN);
    }
    return status;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(textures),
        cmocka_unit_test(bitmaps),
        cmocka_unit_test(parameters),
        cmocka_unit_test(woodgrains),
    };
    return cmocka_run_group_tests(tests, open_files, scene_files_close);
}
