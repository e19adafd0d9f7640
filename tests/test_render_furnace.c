/*
 * test_render_furnace.c - scenes whose radiance is known, as light comes alike from everywhere:
 * furnaces, glass, and what a depth limit leaves of them.
 */
#include "render_scenes.h"

#include <math.h>

#define CONSTANT "<emitter type=\"constant\"><rgb name=\"radiance\" value=\"1\"/></emitter>\n"
#define FLIPPED "<boolean name=\"flip_normals\" value=\"true\"/>"
#define WHITE "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"1\"/></bsdf>"
#define HALF "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.5\"/></bsdf>"
#define GLOW(radiance)                                                                             \
    "<emitter type=\"area\"><rgb name=\"radiance\" value=\"" radiance "\"/></emitter>"

/* White things of every shape between each other, under a sky of 1: nothing can be told apart. */
static void white_scene_under_white_sky(void **state)
{
    const struct view view = {"0, 1, 4", "0, 0.4, 0", 40.0, 24, 64, -1, 4, NULL, NULL};
    const char *content =
        CONSTANT "<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"5\"/>"
                 "<rotate x=\"1\" angle=\"-90\"/></transform>" WHITE "</shape>\n"
                 "<shape type=\"sphere\"><point name=\"center\" x=\"-0.5\" y=\"0.5\" z=\"0\"/>"
                 "<float name=\"radius\" value=\"0.5\"/>" WHITE "</shape>\n"
                 "<shape type=\"cube\"><transform name=\"to_world\"><scale value=\"0.3\"/>"
                 "<translate x=\"0.6\" y=\"0.35\" z=\"0.4\"/></transform>" WHITE "</shape>\n"
                 "<shape type=\"disk\"><transform name=\"to_world\"><scale value=\"0.7\"/>"
                 "<translate y=\"1.2\" z=\"-0.6\"/></transform>" WHITE "</shape>\n";
    (void)state;
    assert_estimate("white", render_estimate(&view, content), 1.0, 1e-4, 4e-3);
}

/* A closed room whose walls and things glow 0.5 and reflect 0.5: each bounce adds a half of what
   is left, up to 1. With a limit of `depth` segments, 1 - 2^-depth is seen. */
static void glowing_room(void **state)
{
    const char *content =
        "<shape type=\"cube\">" FLIPPED
        "<transform name=\"to_world\"><scale x=\"2\" y=\"1.5\" z=\"3\"/></transform>" HALF GLOW(
            "0.5") "</shape>\n"
                   "<shape type=\"sphere\"><point name=\"center\" x=\"-0.5\" y=\"0.5\" z=\"0\"/>"
                   "<float name=\"radius\" value=\"0.5\"/>" HALF GLOW("0.5") "</shape>\n";
    (void)state;
    for (int depth = 1; depth < 6; ++depth) {
        const struct view view = {"1, 0.3, 2", "0, 0, 0", 80.0, 16, 64, depth, 0, NULL, NULL};
        char name[32];
        snprintf(name, sizeof name, "depth %d", depth);
        assert_estimate(name, render_estimate(&view, content), 1.0 - pow(0.5, depth), 1e-4, 4e-3);
    }
    const struct view endless = {"1, 0.3, 2", "0, 0, 0", 80.0, 16, 64, -1, 1, NULL, NULL};
    assert_estimate("roulette", render_estimate(&endless, content), 1.0, 1e-4, 8e-3);
}

/*
 * The albedo of a perfectly reflecting rough metal, by quadrature over the hemisphere in double
 * precision; separable masking, and what else Mitsuba 3 assumes where a file is silent.
 */
static const struct {
    const char *distribution;
    double alpha;
    double cosine;
    double albedo;
} rough[] = {
    {"ggx", 0.25, 0.5, 0.85510},       {"ggx", 1.0, 0.25, 0.49096},     {"ggx", 0.5, 0.75, 0.67873},
    {"beckmann", 0.25, 0.25, 0.90461}, {"beckmann", 1.0, 0.5, 0.75630},
};

/* The same light from four sources, each sampled in another way. */
static const char *const around[] = {
    CONSTANT,
    "<shape type=\"sphere\">" FLIPPED "<float name=\"radius\" value=\"30\"/>" GLOW("1") "</shape>",
    "<shape type=\"cube\">" FLIPPED
    "<transform name=\"to_world\"><scale value=\"30\"/></transform>" GLOW("1") "</shape>",
    "<emitter type=\"envmap\"><string name=\"filename\" value=\"white.exr\"/></emitter>",
};

static void rough_metal(void **state)
{
    struct brdfcl_image white;
    struct brdf_error error;
    (void)state;
    assert_int_equal(brdfcl_image_create(&white, 8, 5, &error), BRDF_OK);
    for (int i = 0; i < 8 * 5 * 3; ++i) {
        white.rgb[i] = 1.0f;
    }
    assert_int_equal(brdfcl_image_write(&white, scene_file_write("white.exr", ""), NULL, &error),
                     BRDF_OK);
    brdfcl_image_destroy(&white);
    for (size_t i = 0; i < sizeof rough / sizeof rough[0]; ++i) {
        for (size_t k = 0; k < sizeof around / sizeof around[0]; ++k) {
            char from[64];
            char name[64];
            char content[2048];
            const struct view view = {from, "0, 0, 0", 0.01, 16, 128, 2, 0, NULL, NULL};
            double sine = sqrt(1.0 - rough[i].cosine * rough[i].cosine);
            snprintf(from, sizeof from, "%.9g, %.9g, 0", 10.0 * sine, 10.0 * rough[i].cosine);
            snprintf(name, sizeof name, "%s %g, around %zu", rough[i].distribution, rough[i].alpha,
                     k);
            snprintf(content, sizeof content,
                     "%s<shape type=\"rectangle\"><transform name=\"to_world\">"
                     "<rotate x=\"1\" angle=\"-90\"/></transform><bsdf type=\"roughconductor\">"
                     "<string name=\"distribution\" value=\"%s\"/>"
                     "<float name=\"alpha\" value=\"%g\"/></bsdf></shape>",
                     around[k], rough[i].distribution, rough[i].alpha);
            assert_estimate(name, render_estimate(&view, content), rough[i].albedo, 3e-4, 4e-3);
        }
    }
}

/* Every pixel within a rounding error of what is expected: no random choice changes a path's sum.
 */
static void assert_even(const char *name, const struct view *view, const char *content,
                        double expected, double tolerance)
{
    struct estimate e = render_estimate(view, content);
    if (!(e.least >= expected * (1.0 - tolerance) && e.most <= expected * (1.0 + tolerance))) {
        fail_msg("%s: %.9g to %.9g, expected %.9g", name, e.least, e.most, expected);
    }
}

#define GLASS(int_ior, ext_ior)                                                                    \
    "<bsdf type=\"dielectric\"><float name=\"int_ior\" value=\"" int_ior "\"/>"                    \
    "<float name=\"ext_ior\" value=\"" ext_ior "\"/></bsdf>"

#define PANE(turn, z)                                                                              \
    "<shape type=\"rectangle\"><transform name=\"to_world\"><scale value=\"50\"/>"                 \
    "<rotate y=\"1\" angle=\"" turn "\"/><translate z=\"" z                                        \
    "\"/></transform>" GLASS("1.5", "1.0") "</shape>"

/* Glass under a sky of 1 cannot be seen: what it takes by 1/eta^2 on one side it gives back. */
static void glass_under_white_sky(void **state)
{
    const struct view view = {"0, 1, 4", "0, 0, 0", 35.0, 16, 16, 200, 0, NULL, NULL};
    (void)state;
    assert_even("sphere", &view, CONSTANT "<shape type=\"sphere\">" GLASS("1.5", "1.0") "</shape>",
                1.0, 2e-5);
    assert_even("sphere of air in water", &view,
                CONSTANT "<shape type=\"sphere\">" GLASS("1.0", "1.33") "</shape>", 1.0, 2e-5);
    assert_even("pane", &view, CONSTANT PANE("0", "0") PANE("180", "-0.1"), 1.0, 2e-5);
}

/* From inside, radiance is larger by the square of the refractive index. */
static void from_inside_glass(void **state)
{
    const struct view inside = {"0, 0, 0", "0.3, 0.2, 1", 35.0, 16, 16, 200, 0, NULL, NULL};
    (void)state;
    assert_even("inside", &inside,
                CONSTANT "<shape type=\"sphere\">" GLASS("1.5", "1.2") "</shape>",
                1.5 * 1.5 / (1.2 * 1.2), 2e-5);
}

/* Roulette changes no mean; and it goes by throughput times eta^2, as most paths would otherwise be
   cut short on their way into dense glass: the noise tells. */
static void roulette_in_glass(void **state)
{
    const char *content = CONSTANT "<shape type=\"sphere\">" GLASS("2.5", "1.0") "</shape>";
    const struct view inside = {"0, 0, 0", "0.3, 0.2, 1", 35.0, 24, 256, -1, 1, NULL, NULL};
    const struct view outside = {"0, 0, 4", "0, 0, 0", 20.0, 24, 256, -1, 1, NULL, NULL};
    (void)state;
    assert_estimate("inside", render_estimate(&inside, content), 6.25, 1e-4, 2e-3);
    assert_estimate("outside", render_estimate(&outside, content), 1.0, 1e-4, 2e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_scene_under_white_sky),
        cmocka_unit_test(glowing_room),
        cmocka_unit_test(rough_metal),
        cmocka_unit_test(glass_under_white_sky),
        cmocka_unit_test(from_inside_glass),
        cmocka_unit_test(roulette_in_glass),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
