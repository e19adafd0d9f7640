/*
 * bvh.h - building the hierarchy that kernels/bvh.h traverses.
 */
#ifndef BRDFCL_LIB_BVH_H
#define BRDFCL_LIB_BVH_H

#include <stddef.h>

#include <brdf/status.h>

/* The parts of pt_settings and of the scene array that kernels/bvh.h describes. */
struct bvh {
    float *nodes; /* aligned to 64 bytes */
    size_t node_words;
    float *leaves; /* aligned to 64 bytes */
    size_t leaf_words;
    int root;  /* pt_settings.root */
    int depth; /* levels of nodes, at most PT_BVH_DEPTH; 0 where everything fits a leaf */
};

/* An axis-aligned box; empty where lower > upper. */
struct bvh_box {
    float lower[3];
    float upper[3];
};

/*
 * Build over `count` rows of 16 words (kernels/scene.h). A primitive's number is its row. Those
 * without area are left out, as nothing hits them; a hierarchy of nothing is valid and all rays
 * miss. The same rows give the same bytes, on however many threads. Fails on a primitive that is
 * not finite or beyond 1e18 (OUT_OF_RANGE, with its number) and for want of memory; then *out is
 * empty.
 */
brdf_status bvh_build(const float *primitive_rows, size_t count, struct bvh *out,
                      struct brdf_error *error);

/* Frees what bvh_build made; a zeroed struct is fine. */
void bvh_destroy(struct bvh *bvh);

/*
 * A box in which every reported hit of the primitive lies but for the errors that kernels/bvh.h
 * adds itself; empty where nothing hits it. Returns 0 where a word is not finite or beyond 1e18.
 */
int bvh_primitive_box(const float *row, struct bvh_box *box);

/* The smallest box around both. */
struct bvh_box bvh_box_join(struct bvh_box a, struct bvh_box b);
struct bvh_box bvh_box_empty(void);
int bvh_box_is_empty(struct bvh_box box);

#endif
