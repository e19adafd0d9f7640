/*
 * image_folder.h - pictures written into a temporary folder, the current one, and what is left
 * there.
 */
#ifndef TEST_IMAGE_FOLDER_H
#define TEST_IMAGE_FOLDER_H

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <dirent.h>
#include <unistd.h>

#include <brdfcl/image.h>

#include "support_place.h"

static struct place place;

static inline int make_folder(void **state)
{
    (void)state;
    return place_make(&place, "nothing") || chdir(place.folder) ? -1 : 0;
}

static inline int remove_folder(void **state)
{
    (void)state;
    return chdir("/") == 0 ? place_remove(&place) : -1;
}

/* How many names there are in a folder, besides . and .. */
static inline int count_names(const char *where)
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
static inline void check_nothing_left(void)
{
    assert_int_equal(count_names("."), 0);
}

static inline struct brdfcl_image make_image(int width, int height, uint32_t seed)
{
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_create(&image, width, height, NULL), BRDF_OK);
    for (size_t i = 0; i < (size_t)width * (size_t)height * 3; i++) {
        seed = seed * 1664525u + 1013904223u;
        image.rgb[i] = (float)(seed >> 8) * 0x1p-24f; /* noise: it does not compress */
    }
    return image;
}

static inline unsigned long long hash_of(const char *path)
{
    struct brdfcl_image image;
    assert_int_equal(brdfcl_image_read(&image, path, NULL), BRDF_OK);
    unsigned long long hash = brdfcl_image_hash(&image);
    brdfcl_image_destroy(&image);
    return hash;
}

static inline void check_fails(brdf_status status, brdf_status expected,
                               const struct brdf_error *error, const char *words)
{
    if (status != expected || error->status != expected || !strstr(error->message, words))
        fail_msg("status %d, not %d, or '%s' is not in: %s", status, expected, words,
                 error->message);
}

#endif
