/* test_scene_mesh.c - obj and ply: rows, normals, texture coordinates, and what is refused. */
#define _POSIX_C_SOURCE 200809L
#include "scene_files.h"

#include <math.h>

/* Asked by the leak checker, if there is one: assimp itself loses memory over some damaged files.
 */
const char *__lsan_default_suppressions(void);

const char *__lsan_default_suppressions(void)
{
    return "leak:libassimp";
}

static struct brdfcl_scene *load_mesh(const char *type, const char *text, const char *more)
{
    char name[32];
    char scene[1024];
    snprintf(name, sizeof name, "mesh.%s", type);
    scene_file_write(name, text);
    snprintf(scene, sizeof scene,
             "<shape type=\"%s\"><string name=\"filename\" value=\"%s\"/>%s</shape>", type, name,
             more);
    return scene_content_load(scene);
}

static const float *shading_of(const struct brdfcl_scene *scene, size_t primitive)
{
    int row = scene_row_int(scene_row(scene, primitive), PT_SHADING);
    assert_in_range(row, 0, (int)scene->shading.count - 1);
    return scene->shading.words + PT_ROW * row;
}

#define TENT                                                                                       \
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nf 1 2 3 4\n" /* quad, and a wall on it  \
                                                                         */

static void polygons_become_fans(void **state)
{
    struct brdfcl_scene *scene = load_mesh("obj", TENT, "");
    (void)state;
    assert_int_equal(scene->primitives.count, 2);
    assert_int_equal(scene_row_int(scene_row(scene, 0), PT_KIND), PT_TRIANGLE);
    assert_vector(scene_row(scene, 0), PT_P, 0, 0, 0);
    assert_vector(scene_row(scene, 0), PT_E1, 1, 0, 0);
    assert_vector(scene_row(scene, 0), PT_E2, 1, 1, 0);
    assert_vector(scene_row(scene, 1), PT_E1, 1, 1, 0);
    assert_vector(scene_row(scene, 1), PT_E2, 0, 1, 0);
    brdfcl_scene_destroy(scene);
}

static void normals_are_weighted_by_angle(void **state)
{
    struct brdfcl_scene *scene = load_mesh("obj", TENT "f 1 6 2\nf 1 5 6\n", "");
    const float *shading = shading_of(scene, 0);
    const float r = 0.70710678f;
    (void)state;
    assert_int_equal(scene->primitives.count, 4);
    /* vertex 1: 90 degrees of +z and 90 degrees of +y; vertex 3: +z alone */
    assert_vector(shading, PT_NORMALS, 0, r, r);
    assert_vector(shading, PT_NORMALS + 6, 0, 0, 1);
    /* without texture coordinates: the triangle's own */
    assert_vector(shading, PT_UVS, 0, 0, 1);
    assert_vector(shading, PT_UVS + 3, 0, 0, 1);
    brdfcl_scene_destroy(scene);
}

static void flat_and_flipped(void **state)
{
    struct brdfcl_scene *scene =
        load_mesh("obj", TENT, "<boolean name=\"face_normals\" value=\"true\"/>");
    (void)state;
    assert_int_equal(scene_row_int(scene_row(scene, 0), PT_SHADING), -1);
    assert_true(scene_row(scene, 0)[PT_FLIP] == 1.0f);
    brdfcl_scene_destroy(scene);

    scene = load_mesh("obj", TENT,
                      "<boolean name=\"face_normals\" value=\"true\"/>"
                      "<boolean name=\"flip_normals\" value=\"true\"/>");
    assert_true(scene_row(scene, 0)[PT_FLIP] == -1.0f);
    brdfcl_scene_destroy(scene);

    scene = load_mesh("obj", TENT, "<boolean name=\"flip_normals\" value=\"true\"/>");
    assert_true(scene_row(scene, 0)[PT_FLIP] == -1.0f);
    assert_vector(shading_of(scene, 0), PT_NORMALS, 0, 0, -1);
    brdfcl_scene_destroy(scene);
}

#define SHADED                                                                                     \
    "v 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0.25 0.125\nvt 1 0\nvt 0 1\nvn 0 3 -4\nvn 0 0 -2\n"             \
    "f 1/1/1 2/2/2 3/3/2\n"

static void normals_and_uvs_of_the_file_are_kept(void **state)
{
    struct brdfcl_scene *scene = load_mesh("obj", SHADED, "");
    (void)state;
    assert_vector(shading_of(scene, 0), PT_NORMALS, 0, 0.6f, -0.8f);
    assert_vector(shading_of(scene, 0), PT_NORMALS + 3, 0, 0, -1);
    assert_vector(shading_of(scene, 0), PT_UVS, 0.25f, 0.875f, 1); /* obj: v is 1 - v */
    assert_vector(shading_of(scene, 0), PT_UVS + 3, 1, 0, 0);
    /* the winding says +z, the normals -z: the normals count */
    assert_true(scene_row(scene, 0)[PT_FLIP] == -1.0f);
    brdfcl_scene_destroy(scene);

    scene = load_mesh("obj", SHADED, "<boolean name=\"flip_tex_coords\" value=\"false\"/>");
    assert_vector(shading_of(scene, 0), PT_UVS, 0.25f, 0.125f, 1);
    brdfcl_scene_destroy(scene);

    scene = load_mesh("obj", SHADED,
                      "<transform name=\"to_world\"><scale x=\"1\" y=\"1\" z=\"-2\"/>"
                      "<translate z=\"5\"/></transform>");
    assert_vector(scene_row(scene, 0), PT_P, 0, 0, 5);
    assert_vector(shading_of(scene, 0), PT_NORMALS, 0, 0.8320503f, 0.5547002f); /* (0, 3, 2) */
    brdfcl_scene_destroy(scene);
}

static void ply_shares_its_vertices(void **state)
{
    struct brdfcl_scene *scene =
        load_mesh("ply",
                  "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
                  "property float z\nproperty float u\nproperty float v\nelement face 2\n"
                  "property list uchar int vertex_indices\nend_header\n"
                  "0 0 0 0.5 0.25\n1 0 0 0 0\n0 1 0 0 0\n0 0 0 0 0\n0 0 1 0 0\n1 0 0 0 0\n"
                  "3 0 1 2\n3 3 4 5\n",
                  "");
    (void)state;
    /* vertices 0 and 3 are at one place and still two: a crease */
    assert_vector(shading_of(scene, 0), PT_NORMALS, 0, 0, 1);
    assert_vector(shading_of(scene, 1), PT_NORMALS, 0, 1, 0);
    assert_vector(shading_of(scene, 0), PT_UVS, 0.5f, 0.25f, 0);
    brdfcl_scene_destroy(scene);
}

static void triangles_without_area_are_dropped(void **state)
{
    struct brdfcl_scene *scene =
        load_mesh("obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 4\nf 1 2 4\n", "");
    (void)state;
    assert_int_equal(scene->primitives.count, 1);
    assert_true(scene_has_note(scene, "2 of 3 triangles have no area"));
    brdfcl_scene_destroy(scene);
}

static void corners_without_normals_are_counted(void **state)
{
    struct brdfcl_scene *scene =
        load_mesh("obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nvn 0 1 1\nf 1//1 2//2 3//2\n", "");
    (void)state;
    assert_vector(shading_of(scene, 0), PT_NORMALS, 0, 0, 1);
    assert_true(scene_has_note(scene, "1 corners have no normal"));
    brdfcl_scene_destroy(scene);
}

#define PLY_HEAD(vertices, faces)                                                                  \
    "ply\nformat ascii 1.0\nelement vertex " vertices "\nproperty float x\nproperty float y\n"     \
    "property float z\nelement face " faces                                                        \
    "\nproperty list uchar int vertex_indices\nend_header\n"

static void damaged_meshes_are_refused(void **state)
{
    static const struct {
        const char *type;
        const char *text;
        const char *says;
    } cases[] = {
        {"obj", "", "empty"},
        {"obj", "not a mesh at all\n", "mesh.obj"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "mesh.obj"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "mesh.obj"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", "mesh.obj"},
        {"obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite"},
        {"obj", "v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "not finite"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 1\nf 1//1 2//1 3//1\n", "not finite"},
        {"obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no triangles (1 without area"},
        {"obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "mesh.obj"},
        {"ply", "ply\nformat ascii 1.0\n", "mesh.ply"},
        {"ply", PLY_HEAD("3", "1") "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", "mesh.ply"},
        {"ply", PLY_HEAD("3", "1") "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "mesh.ply"},
        {"ply", PLY_HEAD("3", "1") "0 0 0\nnan 0 0\n0 1 0\n3 0 1 2\n", "mesh.ply"},
        {"ply", PLY_HEAD("3", "1") "0 0 0\n1 0 0\n", "mesh.ply"},
        {"ply", PLY_HEAD("3", "0") "0 0 0\n1 0 0\n0 1 0\n", "mesh.ply"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdfcl_scene *scene = NULL;
        struct brdf_error error = {BRDF_OK, ""};
        char name[32];
        char text[512];
        snprintf(name, sizeof name, "mesh.%s", cases[i].type);
        scene_file_write(name, cases[i].text);
        snprintf(text, sizeof text,
                 "<scene version=\"3.0.0\"><sensor type=\"perspective\"/>\n<shape type=\"%s\">\n"
                 "<string name=\"filename\" value=\"%s\"/></shape></scene>",
                 cases[i].type, name);
        if (scene_text_load(text, NULL, 0, &scene, &error) != BRDF_BAD_FILE || scene ||
            !strstr(error.message, "scene.xml:3:") || !strstr(error.message, cases[i].says)) {
            fail_msg("case %d (%s): %d \"%s\"", (int)i, cases[i].says, error.status, error.message);
        }
    }
}

/* No damage to a file brings anything but an error or a scene. */
static void every_truncation_and_flip_is_survived(void **state)
{
    static const char *const texts[] = {SHADED,
                                        PLY_HEAD("3", "1") "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"};
    static const char *const types[] = {"obj", "ply"};
    (void)state;
    for (size_t i = 0; i < 2; ++i) {
        size_t length = strlen(texts[i]);
        char scene_text[256];
        char name[32];
        char *bytes = malloc(length);
        assert_non_null(bytes);
        snprintf(name, sizeof name, "mesh.%s", types[i]);
        snprintf(scene_text, sizeof scene_text,
                 "<scene version=\"3.0.0\"><sensor type=\"perspective\"/><shape type=\"%s\">"
                 "<string name=\"filename\" value=\"%s\"/></shape></scene>",
                 types[i], name);
        for (size_t k = 0; k < 2 * length; ++k) {
            struct brdfcl_scene *scene = NULL;
            memcpy(bytes, texts[i], length);
            bytes[k / 2] = (char)(bytes[k / 2] ^ (k % 2 ? 0x10 : 0x03));
            scene_file_write_bytes(name, bytes, k % 2 ? length : k / 2);
            if (scene_text_load(scene_text, NULL, 0, &scene, NULL) == BRDF_OK) {
                assert_true(scene->primitives.count > 0);
            }
            brdfcl_scene_destroy(scene);
        }
        free(bytes);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polygons_become_fans),
        cmocka_unit_test(normals_are_weighted_by_angle),
        cmocka_unit_test(flat_and_flipped),
        cmocka_unit_test(normals_and_uvs_of_the_file_are_kept),
        cmocka_unit_test(ply_shares_its_vertices),
        cmocka_unit_test(triangles_without_area_are_dropped),
        cmocka_unit_test(corners_without_normals_are_counted),
        cmocka_unit_test(damaged_meshes_are_refused),
        cmocka_unit_test(every_truncation_and_flip_is_survived),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
