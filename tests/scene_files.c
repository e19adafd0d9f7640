/* scene_files.c - scenes in a temporary folder. */
#define _POSIX_C_SOURCE 200809L
#include "scene_files.h"
#include "support_place.h"

#include <math.h>
#include <unistd.h>

#define FILES_MAX 64
#define PATH_SIZE 512

static struct place place;
static char written[FILES_MAX][PATH_SIZE];
static int written_count;

int scene_files_open(void **state)
{
    (void)state;
    written_count = 0;
    return place_make(&place, "nothing");
}

int scene_files_close(void **state)
{
    (void)state;
    for (int i = 0; i < written_count; ++i) {
        unlink(written[i]);
    }
    return place_remove(&place);
}

static const char *path_of(const char *name)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s", place.folder, name);
    for (int i = 0; i < written_count; ++i) {
        if (strcmp(written[i], path) == 0) {
            return written[i];
        }
    }
    assert_true(written_count < FILES_MAX);
    memcpy(written[written_count], path, sizeof path);
    return written[written_count++];
}

const char *scene_file_write_bytes(const char *name, const void *bytes, size_t length)
{
    const char *path = path_of(name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
    return path;
}

const char *scene_file_write(const char *name, const char *text)
{
    return scene_file_write_bytes(name, text, strlen(text));
}

brdf_status scene_text_load(const char *text, const struct brdfcl_define *defines, size_t count,
                            struct brdfcl_scene **scene, struct brdf_error *error)
{
    return brdfcl_scene_load(scene_file_write("scene.xml", text), defines, count, scene, error);
}

struct brdfcl_scene *scene_content_load(const char *content)
{
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    size_t size = strlen(content) + 256;
    char *text = malloc(size);
    assert_non_null(text);
    snprintf(text, size,
             "<scene version=\"3.0.0\"><integrator type=\"path\"/><sensor type=\"perspective\"/>\n"
             "%s</scene>",
             content);
    if (scene_text_load(text, NULL, 0, &scene, &error)) {
        free(text);
        fail_msg("%s", error.message);
    }
    free(text);
    assert_non_null(scene);
    return scene;
}

const float *scene_row(const struct brdfcl_scene *scene, size_t index)
{
    assert_true(index < scene->primitives.count);
    return scene->primitives.words + PT_ROW * index;
}

int scene_row_int(const float *row, int word)
{
    int value;
    memcpy(&value, row + word, sizeof value);
    return value;
}

void assert_vector(const float *row, int word, float x, float y, float z)
{
    const float expected[3] = {x, y, z};
    for (int i = 0; i < 3; ++i) {
        if (!(fabsf(row[word + i] - expected[i]) <= 1e-6f)) {
            fail_msg("word %d is %g, expected %g", word + i, (double)row[word + i],
                     (double)expected[i]);
        }
    }
}

void scene_mistakes_check(const struct scene_mistake *mistakes, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        const struct scene_mistake *m = &mistakes[i];
        struct brdfcl_scene *scene = (struct brdfcl_scene *)(void *)&scene;
        struct brdf_error error = {BRDF_OK, ""};
        char place[32];
        brdf_status status = scene_text_load(m->text, NULL, 0, &scene, &error);
        snprintf(place, sizeof place, "scene.xml:%d:", m->line);
        if (status != m->status || error.status != m->status || scene ||
            !strstr(error.message, m->says) || (m->line > 0 && !strstr(error.message, place))) {
            fail_msg("%s\n-> status %d, \"%s\"\nexpected %d, line %d, \"%s\"", m->text, status,
                     error.message, m->status, m->line, m->says);
        }
    }
}

int scene_has_note(const struct brdfcl_scene *scene, const char *text)
{
    for (size_t i = 0; brdfcl_scene_note(scene, i); ++i) {
        if (strstr(brdfcl_scene_note(scene, i), text)) {
            return 1;
        }
    }
    return 0;
}
