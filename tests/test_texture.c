/*
 * test_texture.c - textures looked up, against their definition.
 */
#include "texture_stage.h"

#include <float.h>
#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* A picture whose texels are all different. */
enum { WIDTH = 7, HEIGHT = 5 };

static int code_of(int x, int y, int channel)
{
    return (x * 37 + y * 61 + channel * 85 + 3) % 256;
}

/* IEC 61966-2-1. */
static double from_srgb(double x)
{
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

static void write_pictures(void)
{
    struct brdfcl_image image;
    struct brdf_error error;
    assert_int_equal(brdfcl_image_create(&image, WIDTH, HEIGHT, &error), BRDF_OK);
    for (int i = 0; i < WIDTH * HEIGHT * 3; ++i) {
        int texel = i / 3;
        image.rgb[i] = (float)from_srgb(code_of(texel % WIDTH, texel / WIDTH, i % 3) / 255.0);
    }
    const char *const names[] = {"picture.png", "picture.exr"};
    for (size_t i = 0; i < COUNT(names); ++i) {
        const char *path = scene_file_write(names[i], "");
        if (brdfcl_image_write(&image, path, NULL, &error) != BRDF_OK) {
            fail_msg("%s", error.message);
        }
    }
    brdfcl_image_destroy(&image);
}

static brdf_rgb look_up(const struct stage *stage, int texture, double u, double v)
{
    struct pt_interaction at;
    memset(&at, 0, sizeof at);
    at.u = (float)u;
    at.v = (float)v;
    return pt_texture_eval(stage->w, texture, at);
}

/* --- Bitmaps --- */

static const char *const wraps[] = {"repeat", "mirror", "clamp"};

/* Which texel stands for number i of an endless row. */
static int wrapped(int wrap, int size, int i)
{
    int turn = (int)floor((double)i / size);
    int inside = i - turn * size;
    if (wrap == 2) {
        return i < 0 ? 0 : i >= size ? size - 1 : i;
    }
    return wrap == 1 && turn % 2 != 0 ? size - 1 - inside : inside;
}

static double texel(int wrap, int x, int y, int channel, int raw)
{
    double code = code_of(wrapped(wrap, WIDTH, x), wrapped(wrap, HEIGHT, y), channel) / 255.0;
    return raw ? code : from_srgb(code);
}

static void expect_bitmap(int wrap, int nearest, int raw, double u, double v, double color[3])
{
    double x = u * WIDTH - (nearest ? 0.0 : 0.5);
    double y = v * HEIGHT - (nearest ? 0.0 : 0.5);
    int i = (int)floor(x);
    int j = (int)floor(y);
    double fx = nearest ? 0.0 : x - i;
    double fy = nearest ? 0.0 : y - j;
    for (int c = 0; c < 3; ++c) {
        color[c] = (1.0 - fy) * ((1.0 - fx) * texel(wrap, i, j, c, raw) +
                                 fx * texel(wrap, i + 1, j, c, raw)) +
                   fy * ((1.0 - fx) * texel(wrap, i, j + 1, c, raw) +
                         fx * texel(wrap, i + 1, j + 1, c, raw));
    }
}

static void check_bitmap(const char *file, int wrap, int nearest, int raw)
{
    char content[512];
    struct stage stage;
    int linear = strcmp(file, "picture.exr") == 0;
    snprintf(content, sizeof content,
             "<texture type='bitmap' id='t'><string name='filename' value='%s'/>"
             "<string name='filter_type' value='%s'/><string name='wrap_mode' value='%s'/>"
             "<boolean name='raw' value='%s'/></texture>",
             file, nearest ? "nearest" : "bilinear", wraps[wrap], raw ? "true" : "false");
    stage_open(&stage, content);
    for (int i = 0; i < 61; ++i) {
        for (int j = 0; j < 61; ++j) {
            double u = -2.26 + 0.09177 * i;
            double v = -2.26 + 0.09177 * j;
            double color[3];
            /* raw means nothing to OpenEXR; the picture in it is the decoded one. */
            expect_bitmap(wrap, nearest, raw && !linear, u, v, color);
            assert_color(content, u, v, look_up(&stage, 0, u, v), color);
        }
    }
    stage_close(&stage);
}

static void bitmaps(void **state)
{
    (void)state;
    for (int wrap = 0; wrap < 3; ++wrap) {
        for (int nearest = 0; nearest < 2; ++nearest) {
            check_bitmap("picture.png", wrap, nearest, 0);
            check_bitmap("picture.png", wrap, nearest, 1);
            check_bitmap("picture.exr", wrap, nearest, 0);
            check_bitmap("picture.exr", wrap, nearest, 1);
        }
    }
}

/* However far away, at a NaN even, the value is one of the picture's. */
static void bitmaps_anywhere(void **state)
{
    static const float odd[] = {0.0f,       -0.0f, 1.0f,  -1.0f, 1e-45f,   -1e-30f,  0.99999994f,
                                8388608.0f, 3e9f,  -3e9f, 1e38f, -FLT_MAX, INFINITY, NAN};
    (void)state;
    for (int wrap = 0; wrap < 3; ++wrap) {
        for (int nearest = 0; nearest < 2; ++nearest) {
            char content[256];
            struct stage stage;
            snprintf(content, sizeof content,
                     "<texture type='bitmap' id='t'><string name='filename' value='picture.png'/>"
                     "<string name='filter_type' value='%s'/>"
                     "<string name='wrap_mode' value='%s'/></texture>",
                     nearest ? "nearest" : "bilinear", wraps[wrap]);
            stage_open(&stage, content);
            for (size_t i = 0; i < COUNT(odd) * COUNT(odd); ++i) {
                brdf_rgb c =
                    look_up(&stage, 0, (double)odd[i / COUNT(odd)], (double)odd[i % COUNT(odd)]);
                assert_true(c.r >= 0.0f && c.r <= 1.0f && c.g >= 0.0f && c.g <= 1.0f);
            }
            stage_close(&stage);
        }
    }
}

/* Kept as they are in the file: one word for a texel of 8 bits, four for one of floats. */
static void bitmaps_are_compact(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='bitmap' id='a'><string name='filename' value='picture.png'/>"
                       "</texture><texture type='bitmap' id='b'>"
                       "<string name='filename' value='picture.exr'/></texture>");
    assert_non_null(stage.scene->textures[0].codes);
    assert_null(stage.scene->textures[0].rgb);
    assert_null(stage.scene->textures[1].codes);
    assert_true(pt_texture_at(stage.w, 0)->decode >= 0);
    assert_int_equal(pt_texture_at(stage.w, 1)->decode, -1);
    for (int y = 0; y < HEIGHT; ++y) {
        for (int x = 0; x < WIDTH; ++x) {
            brdf_rgb a = pt_texel(stage.w, pt_texture_at(stage.w, 0), x, y);
            brdf_rgb b = pt_texel(stage.w, pt_texture_at(stage.w, 1), x, y);
            assert_memory_equal(&a, &b, sizeof a);
        }
    }
    stage_close(&stage);
}

/* --- Checkerboard, to_uv --- */

static void checkerboard(void **state)
{
    static const double dark[3] = {0.2, 0.2, 0.2};
    static const double light[3] = {0.4, 0.4, 0.4};
    static const double red[3] = {0.9, 0.1, 0.2};
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='checkerboard' id='plain'/>"
                       "<texture type='checkerboard' id='turned'><rgb name='color1' value='0.9, "
                       "0.1, 0.2'/><transform name='to_uv'><scale x='2' y='3'/>"
                       "<rotate z='1' angle='90'/><translate x='0.25' y='4'/></transform>"
                       "</texture>");
    for (int i = -20; i < 20; ++i) {
        for (int j = -20; j < 20; ++j) {
            double u = 0.13 * i + 0.007;
            double v = 0.13 * j + 0.011;
            int same = (u - floor(u) > 0.5) == (v - floor(v) > 0.5);
            assert_color("plain", u, v, look_up(&stage, 0, u, v), same ? light : dark);
            double s = -3.0 * v + 0.25; /* scaled, turned by 90 degrees, moved */
            double t = 2.0 * u + 4.0;
            same = (s - floor(s) > 0.5) == (t - floor(t) > 0.5);
            assert_color("turned", u, v, look_up(&stage, 1, u, v), same ? light : red);
        }
    }
    stage_close(&stage);
}

static int open_files(void **state)
{
    int status = scene_files_open(state);
    if (!status) {
        write_pictures();
    }
    return status;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bitmaps),
        cmocka_unit_test(bitmaps_anywhere),
        cmocka_unit_test(bitmaps_are_compact),
        cmocka_unit_test(checkerboard),
    };
    return cmocka_run_group_tests(tests, open_files, scene_files_close);
}
