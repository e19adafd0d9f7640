/*
 * test_render.c - what brdfcl_render promises besides the picture: progress, stopping, what it
 * counts, and what it refuses.
 */
#include "render_contents.h"
#include "render_scenes.h"

#include <math.h>

#include "kernels/environment.h"
#include "opencl.h"

/* Counts the calls, checks what they say, and stops at one of them. */
struct watch {
    int calls;
    int stop_at; /* 0: never */
    struct brdfcl_progress last;
};

static int look(void *context, const struct brdfcl_progress *progress)
{
    struct watch *watch = context;
    watch->calls += 1;
    assert_true(progress->seconds >= watch->last.seconds);
    assert_true(progress->samples >= watch->last.samples);
    assert_true(progress->samples <= progress->samples_all);
    assert_true(progress->spp_done >= watch->last.spp_done);
    watch->last = *progress;
    return watch->calls == watch->stop_at;
}

/* A scene that takes seconds: there is time to look, and to stop. */
static const struct view slow = {NULL, NULL, 0, 96, 4096, 6, 0, NULL, NULL};

static void check_stopped(const struct brdfcl_scene *scene,
                          const struct brdfcl_render_options *options)
{
    struct watch *watch = options->context;
    struct brdfcl_render_result result;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(brdfcl_render(scene, options, &result, &error), BRDF_OK);
    assert_int_equal(result.stopped, 1);
    assert_int_equal(watch->calls, watch->stop_at);
    assert_in_range(result.spp, 1, 4095);
    assert_true(result.samples >= watch->last.samples);
    assert_true(result.samples >= (long long)result.spp * 96 * 96);
    assert_true(result.samples < (long long)(result.spp + 16) * 96 * 96);
    /* The pixels of the unfinished sweep are divided by what they have: the picture is even. */
    for (int i = 0; i < 96 * 96 * 3; ++i) {
        assert_true(isfinite(result.image.rgb[i]));
        assert_true(fabsf(result.image.rgb[i] - 1.0f) < 1e-4f);
    }
    brdfcl_image_destroy(&result.image);
}

/* Glass under a white sky: every sample of every pixel is 1. */
static const char *const even_contents =
    "<emitter type='constant'><rgb name='radiance' value='1'/></emitter>"
    "<shape type='sphere'><bsdf type='dielectric'/></shape>"
    "<shape type='rectangle'><emitter type='area'><rgb name='radiance' value='1'/></emitter>"
    "<transform name='to_world'><translate z='-3'/></transform></shape>";

static void stops_when_told(void **state)
{
    struct view deep = slow;
    deep.depth = 60;
    (void)state;
    struct brdfcl_scene *scene = render_scene_load(&deep, even_contents);
    struct watch watch = {0, 3, {0.0, 0, 0, 0}};
    struct brdfcl_render_options options = {NULL, 2, 0, look, &watch};
    check_stopped(scene, &options);
    if (brdfcl_device_count() > 0) {
        memset(&watch, 0, sizeof watch);
        watch.stop_at = 3;
        assert_int_equal(brdfcl_device_open("", 0, 0, &options.device, NULL), BRDF_OK);
        check_stopped(scene, &options);
        brdfcl_device_close(options.device);
    }
    brdfcl_scene_destroy(scene);
}

/* At the first look there may be no sample of every pixel: rows that have none are black, or there
   is no picture at all. */
static void stops_at_once(void **state)
{
    const struct view huge = {NULL, NULL, 0, 1000, 4096, 60, 0, NULL, NULL};
    (void)state;
    struct brdfcl_scene *scene = render_scene_load(&huge, even_contents);
    struct watch watch = {0, 1, {0.0, 0, 0, 0}};
    struct brdfcl_render_options options = {NULL, 2, 0, look, &watch};
    struct brdfcl_render_result result;
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = brdfcl_render(scene, &options, &result, &error);
    if (status == BRDF_OK) {
        assert_int_equal(result.spp, 0);
        assert_true(result.image.rgb[0] > 0.99f);
        assert_true(result.image.rgb[1000 * 1000 * 3 - 1] == 0.0f);
    } else {
        assert_int_equal(status, BRDF_CANCELLED);
        assert_null(result.image.rgb);
        assert_non_null(strstr(error.message, "before the first sample"));
    }
    assert_int_equal(result.stopped, 1);
    brdfcl_image_destroy(&result.image);
    brdfcl_scene_destroy(scene);
}

static void counts_what_it_does(void **state)
{
    const struct view view = {NULL, NULL, 0, 20, 10, 1, 0, NULL, NULL};
    const struct renderer who = {0, 1, 0};
    (void)state;
    /* One segment a path: one ray a sample, and no shadow rays. */
    struct brdfcl_scene *scene = render_scene_load(&view, even_contents);
    struct brdfcl_render_result result = render_by(&who, scene);
    assert_int_equal(result.samples, 20 * 20 * 10);
    assert_int_equal(result.rays, 20 * 20 * 10);
    assert_true(result.seconds_render > 0.0 && result.seconds_kernel_build > 0.0);
    brdfcl_image_destroy(&result.image);
    brdfcl_scene_destroy(scene);
}

static void assert_refused(const struct brdfcl_scene *scene, struct brdfcl_device *device,
                           brdf_status expected, const char *part)
{
    struct brdfcl_render_options options = {device, 1, 0, NULL, NULL};
    struct brdfcl_render_result result;
    struct brdf_error error = {BRDF_OK, ""};
    assert_int_equal(brdfcl_render(scene, &options, &result, &error), expected);
    assert_int_equal(error.status, expected);
    assert_null(result.image.rgb);
    if (!strstr(error.message, part)) {
        fail_msg("\"%s\" does not say \"%s\"", error.message, part);
    }
}

static void too_many_pixels(void **state)
{
    const struct view view = {NULL, NULL, 0, 8, 1, 1, 0, NULL, NULL};
    (void)state;
    struct brdfcl_scene *scene = render_scene_load(&view, even_contents);
    assert_int_equal(brdfcl_scene_set_size(scene, 65536, 65536, NULL), BRDF_OK);
    assert_refused(scene, NULL, BRDF_OUT_OF_RANGE, "65536 x 65536");
    brdfcl_scene_destroy(scene);
}

/* More than the device gives in one buffer: said before any of it is asked for. */
static void too_large_for_the_device(void **state)
{
    const struct view view = {NULL, NULL, 0, 8, 1, 1, 0, NULL, NULL};
    struct brdfcl_device *device = NULL;
    (void)state;
    if (brdfcl_device_count() == 0) {
        skip();
    }
    assert_int_equal(brdfcl_device_open("", 0, 0, &device, NULL), BRDF_OK);
    struct brdfcl_scene *scene = render_scene_load(&view, even_contents);
    /* As if it were a small one. */
    device->info.largest = 1000 * 1000 * 8 * sizeof(float) - 1;
    assert_int_equal(brdfcl_scene_set_size(scene, 1000, 1000, NULL), BRDF_OK);
    assert_refused(scene, device, BRDF_OUT_OF_MEMORY, "1000 x 1000");
    assert_int_equal(brdfcl_scene_set_size(scene, 100, 100, NULL), BRDF_OK);
    device->info.largest = 100 * 100 * 16 * sizeof(float); /* enough pixels, but for their paths */
    assert_refused(scene, device, BRDF_OUT_OF_MEMORY, "paths");
    brdfcl_device_close(device);
    brdfcl_scene_destroy(scene);
}

/* 32 lanes are for arrays. */
static void lanes_that_no_render_has(void **state)
{
    const struct view view = {NULL, NULL, 0, 8, 1, 1, 0, NULL, NULL};
    struct brdfcl_device *device = NULL;
    (void)state;
    if (brdfcl_device_count() == 0) {
        skip();
    }
    assert_int_equal(brdfcl_device_open("", 32, 0, &device, NULL), BRDF_OK);
    struct brdfcl_scene *scene = render_scene_load(&view, even_contents);
    assert_refused(scene, device, BRDF_OUT_OF_RANGE, "32 lanes");
    brdfcl_device_close(device);
    brdfcl_scene_destroy(scene);
}

/* Lanes without a path compute with whatever lies in memory; what they read must still be there. */
static void idle_lanes_read_inside(void **state)
{
    const brdf_real nothing = brdf_from_bits(0x7fc00000);
    const brdf_vec3 directions[] = {{nothing, nothing, nothing},
                                    {HUGE_VALF, 1.0f, -HUGE_VALF},
                                    {3e38f, -3e38f, 3e38f},
                                    {0.0f, 0.0f, 0.0f}};
    struct pt_settings settings;
    (void)state;
    memset(&settings, 0, sizeof settings);
    settings.environment_width = 8;
    settings.environment_height = 5;
    for (size_t i = 0; i < sizeof directions / sizeof directions[0]; ++i) {
        struct pt_map_place place = pt_map_locate(&settings, directions[i]);
        assert_in_range(place.column, 0, 7);
        assert_in_range(place.row, 0, 3);
        assert_true(place.x >= 0.0f && place.x <= 1.0f && place.y >= 0.0f && place.y <= 1.0f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stops_when_told),          cmocka_unit_test(stops_at_once),
        cmocka_unit_test(counts_what_it_does),      cmocka_unit_test(too_many_pixels),
        cmocka_unit_test(too_large_for_the_device), cmocka_unit_test(lanes_that_no_render_has),
        cmocka_unit_test(idle_lanes_read_inside),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
