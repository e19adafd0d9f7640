/*
 * test_image_write.c - a file appears whole or not at all, under its own name, and where it was
 * asked for; and what cannot be written is said before it is tried.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <dirent.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <brdfcl/image.h>

static char folder[256];

static int make_folder(void **state)
{
    const char *parent = getenv("TMPDIR");
    (void)state;
    snprintf(folder, sizeof folder, "%s/test_image_write.XXXXXX", parent ? parent : "/tmp");
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

/* How many names there are in a folder, besides . and .. */
static int count_names(const char *where)
{
    int count = 0;
    DIR *names = opendir(where);
    assert_non_null(names);
    while (readdir(names))
        count++;
    closedir(names);
    return count - 2;
}

/* Every test ends with this, having removed what it made: anything that is left is the library's.
 */
static void check_nothing_left(void)
{
    assert_int_equal(count_names("."), 0);
}

static int remove_folder(void **state)
{
    (void)state;
    return chdir("/") == 0 ? rmdir(folder) : -1;
}

static struct brdfcl_image make_image(int width, int height, uint32_t seed)
{
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_create(&image, width, height, NULL), BRDF_OK);
    for (size_t i = 0; i < (size_t)width * (size_t)height * 3; i++) {
        seed = seed * 1664525u + 1013904223u;
        image.rgb[i] = (float)(seed >> 8) * 0x1p-24f; /* noise: it does not compress */
    }
    return image;
}

static unsigned long long hash_of(const char *path)
{
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_read(&image, path, NULL), BRDF_OK);
    unsigned long long hash = brdfcl_image_hash(&image);
    brdfcl_image_destroy(&image);
    return hash;
}

static void check_fails(brdf_status status, brdf_status expected, const struct brdf_error *error,
                        const char *words)
{
    if (status != expected || error->status != expected || !strstr(error->message, words))
        fail_msg("status %d, not %d, or '%s' is not in: %s", status, expected, words,
                 error->message);
}

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

static void a_full_disk_leaves_the_old_file(void **state)
{
    static const char *const names[] = {"full.exr", "full.png"};
    struct brdfcl_image small = make_image(8, 8, 1), large = make_image(200, 100, 2);
    struct rlimit before, limit;
    (void)state;
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    for (int i = 0; i < 2; i++)
        for (rlim_t bytes = 0; bytes < 30000; bytes += 5000) {
            struct brdf_error error = {BRDF_OK, ""};
            assert_int_equal(brdfcl_image_write(&small, names[i], NULL, NULL), BRDF_OK);
            unsigned long long old = hash_of(names[i]);
            limit = before;
            limit.rlim_cur = bytes;
            assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
            brdf_status status = brdfcl_image_write(&large, names[i], NULL, &error);
            assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
            check_fails(status, BRDF_IO, &error, "File too large");
            assert_non_null(strstr(error.message, names[i]));
            assert_true(hash_of(names[i]) == old);
            assert_int_equal(count_names("."), 1);
            assert_int_equal(unlink(names[i]), 0);
        }
    brdfcl_image_destroy(&small);
    brdfcl_image_destroy(&large);
    check_nothing_left();
}

static mode_t mode_of(const char *path)
{
    struct stat info;
    assert_int_equal(lstat(path, &info), 0);
    return info.st_mode & 07777;
}

static void permissions(void **state)
{
    struct brdfcl_image image = make_image(2, 2, 1);
    (void)state;
    mode_t before = umask(027);
    assert_int_equal(brdfcl_image_write(&image, "a.png", NULL, NULL), BRDF_OK);
    assert_int_equal(mode_of("a.png"), 0640); /* as the umask says */
    assert_int_equal(chmod("a.png", 0604), 0);
    assert_int_equal(brdfcl_image_write(&image, "a.png", NULL, NULL), BRDF_OK);
    assert_int_equal(mode_of("a.png"), 0604); /* as it was */
    umask(before);
    assert_int_equal(unlink("a.png"), 0);
    brdfcl_image_destroy(&image);
    check_nothing_left();
}

static void symbolic_links_are_followed(void **state)
{
    struct brdfcl_image image = make_image(3, 2, 1);
    struct stat info;
    (void)state;
    assert_int_equal(mkdir("there", 0700), 0);
    assert_int_equal(symlink("there/second.exr", "first.exr"), 0);
    assert_int_equal(symlink("picture.exr", "there/second.exr"), 0);
    for (int i = 0; i < 2; i++) { /* at first the target is not there, then it is */
        assert_int_equal(brdfcl_image_path_check("first.exr", NULL), BRDF_OK);
        assert_int_equal(brdfcl_image_write(&image, "first.exr", NULL, NULL), BRDF_OK);
        assert_int_equal(lstat("first.exr", &info), 0);
        assert_true(S_ISLNK(info.st_mode));
        assert_int_equal(lstat("there/picture.exr", &info), 0);
        assert_true(S_ISREG(info.st_mode));
        assert_true(hash_of("first.exr") == brdfcl_image_hash(&image));
        assert_int_equal(count_names("there"), 2);
    }
    unlink("there/picture.exr");
    unlink("there/second.exr");
    unlink("first.exr");
    assert_int_equal(rmdir("there"), 0);
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

/* A writer that is killed at any time leaves the old picture or the new one. */
static void a_killed_writer_leaves_no_half_file(void **state)
{
    struct brdfcl_image images[2] = {make_image(300, 200, 1), make_image(300, 200, 2)};
    const unsigned long long hashes[2] = {brdfcl_image_hash(&images[0]),
                                          brdfcl_image_hash(&images[1])};
    (void)state;
    assert_int_equal(brdfcl_image_write(&images[0], "x.exr", NULL, NULL), BRDF_OK);
    for (int i = 0; i < 20; i++) {
        pid_t child = fork();
        if (child == 0)
            for (int turn = 0;; turn++)
                brdfcl_image_write(&images[turn & 1], "x.exr", NULL, NULL);
        assert_true(child > 0);
        nanosleep(&(struct timespec){0, 3000000 + i * 1700000}, NULL);
        kill(child, SIGKILL);
        assert_int_equal(waitpid(child, NULL, 0), child);
        unsigned long long found = hash_of("x.exr");
        assert_true(found == hashes[0] || found == hashes[1]);
    }
    DIR *names = opendir(".");
    for (struct dirent *entry; (entry = readdir(names));)
        if (strncmp(entry->d_name, ".x.exr.", 7) == 0)
            unlink(entry->d_name);
    closedir(names);
    assert_int_equal(count_names("."), 1);
    assert_int_equal(unlink("x.exr"), 0);
    brdfcl_image_destroy(&images[0]);
    brdfcl_image_destroy(&images[1]);
    check_nothing_left();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_that_are_refused),
        cmocka_unit_test(folders_and_files_that_may_not_be_written),
        cmocka_unit_test(path_check_leaves_no_trace),
        cmocka_unit_test(options_that_are_refused),
        cmocka_unit_test(a_full_disk_leaves_the_old_file),
        cmocka_unit_test(permissions),
        cmocka_unit_test(symbolic_links_are_followed),
        cmocka_unit_test(names_of_any_length),
        cmocka_unit_test(chunks_that_hardly_compress),
        cmocka_unit_test(a_killed_writer_leaves_no_half_file),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
