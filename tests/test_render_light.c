/*
 * test_render_light.c - light of every kind on a floor, against what geometry says it receives.
 *
 * The camera looks at one point of the floor under a tiny angle, so that every pixel estimates the
 * same number. The lights fill anything between a dot and the hemisphere: small ones are found by
 * next-event estimation, large ones by sampling the floor's reflection as well.
 */
#include "angle.h"
#include "irradiance.h"
#include "render_scenes.h"

#include <math.h>

#define ALBEDO 0.6
#define FLOOR                                                                                      \
    "<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"9\"/>"                  \
    "<rotate x=\"1\" angle=\"-90\"/></transform><bsdf type=\"diffuse\">"                           \
    "<rgb name=\"reflectance\" value=\"0.6\"/></bsdf></shape>\n"
#define EMITTER(radiance)                                                                          \
    "<emitter type=\"area\"><rgb name=\"radiance\" value=\"" radiance "\"/></emitter></shape>\n"

static const struct view at_origin = {"7, 1.5, 0", "0, 0, 0", 0.01, 20, 500, 2, 0, NULL, NULL};

static void check_floor(const char *name, const char *lights, double irradiance, double slack)
{
    char content[8192];
    snprintf(content, sizeof content, "%s%s", FLOOR, lights);
    assert_estimate(name, render_estimate(&at_origin, content), ALBEDO / pi * irradiance, slack,
                    4e-3);
}

#define DOWN(x, y, z, sx, sz)                                                                      \
    "<transform name=\"to_world\"><scale x=\"" #sx "\" y=\"" #sz "\"/>"                            \
    "<rotate x=\"1\" angle=\"90\"/><translate x=\"" #x "\" y=\"" #y "\" z=\"" #z                   \
    "\"/></transform>"

#define RECTANGLE(x, y, z, sx, sz, radiance)                                                       \
    "<shape type=\"rectangle\">" DOWN(x, y, z, sx, sz) EMITTER(radiance)
#define DISK(x, y, z, sx, sz, radiance)                                                            \
    "<shape type=\"disk\">" DOWN(x, y, z, sx, sz) EMITTER(radiance)
#define BALL(x, y, z, r, radiance)                                                                 \
    "<shape type=\"sphere\"><point name=\"center\" x=\"" #x "\" y=\"" #y "\" z=\"" #z "\"/>"       \
    "<float name=\"radius\" value=\"" #r "\"/>" EMITTER(radiance)
#define FLIPPED "<boolean name=\"flip_normals\" value=\"true\"/>"

static void rectangles(void **state)
{
    (void)state;
    check_floor("rectangle", RECTANGLE(0.5, 2, -0.3, 0.4, 0.7, "3"),
                3.0 * rectangle_irradiance(0.4, 0.7, (struct point){0.5, 2.0, -0.3}), 2e-4);
    check_floor("huge rectangle", RECTANGLE(0.5, 1, -0.3, 3.5, 8, "3"),
                3.0 * rectangle_irradiance(3.5, 8.0, (struct point){0.5, 1.0, -0.3}), 2e-4);
    /* So near that the start of a shadow ray, a little above the floor, is a part of the way. */
    check_floor("rectangle at the floor", RECTANGLE(0, 0.02, 0, 0.03, 0.02, "3"),
                3.0 * rectangle_irradiance(0.03, 0.02, (struct point){0.0, 0.02, 0.0}), 6e-3);
}

static void disks(void **state)
{
    const double c = cos(70.0 * pi / 180.0);
    const double s = sin(70.0 * pi / 180.0);
    const struct point centre = {-0.8, 1.5, 0.4};
    const struct point a = {0.5, 0.0, 0.0};
    const struct point b = {0.0, 0.8 * c, 0.8 * s};
    (void)state;
    check_floor("disk overhead", DISK(0, 1, 0, 0.5, 0.5, "2"), 2.0 * pi * 0.25 / 1.25, 2e-4);
    check_floor("tilted ellipse",
                "<shape type=\"disk\"><transform name=\"to_world\"><scale x=\"0.5\" y=\"0.8\"/>"
                "<rotate x=\"1\" angle=\"70\"/>"
                "<translate x=\"-0.8\" y=\"1.5\" z=\"0.4\"/></transform>" EMITTER("2"),
                2.0 * disk_irradiance(centre, a, b), 2e-4);
}

static void spheres(void **state)
{
    (void)state;
    check_floor("sphere", BALL(-1, 1.2, 0.3, 0.4, "5"),
                5.0 * sphere_irradiance((struct point){-1.0, 1.2, 0.3}, 0.4), 2e-4);
    check_floor("large sphere", BALL(0.2, 2, 0, 1.9, "5"),
                5.0 * sphere_irradiance((struct point){0.2, 2.0, 0.0}, 1.9), 2e-4);
    check_floor("far and small", BALL(-3, 6, 2, 0.01, "50000"),
                50000.0 * sphere_irradiance((struct point){-3.0, 6.0, 2.0}, 0.01), 2e-4);
    check_floor("from inside",
                "<shape type=\"sphere\">" FLIPPED
                "<float name=\"radius\" value=\"30\"/>" EMITTER("0.7"),
                0.7 * pi, 2e-4);
}

static void meshes(void **state)
{
    const struct point corner[5] = {
        {-1.0, 1.5, -0.5}, {1.2, 1.5, -0.5}, {1.2, 1.5, 0.5}, {-1.0, 1.5, 0.5}, {0.1, 2.0, 1.5}};
    const struct point one[3] = {corner[0], corner[1], corner[2]};
    const struct point two[3] = {corner[0], corner[2], corner[3]};
    const struct point three[3] = {corner[3], corner[2], corner[4]};
    (void)state;
    scene_file_write("roof.obj", "v -1 1.5 -0.5\nv 1.2 1.5 -0.5\nv 1.2 1.5 0.5\nv -1 1.5 0.5\n"
                                 "v 0.1 2 1.5\nf 1 2 3\nf 1 3 4\nf 4 3 5\n");
    check_floor("mesh",
                "<shape type=\"obj\"><string name=\"filename\" value=\"roof.obj\"/>"
                "<boolean name=\"face_normals\" value=\"true\"/>" EMITTER("4"),
                4.0 * (polygon_irradiance(one, 3) + polygon_irradiance(two, 3) +
                       polygon_irradiance(three, 3)),
                2e-4);
}

static void many_lights_add_up(void **state)
{
    const struct point centre = {1.5, 2.0, 1.5};
    const struct point a = {0.5, 0.0, 0.0};
    const struct point b = {0.0, 0.0, 0.5};
    (void)state;
    check_floor("all of them",
                RECTANGLE(0.5, 2, -0.3, 0.4, 0.7, "3") BALL(-1, 1.2, 0.3, 0.4, "1")
                    DISK(1.5, 2, 1.5, 0.5, 0.5, "20"),
                3.0 * rectangle_irradiance(0.4, 0.7, (struct point){0.5, 2.0, -0.3}) +
                    sphere_irradiance((struct point){-1.0, 1.2, 0.3}, 0.4) +
                    20.0 * disk_irradiance(centre, a, b),
                2e-4);
}

/* Lights shine from one side; what they turn away from is black, to the last bit. */
static void the_other_side_is_dark(void **state)
{
    static const char *const lights[] = {
        "<shape type=\"rectangle\">" FLIPPED DOWN(0.5, 2, -0.3, 0.4, 0.7) EMITTER("3"),
        "<shape type=\"disk\">" FLIPPED DOWN(0, 1, 0, 0.5, 0.5) EMITTER("3"),
        "<shape type=\"sphere\">" FLIPPED "<point name=\"center\" x=\"-1\" y=\"1.2\" z=\"0.3\"/>"
        "<float name=\"radius\" value=\"0.4\"/>" EMITTER("3"),
        "<shape type=\"sphere\"><float name=\"radius\" value=\"30\"/>" EMITTER("0.7"),
        BALL(1, -2, 0, 1, "3"), /* below the horizon */
    };
    (void)state;
    for (size_t i = 0; i < sizeof lights / sizeof lights[0]; ++i) {
        char content[4096];
        snprintf(content, sizeof content, "%s%s", FLOOR, lights[i]);
        struct estimate e = render_estimate(&at_origin, content);
        if (e.most != 0.0) {
            fail_msg("light %zu, turned away: %g", i, e.most);
        }
    }
}

/* Half of a light behind a wall that ends exactly above the point. */
static void shadows(void **state)
{
    const struct point half[4] = {
        {0.0, 2.0, -0.5}, {0.5, 2.0, -0.5}, {0.5, 2.0, 0.5}, {0.0, 2.0, 0.5}};
    (void)state;
    check_floor("half of a rectangle",
                RECTANGLE(0, 2, 0, 0.5, 0.5, "3") "<shape type=\"rectangle\">" DOWN(-1, 1, 0, 1,
                                                                                    1) "</shape>",
                3.0 * polygon_irradiance(half, 4), 3e-4);
}

static void environment_maps(void **state)
{
    static const struct {
        int column, row;
        double value, angle;
    } cases[] = {
        {3, 2, 300.0, 0.0},  {MAP_WIDTH - 1, 1, 300.0, 0.0},
        {0, 0, 300.0, 0.0},  {5, 3, 300.0, 40.0},
        {7, 4, 20.0, -75.0}, {7, MAP_HEIGHT - 1, 100.0, 130.0},
    };
    struct brdf_error error;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        struct brdfcl_image map;
        char content[1024];
        char name[64];
        assert_int_equal(brdfcl_image_create(&map, MAP_WIDTH, MAP_HEIGHT, &error), BRDF_OK);
        for (int k = 0; k < 3 * MAP_WIDTH * MAP_HEIGHT; ++k) {
            map.rgb[k] = 0.1f + 0.05f * (float)(k % 7);
        }
        map.rgb[3 * (cases[i].row * MAP_WIDTH + cases[i].column)] = (float)cases[i].value;
        assert_int_equal(brdfcl_image_write(&map, scene_file_write("map.exr", ""), NULL, &error),
                         BRDF_OK);
        snprintf(content, sizeof content,
                 "<emitter type=\"envmap\"><string name=\"filename\" value=\"map.exr\"/>"
                 "<float name=\"scale\" value=\"0.5\"/><transform name=\"to_world\">"
                 "<rotate x=\"0.48\" y=\"0.6\" z=\"0.64\" angle=\"%g\"/></transform></emitter>",
                 cases[i].angle);
        snprintf(name, sizeof name, "map %zu", i);
        check_floor(name, content, 0.5 * map_irradiance(&map, cases[i].angle), 3e-4);
        brdfcl_image_destroy(&map);
    }
}

/* With both, each is chosen half of the time. */
static void environment_and_lights_add_up(void **state)
{
    (void)state;
    check_floor("constant and sphere",
                BALL(0.2, 2, 0, 0.4, "5") "<emitter type=\"constant\">"
                                          "<rgb name=\"radiance\" value=\"0.3\"/></emitter>",
                0.3 * pi + 4.7 * sphere_irradiance((struct point){0.2, 2.0, 0.0}, 0.4), 3e-4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles),
        cmocka_unit_test(disks),
        cmocka_unit_test(spheres),
        cmocka_unit_test(meshes),
        cmocka_unit_test(many_lights_add_up),
        cmocka_unit_test(the_other_side_is_dark),
        cmocka_unit_test(shadows),
        cmocka_unit_test(environment_maps),
        cmocka_unit_test(environment_and_lights_add_up),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
