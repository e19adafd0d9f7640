/*
 * test_rgl_refused.c - RGL files that are none, or no longer: everything that can be wrong.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <sys/stat.h>
#include <unistd.h>

#include "rgl_files.h"

/* A file in memory, to be damaged, and where it goes. */
struct damage {
    struct place place;
    unsigned char *bytes;
    size_t size;
};

static void damage_write(const struct damage *damage, const unsigned char *bytes, size_t size)
{
    unlink(
        damage->place.path); /* a file that is cut and written again waits for the disk on ext4 */
    FILE *stream = fopen(damage->place.path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, size, stream), size);
    assert_int_equal(fclose(stream), 0);
}

static int damage_make(void **state)
{
    struct damage *damage = calloc(1, sizeof *damage);
    struct brdf_rgl_file file = rgl_test_make("roughconductor:alpha=0.4", &rgl_test_tiny);
    *state = damage;
    assert_int_equal(place_make(&damage->place, "material.bsdf"), 0);
    assert_int_equal(brdf_rgl_write(damage->place.path, &file, NULL), BRDF_OK);
    brdf_rgl_free(&file);
    FILE *stream = fopen(damage->place.path, "rb");
    assert_non_null(stream);
    damage->bytes = malloc(65536);
    damage->size = fread(damage->bytes, 1, 65536, stream);
    fclose(stream);
    return 0;
}

static int damage_remove(void **state)
{
    struct damage *damage = *state;
    int left = place_remove(&damage->place);
    free(damage->bytes);
    free(damage);
    return left;
}

static void expect_refusal(const char *path, brdf_status status, const char *words)
{
    struct brdf_rgl_file file;
    struct brdf_error error = {0, ""};
    assert_int_equal(brdf_rgl_read(path, &file, &error), status);
    assert_int_equal(error.status, status);
    if (!strstr(error.message, words) || !strstr(error.message, path)) {
        fail_msg("\"%s\" should name %s and say \"%s\"", error.message, path, words);
    }
    assert_null(file.values);
    assert_null(file.description);
}

/* Cut off anywhere, and with too much behind it. */
static void other_lengths_are_refused(void **state)
{
    struct damage *damage = *state;
    struct brdf_rgl_file file;
    unsigned char longer[65536] = {0};
    for (size_t size = 0; size < damage->size; size += size < 600 ? 1 : 37) {
        damage_write(damage, damage->bytes, size);
        assert_int_equal(brdf_rgl_read(damage->place.path, &file, NULL), BRDF_BAD_FILE);
    }
    damage_write(damage, damage->bytes, damage->size - 1);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "cut off");
    damage_write(damage, damage->bytes, 100);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "byte ");
    memcpy(longer, damage->bytes, damage->size);
    damage_write(damage, longer, damage->size + 8);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "too long");
    damage_write(damage, longer, 17);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "17 bytes are too short");
}

/* Where the description of a field begins: at the length of its name. */
static size_t field_at(const struct damage *damage, const char *name)
{
    size_t length = strlen(name);
    for (size_t at = 18; at + length + 2 < damage->size; ++at) {
        if (damage->bytes[at] == length && damage->bytes[at + 1] == 0 &&
            memcmp(damage->bytes + at + 2, name, length) == 0) {
            return at;
        }
    }
    fail_msg("no field %s", name);
    return 0;
}

/* What lies where, counted from the end of a field's name. */
enum { RANK = 0, TYPE = 2, DATA = 3, FIRST_DIMENSION = 11 };

/* The file with some bytes of a field's description, or of the header (name NULL), replaced. */
static void patched(struct damage *damage, const char *name, size_t offset, const void *bytes,
                    size_t count)
{
    unsigned char *copy = malloc(damage->size);
    memcpy(copy, damage->bytes, damage->size);
    size_t at = name ? field_at(damage, name) + 2 + strlen(name) + offset : offset;
    memcpy(copy + at, bytes, count);
    damage_write(damage, copy, damage->size);
    free(copy);
}

/* Patched so, the file is refused with these words. */
static void patch_refused(struct damage *damage, const char *name, size_t offset, const void *bytes,
                          size_t count, const char *words)
{
    patched(damage, name, offset, bytes, count);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, words);
}

static void bad_headers_are_refused(void **state)
{
    struct damage *damage = *state;
    patch_refused(damage, NULL, 0, "Tensor", 6, "not an RGL .bsdf file");
    patch_refused(damage, NULL, 12, "\2", 1, "byte 12: version 2.0");
    patch_refused(damage, NULL, 14, "\377\377\377\377", 4, "byte ");
    patch_refused(damage, NULL, 14, "\0\0\0\0", 4, "byte ");
    patch_refused(damage, "ndf", TYPE, "\13", 1, "\"ndf\" has rank 2 and type 11");
    patch_refused(damage, "ndf", TYPE, "\0", 1, "unknown type 0");
    patch_refused(damage, "vndf", RANK, "\3", 1, "\"vndf\" has rank 3");
    patch_refused(damage, "sigma", (size_t)0 - 5, "gamma", 5, "has no field \"sigma\"");
    patch_refused(damage, "phi_i", (size_t)0 - 5, "sigma", 5, "rank 1");
}

static void bad_sizes_are_refused(void **state)
{
    struct damage *damage = *state;
    patch_refused(damage, "ndf", FIRST_DIMENSION, "\377\377\377\377\377\377\377\377", 8,
                  "larger than the file");
    patch_refused(damage, "ndf", FIRST_DIMENSION, "\0\0\0\0\0\0\0\200", 8, "larger than the file");
    patch_refused(damage, "vndf", FIRST_DIMENSION, "\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\0", 16,
                  "larger than the file");
    patch_refused(damage, "ndf", FIRST_DIMENSION, "\1", 1, "dimension 0 of \"ndf\" is 1");
    patch_refused(damage, "theta_i", FIRST_DIMENSION, "\0", 1, "dimension 0 of \"theta_i\" is 0");
    patch_refused(damage, "vndf", FIRST_DIMENSION + 8, "\1", 1,
                  "dimension 1 of \"vndf\" is 1, but must be 2");
    patch_refused(damage, "rgb", FIRST_DIMENSION + 16, "\2", 1,
                  "dimension 2 of \"rgb\" is 2, but must be 3");
    patch_refused(damage, "luminance", DATA, "\377\377\377\377\377\377\377\177", 8,
                  "lie outside of the file");
    patch_refused(damage, "luminance", DATA, "\377\377\377\377\377\377\377\377", 8,
                  "lie outside of the file");
}

/* One float of a field, number `index`, as the bytes of the file. */
static size_t value_patched(struct damage *damage, const char *name, size_t index,
                            const char bytes[4])
{
    size_t at = field_at(damage, name) + 2 + strlen(name) + DATA;
    size_t data = damage->bytes[at] | (size_t)damage->bytes[at + 1] << 8;
    patched(damage, NULL, data + 4 * index, bytes, 4);
    return data + 4 * index;
}

static void bad_values_are_refused(void **state)
{
    struct damage *damage = *state;
    char words[80];
    size_t at = value_patched(damage, "vndf", 7, "\0\0\300\177");
    snprintf(words, sizeof words, "byte %zu: value 7 of \"vndf\" is not a number", at);
    expect_refusal(damage->place.path, BRDF_BAD_FILE, words);
    value_patched(damage, "rgb", 0, "\0\0\200\377");
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "is infinite");
    value_patched(damage, "luminance", 1, "\377\377\177\177");
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "too large");
    value_patched(damage, "theta_i", 1, "\0\0\0\0");
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "not above the one before");
    value_patched(damage, "theta_i", 1, "\0\0\200\100");
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "not an angle");
    value_patched(damage, "sigma", 0, "\0\0\200\277");
    expect_refusal(damage->place.path, BRDF_BAD_FILE, "\"sigma\" is negative");
}

/* Whatever a header says, there is an answer; the model then takes what has been accepted. */
static void changed_bytes_do_no_harm(void **state)
{
    struct damage *damage = *state;
    struct brdfcl_random random = {3};
    size_t accepted = 0;
    for (int i = 0; i < 4000; ++i) {
        struct brdf_rgl_file file;
        size_t at = (size_t)((double)brdfcl_random_uniform(&random) * (double)damage->size);
        unsigned char byte = (unsigned char)(256.0 * (double)brdfcl_random_uniform(&random));
        patched(damage, NULL, at, &byte, 1);
        struct brdf_bsdf *bsdf = NULL;
        struct brdf_setting setting = brdf_setting_text("filename", damage->place.path);
        if (brdf_rgl_read(damage->place.path, &file, NULL) == BRDF_OK) {
            brdf_rgl_free(&file);
            assert_int_equal(brdf_bsdf_create_from("measured", &setting, 1, &bsdf, NULL), BRDF_OK);
            struct brdf_sample s = brdf_sample(bsdf, random_above(&random), random_cube(&random));
            assert_true(s.pdf >= 0.0f && isfinite(s.pdf) && isfinite(s.weight.g));
            brdf_bsdf_destroy(bsdf);
            ++accepted;
        }
    }
    assert_true(accepted > 100 && accepted < 3900);
}

static void other_things_than_files_are_refused(void **state)
{
    struct damage *damage = *state;
    struct brdf_rgl_file file;
    unlink(damage->place.path);
    expect_refusal(damage->place.path, BRDF_IO, "No such file");
    expect_refusal(damage->place.folder, BRDF_IO, "a folder");
    assert_int_equal(mkfifo(damage->place.path, 0600), 0);
    expect_refusal(damage->place.path, BRDF_IO, "a pipe"); /* and does not wait for a writer */
    assert_int_equal(brdf_rgl_read(NULL, &file, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_read(damage->place.path, NULL, NULL), BRDF_BAD_ARGUMENT);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, damage_make, damage_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(other_lengths_are_refused), TEST(bad_headers_are_refused),
        TEST(bad_sizes_are_refused),     TEST(bad_values_are_refused),
        TEST(changed_bytes_do_no_harm),  TEST(other_things_than_files_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
