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

#include "bvh.h"
#include "kernels/bvh.h"

/* In units of each other, by measurement (360,000 triangles, coherent and incoherent rays). */
#define TRAVERSAL_COST 1.0f
#define INTERSECTION_COST 1.0f

#define LARGEST_LINE (1 << 29) /* so that words and references of lines fit an int */

/* A node of Embree's tree, in Embree's memory. */
struct tree {
    int is_leaf;
    int count;
    union {
        struct tree *child[PT_WIDTH];
        unsigned number[PT_WIDTH]; /* of primitives */
    } of;
};

/* Everything that a build needs and frees. */
struct build {
    const float *rows;
    struct bvh_box *boxes;              /* a primitive each */
    struct RTCBuildPrimitive *prepared; /* those that can be hit */
    size_t prepared_count;
    RTCDevice device;
    RTCBVH memory;
    struct tree *tree;
    size_t node_count;
    size_t leaf_count;
    size_t next_node; /* lines */
    size_t next_leaf;
    int incomplete; /* a node is missing: no memory */
    struct bvh *out;
};

static struct tree *tree_make(RTCThreadLocalAllocator allocator, int is_leaf, size_t count)
{
    struct tree *tree = rtcThreadLocalAlloc(allocator, sizeof *tree, 16);
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
    return tree_make(allocator, 0, count);
}

static void on_children(void *node, void **children, unsigned count, void *user)
{
    struct tree *tree = node;
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
    struct tree *tree = tree_make(allocator, 1, count);
    (void)user;
    if (tree) {
        for (size_t i = 0; i < count; ++i) {
            tree->of.number[i] = primitives[i].primID;
        }
        qsort(tree->of.number, count, sizeof tree->of.number[0], compare_numbers);
    }
    return tree;
}

static brdf_status no_memory(size_t count, struct brdf_error *error)
{
    return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                     "out of memory for the hierarchy over %zu primitives; use a smaller mesh",
                     count);
}

/* The boxes of the primitives, and from them what Embree wants to know. */
static brdf_status prepare(struct build *build, size_t count, struct brdf_error *error)
{
    build->boxes = malloc((count + 1) * sizeof *build->boxes);
    void *memory = NULL;
    int failed = posix_memalign(&memory, 64, (count + 1) * sizeof *build->prepared);
    build->prepared = failed ? NULL : memory;
    if (!build->boxes || !build->prepared) {
        return no_memory(count, error);
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
        return no_memory(build->prepared_count, error);
    }
    struct RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = PT_WIDTH;
    arguments.maxDepth = PT_BVH_DEPTH; /* the last levels are split in the middle, to keep to it */
    arguments.sahBlockSize = PT_WIDTH;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = PT_WIDTH;
    arguments.traversalCost = TRAVERSAL_COST;
    arguments.intersectionCost = INTERSECTION_COST;
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
        return no_memory(build->prepared_count, error);
    }
    if (!build->tree || failure != RTC_ERROR_NONE) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "Embree could not build a hierarchy over %zu primitives (error %d)",
                         build->prepared_count, (int)failure);
    }
    return BRDF_OK;
}

/* Count nodes and leaves; returns the levels of nodes from here on. */
static int survey(struct build *build, const struct tree *tree)
{
    if (!tree) {
        build->incomplete = 1;
        return 0;
    }
    if (tree->is_leaf) {
        ++build->leaf_count;
        return 0;
    }
    ++build->node_count;
    int depth = 0;
    for (int i = 0; i < tree->count; ++i) {
        int below = survey(build, tree->of.child[i]);
        depth = below > depth ? below : depth;
    }
    return depth + 1;
}

static void put_vector(float *word, brdf_vec3 v)
{
    word[0] = v.x;
    word[PT_WIDTH] = v.y;
    word[2 * PT_WIDTH] = v.z;
}

static brdf_vec3 vector_at(const float *words)
{
    return brdf_vec3_make(words[0], words[1], words[2]);
}

static void put_primitive(float *lane, const float *row, unsigned number)
{
    int kind = brdf_bits(row[PT_KIND]);
    if (kind == PT_SPHERE) {
        put_vector(lane + PT_LEAF_P * PT_WIDTH, vector_at(row + PT_P));
        lane[PT_LEAF_N * PT_WIDTH] = row[PT_RADIUS];
    } else {
        struct pt_plane plane =
            pt_plane_make(vector_at(row + PT_P), vector_at(row + PT_E1), vector_at(row + PT_E2));
        put_vector(lane + PT_LEAF_P * PT_WIDTH, plane.p);
        put_vector(lane + PT_LEAF_N * PT_WIDTH, plane.n);
        put_vector(lane + PT_LEAF_A * PT_WIDTH, plane.a);
        put_vector(lane + PT_LEAF_B * PT_WIDTH, plane.b);
    }
    lane[PT_LEAF_KIND * PT_WIDTH] = brdf_from_bits(kind);
    lane[PT_LEAF_NUMBER * PT_WIDTH] = brdf_from_bits((int)number);
}

static int place_leaf(struct build *build, const struct tree *tree, struct bvh_box *box)
{
    size_t line = build->next_leaf;
    build->next_leaf += PT_LEAF_LINES;
    float *leaf = build->out->leaves + line * PT_WIDTH;
    int spheres = 0;
    for (int i = 0; i < tree->count; ++i) {
        unsigned number = tree->of.number[i];
        const float *row = build->rows + (size_t)number * PT_ROW;
        put_primitive(leaf + i, row, number);
        spheres |= brdf_bits(row[PT_KIND]) == PT_SPHERE;
        *box = bvh_box_join(*box, build->boxes[number]);
    }
    for (int i = tree->count; i < PT_WIDTH; ++i) {
        leaf[PT_LEAF_NUMBER * PT_WIDTH + i] = brdf_from_bits(-1);
    }
    return ~(2 * (int)line + spheres);
}

static void put_child(float *lane, struct bvh_box box, int reference)
{
    for (int axis = 0; axis < 3; ++axis) {
        lane[(PT_NODE_LOWER + axis) * PT_WIDTH] = box.lower[axis];
        lane[(PT_NODE_UPPER + axis) * PT_WIDTH] = box.upper[axis];
    }
    lane[PT_NODE_CHILD * PT_WIDTH] = brdf_from_bits(reference);
}

/* Lay out a subtree, its root first; joins its box to *box and returns the reference of its root.
 */
static int place(struct build *build, const struct tree *tree, struct bvh_box *box)
{
    if (tree->is_leaf) {
        return place_leaf(build, tree, box);
    }
    size_t line = build->next_node;
    build->next_node += PT_NODE_LINES;
    float *node = build->out->nodes + line * PT_WIDTH;
    for (int i = 0; i < PT_WIDTH; ++i) {
        struct bvh_box child_box = bvh_box_empty();
        int reference = 0;
        if (i < tree->count) {
            reference = place(build, tree->of.child[i], &child_box);
        }
        put_child(node + i, child_box, reference);
        *box = bvh_box_join(*box, child_box);
    }
    return (int)line;
}

static float *allocate_lines(size_t lines, size_t *words)
{
    void *memory = NULL;
    size_t bytes = lines * PT_WIDTH * sizeof(float);
    if (posix_memalign(&memory, 64, bytes)) {
        return NULL;
    }
    memset(memory, 0, bytes);
    *words = lines * PT_WIDTH;
    return memory;
}

static brdf_status lay_out(struct build *build, struct brdf_error *error)
{
    struct tree nothing = {0};
    const struct tree *tree = build->tree ? build->tree : &nothing;
    struct bvh *out = build->out;
    out->depth = survey(build, tree);
    size_t node_lines = 1 + build->node_count * PT_NODE_LINES;
    size_t leaf_lines = build->leaf_count * PT_LEAF_LINES;
    if (build->incomplete || node_lines > LARGEST_LINE || leaf_lines > LARGEST_LINE) {
        return no_memory(build->prepared_count, error);
    }
    if (out->depth > PT_BVH_DEPTH) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "the hierarchy over %zu primitives has %d levels, %d are possible",
                         build->prepared_count, out->depth, PT_BVH_DEPTH);
    }
    out->nodes = allocate_lines(node_lines, &out->node_words);
    out->leaves = allocate_lines(leaf_lines, &out->leaf_words);
    if (!out->nodes || !out->leaves) {
        return no_memory(build->prepared_count, error);
    }
    build->next_node = 1;
    struct bvh_box all = bvh_box_empty();
    out->root = place(build, tree, &all);
    for (int axis = 0; axis < 3 && !bvh_box_is_empty(all); ++axis) {
        out->nodes[PT_BVH_CENTRE + axis] = 0.5f * all.lower[axis] + 0.5f * all.upper[axis];
        out->nodes[PT_BVH_HALF + axis] = 0.5f * all.upper[axis] - 0.5f * all.lower[axis];
    }
    return BRDF_OK;
}

brdf_status bvh_build(const float *primitive_rows, size_t count, struct bvh *out,
                      struct brdf_error *error)
{
    struct build build;
    memset(&build, 0, sizeof build);
    memset(out, 0, sizeof *out);
    build.rows = primitive_rows;
    build.out = out;
    brdf_status status = prepare(&build, count, error);
    if (status == BRDF_OK && build.prepared_count > 0) {
        status = grow(&build, error);
    }
    if (status == BRDF_OK) {
        status = lay_out(&build, error);
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
