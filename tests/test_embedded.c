/*
 * test_embedded.c - what the libraries carry is what the source tree holds, byte for byte.
 */
#define _POSIX_C_SOURCE 200809L
#include <dirent.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <cmocka.h>

#include "../lib/brdf/embedded.h"
#include "../lib/brdfcl/embedded.h"

/* A table, and the tree that it should hold: `root` is what the names leave out. */
struct tree {
    const struct brdf_source_file *files;
    const char *root;
    const char *directory;
};

static struct tree headers = {brdf_embedded_files, "include/", "brdf"};
static struct tree kernels = {brdfcl_embedded_files, "", "kernels"};

static void assert_same_text(const char *path, const char *const *lines)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        fail_msg("%s is carried, but cannot be read", path);
        return;
    }
    for (int number = 1; lines[number - 1]; ++number) {
        const char *line = lines[number - 1];
        for (const char *c = line; *c; ++c) {
            if (fgetc(file) != (unsigned char)*c) {
                fail_msg("%s:%d: differs from what is carried: %s", path, number, line);
            }
        }
        if (fgetc(file) != '\n') {
            fail_msg("%s:%d: does not end as what is carried: %s", path, number, line);
        }
    }
    if (fgetc(file) != EOF) {
        fail_msg("%s: goes on after what is carried", path);
    }
    fclose(file);
}

static void every_carried_file_is_the_file(void **state)
{
    const struct tree *tree = *state;
    for (const struct brdf_source_file *file = tree->files; file->name; ++file) {
        char path[512];
        snprintf(path, sizeof path, "%s%s", tree->root, file->name);
        assert_same_text(path, file->lines);
    }
}

static int is_carried(const struct tree *tree, const char *name)
{
    for (const struct brdf_source_file *file = tree->files; file->name; ++file) {
        if (!strcmp(file->name, name)) {
            return 1;
        }
    }
    return 0;
}

static int is_text(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot && (!strcmp(dot, ".h") || !strcmp(dot, ".cl"));
}

/* Walk the directory `name` (without the root) and return how many texts it holds. */
static int assert_all_carried(const struct tree *tree, const char *name)
{
    char path[512];
    snprintf(path, sizeof path, "%s%s", tree->root, name);
    DIR *directory = opendir(path);
    if (!directory) {
        fail_msg("%s: cannot be listed; run the tests from the root of the source", path);
        return 0;
    }
    int count = 0;
    for (struct dirent *entry; (entry = readdir(directory));) {
        if (entry->d_name[0] == '.') {
            continue;
        }
        char inner[512];
        struct stat status;
        snprintf(inner, sizeof inner, "%s/%s", name, entry->d_name);
        snprintf(path, sizeof path, "%s%s", tree->root, inner);
        assert_int_equal(stat(path, &status), 0);
        if (S_ISDIR(status.st_mode)) {
            count += assert_all_carried(tree, inner);
        } else if (is_text(inner)) {
            if (!is_carried(tree, inner)) {
                fail_msg("%s is not carried", path);
            }
            ++count;
        }
    }
    closedir(directory);
    return count;
}

static void no_file_is_missing(void **state)
{
    const struct tree *tree = *state;
    int carried = 0;
    while (tree->files[carried].name) {
        ++carried;
    }
    assert_true(carried > 0);
    assert_int_equal(assert_all_carried(tree, tree->directory), carried);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        {"headers: every carried file is the file", every_carried_file_is_the_file, NULL, NULL,
         &headers},
        {"headers: no file is missing", no_file_is_missing, NULL, NULL, &headers},
        {"kernels: every carried file is the file", every_carried_file_is_the_file, NULL, NULL,
         &kernels},
        {"kernels: no file is missing", no_file_is_missing, NULL, NULL, &kernels},
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
