/*
 * bvh_layout.c - the arrays of a hierarchy: a tree becomes lines of 16 words.
 */
#define _POSIX_C_SOURCE 200809L

#include <stdlib.h>
#include <string.h>

#include "bvh_tree.h"

#define LARGEST_LINE (1 << 27) /* so that the number of a word fits an int */

/* Where the next node and the next leaf go. */
struct layout {
    const float *rows;
    const struct bvh_box *boxes;
    struct bvh *out;
    size_t node_count;
    size_t leaf_count;
    size_t next_node; /* lines */
    size_t next_leaf;
    int incomplete;
};

brdf_status bvh_no_memory(struct brdf_error *error)
{
    return brdf_fail(error, BRDF_OUT_OF_MEMORY,
                     "out of memory for the hierarchy of the scene; use smaller meshes");
}

/* Count nodes and leaves; returns the levels of nodes from here on. */
static int survey(struct layout *layout, const struct bvh_tree *tree)
{
    if (!tree) {
        layout->incomplete = 1;
        return 0;
    }
    if (tree->is_leaf) {
        ++layout->leaf_count;
        return 0;
    }
    ++layout->node_count;
    int depth = 0;
    for (int i = 0; i < tree->count; ++i) {
        int below = survey(layout, tree->of.child[i]);
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

static int place_leaf(struct layout *layout, const struct bvh_tree *tree, struct bvh_box *box)
{
    size_t line = layout->next_leaf;
    layout->next_leaf += PT_LEAF_LINES;
    float *leaf = layout->out->leaves + line * PT_WIDTH;
    int content = 0;
    for (int i = 0; i < tree->count; ++i) {
        unsigned number = tree->of.number[i];
        const float *row = layout->rows + (size_t)number * PT_ROW;
        put_primitive(leaf + i, row, number);
        int kind = brdf_bits(row[PT_KIND]);
        content |=
            (kind == PT_SPHERE ? PT_LEAF_SPHERES : 0) | (kind == PT_TRIANGLE ? 0 : PT_LEAF_KINDS);
        *box = bvh_box_join(*box, layout->boxes[number]);
    }
    for (int i = tree->count; i < PT_WIDTH; ++i) {
        leaf[PT_LEAF_NUMBER * PT_WIDTH + i] = brdf_from_bits(-1);
    }
    return ~(4 * (int)line + content);
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
static int place(struct layout *layout, const struct bvh_tree *tree, struct bvh_box *box)
{
    if (tree->is_leaf) {
        return place_leaf(layout, tree, box);
    }
    size_t line = layout->next_node;
    layout->next_node += PT_NODE_LINES;
    float *node = layout->out->nodes + line * PT_WIDTH;
    for (int i = 0; i < PT_WIDTH; ++i) {
        struct bvh_box child_box = bvh_box_empty();
        int reference = 0;
        if (i < tree->count) {
            reference = place(layout, tree->of.child[i], &child_box);
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

brdf_status bvh_lay_out(const struct bvh_tree *tree, const float *rows, const struct bvh_box *boxes,
                        struct bvh *out, struct brdf_error *error)
{
    struct layout layout = {rows, boxes, out, 0, 0, 1, 0, 0};
    out->depth = survey(&layout, tree);
    size_t node_lines = 1 + layout.node_count * PT_NODE_LINES;
    size_t leaf_lines = layout.leaf_count * PT_LEAF_LINES;
    if (layout.incomplete || node_lines > LARGEST_LINE || leaf_lines > LARGEST_LINE) {
        return bvh_no_memory(error);
    }
    if (out->depth > PT_BVH_DEPTH) {
        return brdf_fail(
            error, BRDF_UNSUPPORTED,
            "the hierarchy of the scene has %d levels, but %d are possible; primitives "
            "of very different sizes lie in one place",
            out->depth, PT_BVH_DEPTH);
    }
    out->nodes = allocate_lines(node_lines, &out->node_words);
    out->leaves = allocate_lines(leaf_lines, &out->leaf_words);
    if (!out->nodes || !out->leaves) {
        return bvh_no_memory(error);
    }
    struct bvh_box all = bvh_box_empty();
    out->root = place(&layout, tree, &all);
    for (int axis = 0; axis < 3 && !bvh_box_is_empty(all); ++axis) {
        out->nodes[PT_BVH_CENTRE + axis] = 0.5f * all.lower[axis] + 0.5f * all.upper[axis];
        out->nodes[PT_BVH_HALF + axis] = 0.5f * all.upper[axis] - 0.5f * all.lower[axis];
    }
    return BRDF_OK;
}
