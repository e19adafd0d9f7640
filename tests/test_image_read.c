/* test_image_read.c - every kind of OpenEXR and PNG file that is read, and those of real use. */
#define _POSIX_C_SOURCE 200809L

#include "image_samples.h"

#include <math.h>
#include <unistd.h>

#include <brdfcl/image.h>

static const char *const path = place.path;

/*
 * Write the sample, read it, and compare every pixel. Channel holds the index of the sample's
 * channel for red, green and blue; tolerance is what a value may be off by, as a part of it and
 * of 16.
 */
static void check_sample(const struct exr_sample *sample, int r, int g, int b, float tolerance)
{
    const int channel[3] = {r, g, b};
    struct brdfcl_image image;
    struct brdf_error error = {0, ""};
    if (sample->compression == EXR_COMPRESSION_DWAA || sample->compression == EXR_COMPRESSION_DWAB)
        dwa_sample_write(path, sample);
    else
        exr_sample_write(path, sample);
    if (brdfcl_image_read(&image, path, &error) != BRDF_OK)
        fail_msg("%s", error.message);
    assert_int_equal(image.width, sample->display.max.x - sample->display.min.x + 1);
    assert_int_equal(image.height, sample->display.max.y - sample->display.min.y + 1);
    for (int i = 0; i < image.width * image.height * 3; i++) {
        int x = i / 3 % image.width + sample->display.min.x;
        int y = i / 3 / image.width + sample->display.min.y;
        int stored = x >= sample->data.min.x && x <= sample->data.max.x &&
                     y >= sample->data.min.y && y <= sample->data.max.y;
        float expected = stored ? sample_value(channel[i % 3], x, y) : 0.0f;
        if (!(fabsf(image.rgb[i] - expected) <= tolerance * (expected + 16.0f)))
            fail_msg("compression %d type %d tile %d: pixel %d, %d colour %d is %g, not %g",
                     sample->compression, sample->type, sample->tile, x, y, i % 3,
                     (double)image.rgb[i], (double)expected);
    }
    brdfcl_image_destroy(&image);
}

static void every_compression(void **state)
{
    /* How much each may lose on a smooth ramp far from zero, in half and in float. */
    static const struct {
        exr_compression_t compression;
        float half, single;
    } kinds[] = {
        {EXR_COMPRESSION_NONE, 0.0f, 0.0f},  {EXR_COMPRESSION_RLE, 0.0f, 0.0f},
        {EXR_COMPRESSION_ZIPS, 0.0f, 0.0f},  {EXR_COMPRESSION_ZIP, 0.0f, 0.0f},
        {EXR_COMPRESSION_PIZ, 0.0f, 0.0f},   {EXR_COMPRESSION_PXR24, 0.0f, 0x1p-15f},
        {EXR_COMPRESSION_B44, 0.004f, 0.0f}, {EXR_COMPRESSION_B44A, 0.004f, 0.0f},
    };
    (void)state;
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++)
        for (int tile = 0; tile <= 7; tile += 7) {
            struct exr_sample sample = sample_plain(EXR_PIXEL_FLOAT, 16, 13);
            memcpy(sample.channels, (const char *[]){"A", "B", "G", "R"}, 4 * sizeof(char *));
            sample.compression = kinds[i].compression;
            sample.tile = tile;
            check_sample(&sample, 3, 2, 1, kinds[i].single);
            sample.type = EXR_PIXEL_HALF;
            check_sample(&sample, 3, 2, 1, kinds[i].half);
        }
}

static void dwa(void **state)
{
    /* min and max of the data window; the picture is 16 x 16. */
    static const int windows[][4] = {{0, 0, 15, 15}, {3, 4, 9, 12}};
    static const char *const channels[][4] = {{"B", "G", "R", NULL}, {"Y", NULL, NULL, NULL}};
    (void)state;
    for (int i = 0; i < 16; i++) {
        struct exr_sample sample = sample_plain(EXR_PIXEL_FLOAT, 16, 13);
        const int *w = windows[i & 1];
        exr_attr_box2i_t data = {{{{w[0], w[1]}}}, {{{w[2], w[3]}}}};
        sample.data = data;
        sample.display.max.y = 15;
        sample.type = EXR_PIXEL_HALF;
        memcpy(sample.channels, channels[i >> 1 & 1], sizeof channels[0]);
        sample.tile = i & 4 ? 5 : 0;
        sample.compression = i & 8 ? EXR_COMPRESSION_DWAA : EXR_COMPRESSION_DWAB;
        check_sample(&sample, 0, 0, 0, 0.05f);
    }
}

static void every_type_and_set_of_channels(void **state)
{
    static const exr_pixel_type_t types[] = {EXR_PIXEL_UINT, EXR_PIXEL_HALF, EXR_PIXEL_FLOAT};
    static const struct {
        const char *channels[SAMPLE_CHANNELS];
        int r, g, b;
    } sets[] = {
        {{"B", "G", "R"}, 2, 1, 0},
        {{"A", "B", "G", "R"}, 3, 2, 1},
        {{"A", "B", "G", "R", "Z"}, 3, 2, 1},
        {{"B", "G", "R", "Y"}, 2, 1, 0},
        {{"A", "B", "G", "N.X", "N.Y", "N.Z", "R"}, 6, 2, 1},
        {{"Y"}, 0, 0, 0},
        {{"A", "Y"}, 1, 1, 1},
        {{"A", "X", "Y", "Z"}, 2, 2, 2},
    };
    (void)state;
    for (size_t t = 0; t < sizeof types / sizeof types[0]; t++)
        for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++)
            for (int tile = 0; tile <= 4; tile += 4)
                for (int zip = 0; zip <= 1; zip++) {
                    struct exr_sample sample = sample_plain(EXR_PIXEL_FLOAT, 16, 13);
                    memcpy(sample.channels, sets[i].channels, sizeof sample.channels);
                    sample.type = types[t];
                    sample.tile = tile;
                    sample.compression = zip ? EXR_COMPRESSION_ZIP : EXR_COMPRESSION_NONE;
                    check_sample(&sample, sets[i].r, sets[i].g, sets[i].b, 0.0f);
                }
}

static void data_window_is_not_display_window(void **state)
{
    /* min and max of the data window, then of the display window. */
    static const int windows[][8] = {
        {3, 2, 9, 12, 0, 0, 15, 15},  {0, 0, 15, 12, 4, 5, 8, 7},  {0, 0, 9, 9, 5, 5, 14, 12},
        {5, 5, 14, 12, 0, 0, 9, 9},   {5, 6, 6, 8, -3, -4, 20, 9}, {0, 0, 3, 3, 8, 8, 9, 9},
        {1, 1, 15, 12, 1, 1, 15, 12},
    };
    (void)state;
    for (size_t i = 0; i < sizeof windows / sizeof windows[0]; i++)
        for (int tile = 0; tile <= 5; tile += 5) {
            struct exr_sample sample = sample_plain(EXR_PIXEL_FLOAT, 16, 13);
            const int *w = windows[i];
            exr_attr_box2i_t data = {{{{w[0], w[1]}}}, {{{w[2], w[3]}}}};
            exr_attr_box2i_t display = {{{{w[4], w[5]}}}, {{{w[6], w[7]}}}};
            sample.data = data;
            sample.display = display;
            sample.tile = tile;
            check_sample(&sample, 2, 1, 0, 0.0f);
        }
}

/* Codes of 8 or 16 bits that the sRGB curve takes to these values. */
static double decoded(double code)
{
    return code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);
}

static void check_png(int width, int colour, int depth, int interlace, const unsigned char *bytes,
                      size_t stride, const double *codes)
{
    struct brdfcl_image image;
    struct brdf_error error = {0, ""};
    png_sample_write(path, width, 2, colour, depth, interlace, bytes, stride);
    if (brdfcl_image_read(&image, path, &error) != BRDF_OK)
        fail_msg("%s", error.message);
    assert_int_equal(image.width, width);
    assert_int_equal(image.height, 2);
    for (int i = 0; i < width * 2 * 3; i++)
        if (fabs((double)image.rgb[i] - decoded(codes[i])) > 1e-6)
            fail_msg("colour type %d, %d bits: value %d is %g, not %g", colour, depth, i,
                     (double)image.rgb[i], decoded(codes[i]));
    brdfcl_image_destroy(&image);
}

#define GREY(v) (v), (v), (v)

static void every_png(void **state)
{
    static const unsigned char grey8[] = {0, 118, 188, 255};
    static const double codes8[] = {GREY(0.0), GREY(118 / 255.0), GREY(188 / 255.0), GREY(1.0)};
    static const unsigned char grey_alpha8[] = {0, 255, 118, 0, 188, 1, 255, 77};
    static const unsigned char grey16[] = {0, 0, 1, 2, 0x80, 0, 255, 255};
    static const double codes16[] = {GREY(0.0), GREY(258 / 65535.0), GREY(32768 / 65535.0),
                                     GREY(1.0)};
    static const unsigned char grey1[] = {0x40, 0x80}, grey2[] = {0x60, 0xc0},
                               grey4[] = {0x05, 0xfa};
    static const double codes1[] = {GREY(0.0), GREY(1.0), GREY(1.0), GREY(0.0)};
    static const double codes2[] = {GREY(1 / 3.0), GREY(2 / 3.0), GREY(1.0), GREY(0.0)};
    static const double codes4[] = {GREY(0.0), GREY(5 / 15.0), GREY(1.0), GREY(10 / 15.0)};
    static const unsigned char rgb8[] = {1, 2, 3, 250, 251, 252};
    static const unsigned char rgba8[] = {1, 2, 3, 0, 250, 251, 252, 128};
    static const double rgb_codes[] = {1 / 255.0,   2 / 255.0,   3 / 255.0,
                                       250 / 255.0, 251 / 255.0, 252 / 255.0};
    static const unsigned char rgba16[] = {0x12, 0x34, 0x56, 0x78, 0x9a, 0xbc, 0,    0,
                                           0xff, 0xfe, 0x80, 0x01, 0x00, 0x01, 0x7f, 0xff};
    static const double rgba16_codes[] = {0x1234 / 65535.0, 0x5678 / 65535.0, 0x9abc / 65535.0,
                                          0xfffe / 65535.0, 0x8001 / 65535.0, 0x0001 / 65535.0};
    static const unsigned char palette8[] = {0, 3, 2, 1}, palette2[] = {0x30, 0x90};
    static const double palette_codes[] = {1, 0, 0, 188 / 255.0, 118 / 255.0, 1 / 255.0,
                                           0, 0, 1, 0,           1,           0};
    (void)state;
    for (int interlace = 0; interlace <= 1; interlace++) {
        check_png(2, PNG_COLOR_TYPE_GRAY, 8, interlace, grey8, 2, codes8);
        check_png(2, PNG_COLOR_TYPE_GRAY_ALPHA, 8, interlace, grey_alpha8, 4, codes8);
        check_png(2, PNG_COLOR_TYPE_GRAY, 16, interlace, grey16, 4, codes16);
        check_png(1, PNG_COLOR_TYPE_RGB, 8, interlace, rgb8, 3, rgb_codes);
        check_png(1, PNG_COLOR_TYPE_RGB_ALPHA, 8, interlace, rgba8, 4, rgb_codes);
        check_png(1, PNG_COLOR_TYPE_RGB_ALPHA, 16, interlace, rgba16, 8, rgba16_codes);
        check_png(2, PNG_COLOR_TYPE_PALETTE, 8, interlace, palette8, 2, palette_codes);
    }
    check_png(2, PNG_COLOR_TYPE_GRAY, 1, 0, grey1, 1, codes1);
    check_png(2, PNG_COLOR_TYPE_GRAY, 2, 0, grey2, 1, codes2);
    check_png(2, PNG_COLOR_TYPE_GRAY, 4, 0, grey4, 1, codes4);
    check_png(2, PNG_COLOR_TYPE_PALETTE, 2, 0, palette2, 1, palette_codes);
}

/* Read an environment map of the data folder, or return 0 if there is none. */
static int read_real(struct brdfcl_image *image, const char *name)
{
    char real[1024];
    struct brdf_error error = {0, ""};
    const char *data = getenv("BRDFCL_DATA");
    snprintf(real, sizeof real, "%s/envmaps/%s", data ? data : "../shared/data", name);
    if (access(real, R_OK) != 0)
        return 0;
    if (brdfcl_image_read(image, real, &error) != BRDF_OK)
        fail_msg("%s", error.message);
    assert_int_equal(image->width, 1024);
    assert_int_equal(image->height, 512);
    double sum = 0.0;
    for (int i = 0; i < 1024 * 512 * 3; i++) {
        /* DWA swings below zero a little where it is dark. */
        assert_true(isfinite(image->rgb[i]) && image->rgb[i] > -1e-5f);
        sum += (double)image->rgb[i];
    }
    assert_true(sum > 0.0);
    return 1;
}

static void real_environment_maps(void **state)
{
    static const char *const names[] = {"forest.exr", "sunset.exr", "studio.exr"};
    struct brdfcl_image image;
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (!read_real(&image, names[i]))
            skip();
        brdfcl_image_destroy(&image);
    }
}

static void dwab_is_as_zip(void **state)
{
    struct brdfcl_image zip, dwab;
    (void)state;
    if (!read_real(&zip, "studio.exr") || !read_real(&dwab, "studio_dwab.exr"))
        skip();
    /* The one was made of the other, by clamping at zero. */
    for (int i = 0; i < 1024 * 512 * 3; i++)
        assert_true(zip.rgb[i] == (dwab.rgb[i] > 0.0f ? dwab.rgb[i] : 0.0f));
    brdfcl_image_destroy(&zip);
    brdfcl_image_destroy(&dwab);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_compression),
        cmocka_unit_test(dwa),
        cmocka_unit_test(every_type_and_set_of_channels),
        cmocka_unit_test(data_window_is_not_display_window),
        cmocka_unit_test(every_png),
        cmocka_unit_test(real_environment_maps),
        cmocka_unit_test(dwab_is_as_zip),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
