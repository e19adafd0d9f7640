/*
 * bvh.c - building the hierarchy: Embree decides who goes with whom, the layout is ours.
 *
 * Embree calls back from several threads in no particular order, so the callbacks only link up a
 * tree. It is numbered afterwards by a walk, depth first, which makes the bytes depend on the tree
 * alone; and the boxes are joined anew from those of the primitives.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifdef BRDFCL_EMBREE4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "bvh_tree.h"

/* Everything that a build needs and frees. */
struct build {
    const float *rows;
    struct bvh_box *boxes;              /* a primitive each */
    struct RTCBuildPrimitive *prepared; /* those that can be hit */
    size_t prepared_count;
    RTCDevice device;
    RTCBVH memory;
    struct bvh_tree *tree; /* in Embree's memory */
};

static struct bvh_tree *grow_node(RTCThreadLocalAllocator allocator, int is_leaf, size_t count)
{
    struct bvh_tree *tree = rtcThreadLocalAlloc(allocator, sizeof *tree, 16);
    if (tree) {
        memset(tree, 0, sizeof *tree);
        tree->is_leaf = is_leaf;
        tree->count = (int)count;
    }
    return tree;
}

static void *on_node(RTCThreadLocalAllocator allocator, unsigned count, void *user)
{
    (void)user;
    return grow_node(allocator, 0, count);
}

static void on_children(void *node, void **children, unsigned count, void *user)
{
    struct bvh_tree *tree = node;
    (void)user;
    for (unsigned i = 0; tree && i < count; ++i) {
        tree->of.child[i] = children[i];
    }
}

static void on_bounds(void *node, const struct RTCBounds **bounds, unsigned count, void *user)
{
    (void)node;
    (void)bounds;
    (void)count;
    (void)user;
}

static int compare_numbers(const void *a, const void *b)
{
    unsigned left = *(const unsigned *)a;
    unsigned right = *(const unsigned *)b;
    return (left > right) - (left < right);
}

static void *on_leaf(RTCThreadLocalAllocator allocator, const struct RTCBuildPrimitive *primitives,
                     size_t count, void *user)
{
    struct bvh_tree *tree = grow_node(allocator, 1, count);
    (void)user;
    if (tree) {
        for (size_t i = 0; i < count; ++i) {
            tree->of.number[i] = primitives[i].primID;
        }
        qsort(tree->of.number, count, sizeof tree->of.number[0], compare_numbers);
    }
    return tree;
}

/* The boxes of the primitives, and from them what Embree wants to know. */
static brdf_status prepare(struct build *build, size_t count, struct brdf_error *error)
{
    build->boxes = malloc((count + 1) * sizeof *build->boxes);
    void *memory = NULL;
    int failed = posix_memalign(&memory, 64, (count + 1) * sizeof *build->prepared);
    build->prepared = failed ? NULL : memory;
    if (!build->boxes || !build->prepared) {
        return bvh_no_memory(error);
    }
    for (size_t i = 0; i < count; ++i) {
        struct bvh_box *box = &build->boxes[i];
        if (!bvh_primitive_box(build->rows + i * PT_ROW, box)) {
            return brdf_fail(error, BRDF_OUT_OF_RANGE,
                             "primitive %zu has a coordinate that is not a number or beyond 1e18; "
                             "scale the scene down",
                             i);
        }
        if (bvh_box_is_empty(*box)) {
            continue;
        }
        struct RTCBuildPrimitive *p = &build->prepared[build->prepared_count++];
        p->lower_x = box->lower[0];
        p->lower_y = box->lower[1];
        p->lower_z = box->lower[2];
        p->upper_x = box->upper[0];
        p->upper_y = box->upper[1];
        p->upper_z = box->upper[2];
        p->geomID = 0;
        p->primID = (unsigned)i;
    }
    return BRDF_OK;
}

static brdf_status grow(struct build *build, struct brdf_error *error)
{
    build->device = rtcNewDevice("verbose=0");
    build->memory = build->device ? rtcNewBVH(build->device) : NULL;
    if (!build->memory) {
        return bvh_no_memory(error);
    }
    struct RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = PT_WIDTH;
    arguments.maxDepth = PT_BVH_DEPTH; /* the last levels are split in the middle, to keep to it */
    arguments.sahBlockSize = PT_WIDTH;
    arguments.minLeafSize = PT_WIDTH; /* leaves are full: less memory, and faster as measured */
    arguments.maxLeafSize = PT_WIDTH;
    arguments.bvh = build->memory;
    arguments.primitives = build->prepared;
    arguments.primitiveCount = build->prepared_count;
    arguments.primitiveArrayCapacity = build->prepared_count;
    arguments.createNode = on_node;
    arguments.setNodeChildren = on_children;
    arguments.setNodeBounds = on_bounds;
    arguments.createLeaf = on_leaf;
    build->tree = rtcBuildBVH(&arguments);
    enum RTCError failure = rtcGetDeviceError(build->device);
    if (failure == RTC_ERROR_OUT_OF_MEMORY) {
        return bvh_no_memory(error);
    }
    if (!build->tree || failure != RTC_ERROR_NONE) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "Embree could not build a hierarchy over %zu primitives (error %d)",
                         build->prepared_count, (int)failure);
    }
    return BRDF_OK;
}

brdf_status bvh_build(const float *primitive_rows, size_t count, struct bvh *out,
                      struct brdf_error *error)
{
    struct bvh_tree nothing = {1, 0, {{NULL}}};
    struct build build;
    memset(&build, 0, sizeof build);
    memset(out, 0, sizeof *out);
    build.rows = primitive_rows;
    build.tree = &nothing;
    brdf_status status = prepare(&build, count, error);
    if (status == BRDF_OK && build.prepared_count > 0) {
        status = grow(&build, error);
    }
    if (status == BRDF_OK) {
        status = bvh_lay_out(build.tree, primitive_rows, build.boxes, out, error);
    }
    if (status != BRDF_OK) {
        bvh_destroy(out);
    }
    if (build.memory) {
        rtcReleaseBVH(build.memory);
    }
    if (build.device) {
        rtcReleaseDevice(build.device);
    }
    free(build.prepared);
    free(build.boxes);
    return status;
}

void bvh_destroy(struct bvh *bvh)
{
    free(bvh->nodes);
    free(bvh->leaves);
    memset(bvh, 0, sizeof *bvh);
}
