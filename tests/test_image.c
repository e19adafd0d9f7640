/* test_image.c - pictures survive their files: values, metadata, every kind of file that is read.
 */
#define _POSIX_C_SOURCE 200809L

#include "image_samples.h"

#include <math.h>
#include <stdarg.h>
#include <unistd.h>

#include <brdfcl/image.h>

static char path_buffer[512];

static const char *in_folder(const char *name)
{
    snprintf(path_buffer, sizeof path_buffer, "%s/%s", place.folder, name);
    return path_buffer;
}

/* Values that a careless writer would change: signs, denormals, infinities, NaN with a payload. */
static struct brdfcl_image make_image(int width, int height)
{
    static const uint32_t hard[] = {0x80000000u, 0x00000001u, 0x7f800000u, 0xff800000u,
                                    0x7fc12345u, 0x7f7fffffu, 0xc2f6e979u, 0x3f800001u};
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_create(&image, width, height, NULL), BRDF_OK);
    for (size_t i = 0; i < (size_t)width * (size_t)height * 3; i++) {
        uint32_t bits = (uint32_t)i * 2654435761u;
        image.rgb[i] = (float)(bits >> 8) * 0x1p-20f;
        if (i % 7 == 3)
            memcpy(&image.rgb[i], &hard[i / 7 % 8], sizeof bits);
    }
    return image;
}

static void float_exr_keeps_every_bit(void **state)
{
    /* One line, less than a chunk of 16 lines, exactly one, and a part of the second. */
    static const int sizes[][2] = {{1, 1}, {5, 3}, {7, 16}, {33, 21}, {1, 40}, {300, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        struct brdfcl_image out = make_image(sizes[i][0], sizes[i][1]), in;
        const char *path = in_folder("bits.ExR");
        assert_int_equal(brdfcl_image_write(&out, path, NULL, NULL), BRDF_OK);
        assert_int_equal(brdfcl_image_read(&in, path, NULL), BRDF_OK);
        assert_int_equal(in.width, out.width);
        assert_int_equal(in.height, out.height);
        assert_memory_equal(in.rgb, out.rgb, (size_t)(out.width * out.height) * 3 * sizeof *in.rgb);
        assert_true(brdfcl_image_hash(&in) == brdfcl_image_hash(&out));
        brdfcl_image_destroy(&in);
        brdfcl_image_destroy(&out);
        assert_int_equal(unlink(path), 0);
    }
}

static void half_exr_rounds_and_clamps(void **state)
{
    struct brdfcl_image out, in;
    struct brdfcl_image_options options = {1, 0.0f, NULL, 0};
    const char *path = in_folder("half.exr");
    (void)state;
    assert_int_equal(brdfcl_image_create(&out, 19, 37, NULL), BRDF_OK);
    size_t count = (size_t)(out.width * out.height) * 3;
    for (size_t i = 0; i < count; i++)
        out.rgb[i] = ldexpf(1.0f + (float)(i * 37 % 1009) / 1009.0f, (int)(i % 29) - 14);
    out.rgb[0] = 1e9f;
    out.rgb[1] = -1e9f;
    out.rgb[2] = INFINITY;
    out.rgb[3] = NAN;
    assert_int_equal(brdfcl_image_write(&out, path, &options, NULL), BRDF_OK);
    assert_int_equal(brdfcl_image_read(&in, path, NULL), BRDF_OK);
    assert_true(in.rgb[0] == 65504.0f && in.rgb[1] == -65504.0f);
    assert_true(in.rgb[2] == INFINITY && isnan(in.rgb[3]));
    int rounded = 0;
    for (size_t i = 4; i < count; i++) {
        /* Eleven bits of mantissa: half a unit of the last place at most. */
        assert_true(fabsf(in.rgb[i] - out.rgb[i]) <= out.rgb[i] * 0x1p-11f);
        rounded += in.rgb[i] != out.rgb[i];
    }
    assert_true(rounded > 0); /* it was indeed half */
    brdfcl_image_destroy(&in);
    brdfcl_image_destroy(&out);
    assert_int_equal(unlink(path), 0);
}

static const struct brdfcl_image_metadata facts[] = {
    {"software", BRDFCL_METADATA_TEXT, {"brdfcl 1.0"}},
    {"spp", BRDFCL_METADATA_INT, {.integer = -256}},
    {"renderSeconds", BRDFCL_METADATA_FLOAT, {.number = 0.1f}},
    {"scene", BRDFCL_METADATA_TEXT, {"caf\xc3\xa9.xml"}},
};
static const struct brdfcl_image_options with_facts = {0, 0.0f, facts, 4};

static void exr_holds_metadata(void **state)
{
    struct brdfcl_image image = make_image(4, 4);
    const char *path = in_folder("facts.exr");
    exr_context_t file;
    exr_attr_chromaticities_t primaries;
    exr_compression_t compression;
    const char *text;
    int32_t length, integer;
    float number;
    (void)state;
    assert_int_equal(brdfcl_image_write(&image, path, &with_facts, NULL), BRDF_OK);
    assert_int_equal(exr_start_read(&file, path, NULL), 0);
    assert_int_equal(exr_attr_get_string(file, 0, "software", &length, &text), 0);
    assert_string_equal(text, "brdfcl 1.0");
    assert_int_equal(exr_attr_get_string(file, 0, "scene", &length, &text), 0);
    assert_string_equal(text, "caf\xc3\xa9.xml");
    assert_int_equal(exr_attr_get_int(file, 0, "spp", &integer), 0);
    assert_int_equal(integer, -256);
    assert_int_equal(exr_attr_get_float(file, 0, "renderSeconds", &number), 0);
    assert_true(number == 0.1f);
    assert_int_equal(exr_attr_get_chromaticities(file, 0, "chromaticities", &primaries), 0);
    assert_true(primaries.red_x == 0.64f && primaries.white_y == 0.329f);
    assert_int_equal(exr_get_compression(file, 0, &compression), 0);
    assert_int_equal(compression, EXR_COMPRESSION_ZIP);
    exr_finish(&file);
    brdfcl_image_destroy(&image);
    assert_int_equal(unlink(path), 0);
}

static void png_holds_metadata(void **state)
{
    struct brdfcl_image image = make_image(4, 4);
    const char *path = in_folder("facts.png");
    png_textp text;
    int count = 0, intent = -1;
    (void)state;
    assert_int_equal(brdfcl_image_write(&image, path, &with_facts, NULL), BRDF_OK);
    FILE *file = fopen(path, "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    assert_non_null(file);
    png_init_io(png, file);
    png_read_info(png, info);
    assert_int_equal(png_get_bit_depth(png, info), 8);
    assert_int_equal(png_get_color_type(png, info), PNG_COLOR_TYPE_RGB);
    assert_true(png_get_sRGB(png, info, &intent) != 0);
    assert_int_equal(png_get_text(png, info, &text, &count), 4);
    static const char *const expected[] = {"brdfcl 1.0", "-256", "0.100000001", "caf\xc3\xa9.xml"};
    for (int i = 0; i < count; i++) {
        assert_string_equal(text[i].key, facts[i].name);
        assert_string_equal(text[i].text, expected[i]);
        assert_int_equal(text[i].compression,
                         i == 3 ? PNG_ITXT_COMPRESSION_NONE : PNG_TEXT_COMPRESSION_NONE);
    }
    png_destroy_read_struct(&png, &info, NULL);
    fclose(file);
    brdfcl_image_destroy(&image);
    assert_int_equal(unlink(path), 0);
}

/* The 8-bit code that a linear value is written as. */
static int png_code(float linear, float exposure)
{
    struct brdfcl_image image;
    struct brdfcl_image_options options = {0, exposure, NULL, 0};
    const char *path = in_folder("code.PNG");
    png_image reader;
    unsigned char codes[3 * 3];
    assert_int_equal(brdfcl_image_create(&image, 3, 1, NULL), BRDF_OK);
    image.rgb[4] = linear; /* green of the middle pixel */
    assert_int_equal(brdfcl_image_write(&image, path, &options, NULL), BRDF_OK);
    memset(&reader, 0, sizeof reader);
    reader.version = PNG_IMAGE_VERSION;
    assert_true(png_image_begin_read_from_file(&reader, path));
    reader.format = PNG_FORMAT_RGB;
    assert_int_equal(PNG_IMAGE_SIZE(reader), sizeof codes);
    assert_true(png_image_finish_read(&reader, NULL, codes, 0, NULL));
    for (int i = 0; i < 9; i++)
        assert_true(i == 4 || codes[i] == 0);
    brdfcl_image_destroy(&image);
    assert_int_equal(unlink(path), 0);
    return codes[4];
}

static void png_codes_are_srgb(void **state)
{
    /* Worked out by hand from the curve; 0.0031308 is its knee. */
    static const struct {
        float linear, exposure;
        int code;
    } known[] = {
        {0.0f, 0.0f, 0},      {0.5f, 0.0f, 188},   {0.18f, 0.0f, 118}, {1.0f, 0.0f, 255},
        {0.001f, 0.0f, 3},    {0.0031f, 0.0f, 10}, {0.2f, 0.0f, 124},  {0.8f, 0.0f, 231},
        {7.0f, 0.0f, 255},    {-1.0f, 0.0f, 0},    {NAN, 0.0f, 0},     {INFINITY, 0.0f, 255},
        {-INFINITY, 0.0f, 0}, {0.25f, 1.0f, 188},  {2.0f, -2.0f, 188}, {0.09f, 1.0f, 118},
        {0.0f, 2000.0f, 0},   {1.0f, -2000.0f, 0},
    };
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++)
        assert_int_equal(png_code(known[i].linear, known[i].exposure), known[i].code);
}

static void png_round_trip_keeps_codes(void **state)
{
    struct brdfcl_image out, in;
    const char *path = in_folder("codes.png");
    (void)state;
    assert_int_equal(brdfcl_image_create(&out, 256, 1, NULL), BRDF_OK);
    for (int i = 0; i < 256; i++) {
        double code = i / 255.0;
        double linear = code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);
        for (int c = 0; c < 3; c++)
            out.rgb[3 * i + c] = (float)linear;
    }
    assert_int_equal(brdfcl_image_write(&out, path, NULL, NULL), BRDF_OK);
    assert_int_equal(brdfcl_image_read(&in, path, NULL), BRDF_OK);
    for (int i = 0; i < 256 * 3; i++)
        assert_true(in.rgb[i] == out.rgb[i]);
    brdfcl_image_destroy(&in);
    brdfcl_image_destroy(&out);
    assert_int_equal(unlink(path), 0);
}

static void hash_is_what_it_says(void **state)
{
    /* FNV-1a of the bytes 01 00 00 00, 01 00 00 00 and three floats, by a separate program. */
    struct brdfcl_image image;
    (void)state;
    assert_int_equal(brdfcl_image_create(&image, 1, 1, NULL), BRDF_OK);
    image.rgb[0] = 1.0f;
    image.rgb[1] = -2.5f;
    image.rgb[2] = 0.1f;
    assert_true(brdfcl_image_hash(&image) == 0xaf8d2e89ea62d3a6ull);
    unsigned long long before = brdfcl_image_hash(&image);
    image.rgb[2] = nextafterf(0.1f, 1.0f);
    assert_true(brdfcl_image_hash(&image) != before);
    brdfcl_image_destroy(&image);
}

static void sizes_are_checked(void **state)
{
    static const int bad[][2] = {{0, 1}, {1, 0}, {-1, 5}, {1 << 20, 257}, {(1 << 20) + 1, 1}};
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        struct brdfcl_image image = {3, 3, &(float){0.0f}};
        struct brdf_error error;
        assert_int_equal(brdfcl_image_create(&image, bad[i][0], bad[i][1], &error),
                         BRDF_OUT_OF_RANGE);
        assert_null(image.rgb);
        assert_int_equal(error.status, BRDF_OUT_OF_RANGE);
    }
    brdfcl_image_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(float_exr_keeps_every_bit), cmocka_unit_test(half_exr_rounds_and_clamps),
        cmocka_unit_test(exr_holds_metadata),        cmocka_unit_test(png_holds_metadata),
        cmocka_unit_test(png_codes_are_srgb),        cmocka_unit_test(png_round_trip_keeps_codes),
        cmocka_unit_test(hash_is_what_it_says),      cmocka_unit_test(sizes_are_checked),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
