/*
 * test_tilt.c - normalmap and bumpmap, and forks that ask where a path is: textured weights, sides.
 *
 * Under a sky of 1, a diffuse card whose normal is tilted by a constant angle has a radiance that
 * an integral over the directions above both planes gives.
 */
#include "angle.h"
#include "render_scenes.h"

#include <math.h>

#define SKY "<emitter type='constant'><rgb name='radiance' value='1'/></emitter>\n"
#define GRAY(value) "<bsdf type='diffuse'><rgb name='reflectance' value='" value "'/></bsdf>"
#define WHITE GRAY("1")
#define TWOSIDED(a) "<bsdf type='twosided'>" a "</bsdf>"
#define CARD(bsdf) "<shape type='rectangle'>" bsdf "</shape>\n"
#define BALL(bsdf) "<shape type='sphere'>" bsdf "</shape>\n"
#define DISK(moved, bsdf)                                                                          \
    "<shape type='disk'><transform name='to_world'>" moved "</transform>" bsdf "</shape>\n"
#define OFF(name) "<boolean name='" name "' value='false'/>"
#define NORMAL(inside)                                                                             \
    "<bsdf type='normalmap'><texture type='bitmap' name='normalmap'>"                              \
    "<string name='filename' value='normal.exr'/></texture>" inside "</bsdf>"
#define BUMP(scale, inside)                                                                        \
    "<bsdf type='bumpmap'><texture type='bitmap'><string name='filename' value='ramp.exr'/>"       \
    "</texture><float name='scale' value='" scale "'/>" inside "</bsdf>"
#define CHECKS                                                                                     \
    "type='checkerboard'><rgb name='color0' value='0'/><rgb name='color1' value='1'/></texture>"

/* An image of 4 x 4 whose columns go from `from` by `step`. */
static void write_columns(const char *name, const float from[3], const float step[3])
{
    struct brdfcl_image image;
    struct brdf_error error;
    assert_int_equal(brdfcl_image_create(&image, 4, 4, &error), BRDF_OK);
    for (int i = 0; i < 4 * 4 * 3; ++i) {
        image.rgb[i] = from[i % 3] + step[i % 3] * (float)(i / 3 % 4);
    }
    assert_int_equal(brdfcl_image_write(&image, scene_file_write(name, ""), NULL, &error), BRDF_OK);
    brdfcl_image_destroy(&image);
}

/* A normal tilted by `angle` [rad] towards u, as colours. */
static void write_normal(double angle)
{
    const float flat[3] = {0.0f, 0.0f, 0.0f};
    const float color[3] = {(float)(0.5 + 0.5 * sin(angle)), 0.5f, (float)(0.5 + 0.5 * cos(angle))};
    write_columns("normal.exr", color, flat);
}

/* The integral of cos' / pi over directions above the card and above the tilted plane, with what
   facets leave of it if they shadow each other. */
static double expected(double angle, int shadow)
{
    const int steps = 400;
    double alpha2 = shadow ? fmin(0.125 * tan(angle) * tan(angle), 1.0) : 0.0;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        double z = (i + 0.5) / steps;
        double r = sqrt(1.0 - z * z);
        double factor = 2.0 / (1.0 + sqrt(1.0 + alpha2 * r * r / (z * z)));
        for (int k = 0; k < steps; ++k) {
            double x = r * cos(2.0 * pi * (k + 0.5) / steps);
            sum += factor * fmax(x * sin(angle) + z * cos(angle), 0.0);
        }
    }
    return sum * 2.0 / ((double)steps * steps);
}

static void check(const char *name, const char *from, const char *bsdf, double value)
{
    const struct view view = {from, "0, 0, 0", 1.0, 24, 64, 2, 0, NULL, NULL};
    char content[2048];
    snprintf(content, sizeof content, SKY CARD("%s"), bsdf);
    assert_estimate(name, render_estimate(&view, content), value, 1e-3, 1e-2);
}

static void normal_maps(void **state)
{
    static const double angles[] = {0.0, 0.3, 0.8, 1.3};
    (void)state;
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; ++i) {
        double angle = angles[i];
        write_normal(angle);
        assert_true(fabs(expected(angle, 0) - 0.5 * (1.0 + cos(angle))) < 1e-4);
        check("plain", "0, 0, 4", NORMAL(OFF("use_shadowing_function") WHITE), expected(angle, 0));
        check("shadowed", "0, 0, 4", NORMAL(WHITE), expected(angle, 1));
        check("two-sided inside", "0, 0, -4", NORMAL(TWOSIDED(WHITE)), expected(angle, 1));
        check("two-sided outside", "0, 0, -4", TWOSIDED(NORMAL(WHITE)), expected(angle, 1));
        check("one side", "0, 0, -4", NORMAL(WHITE), 0.0);
    }
}

/* Seen so obliquely that the normal faces away, it is mirrored: towards the viewer. */
static void normals_that_face_away(void **state)
{
    (void)state;
    write_normal(1.0);
    check("towards", "3, 0, 1", NORMAL(WHITE), expected(1.0, 1));
    check("mirrored", "-3, 0, 1", NORMAL(WHITE), expected(1.0, 1));
    check("left as it is", "-3, 0, 1", NORMAL(OFF("flip_invalid_normals") WHITE), 0.0);
}

/* A ramp: between the outer texels' centres it rises by 0.1 a texel, 4 texels over 2 units. */
static void bump_maps(void **state)
{
    const float from[3] = {0.0f, 0.0f, 0.0f};
    const float step[3] = {0.1f, 0.1f, 0.1f};
    (void)state;
    write_columns("ramp.exr", from, step);
    check("ramp", "0, 0, 4", BUMP("1", WHITE), expected(atan(0.2), 1));
    check("steep", "0, 0, 4", BUMP("-5", WHITE), expected(atan(1.0), 1));
    check("no height", "0, 0, 4", BUMP("0", WHITE), 1.0);
    check("back", "0, 0, -4", TWOSIDED(BUMP("5", OFF("use_shadowing_function") WHITE)),
          expected(atan(1.0), 0));
}

/* The back of a two-sided map is the mirror image of its front: so it is under mirrored light. */
static void backs_are_mirror_images(void **state)
{
#define LIT(z, bsdf)                                                                               \
    "<shape type='sphere'><point name='center' x='3' y='1' z='" z "'/>"                            \
    "<float name='radius' value='0.5'/>"                                                           \
    "<emitter type='area'><rgb name='radiance' value='9'/></emitter></shape>" CARD(bsdf)
    const struct view front = {"0, 0, 4", "0, 0, 0", 1.0, 24, 64, 2, 0, NULL, NULL};
    const struct view back = {"0, 0, -4", "0, 0, 0", 1.0, 24, 64, 2, 0, NULL, NULL};
    (void)state;
    write_normal(0.5);
    struct estimate seen = render_estimate(&front, LIT("2", TWOSIDED(NORMAL(WHITE))));
    struct estimate flat = render_estimate(&front, LIT("2", WHITE));
    assert_true(seen.mean > 1.2 * flat.mean);
    assert_estimate("outside", render_estimate(&back, LIT("-2", TWOSIDED(NORMAL(WHITE)))),
                    seen.mean, 1e-3, 1e-2);
    /* Inside, the tilted frame as a whole has two sides, and the back leans the other way. */
    struct estimate inside = render_estimate(&back, LIT("-2", NORMAL(TWOSIDED(WHITE))));
    assert_true(inside.mean < 0.9 * flat.mean);
}

static void forks_by_place(void **state)
{
    (void)state;
#define AT(place, bsdf, value)                                                                     \
    do {                                                                                           \
        const struct view view = {place ", 4", place ", 0", 1.0, 16, 64, 4, 0, NULL, NULL};        \
        assert_estimate(bsdf, render_estimate(&view, SKY CARD(bsdf)), value, 1e-5, 1e-2);          \
    } while (0)
#define CHECKED                                                                                    \
    "<bsdf type='blendbsdf'><texture name='weight' " CHECKS GRAY("0.8") GRAY("0.3") "</bsdf>"
#define HOLED "<bsdf type='mask'><texture name='opacity' " CHECKS GRAY("0.6") "</bsdf>"
    AT("-0.5, -0.5", CHECKED, 0.8);
    AT("0.5, -0.5", CHECKED, 0.3);
    AT("0.5, 0.5", CHECKED, 0.8);
    AT("-0.5, -0.5", HOLED, 1.0);
    AT("0.5, -0.5", HOLED, 0.6);
    check("front", "1, 0, 4", TWOSIDED(GRAY("0.8") GRAY("0.3")), 0.8);
    check("back", "1, 0, -4", TWOSIDED(GRAY("0.8") GRAY("0.3")), 0.3);
    check("back of a map", "0, 0, -4", TWOSIDED(GRAY("0.8") BUMP("0", GRAY("0.3"))), 0.3);
}

/* All kinds of composition in one scene, as compiling kernels takes most of the time. */
static void same_bits_at_all_lanes(void **state)
{
    static const int lane_counts[] = {1, 4, 8, 16};
    const float from[3] = {0.3f, 0.4f, 0.9f};
    const float step[3] = {0.1f, 0.05f, 0.02f};
    const struct view view = {NULL, NULL, 0, 40, 6, 6, 3, "multijitter", "gaussian"};
    (void)state;
    if (brdfcl_device_count() == 0) {
        print_message("    skipped, no OpenCL device\n");
        skip();
    }
    write_columns("normal.exr", from, step);
    write_columns("ramp.exr", from, step);
#define MASKED                                                                                     \
    "<bsdf type='mask'><bsdf type='blendbsdf'><float name='weight' value='0.3'/>"                  \
    "<bsdf type='mask'>" WHITE "</bsdf>" GRAY("0.3") "</bsdf></bsdf>"
    struct brdfcl_scene *scene = render_scene_load(
        &view, SKY CARD(CHECKED) BALL(TWOSIDED(NORMAL(WHITE) BUMP("0.5", GRAY("0.3"))))
                   DISK("<rotate y='1' angle='60'/>", BUMP("2", GRAY("0.3")))
                       DISK("<translate z='1.5'/>", MASKED));
    const struct renderer in_c = {0, 0, 0};
    unsigned long long hash = render_hash(&in_c, scene);
    for (size_t i = 0; i < sizeof lane_counts / sizeof lane_counts[0]; ++i) {
        const struct renderer who = {lane_counts[i], 0, 0};
        if (render_hash(&who, scene) != hash) {
            fail_msg("%d lanes: another picture than C's", lane_counts[i]);
        }
    }
    brdfcl_scene_destroy(scene);
}

static void remarks(void **state)
{
    (void)state;
    write_normal(0.2);
    scene_file_write("colors.png", "");
    struct brdfcl_image image;
    struct brdf_error error;
    assert_int_equal(brdfcl_image_create(&image, 2, 2, &error), BRDF_OK);
    assert_int_equal(brdfcl_image_write(&image, scene_file_write("colors.png", ""), NULL, &error),
                     BRDF_OK);
    brdfcl_image_destroy(&image);
    struct brdfcl_scene *scene = scene_content_load(
        CARD("<bsdf type='normalmap'><texture type='bitmap' name='normalmap'>"
             "<string name='filename' value='colors.png'/></texture>" WHITE "</bsdf>")
            CARD("<bsdf type='bumpmap'><texture type='bitmap'><string name='filter_type' "
                 "value='nearest'/><string name='filename' value='colors.png'/></texture>" WHITE
                 "</bsdf>"));
    assert_true(scene_has_note(scene, "raw = true"));
    assert_true(scene_has_note(scene, "flat"));
    brdfcl_scene_destroy(scene);
}

static void mistakes(void **state)
{
#define PLAIN(tag, name) "<bsdf type='" tag "'><texture " name " " CHECKS
    static const struct {
        const char *bsdf;
        brdf_status status;
        const char *says;
    } list[] = {
        {"<bsdf type='normalmap'>" WHITE "</bsdf>", BRDF_BAD_FILE, "name=\"normalmap\""},
        {"<bsdf type='bumpmap'>" WHITE "</bsdf>", BRDF_BAD_FILE, "needs a <texture>"},
        {PLAIN("normalmap", "name='normals'") WHITE "</bsdf>", BRDF_UNKNOWN_NAME, "normalmap"},
        {PLAIN("normalmap", "") WHITE "</bsdf>", BRDF_BAD_FILE, "needs a name"},
        {PLAIN("normalmap", "name='normalmap'") "</bsdf>", BRDF_BAD_FILE, "one <bsdf>, not none"},
        {PLAIN("bumpmap", "") WHITE "</bsdf>", BRDF_UNSUPPORTED, "must be a bitmap"},
        {NORMAL(BUMP("1", WHITE)), BRDF_UNSUPPORTED, "a bumpmap in a normalmap"},
        {NORMAL(HOLED), BRDF_UNSUPPORTED, "put the normalmap into the mask"},
        {NORMAL(TWOSIDED(WHITE WHITE)), BRDF_UNSUPPORTED, "put a normalmap into each side"},
        {TWOSIDED(NORMAL("<bsdf type='dielectric'/>")), BRDF_BAD_ARGUMENT, "leave out twosided"},
        {TWOSIDED(WHITE WHITE WHITE), BRDF_BAD_FILE, "one more"},
        {PLAIN("mask", "name='opacity'") "<float name='opacity' value='0.5'/>" WHITE "</bsdf>",
         BRDF_BAD_FILE, "given already, in line 3"},
        {"<bsdf type='mask'><texture name='opacity' type='checkerboard'>"
         "<rgb name='color0' value='2'/></texture>" WHITE "</bsdf>",
         BRDF_OUT_OF_RANGE, "expected 0 to 1"},
        {"<bsdf type='normalmap'><float name='scale' value='1'/></bsdf>", BRDF_UNKNOWN_NAME,
         "scale"},
    };
    char text[2048];
    (void)state;
    write_columns("ramp.exr", (const float[3]){0.0f, 0.0f, 0.0f},
                  (const float[3]){0.1f, 0.1f, 0.1f});
    for (size_t i = 0; i < sizeof list / sizeof list[0]; ++i) {
        struct brdfcl_scene *scene = NULL;
        struct brdf_error error = {BRDF_OK, ""};
        snprintf(text, sizeof text,
                 "<scene version='3.0.0'>\n<integrator type='path'/><sensor type='perspective'/>\n"
                 "%s</scene>",
                 list[i].bsdf);
        brdf_status status = scene_text_load(text, NULL, 0, &scene, &error);
        if (status != list[i].status || scene || !strstr(error.message, list[i].says) ||
            !strstr(error.message, "scene.xml:3:")) {
            fail_msg("%s\n-> status %d, \"%s\"\nexpected %d, \"%s\"", text, status, error.message,
                     list[i].status, list[i].says);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normal_maps),    cmocka_unit_test(normals_that_face_away),
        cmocka_unit_test(bump_maps),      cmocka_unit_test(backs_are_mirror_images),
        cmocka_unit_test(forks_by_place), cmocka_unit_test(same_bits_at_all_lanes),
        cmocka_unit_test(remarks),        cmocka_unit_test(mistakes),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
