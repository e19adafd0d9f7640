/*
 * test_compose.c - blendbsdf, mask and twosided around them: what is made of them, what they look
 * like, and what is refused.
 */
#include "render_scenes.h"

#define SKY "<emitter type='constant'><rgb name='radiance' value='1'/></emitter>\n"
#define LAMP                                                                                       \
    "<shape type='sphere'><point name='center' x='1' y='2' z='1.5'/>"                              \
    "<float name='radius' value='0.3'/>"                                                           \
    "<emitter type='area'><rgb name='radiance' value='9, 8, 7'/></emitter></shape>\n"
#define FLOOR                                                                                      \
    "<shape type='rectangle'><transform name='to_world'><scale value='2'/>"                        \
    "<rotate x='1' angle='-90'/></transform></shape>\n"
#define GRAY(value) "<bsdf type='diffuse'><rgb name='reflectance' value='" value "'/></bsdf>"
#define METAL "<bsdf type='roughconductor'><float name='alpha' value='0.2'/></bsdf>"
#define BLEND(weight, a, b)                                                                        \
    "<bsdf type='blendbsdf'><float name='weight' value='" weight "'/>" a b "</bsdf>"
#define MASK(opacity, a) "<bsdf type='mask'><float name='opacity' value='" opacity "'/>" a "</bsdf>"
#define TWOSIDED(a) "<bsdf type='twosided'>" a "</bsdf>"
#define BALL(bsdf)                                                                                 \
    "<shape type='sphere'><point name='center' x='0' y='0.5' z='0'/>"                              \
    "<float name='radius' value='0.5'/>" bsdf "</shape>\n"
#define CARD(bsdf)                                                                                 \
    "<shape type='rectangle'><transform name='to_world'><scale value='0.5'/>"                      \
    "<rotate x='1' y='1' angle='130'/><translate x='-0.7' y='0.8' z='0.5'/></transform>" bsdf      \
    "</shape>\n"

static const struct renderer in_c = {0, 0, 0};

static unsigned long long hash_of(const char *content)
{
    const struct view view = {NULL, NULL, 0, 24, 8, 6, 3, NULL, NULL};
    struct brdfcl_scene *scene = render_scene_load(&view, content);
    unsigned long long hash = render_hash(&in_c, scene);
    brdfcl_scene_destroy(scene);
    return hash;
}

/* At weights of 0 and 1 no path goes to the other part, and where all parts are one material, it
   does not matter where one goes: pictures are the same to the last bit. */
static void ends_are_exact(void **state)
{
    static const char *const gray[] = {
        BLEND("0", GRAY("0.7"), METAL),
        BLEND("1", METAL, GRAY("0.7")),
        BLEND("0.3", GRAY("0.7"), GRAY("0.7")),
        BLEND("0.3", BLEND("0.9", GRAY("0.7"), GRAY("0.7")), GRAY("0.7")),
        MASK("1", GRAY("0.7")),
        MASK("1", BLEND("1", METAL, BLEND("0", GRAY("0.7"), METAL))),
    };
    char content[2048];
    (void)state;
    unsigned long long plain = hash_of(SKY LAMP FLOOR BALL(GRAY("0.7")));
    assert_true(plain != hash_of(SKY LAMP FLOOR BALL(METAL)));
    for (size_t i = 0; i < sizeof gray / sizeof gray[0]; ++i) {
        snprintf(content, sizeof content, SKY LAMP FLOOR BALL("%s"), gray[i]);
        if (hash_of(content) != plain) {
            fail_msg("%s: not the picture of its only part", gray[i]);
        }
    }
    assert_true(plain != hash_of(SKY LAMP FLOOR BALL(BLEND("0.5", GRAY("0.7"), METAL))));
    assert_true(plain != hash_of(SKY LAMP FLOOR BALL(MASK("0.99", GRAY("0.7")))));
}

/* A card under a sky of 1, seen from both sides: what it reflects and lets through is known. */
static const struct known {
    const char *bsdf;
    double front;
    double back;
} known[] = {
    {BLEND("0.25", GRAY("0.8"), GRAY("0.2")), 0.65, 0.0},
    {TWOSIDED(BLEND("0.25", GRAY("0.8"), GRAY("0.2"))), 0.65, 0.65},
    {BLEND("0.25", TWOSIDED(GRAY("0.8")), GRAY("0.2")), 0.65, 0.6},
    {BLEND("0.5", BLEND("0.5", GRAY("0"), GRAY("0.4")), BLEND("0.25", GRAY("0.8"), GRAY("0.4"))),
     0.45, 0.0},
    {MASK("0.3", GRAY("0")), 0.7, 0.7},
    {MASK("0.3", TWOSIDED(GRAY("0.5"))), 0.85, 0.85},
    {MASK("0.5", MASK("0.5", GRAY("0"))), 0.75, 0.75},
    {BLEND("0.5", MASK("0.2", GRAY("0.5")), GRAY("0.6")), 0.75, 0.4},
};

static void known_answers(void **state)
{
    static const char *const from[] = {"0, 0, 4", "0, 0, -4"};
    char content[2048];
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        for (int side = 0; side < 2; ++side) {
            const struct view view = {from[side], "0, 0, 0", 5.0, 32, 64, 4, 0, NULL, NULL};
            snprintf(content, sizeof content, SKY "<shape type='rectangle'>%s</shape>",
                     known[i].bsdf);
            assert_estimate(known[i].bsdf, render_estimate(&view, content),
                            side ? known[i].back : known[i].front, 1e-6, 1e-2);
        }
    }
}

/* Beyond a mask a lamp counts in full, as its shadow rays are stopped: so a room lit through one is
   as bright as the mask is open. Going through is a bounce. */
static void light_through_a_mask(void **state)
{
#define LIT(pane)                                                                                  \
    "<shape type='rectangle'><transform name='to_world'><scale value='4'/>"                        \
    "<rotate x='1' angle='-90'/></transform>" GRAY(                                                \
        "0.5") "</shape>"                                                                          \
               "<shape type='disk'><transform name='to_world'><scale value='2'/><rotate x='1' "    \
               "angle='90'/>"                                                                      \
               "<translate y='1.5'/></transform>"                                                  \
               "<emitter type='area'><rgb name='radiance' value='4'/></emitter></shape>" pane
#define PANE                                                                                       \
    "<shape type='rectangle'><transform name='to_world'><scale value='9'/>"                        \
    "<rotate x='1' angle='90'/><translate y='1'/></transform>" MASK("0.25", GRAY("0")) "</shape>"
    const struct view near = {"0, 0.5, 0.1", "0, 0, 0", 0.1, 48, 256, 3, 0, NULL, NULL};
    const struct view shallow = {"0, 0.5, 0.1", "0, 0, 0", 0.1, 16, 16, 2, 0, NULL, NULL};
    (void)state;
    struct estimate bare = render_estimate(&near, LIT(""));
    assert_estimate("through a mask", render_estimate(&near, LIT(PANE)), 0.75 * bare.mean, 2e-3,
                    1e-2);
    assert_estimate("too shallow", render_estimate(&shallow, LIT(PANE)), 0.0, 0.0, 1.0);
}

/* A mask that lets half through and glows: it glows in full, from its front. */
static void glowing_mask(void **state)
{
    const struct view view = {"0, 0, 4", "0, 0, 0", 5.0, 16, 64, 3, 0, NULL, NULL};
    (void)state;
    assert_estimate(
        "glow",
        render_estimate(&view, SKY "<shape type='rectangle'>" MASK(
                                   "0.5", GRAY("0")) "<emitter type='area'><rgb name='radiance' "
                                                     "value='2'/></emitter></shape>"),
        2.5, 1e-6, 1e-2);
}

/* Parts that are equal are one surface, so that packets are full. */
static void parts_are_shared(void **state)
{
    (void)state;
    struct brdfcl_scene *scene = scene_content_load(BALL(BLEND("0.5", GRAY("0.7"), METAL)) CARD(
        BLEND("0.5", GRAY("0.7"), METAL)) CARD(GRAY("0.7")) CARD(MASK("0.5", METAL)));
    assert_int_equal(scene->fork_count, 2);
    assert_int_equal(scene->surface_count, 3);
    int ball = scene_row_int(scene_row(scene, 0), PT_SURFACE);
    assert_int_equal(ball, -1);
    assert_int_equal(scene_row_int(scene_row(scene, 1), PT_SURFACE), ball);
    assert_int_equal(scene_row_int(scene_row(scene, 2), PT_SURFACE), scene->forks[0].first);
    assert_int_equal(scene->forks[1].second, scene->forks[0].second);
    assert_null(scene->surfaces[scene->forks[1].first].bsdf);
    brdfcl_scene_destroy(scene);
}

#define HEAD "<scene version='3.0.0'>\n<integrator type='path'/><sensor type='perspective'/>\n"

static void mistakes(void **state)
{
    static const struct {
        const char *bsdf;
        brdf_status status;
        const char *says;
    } list[] = {
        {BLEND("1.5", METAL, METAL), BRDF_OUT_OF_RANGE, ":3:"},
        {MASK("-0.1", METAL), BRDF_OUT_OF_RANGE, ":3:"},
        {BLEND("0.5", METAL, ""), BRDF_BAD_FILE, "two <bsdf>, not one"},
        {BLEND("0.5", METAL METAL, METAL), BRDF_BAD_FILE, "one more"},
        {MASK("0.5", ""), BRDF_BAD_FILE, "one <bsdf>, not none"},
        {"<bsdf type='blendbsdf'>" METAL METAL "</bsdf>", BRDF_BAD_FILE, "needs a weight"},
        {"<bsdf type='blendbsdf'><float name='wait' value='1'/></bsdf>", BRDF_UNKNOWN_NAME,
         "weight"},
        {"<bsdf type='blend'/>", BRDF_UNKNOWN_NAME, "blendbsdf"},
        {TWOSIDED(MASK("0.5", METAL)), BRDF_UNSUPPORTED, "put the twosided into the mask"},
        {TWOSIDED(BLEND("0.5", METAL, TWOSIDED(METAL))), BRDF_BAD_FILE, "twosided in twosided"},
        {TWOSIDED(BLEND("0.5", METAL, "<bsdf type='dielectric'/>")), 1, "leave out twosided"},
    };
    char text[2048];
    (void)state;
    for (size_t i = 0; i < sizeof list / sizeof list[0]; ++i) {
        for (int used = 0; used < 2; ++used) {
            struct brdfcl_scene *scene = NULL;
            struct brdf_error error = {BRDF_OK, ""};
            snprintf(text, sizeof text,
                     used ? HEAD "<shape type='sphere'>%s</shape></scene>" : HEAD "%s</scene>",
                     list[i].bsdf);
            brdf_status status = scene_text_load(text, NULL, 0, &scene, &error);
            if (status != list[i].status || scene || !strstr(error.message, list[i].says) ||
                !strstr(error.message, "scene.xml:3:")) {
                fail_msg("%s\n-> status %d, \"%s\"\nexpected %d, \"%s\"", text, status,
                         error.message, list[i].status, list[i].says);
            }
        }
    }
}

/* Each blend has the one before twice: thirty of them would be a billion parts. */
static void doubling_is_refused(void **state)
{
    char text[8192] = HEAD "<bsdf type='diffuse' id='b0'/>";
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    (void)state;
    for (int i = 1; i <= 30; ++i) {
        size_t used = strlen(text);
        snprintf(text + used, sizeof text - used,
                 "<bsdf type='blendbsdf' id='b%d'><float name='weight' value='0.%d'/>"
                 "<ref id='b%d'/><ref id='b%d'/></bsdf>\n",
                 i, 10 + i, i - 1, i - 1);
    }
    strcat(text, "</scene>");
    assert_int_equal(scene_text_load(text, NULL, 0, &scene, &error), BRDF_UNSUPPORTED);
    assert_non_null(strstr(error.message, "more than 1000 parts"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_are_exact),       cmocka_unit_test(known_answers),
        cmocka_unit_test(light_through_a_mask), cmocka_unit_test(glowing_mask),
        cmocka_unit_test(parts_are_shared),     cmocka_unit_test(mistakes),
        cmocka_unit_test(doubling_is_refused),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
