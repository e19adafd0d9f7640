/*
 * test_woodgrain.c - the solid texture of wood: its noise, its rings where they have a closed form,
 * fibres that run along the pattern, and which output sets what.
 */
#include "angle.h"
#include "scene_loader.h"
#include "texture_stage.h"

#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* A number in [0, 1) for each i, the same everywhere. */
static double scattered(unsigned i)
{
    i = (i ^ (i >> 16)) * 0x7feb352du;
    i = (i ^ (i >> 15)) * 0x846ca68bu;
    return (double)(i ^ (i >> 16)) / 4294967296.0;
}

static brdf_vec3 point_of(unsigned i, double size)
{
    return brdf_vec3_make((float)(size * (scattered(3 * i) - 0.5)),
                          (float)(size * (scattered(3 * i + 1) - 0.5)),
                          (float)(size * (scattered(3 * i + 2) - 0.5)));
}

/* A place whose local frame is the world's. */
static struct pt_interaction place_of(brdf_vec3 p)
{
    struct pt_interaction at;
    memset(&at, 0, sizeof at);
    at.p = p;
    at.frame.s = brdf_vec3_make(1.0f, 0.0f, 0.0f);
    at.frame.t = brdf_vec3_make(0.0f, 1.0f, 0.0f);
    at.frame.n = brdf_vec3_make(0.0f, 0.0f, 1.0f);
    at.ng = at.frame.n;
    return at;
}

/* Within [-1, 1], centred, continuous from cell to cell, and its slope is its slope. */
static void noise(void **state)
{
    double sum = 0.0;
    double squares = 0.0;
    const int count = 20000;
    (void)state;
    for (int i = 0; i < count; ++i) {
        const float step = 1.0f / 256.0f;
        brdf_vec3 p = point_of((unsigned)i, 200.0);
        struct pt_noise here = pt_noise_at(p, 5);
        struct pt_noise below = pt_noise_at(brdf_vec3_make(p.x, p.y, p.z - step), 5);
        struct pt_noise above = pt_noise_at(brdf_vec3_make(p.x, p.y, p.z + step), 5);
        double slope = (double)(above.a - below.a) / (2.0 * (double)step);
        assert_true(fabsf(here.a) <= 1.0f && fabsf(here.b) <= 1.0f);
        assert_true(fabsf(here.a_z) <= 3.7501f);
        assert_true(fabsf(above.a - here.a) <= 3.76f * step + 1e-5f);
        assert_float_equal(here.a_z, (float)slope, 0.02f);
        sum += (double)here.a;
        squares += (double)here.a * (double)here.a;
    }
    assert_true(fabs(sum / count) < 0.02);
    assert_true(squares / count > 0.05 && squares / count < 0.3);
    brdf_vec3 odd = brdf_vec3_make(NAN, INFINITY, -1e30f);
    assert_true(fabsf(pt_noise_at(odd, 0).a) <= 1.0f);
}

/* A straight tree: circles around the axis, fibres along it, whatever the transform. */
static void straight_wood(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='woodgrain' id='w'><float name='ring_wander' value='0'/>"
                       "<float name='figure' value='0'/><float name='ring_width' value='0.1'/>"
                       "<transform name='to_world'><rotate y='1' angle='90'/><scale value='2'/>"
                       "<translate x='3' y='-1' z='0.5'/></transform></texture>");
    for (unsigned i = 0; i < 500; ++i) {
        brdf_vec3 p = point_of(i, 4.0);
        struct pt_grain grain = pt_texture_find(stage.w, 0, place_of(p)).grain;
        double y = ((double)p.y + 1.0) / 2.0; /* z of the log is x of the world */
        double z = ((double)p.z - 0.5) / 2.0;
        double rings = sqrt(y * y + z * z) / 0.1;
        double year = rings - floor(rings);
        double winter = fmin(fmax(10.0 * (year - 0.9), 0.0), 1.0);
        double late = year * year * year * (1.0 - winter * winter * (3.0 - 2.0 * winter));
        assert_float_equal(grain.late, (float)late, 2e-4f);
        assert_float_equal(fabsf(grain.axis.x), 1.0f, 1e-6f);
        assert_true(grain.streak >= 0.0f && grain.streak <= 1.0f);
    }
    stage_close(&stage);
}

/* How much later or earlier the wood is a little further in direction d. */
static double change_along(const struct stage *stage, brdf_vec3 p, brdf_vec3 d)
{
    const float step = 5e-4f;
    brdf_vec3 q = brdf_add(p, brdf_scale(d, step));
    return fabs((double)(pt_texture_find(stage->w, 0, place_of(q)).grain.late -
                         pt_texture_find(stage->w, 0, place_of(p)).grain.late));
}

/* In figured wood the pattern changes across the fibres, and hardly along them; it does along the
   trunk, from which they bend. */
static void fibers_follow_the_pattern(void **state)
{
    double along = 0.0;
    double trunk = 0.0;
    double steepest = 0.0;
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='woodgrain' id='w'><float name='ring_wander' value='0'/>"
                       "<float name='figure' value='20'/></texture>");
    for (unsigned i = 0; i < 4000; ++i) {
        brdf_vec3 p = point_of(i, 2.0);
        brdf_vec3 axis = pt_texture_find(stage.w, 0, place_of(p)).grain.axis;
        along += change_along(&stage, p, axis);
        trunk += change_along(&stage, p, brdf_vec3_make(0.0f, 0.0f, 1.0f));
        steepest = fmax(steepest, acos(fmin((double)axis.z, 1.0)) * 180.0 / pi);
        assert_float_equal(brdf_dot(axis, axis), 1.0f, 1e-5f);
    }
    assert_true(along < 0.4 * trunk);
    assert_true(steepest > 10.0 && steepest < 28.0); /* 20 in each of two directions */
    stage_close(&stage);
}

/* The other side of a twosided surface is mirrored, and the fibres with it. */
static void fibers_of_the_other_side(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='woodgrain' id='w'><transform name='to_world'>"
                       "<rotate x='1' angle='30'/></transform></texture>");
    for (unsigned i = 0; i < 100; ++i) {
        struct pt_interaction at = place_of(point_of(i, 2.0));
        brdf_vec3 up = brdf_vec3_make(0.6f, 0.0f, 0.8f);
        brdf_vec3 down = brdf_vec3_make(0.6f, 0.0f, -0.8f);
        struct pt_interaction above = pt_seen_side(BRDF_TWOSIDED, at, up);
        struct pt_interaction below = pt_seen_side(BRDF_TWOSIDED, at, down);
        struct pt_interaction plain = pt_seen_side(0u, at, down);
        brdf_vec3 front = pt_texture_find(stage.w, 0, above).grain.axis;
        brdf_vec3 back = pt_texture_find(stage.w, 0, below).grain.axis;
        brdf_vec3 same = pt_texture_find(stage.w, 0, plain).grain.axis;
        assert_true(front.x == back.x && front.y == back.y && front.z == -back.z);
        assert_memory_equal(&front, &same, sizeof front);
        assert_true(fabsf(front.z) > 0.5f);
    }
    stage_close(&stage);
}

/* By the name of the parameter, or as the file says; each within the range that it claims. */
static void outputs(void **state)
{
    static const char *const names[] = {"color", "fiber_color", "fiber_axis",
                                        "beta",  "alpha",       "late"};
    (void)state;
    for (int output = 0; output < PT_GRAIN_OUTPUTS; ++output) {
        char content[256];
        struct stage stage;
        float least = 0.0f;
        float most = 0.0f;
        snprintf(content, sizeof content,
                 "<texture type='woodgrain' id='w'><string name='output' value='%s'/></texture>",
                 names[output]);
        stage_open(&stage, content);
        assert_int_equal(stage.scene->textures[0].record.output, output);
        scene_texture_range(&stage.scene->textures[0], output, &least, &most);
        for (unsigned i = 0; i < 2000; ++i) {
            brdf_rgb c = pt_texture_eval(stage.w, 0, place_of(point_of(i, 3.0)));
            assert_true(c.r >= least && c.g >= least && c.b >= least);
            assert_true(c.r <= most && c.g <= most && c.b <= most);
        }
        stage_close(&stage);
    }
}

static void outputs_by_name(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage, "<texture type='woodgrain' id='w'/><bsdf type='roughplastic'>"
                       "<ref id='w' name='diffuse_reflectance'/><ref id='w' name='alpha'/></bsdf>");
    assert_int_equal(stage.scene->texture_count, 1);
    for (size_t i = 0; i < stage.scene->binding_count; ++i) {
        const struct scene_binding *binding = &stage.scene->bindings[i];
        assert_int_equal(binding->record.output, binding->color ? PT_GRAIN_COLOR : PT_GRAIN_ALPHA);
        assert_true(i == 0 || binding->word > binding[-1].word);
    }
    assert_in_range(stage.scene->binding_count, 2, 3);
    stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(noise),
        cmocka_unit_test(straight_wood),
        cmocka_unit_test(fibers_follow_the_pattern),
        cmocka_unit_test(fibers_of_the_other_side),
        cmocka_unit_test(outputs),
        cmocka_unit_test(outputs_by_name),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
