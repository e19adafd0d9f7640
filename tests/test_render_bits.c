/*
 * test_render_bits.c - one scene, one picture, to the last bit: OpenCL at every lane count and C,
 * packets and hierarchy, any number of threads and any pool.
 */
#include "render_contents.h"
#include "render_scenes.h"

static const int lane_counts[] = {1, 4, 8, 16};
static const struct renderer in_c = {0, 0, 0};

/* Every picture must be one of its own: else the settings that differ would not be looked at. */
static void note_hash(unsigned long long hash, const char *name)
{
    static unsigned long long hashes[64];
    static size_t count;
    for (size_t i = 0; i < count; ++i) {
        if (hashes[i] == hash) {
            fail_msg("%s: the same picture as number %zu", name, i);
        }
    }
    assert_true(count < sizeof hashes / sizeof hashes[0]);
    hashes[count++] = hash;
}

static void assert_same_bits(const char *name, const struct view *view, const char *content,
                             const int *lanes, size_t count)
{
    struct brdfcl_scene *scene = render_scene_load(view, content);
    unsigned long long expected = render_hash(&in_c, scene);
    note_hash(expected, name);
    for (size_t i = 0; i < count; ++i) {
        const struct renderer who = {lanes[i], 0, 0};
        unsigned long long hash = render_hash(&who, scene);
        if (hash != expected) {
            fail_msg("%s: %d lanes give %016llx, C gives %016llx", name, lanes[i], hash, expected);
        }
    }
    brdfcl_scene_destroy(scene);
}

static void skip_without_opencl(void)
{
    if (brdfcl_device_count() == 0) {
        print_message("    skipped, no OpenCL device\n");
        skip();
    }
}

/* Both scenes at each lane count; these two also cost the time that compiling kernels takes. */
static void box_at_all_lanes(void **state)
{
    const struct view view = {NULL, NULL, 0, 40, 6, -1, 3, "multijitter", "gaussian"};
    (void)state;
    skip_without_opencl();
    assert_same_bits("box", &view, box_contents, lane_counts, 4);
}

static void mesh_at_all_lanes(void **state)
{
    const struct view view = {NULL, NULL, 0, 40, 6, 8, 0, "independent", "tent"};
    (void)state;
    skip_without_opencl();
    assert_same_bits("mesh", &view, mesh_contents, lane_counts, 4);
}

/* What is no constant of the kernels, so that the programs of above serve again. */
static void other_settings(void **state)
{
    static const struct view views[] = {
        {NULL, NULL, 0, 23, 5, 4, 1, "multijitter", "box"},
        {NULL, NULL, 70, 17, 33, -1, 2, "multijitter", "tent"},
        {"0.5, 0.45, 0.35", "0, 0.5, 0", 0, 16, 4, 7, 0, "multijitter", "gaussian"},
        {NULL, NULL, 0, 1, 1, 1, 0, "multijitter", "gaussian"},
    };
    const int lanes[] = {16, 1};
    (void)state;
    skip_without_opencl();
    for (size_t i = 0; i < sizeof views / sizeof views[0]; ++i) {
        assert_same_bits("other settings", &views[i], box_contents, lanes, 2);
    }
}

/* Few primitives: every ray against each of them. The same and more that no ray meets: through the
   hierarchy. Closest hits, shadows and ties all agree. */
static void hierarchy_equals_brute_force(void **state)
{
    const struct view view = {NULL, NULL, 0, 64, 8, 8, 0, "independent", "box"};
    char content[16384];
    (void)state;
    struct brdfcl_scene *few = render_scene_load(&view, box_contents);
    snprintf(content, sizeof content, "%s%s", box_contents, far_contents);
    struct brdfcl_scene *many = render_scene_load(&view, content);
    assert_in_range(brdfcl_scene_get_info(few).primitive_count, 15, 32);
    assert_in_range(brdfcl_scene_get_info(many).primitive_count, 33, 100);
    assert_true(render_hash(&in_c, few) == render_hash(&in_c, many));
    brdfcl_scene_destroy(few);
    brdfcl_scene_destroy(many);
}

/* How the work is cut up changes no bit: sums are in the order of samples. */
static void pools_and_threads(void **state)
{
    static const struct renderer others[] = {{0, 1, 16},  {0, 3, 16},      {0, 2, 4096},
                                             {0, 1, 100}, {0, 4, 1 << 20}, {0, 1, 1 << 16}};
    const struct view view = {NULL, NULL, 0, 19, 23, 5, 0, "multijitter", "box"};
    (void)state;
    struct brdfcl_scene *scene = render_scene_load(&view, box_contents);
    unsigned long long expected = render_hash(&in_c, scene);
    assert_true(render_hash(&in_c, scene) == expected);
    for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i) {
        if (render_hash(&others[i], scene) != expected) {
            fail_msg("%d threads, pool of %d: another picture", others[i].threads, others[i].pool);
        }
    }
    brdfcl_scene_set_seed(scene, 1);
    assert_true(render_hash(&in_c, scene) != expected);
    brdfcl_scene_set_seed(scene, 0);
    assert_true(render_hash(&in_c, scene) == expected);
    brdfcl_scene_destroy(scene);
}

static void pools_on_a_device(void **state)
{
    static const int pools[] = {16, 4096 + 16, 1 << 18};
    const struct view view = {NULL, NULL, 0, 40, 11, -1, 3, "multijitter", "gaussian"};
    (void)state;
    skip_without_opencl();
    struct brdfcl_scene *scene = render_scene_load(&view, box_contents);
    assert_int_equal(brdfcl_scene_set_size(scene, 40, 9, NULL), BRDF_OK);
    unsigned long long expected = render_hash(&in_c, scene);
    for (size_t i = 0; i < sizeof pools / sizeof pools[0]; ++i) {
        const struct renderer who = {16, 0, pools[i]};
        if (render_hash(&who, scene) != expected) {
            fail_msg("pool of %d: another picture", pools[i]);
        }
    }
    brdfcl_scene_destroy(scene);
}

static int open_files(void **state)
{
    int status = scene_files_open(state);
    if (!status) {
        render_files_write();
    }
    return status;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_at_all_lanes),  cmocka_unit_test(mesh_at_all_lanes),
        cmocka_unit_test(other_settings),    cmocka_unit_test(hierarchy_equals_brute_force),
        cmocka_unit_test(pools_and_threads), cmocka_unit_test(pools_on_a_device),
    };
    return cmocka_run_group_tests(tests, open_files, scene_files_close);
}
