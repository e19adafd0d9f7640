/*
 * test_image_whole.c - a file appears whole or not at all, under its own name, and where it was
 * asked for.
 */
#define _POSIX_C_SOURCE 200809L

#include "image_folder.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>

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
        cmocka_unit_test(a_full_disk_leaves_the_old_file),
        cmocka_unit_test(permissions),
        cmocka_unit_test(symbolic_links_are_followed),
        cmocka_unit_test(a_killed_writer_leaves_no_half_file),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
