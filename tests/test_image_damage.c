/*
 * test_image_damage.c - files that are not images, or no longer: each is refused with a sentence
 * that names the file, and none does harm (run under sanitizers by `make asan`).
 */
#define _POSIX_C_SOURCE 200809L

#include "image_samples.h"

#include <sys/stat.h>
#include <unistd.h>

#include <brdfcl/image.h>

static const char *const path = place.path;

static void put(const void *bytes, size_t size)
{
    unlink(path); /* a file that is cut and written again waits for the disk on ext4 */
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static unsigned char *get(size_t *size)
{
    FILE *file = fopen(path, "rb");
    unsigned char *bytes = malloc(1 << 16);
    assert_non_null(file);
    *size = fread(bytes, 1, 1 << 16, file);
    assert_int_equal(fclose(file), 0);
    assert_true(*size < 1 << 16);
    return bytes;
}

/* Reading fails in this way, and the sentence names the file and has these words. */
static void check_refused(brdf_status status, const char *name, const char *words)
{
    struct brdfcl_image image = {7, 7, NULL};
    struct brdf_error error = {BRDF_OK, ""};
    const brdf_status found = brdfcl_image_read(&image, name, &error);
    if (found != status || error.status != status || !strstr(error.message, words) ||
        !strstr(error.message, name))
        fail_msg("status %d, not %d, or '%s' is not in: %s", error.status, status, words,
                 error.message);
    assert_true(image.width == 0 && image.height == 0 && image.rgb == NULL);
}

static void no_image_at_all(void **state)
{
    (void)state;
    check_refused(BRDF_IO, "/nonexistent/folder/x.exr", "No such file");
    check_refused(BRDF_IO, place.folder, "is a folder");
    check_refused(BRDF_IO, "/dev/null", "not an ordinary file");
    put("", 0);
    check_refused(BRDF_BAD_FILE, path, "is empty");
    put("P6 1 1 255 abc", 14);
    check_refused(BRDF_BAD_FILE, path, "neither an OpenEXR nor a PNG");
    put("\x89PN", 3);
    check_refused(BRDF_BAD_FILE, path, "neither an OpenEXR nor a PNG");
    put("\x89PNG\r\n\x1a\n", 8);
    check_refused(BRDF_BAD_FILE, path, "cut short");
    put("\x76\x2f\x31\x01", 4);
    check_refused(BRDF_BAD_FILE, path, "");
    put("\x89PNG\r\n\x1a\n\0\0\0\rIDAT                    ", 36);
    check_refused(BRDF_BAD_FILE, path, "no IHDR");
}

static void a_pipe_is_not_waited_for(void **state)
{
    (void)state;
    unlink(path);
    assert_int_equal(mkfifo(path, 0600), 0);
    check_refused(BRDF_IO, path, "not an ordinary file");
    assert_int_equal(unlink(path), 0);
}

static void channels_that_are_missing(void **state)
{
    static const struct {
        const char *channels[SAMPLE_CHANNELS], *words;
    } sets[] = {
        {{"A", "Z"}, "found: A, Z"},
        {{"G", "R"}, "found: G, R"},
        {{"G", "R", "Y"}, "found: G, R, Y"},
        {{"b", "g", "r"}, "found: b, g, r"},
        {{"left.B", "left.G", "left.R"}, "found: left.B, left.G, left.R"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof sets / sizeof sets[0]; i++) {
        struct exr_sample sample = sample_plain(EXR_PIXEL_HALF, 5, 3);
        memcpy(sample.channels, sets[i].channels, sizeof sample.channels);
        exr_sample_write(path, &sample);
        check_refused(BRDF_BAD_FILE, path, sets[i].words);
    }
}

static void kinds_that_are_not_supported(void **state)
{
    static const exr_attr_chromaticities_t aces = {0.713f, 0.293f, 0.165f,   0.83f,
                                                   0.128f, 0.044f, 0.32168f, 0.33767f};
    static const exr_attr_chromaticities_t near = {0.6401f, 0.33f, 0.2999f,  0.6f,
                                                   0.15f,   0.06f, 0.31271f, 0.32902f};
    struct exr_sample sample = sample_plain(EXR_PIXEL_HALF, 5, 3);
    struct brdfcl_image image;
    (void)state;
    sample.primaries = &aces;
    exr_sample_write(path, &sample);
    check_refused(BRDF_UNSUPPORTED, path, "primaries are not those of Rec. 709");
    sample.primaries = &near;
    exr_sample_write(path, &sample);
    assert_int_equal(brdfcl_image_read(&image, path, NULL), BRDF_OK);
    brdfcl_image_destroy(&image);
    sample.primaries = NULL;
    sample.deep = 1;
    sample.compression = EXR_COMPRESSION_ZIPS;
    exr_sample_write(path, &sample);
    check_refused(BRDF_UNSUPPORTED, path, "deep");
    sample = sample_plain(EXR_PIXEL_HALF, 5, 3);
    sample.sampling = 2;
    sample.data.max.x = sample.data.max.y = sample.display.max.x = sample.display.max.y = 3;
    exr_sample_write(path, &sample);
    check_refused(BRDF_UNSUPPORTED, path, "channel R has one value for 2 x 2 pixels");
}

/* Put a little-endian 32-bit number behind the header of an attribute: name, type, size. */
static void poke(unsigned char *bytes, size_t size, const char *attribute, int index, int32_t value)
{
    const char *type = "box2i";
    size_t length = strlen(attribute) + 1;
    for (size_t i = 0; i + length < size; i++)
        if (memcmp(bytes + i, attribute, length) == 0) {
            unsigned char *at = bytes + i + length + strlen(type) + 1 + 4 + 4 * index;
            for (int b = 0; b < 4; b++)
                at[b] = (unsigned char)((uint32_t)value >> (8 * b));
            return;
        }
    fail_msg("no attribute %s", attribute);
}

static void sizes_that_cannot_be(void **state)
{
    /* max.x and max.y of both windows of an OpenEXR file; width and height of a PNG file. */
    static const struct {
        int32_t x, y;
        const char *words;
    } exr[] = {{(1 << 20), 0, "too large"},
               {0, (1 << 20), "too large"},
               {(1 << 20) - 1, 256,
                "too large: at most 1048576 pixels a side and 268435456 in all"},
               {INT32_MAX, INT32_MAX, ""},
               {-1, 3, ""}},
      png[] = {
          {0, 5, "nothing in it"},         {5, 0, "nothing in it"}, {(1 << 20) + 1, 1, "too large"},
          {1 << 15, 1 << 14, "too large"}, {-1, 1, "too large"},    {INT32_MIN, 1, "too large"}};
    struct exr_sample sample = sample_plain(EXR_PIXEL_HALF, 5, 3);
    size_t size;
    (void)state;
    exr_sample_write(path, &sample);
    unsigned char *bytes = get(&size);
    for (size_t i = 0; i < sizeof exr / sizeof exr[0]; i++)
        for (int both = 0; both <= 1; both++) {
            poke(bytes, size, "displayWindow", 2, exr[i].x);
            poke(bytes, size, "displayWindow", 3, exr[i].y);
            poke(bytes, size, "dataWindow", 2, both ? exr[i].x : 4);
            poke(bytes, size, "dataWindow", 3, both ? exr[i].y : 2);
            put(bytes, size);
            check_refused(BRDF_BAD_FILE, path, exr[i].words);
        }
    free(bytes);
    unsigned char head[33] = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
    for (size_t i = 0; i < sizeof png / sizeof png[0]; i++) {
        for (int b = 0; b < 4; b++) {
            head[16 + b] = (unsigned char)((uint32_t)png[i].x >> (24 - 8 * b));
            head[20 + b] = (unsigned char)((uint32_t)png[i].y >> (24 - 8 * b));
        }
        put(head, sizeof head);
        check_refused(BRDF_BAD_FILE, path, png[i].words);
    }
}

/* Cut the file at path at every length: none is read, and none does harm. */
static void cut_everywhere(size_t needed)
{
    size_t size;
    unsigned char *bytes = get(&size);
    for (size_t length = 0; length < size - needed; length++) {
        put(bytes, length);
        check_refused(BRDF_BAD_FILE, path, "");
    }
    free(bytes);
}

/*
 * Change every byte of the file at path in several ways. What is read may still be an image, but of
 * a size that memory was made for; what is not is refused with a sentence. Returns how many were.
 */
static int flip_everywhere(void)
{
    static const unsigned char masks[] = {0x01, 0x80, 0x10, 0xff};
    int refused = 0;
    size_t size;
    unsigned char *bytes = get(&size);
    for (size_t at = 0; at < size; at++)
        for (size_t m = 0; m < sizeof masks; m++) {
            struct brdfcl_image image;
            struct brdf_error error = {BRDF_OK, ""};
            bytes[at] ^= masks[m];
            put(bytes, size);
            bytes[at] ^= masks[m];
            if (brdfcl_image_read(&image, path, &error) == BRDF_OK) {
                assert_true(image.width > 0 && image.height > 0);
                (void)brdfcl_image_hash(&image); /* touches every pixel */
                brdfcl_image_destroy(&image);
            } else {
                assert_true(strstr(error.message, path) != NULL);
                assert_null(image.rgb);
                refused++;
            }
        }
    free(bytes);
    return refused;
}

static void damaged_exr(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct exr_sample sample = sample_plain(EXR_PIXEL_HALF, 5, 3);
        sample.tile = i & 1 ? 4 : 0;
        sample.compression = i & 2 ? EXR_COMPRESSION_NONE : EXR_COMPRESSION_ZIP;
        exr_sample_write(path, &sample);
        cut_everywhere(0);
        exr_sample_write(path, &sample);
        assert_true(flip_everywhere() > 100);
    }
}

static void damaged_png(void **state)
{
    static const unsigned char pixels[2 * 12] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14};
    (void)state;
    for (int interlace = 0; interlace <= 1; interlace++) {
        png_sample_write(path, 4, 2, PNG_COLOR_TYPE_RGB, 8, interlace, pixels, 12);
        cut_everywhere(0);
        png_sample_write(path, 4, 2, PNG_COLOR_TYPE_RGB, 8, interlace, pixels, 12);
        assert_true(flip_everywhere() > 100);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_image_at_all),
        cmocka_unit_test(a_pipe_is_not_waited_for),
        cmocka_unit_test(channels_that_are_missing),
        cmocka_unit_test(kinds_that_are_not_supported),
        cmocka_unit_test(sizes_that_cannot_be),
        cmocka_unit_test(damaged_exr),
        cmocka_unit_test(damaged_png),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
