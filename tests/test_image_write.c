/*
 * test_image_write.c - what cannot be written is said before it is tried, and what can is written
 * whatever its name and content.
 */
#define _POSIX_C_SOURCE 200809L

#include "image_folder.h"

#include <math.h>
#include <sys/stat.h>

/* Both brdfcl_image_path_check and brdfcl_image_write refuse this path, for that reason. */
static void check_path_refused(const char *path, brdf_status expected, const char *words)
{
    struct brdfcl_image image = make_image(2, 2, 1);
    struct brdf_error error = {BRDF_OK, ""};
    check_fails(brdfcl_image_path_check(path, &error), expected, &error, words);
    memset(&error, 0, sizeof error);
    check_fails(brdfcl_image_write(&image, path, NULL, &error), expected, &error, words);
    brdfcl_image_destroy(&image);
}

static void paths_that_are_refused(void **state)
{
    (void)state;
    check_path_refused("x.jpg", BRDF_UNSUPPORTED, ".exr (OpenEXR) or .png (PNG)");
    check_path_refused("x", BRDF_UNSUPPORTED, ".exr");
    check_path_refused("", BRDF_UNSUPPORTED, ".exr");
    check_path_refused("a.exr/x", BRDF_UNSUPPORTED, ".exr");
    check_path_refused("/nonexistent/x.exr", BRDF_IO, "the folder /nonexistent/: No such file");
    assert_int_equal(mkdir("folder.exr", 0700), 0);
    check_path_refused("folder.exr", BRDF_IO, "is a folder");
    assert_int_equal(rmdir("folder.exr"), 0);
    fclose(fopen("file", "w"));
    check_path_refused("file/x.png", BRDF_IO, "Not a directory");
    assert_int_equal(unlink("file"), 0);
    assert_int_equal(symlink("/dev/null", "device.png"), 0);
    check_path_refused("device.png", BRDF_IO, "is a device");
    assert_int_equal(unlink("device.png"), 0);
    assert_int_equal(symlink("loop.exr", "loop.exr"), 0);
    check_path_refused("loop.exr", BRDF_IO, "symbolic link");
    assert_int_equal(unlink("loop.exr"), 0);
    assert_int_equal(mkfifo("pipe.exr", 0600), 0);
    check_path_refused("pipe.exr", BRDF_IO, "a pipe");
    assert_int_equal(unlink("pipe.exr"), 0);
    check_nothing_left();
}

static void folders_and_files_that_may_not_be_written(void **state)
{
    (void)state;
    if (geteuid() == 0)
        skip(); /* everything may be */
    assert_int_equal(mkdir("closed", 0500), 0);
    check_path_refused("closed/x.exr", BRDF_IO, "Permission denied");
    assert_int_equal(rmdir("closed"), 0);
    fclose(fopen("kept.exr", "w"));
    assert_int_equal(chmod("kept.exr", 0400), 0);
    check_path_refused("kept.exr", BRDF_IO, "may not be overwritten");
    assert_int_equal(unlink("kept.exr"), 0);
    check_nothing_left();
}

static void path_check_leaves_no_trace(void **state)
{
    (void)state;
    assert_int_equal(brdfcl_image_path_check("new.exr", NULL), BRDF_OK);
    assert_int_equal(brdfcl_image_path_check("./NEW.PNG", NULL), BRDF_OK);
    check_nothing_left();
}

static void options_that_are_refused(void **state)
{
    static const struct brdfcl_image_metadata bad[] = {
        {"", BRDFCL_METADATA_INT, {NULL}},
        {NULL, BRDFCL_METADATA_INT, {NULL}},
        {"two words", BRDFCL_METADATA_INT, {NULL}},
        {"abcdefghijklmnopqrstuvwxyz012345", BRDFCL_METADATA_INT, {NULL}},
        {"dataWindow", BRDFCL_METADATA_INT, {NULL}},
        {"type", BRDFCL_METADATA_TEXT, {"x"}},
        {"text", BRDFCL_METADATA_TEXT, {NULL}},
        {"kind", (enum brdfcl_metadata_kind)7, {NULL}},
    };
    static const struct brdfcl_image_metadata twice[] = {{"spp", BRDFCL_METADATA_INT, {NULL}},
                                                         {"spp", BRDFCL_METADATA_INT, {NULL}}};
    struct brdfcl_image image = make_image(2, 2, 1), none = {0, 0, NULL};
    struct brdf_error error;
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const struct brdfcl_image_options options = {0, 0.0f, &bad[i], 1};
        check_fails(brdfcl_image_write(&image, "x.exr", &options, &error), BRDF_BAD_ARGUMENT,
                    &error, "metadata");
        check_fails(brdfcl_image_write(&image, "x.png", &options, &error), BRDF_BAD_ARGUMENT,
                    &error, "metadata");
    }
    const struct brdfcl_image_options list = {0, 0.0f, twice, 2}, missing = {0, 0.0f, NULL, 1};
    const struct brdfcl_image_options exposure = {0, NAN, NULL, 0};
    check_fails(brdfcl_image_write(&image, "x.exr", &list, &error), BRDF_BAD_ARGUMENT, &error,
                "given twice");
    check_fails(brdfcl_image_write(&image, "x.exr", &missing, &error), BRDF_BAD_ARGUMENT, &error,
                "no list");
    check_fails(brdfcl_image_write(&image, "x.png", &exposure, &error), BRDF_BAD_ARGUMENT, &error,
                "exposure");
    check_fails(brdfcl_image_write(&none, "x.exr", NULL, &error), BRDF_BAD_ARGUMENT, &error,
                "no image");
    brdfcl_image_destroy(&image);
    check_nothing_left();
}

static void names_of_any_length(void **state)
{
    char name[256];
    struct brdfcl_image image = make_image(2, 2, 1);
    struct brdf_error error;
    (void)state;
    memset(name, 'n', sizeof name);
    memcpy(name + 251, ".exr", 5); /* 255 bytes: as long as a name can be */
    assert_int_equal(brdfcl_image_write(&image, name, NULL, NULL), BRDF_OK);
    assert_int_equal(unlink(name), 0);
    assert_int_equal(brdfcl_image_write(&image, ".exr", NULL, NULL), BRDF_OK);
    assert_int_equal(unlink(".exr"), 0);
    char longer[300];
    memset(longer, 'n', sizeof longer);
    memcpy(longer + 290, ".exr", 5);
    check_fails(brdfcl_image_write(&image, longer, NULL, &error), BRDF_IO, &error, "too long");
    brdfcl_image_destroy(&image);
    check_nothing_left();
}

/*
 * Chunks of every size from worth compressing to not worth it, among them those that are just as
 * large compressed: OpenEXR 3.1 would store these wrongly.
 */
static void chunks_that_hardly_compress(void **state)
{
    /* Noise with fewer and fewer bits that are not zero, behind more and more zeros. */
    static const uint32_t masks[] = {0xffffffffu, 0xffffff00u, 0xfff0f0f0u};
    (void)state;
    for (int i = 0; i < 3 * 6 * 13; i++) {
        const int width = 4 + i / 3 % 6, zeros = i / 18;
        struct brdfcl_image image = make_image(width, 1, (uint32_t)(width * 100 + zeros));
        for (int value = 0; value < 3 * width; value++) {
            uint32_t bits;
            memcpy(&bits, &image.rgb[value], sizeof bits);
            bits &= value < zeros ? 0u : masks[i % 3];
            memcpy(&image.rgb[value], &bits, sizeof bits);
        }
        assert_int_equal(brdfcl_image_write(&image, "x.exr", NULL, NULL), BRDF_OK);
        assert_true(hash_of("x.exr") == brdfcl_image_hash(&image));
        brdfcl_image_destroy(&image);
    }
    assert_int_equal(unlink("x.exr"), 0);
    check_nothing_left();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_that_are_refused),
        cmocka_unit_test(folders_and_files_that_may_not_be_written),
        cmocka_unit_test(path_check_leaves_no_trace),
        cmocka_unit_test(options_that_are_refused),
        cmocka_unit_test(names_of_any_length),
        cmocka_unit_test(chunks_that_hardly_compress),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
