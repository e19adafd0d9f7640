/* test_scene.c - scenes become the rows that their shapes and transforms mean, as in Mitsuba 3. */
#define _POSIX_C_SOURCE 200809L
#include "scene_files.h"

#include <math.h>

#include <brdf/model.h>

static void defaults(void **state)
{
    struct brdfcl_scene *scene = scene_content_load("");
    struct brdfcl_scene_info info = brdfcl_scene_get_info(scene);
    (void)state;
    assert_int_equal(info.width, 768);
    assert_int_equal(info.height, 576);
    assert_int_equal(info.spp, 4);
    assert_int_equal(info.max_depth, -1);
    assert_int_equal(info.rr_depth, 5);
    assert_int_equal(info.seed, 0);
    assert_int_equal(info.half, 1);
    assert_int_equal(info.primitive_count, 0);
    assert_string_equal(info.sampler, "independent");
    assert_string_equal(info.filter, "gaussian");
    assert_true(scene->filter_sigma == 0.5f && scene->filter_radius == 2.0f);
    /* 50 mm on 36 x 24 mm: 2 atan(sqrt(36^2 + 24^2) / 100) = 46.7930 degrees across. */
    assert_int_equal(scene->fov_axis, FOV_DIAGONAL);
    assert_true(fabsf(scene->fov - 46.7930f) < 1e-3f);
    assert_int_equal(scene->environment.kind, ENVIRONMENT_NONE);
    assert_true(scene_has_note(scene, "no shapes"));
    assert_null(brdfcl_scene_note(scene, 1));
    brdfcl_scene_destroy(scene);
    brdfcl_scene_destroy(NULL);
}

static void settings(void **state)
{
    static const struct brdfcl_define spp = {"spp", "12"};
    const char *text =
        "<scene version=\"3.0.0\">\n"
        "<default name=\"spp\" value=\"64\"/><default name=\"w\" value=\"32\"/>"
        "<integrator type=\"path\"><integer name=\"max_depth\" value=\" 7 \"/>"
        "<integer name=\"rr_depth\" value=\"3\"/></integrator>"
        "<sensor type=\"perspective\"><float name=\"fov\" value=\"40\"/>"
        "<string name=\"fov_axis\" value=\"smaller\"/>\n"
        "<float name=\"near_clip\" value=\"0.1\"/>"
        "<film type=\"hdrfilm\"><integer name=\"width\" value=\"1$w\"/>"
        "<integer name=\"height\" value=\"16\"/><rfilter type=\"tent\">"
        "<float name=\"radius\" value=\"1.5\"/></rfilter>"
        "<string name=\"component_format\" value=\"float32\"/></film>\n"
        "<sampler type=\"multijitter\"><integer name=\"sample_count\" value=\"$spp\"/>"
        "<integer name=\"seed\" value=\"5\"/></sampler></sensor></scene>";
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    struct brdfcl_scene_info info;
    (void)state;
    if (scene_text_load(text, &spp, 1, &scene, &error)) {
        fail_msg("%s", error.message);
    }
    info = brdfcl_scene_get_info(scene);
    assert_int_equal(info.width, 132);
    assert_int_equal(info.height, 16);
    assert_int_equal(info.spp, 12);
    assert_int_equal(info.max_depth, 7);
    assert_int_equal(info.rr_depth, 3);
    assert_int_equal(info.seed, 5);
    assert_int_equal(info.half, 0);
    assert_string_equal(info.sampler, "sobol");
    assert_string_equal(info.filter, "tent");
    assert_true(scene->filter_radius == 1.5f);
    assert_true(scene->fov == 40.0f && scene->fov_axis == FOV_SMALLER);
    assert_true(scene_has_note(scene, "scene.xml:4:"));
    assert_true(scene_has_note(scene, "Sobol"));
    assert_true(scene_has_note(scene, "near_clip changes nothing"));
    brdfcl_scene_destroy(scene);
}

static void setters(void **state)
{
    struct brdfcl_scene *scene = scene_content_load("");
    struct brdf_error error = {BRDF_OK, ""};
    struct brdfcl_scene_info info;
    (void)state;
    assert_int_equal(brdfcl_scene_set_size(scene, 10, 65536, &error), BRDF_OK);
    assert_int_equal(brdfcl_scene_set_spp(scene, 16777216, &error), BRDF_OK);
    assert_int_equal(brdfcl_scene_set_depth(scene, -1, &error), BRDF_OK);
    brdfcl_scene_set_seed(scene, 9);
    assert_int_equal(brdfcl_scene_set_size(scene, 0, 5, &error), BRDF_OUT_OF_RANGE);
    assert_non_null(strstr(error.message, "width = 0"));
    assert_int_equal(brdfcl_scene_set_size(scene, 5, 65537, &error), BRDF_OUT_OF_RANGE);
    assert_int_equal(brdfcl_scene_set_spp(scene, 0, &error), BRDF_OUT_OF_RANGE);
    assert_int_equal(brdfcl_scene_set_spp(scene, 16777217, &error), BRDF_OUT_OF_RANGE);
    assert_int_equal(brdfcl_scene_set_depth(scene, -2, NULL), BRDF_OUT_OF_RANGE);
    info = brdfcl_scene_get_info(scene);
    assert_int_equal(info.width, 10);
    assert_int_equal(info.height, 65536);
    assert_int_equal(info.spp, 16777216);
    assert_int_equal(info.seed, 9);
    brdfcl_scene_destroy(scene);
}

static void shapes(void **state)
{
    struct brdfcl_scene *scene =
        scene_content_load("<shape type=\"rectangle\"/><shape type=\"disk\"/>"
                           "<shape type=\"sphere\"><point name=\"center\" x=\"1\" y=\"2\" z=\"3\"/>"
                           "<float name=\"radius\" value=\"0.5\"/></shape><shape type=\"cube\"/>");
    const float *row = scene_row(scene, 0);
    (void)state;
    assert_int_equal(scene->primitives.count, 9);
    assert_int_equal(scene_row_int(row, PT_KIND), PT_RECTANGLE);
    assert_int_equal(scene_row_int(row, PT_SHADING), -1);
    assert_vector(row, PT_P, -1, -1, 0);
    assert_vector(row, PT_E1, 2, 0, 0);
    assert_vector(row, PT_E2, 0, 2, 0);
    assert_true(row[PT_FLIP] == 1.0f && row[PT_RADIUS] == 0.0f);
    row = scene_row(scene, 1);
    assert_int_equal(scene_row_int(row, PT_KIND), PT_DISK);
    assert_vector(row, PT_P, 0, 0, 0);
    assert_vector(row, PT_E1, 1, 0, 0);
    assert_vector(row, PT_E2, 0, 1, 0);
    row = scene_row(scene, 2);
    assert_int_equal(scene_row_int(row, PT_KIND), PT_SPHERE);
    assert_vector(row, PT_P, 1, 2, 3);
    assert_vector(row, PT_E1, 0.5f, 0, 0);
    assert_vector(row, PT_E2, 0, 0.5f, 0);
    assert_true(row[PT_FLIP] == 1.0f && row[PT_RADIUS] == 0.5f);
    for (size_t i = 3; i < 9; ++i) { /* flip (e1 x e2) looks away from the cube's middle */
        const float *r = scene_row(scene, i);
        float n[3];
        float out = 0.0f;
        for (int k = 0; k < 3; ++k) {
            int a = (k + 1) % 3;
            int b = (k + 2) % 3;
            n[k] = r[PT_E1 + a] * r[PT_E2 + b] - r[PT_E1 + b] * r[PT_E2 + a];
            out += r[PT_FLIP] * n[k] * (r[PT_P + k] + 0.5f * (r[PT_E1 + k] + r[PT_E2 + k]));
        }
        assert_true(out == 4.0f);
    }
    brdfcl_scene_destroy(scene);
}

/* One rectangle under a transform; its centre, and where its x and y edges go. */
static void check_transform(const char *operations, const float centre[3], const float x[3],
                            const float y[3], float flip)
{
    char text[1024];
    struct brdfcl_scene *scene;
    const float *row;
    snprintf(text, sizeof text,
             "<shape type=\"rectangle\"><transform name=\"to_world\">%s</transform></shape>",
             operations);
    scene = scene_content_load(text);
    row = scene_row(scene, 0);
    assert_vector(row, PT_E1, 2 * x[0], 2 * x[1], 2 * x[2]);
    assert_vector(row, PT_E2, 2 * y[0], 2 * y[1], 2 * y[2]);
    assert_vector(row, PT_P, centre[0] - x[0] - y[0], centre[1] - x[1] - y[1],
                  centre[2] - x[2] - y[2]);
    assert_true(row[PT_FLIP] == flip);
    brdfcl_scene_destroy(scene);
}

#define V(x, y, z) ((const float[3]){x, y, z})

static void transforms(void **state)
{
    (void)state;
    check_transform("", V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), 1);
    check_transform("<translate x=\"1\" z=\"3\"/>", V(1, 0, 3), V(1, 0, 0), V(0, 1, 0), 1);
    check_transform("<scale value=\"2\"/>", V(0, 0, 0), V(2, 0, 0), V(0, 2, 0), 1);
    check_transform("<scale x=\"2\" y=\"3\"/>", V(0, 0, 0), V(2, 0, 0), V(0, 3, 0), 1);
    check_transform("<scale value=\"2, 3 1\"/>", V(0, 0, 0), V(2, 0, 0), V(0, 3, 0), 1);
    /* z to x to y: counter-clockwise seen from the tip of the axis */
    check_transform("<rotate z=\"1\" angle=\"90\"/>", V(0, 0, 0), V(0, 1, 0), V(-1, 0, 0), 1);
    check_transform("<rotate x=\"1\" angle=\"90\"/>", V(0, 0, 0), V(1, 0, 0), V(0, 0, 1), 1);
    check_transform("<rotate y=\"1\" angle=\"-450\"/>", V(0, 0, 0), V(0, 0, 1), V(0, 1, 0), 1);
    check_transform("<rotate z=\"1\" angle=\"30\"/>", V(0, 0, 0), V(0.8660254f, 0.5f, 0),
                    V(-0.5f, 0.8660254f, 0), 1);
    /* a third of a turn about the diagonal carries x to y to z */
    check_transform("<rotate value=\"1 1 1\" angle=\"120\"/>", V(0, 0, 0), V(0, 1, 0), V(0, 0, 1),
                    1);
    /* the first is applied first */
    check_transform("<translate x=\"1\"/><scale value=\"2\"/>", V(2, 0, 0), V(2, 0, 0), V(0, 2, 0),
                    1);
    check_transform("<scale value=\"2\"/><translate x=\"1\"/>", V(1, 0, 0), V(2, 0, 0), V(0, 2, 0),
                    1);
    check_transform("<matrix value=\"0 1 0 4 2 0 0 5 0 0 1 6 0 0 0 1\"/>", V(4, 5, 6), V(0, 2, 0),
                    V(1, 0, 0), -1);
    check_transform("<matrix value=\"0 1 0 2 0 0 0 0 1\"/>", V(0, 0, 0), V(0, 2, 0), V(1, 0, 0),
                    -1);
    /* +z to the target, +y up, +x to the left */
    check_transform("<lookat origin=\"0, 0, 5\" target=\"0, 0, 0\" up=\"0, 1, 0\"/>", V(0, 0, 5),
                    V(-1, 0, 0), V(0, 1, 0), 1);
    check_transform("<lookat origin=\"1 2 3\" target=\"4 2 3\" up=\"5 0 2\"/>", V(1, 2, 3),
                    V(0, 1, 0), V(0, 0, 1), 1);
    /* a mirror keeps the side of a rectangle: its normal goes with the inverse transposed */
    check_transform("<scale x=\"-1\"/>", V(0, 0, 0), V(-1, 0, 0), V(0, 1, 0), -1);
    check_transform("<scale z=\"-1\"/>", V(0, 0, 0), V(1, 0, 0), V(0, 1, 0), -1);
}

static void flipped_normals(void **state)
{
    struct brdfcl_scene *scene = scene_content_load(
        "<shape type=\"rectangle\"><boolean name=\"flip_normals\" value=\"true\"/></shape>"
        "<shape type=\"disk\"><boolean name=\"flip_normals\" value=\"True\"/></shape>"
        "<shape type=\"sphere\"><boolean name=\"flip_normals\" value=\"true\"/></shape>"
        "<shape type=\"sphere\"><transform name=\"to_world\"><scale x=\"-2\" y=\"2\" z=\"2\"/>"
        "</transform></shape>"
        "<shape type=\"disk\"><transform name=\"to_world\"><scale x=\"-2\" y=\"2\" z=\"2\"/>"
        "</transform><boolean name=\"flip_normals\" value=\"true\"/></shape>");
    static const float expected[] = {-1.0f, -1.0f, -1.0f, -1.0f, 1.0f};
    (void)state;
    for (size_t i = 0; i < 5; ++i) {
        assert_true(scene_row(scene, i)[PT_FLIP] == expected[i]);
    }
    assert_true(scene_row(scene, 3)[PT_RADIUS] == 2.0f);
    brdfcl_scene_destroy(scene);
}

static void camera(void **state)
{
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    (void)state;
    if (scene_text_load("<scene version=\"3.0.0\"><sensor type=\"perspective\">"
                        "<transform name=\"to_world\"><lookat origin=\"1 2 3\" target=\"1 2 4\"/>"
                        "</transform><string name=\"focal_length\" value=\"43.2666153mm\"/>"
                        "<float name=\"principal_point_offset_y\" value=\"0.25\"/>"
                        "</sensor></scene>",
                        NULL, 0, &scene, &error)) {
        fail_msg("%s", error.message);
    }
    /* without `up`: the tangent that Mitsuba chooses */
    assert_vector(scene->camera_to_world, 0, 0, 1, 0);
    assert_vector(scene->camera_to_world, 4, -1, 0, 0);
    assert_vector(scene->camera_to_world, 8, 0, 0, 1);
    assert_true(scene->camera_to_world[3] == 1.0f && scene->camera_to_world[11] == 3.0f);
    assert_true(fabsf(scene->fov - 53.1301f) < 1e-3f); /* the diagonal at its own distance */
    assert_true(scene->principal_offset[0] == 0.0f && scene->principal_offset[1] == 0.25f);
    assert_true(scene_has_note(scene, "no <integrator>"));
    brdfcl_scene_destroy(scene);
}

static void sensor_of_several(void **state)
{
    struct brdfcl_scene *scene = scene_content_load("<sensor type=\"perspective\"/>");
    (void)state;
    assert_true(scene_has_note(scene, "first sensor"));
    brdfcl_scene_destroy(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(defaults),   cmocka_unit_test(settings),
        cmocka_unit_test(setters),    cmocka_unit_test(shapes),
        cmocka_unit_test(transforms), cmocka_unit_test(flipped_normals),
        cmocka_unit_test(camera),     cmocka_unit_test(sensor_of_several),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
