/*
 * test_rgl.c - RGL files: written and read back, and everything that can be wrong.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <sys/stat.h>

#include "rgl_files.h"
#include "support_bsdf.h"

static const float wavelengths[] = {360.0f, 420.0f, 480.0f, 560.0f, 640.0f, 720.0f, 830.0f};

/* The smallest honest grid: a file of a few hundred bytes. */
static const struct brdf_rgl_grid tiny = {
    .thetas = 2, .normals = 4, .size = 2, .description = "tiny"};

/* A file in memory, to be damaged, and its path. */
struct place {
    char *folder;
    char path[4200];
    unsigned char *bytes;
    size_t size;
};

static void place_write(const struct place *place, const unsigned char *bytes, size_t size)
{
    FILE *stream = fopen(place->path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, size, stream), size);
    assert_int_equal(fclose(stream), 0);
}

static int place_make(void **state)
{
    struct place *place = calloc(1, sizeof *place);
    struct brdf_rgl_file file = rgl_test_make("roughconductor:alpha=0.4", &tiny);
    *state = place;
    place->folder = test_folder_make();
    assert_non_null(place->folder);
    snprintf(place->path, sizeof place->path, "%s/material.bsdf", place->folder);
    assert_int_equal(brdf_rgl_write(place->path, &file, NULL), BRDF_OK);
    brdf_rgl_free(&file);
    FILE *stream = fopen(place->path, "rb");
    assert_non_null(stream);
    place->bytes = malloc(65536);
    place->size = fread(place->bytes, 1, 65536, stream);
    fclose(stream);
    return 0;
}

/* Only the one file may be left: rmdir fails, and so the test, if there are others. */
static int place_remove(void **state)
{
    struct place *place = *state;
    unlink(place->path);
    int left = rmdir(place->folder);
    free(place->folder);
    free(place->bytes);
    free(place);
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

static void same_floats(const float *a, const float *b, size_t count)
{
    assert_memory_equal(a, b, count * sizeof *a);
}

static void expect_equal(const struct brdf_rgl_file *a, const struct brdf_rgl_file *b)
{
    size_t views = (size_t)a->phi_count * (size_t)a->theta_count;
    size_t square = (size_t)a->size * (size_t)a->size;
    assert_string_equal(a->description, b->description);
    assert_int_equal(a->phi_count, b->phi_count);
    assert_int_equal(a->theta_count, b->theta_count);
    assert_int_equal(a->channels, b->channels);
    assert_int_equal(a->size, b->size);
    assert_int_equal(a->jacobian, b->jacobian);
    same_floats(a->phi_i, b->phi_i, (size_t)a->phi_count);
    same_floats(a->theta_i, b->theta_i, (size_t)a->theta_count);
    same_floats(a->ndf, b->ndf, (size_t)a->ndf_rows * (size_t)a->ndf_columns);
    same_floats(a->sigma, b->sigma, (size_t)a->sigma_rows * (size_t)a->sigma_columns);
    same_floats(a->vndf, b->vndf, views * (size_t)a->vndf_rows * (size_t)a->vndf_columns);
    same_floats(a->luminance, b->luminance, views * square);
    same_floats(a->values, b->values, views * square * (size_t)a->channels);
    assert_int_equal(a->wavelengths != NULL, b->wavelengths != NULL);
    if (a->wavelengths) {
        same_floats(a->wavelengths, b->wavelengths, (size_t)a->channels);
    }
}

/* Isotropic and anisotropic, RGB and spectral. */
static void written_values_are_read_back(void **state)
{
    struct place *place = *state;
    for (int kind = 0; kind < 4; ++kind) {
        struct brdf_rgl_grid grid = {.thetas = 4, .normals = 12, .size = 6, .description = "kind"};
        struct brdf_rgl_file read;
        struct brdf_error error = {BRDF_OK, ""};
        grid.phis = kind & 1 ? 5 : 1;
        grid.symmetry = kind & 1 ? 2 : 1;
        grid.wavelengths = kind & 2 ? wavelengths : NULL;
        grid.channels = kind & 2 ? 7 : 3;
        struct brdf_rgl_file made = rgl_test_make("roughconductor:alpha_u=0.3,alpha_v=0.5", &grid);
        assert_int_equal(brdf_rgl_write(place->path, &made, NULL), BRDF_OK);
        if (brdf_rgl_read(place->path, &read, &error)) {
            fail_msg("%s", error.message);
        }
        expect_equal(&made, &read);
        brdf_rgl_free(&made);
        brdf_rgl_free(&read);
        assert_null(read.values);
    }
}

/* Cut off anywhere, and with too much behind it. */
static void other_lengths_are_refused(void **state)
{
    struct place *place = *state;
    struct brdf_rgl_file file;
    unsigned char longer[65536] = {0};
    for (size_t size = 0; size < place->size; size += size < 600 ? 1 : 37) {
        place_write(place, place->bytes, size);
        assert_int_equal(brdf_rgl_read(place->path, &file, NULL), BRDF_BAD_FILE);
    }
    place_write(place, place->bytes, place->size - 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "cut off");
    place_write(place, place->bytes, 100);
    expect_refusal(place->path, BRDF_BAD_FILE, "byte ");
    memcpy(longer, place->bytes, place->size);
    place_write(place, longer, place->size + 8);
    expect_refusal(place->path, BRDF_BAD_FILE, "too long");
    place_write(place, longer, 17);
    expect_refusal(place->path, BRDF_BAD_FILE, "17 bytes are too short");
}

/* Where the description of a field begins: at the length of its name. */
static size_t field_at(const struct place *place, const char *name)
{
    size_t length = strlen(name);
    for (size_t at = 18; at + length + 2 < place->size; ++at) {
        if (place->bytes[at] == length && place->bytes[at + 1] == 0 &&
            memcmp(place->bytes + at + 2, name, length) == 0) {
            return at;
        }
    }
    fail_msg("no field %s", name);
    return 0;
}

/* What lies where, counted from the end of a field's name. */
enum { RANK = 0, TYPE = 2, DATA = 3, FIRST_DIMENSION = 11 };

/* The file with some bytes of a field's description, or of the header (name NULL), replaced. */
static void patched(struct place *place, const char *name, size_t offset, const void *bytes,
                    size_t count)
{
    unsigned char *copy = malloc(place->size);
    memcpy(copy, place->bytes, place->size);
    size_t at = name ? field_at(place, name) + 2 + strlen(name) + offset : offset;
    memcpy(copy + at, bytes, count);
    place_write(place, copy, place->size);
    free(copy);
}

static void bad_headers_are_refused(void **state)
{
    struct place *place = *state;
    patched(place, NULL, 0, "Tensor", 6);
    expect_refusal(place->path, BRDF_BAD_FILE, "not an RGL .bsdf file");
    patched(place, NULL, 12, "\2", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "byte 12: version 2.0");
    patched(place, NULL, 14, "\377\377\377\377", 4);
    expect_refusal(place->path, BRDF_BAD_FILE, "byte ");
    patched(place, NULL, 14, "\0\0\0\0", 4);
    expect_refusal(place->path, BRDF_BAD_FILE, "byte ");
    patched(place, "ndf", TYPE, "\13", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "\"ndf\" has rank 2 and type 11");
    patched(place, "ndf", TYPE, "\0", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "unknown type 0");
    patched(place, "vndf", RANK, "\3", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "\"vndf\" has rank 3");
    patched(place, "sigma", (size_t)0 - 5, "gamma", 5);
    expect_refusal(place->path, BRDF_BAD_FILE, "has no field \"sigma\"");
    patched(place, "phi_i", (size_t)0 - 5, "sigma", 5);
    expect_refusal(place->path, BRDF_BAD_FILE, "rank 1");
}

static void bad_sizes_are_refused(void **state)
{
    struct place *place = *state;
    patched(place, "ndf", FIRST_DIMENSION, "\377\377\377\377\377\377\377\377", 8);
    expect_refusal(place->path, BRDF_BAD_FILE, "larger than the file");
    patched(place, "ndf", FIRST_DIMENSION, "\0\0\0\0\0\0\0\200", 8);
    expect_refusal(place->path, BRDF_BAD_FILE, "larger than the file");
    patched(place, "vndf", FIRST_DIMENSION, "\0\0\0\0\1\0\0\0\0\0\0\0\1\0\0\0", 16);
    expect_refusal(place->path, BRDF_BAD_FILE, "larger than the file");
    patched(place, "ndf", FIRST_DIMENSION, "\1", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "dimension 0 of \"ndf\" is 1");
    patched(place, "theta_i", FIRST_DIMENSION, "\0", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "dimension 0 of \"theta_i\" is 0");
    patched(place, "vndf", FIRST_DIMENSION + 8, "\1", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "dimension 1 of \"vndf\" is 1, but must be 2");
    patched(place, "rgb", FIRST_DIMENSION + 16, "\2", 1);
    expect_refusal(place->path, BRDF_BAD_FILE, "dimension 2 of \"rgb\" is 2, but must be 3");
    patched(place, "luminance", DATA, "\377\377\377\377\377\377\377\177", 8);
    expect_refusal(place->path, BRDF_BAD_FILE, "lie outside of the file");
    patched(place, "luminance", DATA, "\377\377\377\377\377\377\377\377", 8);
    expect_refusal(place->path, BRDF_BAD_FILE, "lie outside of the file");
}

/* One float of a field, number `index`, as the bytes of the file. */
static size_t value_patched(struct place *place, const char *name, size_t index,
                            const char bytes[4])
{
    size_t at = field_at(place, name) + 2 + strlen(name) + DATA;
    size_t data = place->bytes[at] | (size_t)place->bytes[at + 1] << 8;
    patched(place, NULL, data + 4 * index, bytes, 4);
    return data + 4 * index;
}

static void bad_values_are_refused(void **state)
{
    struct place *place = *state;
    char words[80];
    size_t at = value_patched(place, "vndf", 7, "\0\0\300\177");
    snprintf(words, sizeof words, "byte %zu: value 7 of \"vndf\" is not a number", at);
    expect_refusal(place->path, BRDF_BAD_FILE, words);
    value_patched(place, "rgb", 0, "\0\0\200\377");
    expect_refusal(place->path, BRDF_BAD_FILE, "is infinite");
    value_patched(place, "luminance", 1, "\377\377\177\177");
    expect_refusal(place->path, BRDF_BAD_FILE, "too large");
    value_patched(place, "theta_i", 1, "\0\0\0\0");
    expect_refusal(place->path, BRDF_BAD_FILE, "not above the one before");
    value_patched(place, "theta_i", 1, "\0\0\200\100");
    expect_refusal(place->path, BRDF_BAD_FILE, "not an angle");
    value_patched(place, "sigma", 0, "\0\0\200\277");
    expect_refusal(place->path, BRDF_BAD_FILE, "\"sigma\" is negative");
}

/* Whatever a header says, there is an answer; the model then takes what has been accepted. */
static void changed_bytes_do_no_harm(void **state)
{
    struct place *place = *state;
    uint64_t random = 3;
    size_t accepted = 0;
    for (int i = 0; i < 4000; ++i) {
        struct brdf_rgl_file file;
        size_t at = (size_t)((double)rgl_test_uniform(&random) * (double)place->size);
        unsigned char byte = (unsigned char)(256.0 * (double)rgl_test_uniform(&random));
        patched(place, NULL, at, &byte, 1);
        struct brdf_bsdf *bsdf = NULL;
        struct brdf_setting setting = brdf_setting_text("filename", place->path);
        if (brdf_rgl_read(place->path, &file, NULL) == BRDF_OK) {
            brdf_rgl_free(&file);
            assert_int_equal(brdf_bsdf_create_from("measured", &setting, 1, &bsdf, NULL), BRDF_OK);
            struct brdf_sample s =
                brdf_sample(bsdf, rgl_test_direction(&random, 0.0), rgl_test_cube(&random));
            assert_true(s.pdf >= 0.0f && isfinite(s.pdf) && isfinite(s.weight.g));
            brdf_bsdf_destroy(bsdf);
            ++accepted;
        }
    }
    assert_true(accepted > 100 && accepted < 3900);
}

static void other_things_than_files_are_refused(void **state)
{
    struct place *place = *state;
    struct brdf_rgl_file file;
    unlink(place->path);
    expect_refusal(place->path, BRDF_IO, "No such file");
    expect_refusal(place->folder, BRDF_IO, "a folder");
    assert_int_equal(mkfifo(place->path, 0600), 0);
    expect_refusal(place->path, BRDF_IO, "a pipe"); /* and does not wait for a writer */
    assert_int_equal(brdf_rgl_read(NULL, &file, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_read(place->path, NULL, NULL), BRDF_BAD_ARGUMENT);
}

static void nothing_odd_is_made_or_written(void **state)
{
    struct place *place = *state;
    struct brdf_error error;
    struct brdf_rgl_file file = rgl_test_make("diffuse", &tiny), none;
    struct brdf_bsdf *bsdf = bsdf_make("diffuse");
    const struct brdf_rgl_grid two_phis = {.phis = 2}, third = {.phis = 4, .symmetry = 3};
    assert_int_equal(brdf_rgl_make(rgl_test_values, bsdf, &two_phis, &none, NULL),
                     BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_make(rgl_test_values, bsdf, &third, &none, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_make(NULL, bsdf, &tiny, &none, NULL), BRDF_BAD_ARGUMENT);
    assert_int_equal(brdf_rgl_write(place->folder, &file, &error), BRDF_IO);
    assert_non_null(strstr(error.message, "not a regular file"));
    file.vndf[3] = (float)NAN;
    assert_int_equal(brdf_rgl_write(place->path, &file, &error), BRDF_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "value 3 of \"vndf\" is not a number"));
    file.vndf[3] = 0.0f;
    file.size = 1;
    assert_int_equal(brdf_rgl_write(place->path, &file, &error), BRDF_BAD_ARGUMENT);
    brdf_rgl_free(&file);
    brdf_bsdf_destroy(bsdf);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, place_make, place_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(written_values_are_read_back),
        TEST(other_lengths_are_refused),
        TEST(bad_headers_are_refused),
        TEST(bad_sizes_are_refused),
        TEST(bad_values_are_refused),
        TEST(changed_bytes_do_no_harm),
        TEST(other_things_than_files_are_refused),
        TEST(nothing_odd_is_made_or_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
