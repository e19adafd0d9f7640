/*
 * bvh_tree.h - between the two halves of the build: the tree as it grew, before it is laid out.
 */
#ifndef BRDFCL_LIB_BVH_TREE_H
#define BRDFCL_LIB_BVH_TREE_H

#include "bvh.h"
#include "kernels/bvh.h"

struct bvh_tree {
    int is_leaf;
    int count;
    union {
        struct bvh_tree *child[PT_WIDTH];
        unsigned number[PT_WIDTH]; /* of primitives, ascending */
    } of;
};

/*
 * Number the nodes by a walk, depth first, and fill in out's arrays, root and depth. `boxes` has
 * one box a row. A child that is missing means that memory ran out while the tree grew.
 */
brdf_status bvh_lay_out(const struct bvh_tree *tree, const float *rows, const struct bvh_box *boxes,
                        struct bvh *out, struct brdf_error *error);

/* Fails with OUT_OF_MEMORY. */
brdf_status bvh_no_memory(struct brdf_error *error);

#endif
