/*
 * rows.h - reading and writing records by index, a packet of lanes at a time.
 *
 * Paths, primitives and lights are records (an array of structs), not one array a field: a packet
 * whose lanes point anywhere touches one cache line a lane instead of one a lane and field, and the
 * transposition into lanes costs a few shuffles. The unit is the quad: four words on 16 bytes.
 */
#ifndef PT_ROWS_H
#define PT_ROWS_H

#include "brdf/quad.h"
#include "brdf/vec.h"

#if defined(__OPENCL_VERSION__) && BRDF_LANES > 1

/* words[index .. index + 3] = q in every lane, the lower lanes first. */
static inline void pt_store_quad(BRDF_GLOBAL float *words, brdf_int index, struct brdf_quad q)
{
    struct brdf_quad rows = brdf_quad_transpose(q);
#define PT_PUT(k, row, part) *(BRDF_GLOBAL float4 *)(words + as_uint(index.s##k)) = rows.row part
#if BRDF_LANES == 4
    PT_PUT(0, a, );
    PT_PUT(1, b, );
    PT_PUT(2, c, );
    PT_PUT(3, d, );
#else
    PT_PUT(0, a, .s0123);
    PT_PUT(1, b, .s0123);
    PT_PUT(2, c, .s0123);
    PT_PUT(3, d, .s0123);
    PT_PUT(4, a, .s4567);
    PT_PUT(5, b, .s4567);
    PT_PUT(6, c, .s4567);
    PT_PUT(7, d, .s4567);
#endif
#if BRDF_LANES == 16
    PT_PUT(8, a, .s89ab);
    PT_PUT(9, b, .s89ab);
    PT_PUT(a, c, .s89ab);
    PT_PUT(b, d, .s89ab);
    PT_PUT(c, a, .scdef);
    PT_PUT(d, b, .scdef);
    PT_PUT(e, c, .scdef);
    PT_PUT(f, d, .scdef);
#endif
#undef PT_PUT
}

/* The integers at words[first ..], one a lane. */
static inline brdf_int pt_load_ints(BRDF_GLOBAL const int *words)
{
#if BRDF_LANES == 4
    return vload4(0, words);
#elif BRDF_LANES == 8
    return vload8(0, words);
#else
    return vload16(0, words);
#endif
}

static inline void pt_store_ints(BRDF_GLOBAL int *words, brdf_int values)
{
#if BRDF_LANES == 4
    vstore4(values, 0, words);
#elif BRDF_LANES == 8
    vstore8(values, 0, words);
#else
    vstore16(values, 0, words);
#endif
}

/* One lane of a vector by number, through memory: the number may change in a loop. */
union pt_lanes {
    brdf_int v;
    int lane[BRDF_LANES];
};

static inline union pt_lanes pt_lanes_of(brdf_int values)
{
    union pt_lanes lanes;
    lanes.v = values;
    return lanes;
}

#else /* one lane */

static inline void pt_store_quad(BRDF_GLOBAL float *words, brdf_int index, struct brdf_quad q)
{
    words[index] = q.a;
    words[index + 1] = q.b;
    words[index + 2] = q.c;
    words[index + 3] = q.d;
}

static inline brdf_int pt_load_ints(BRDF_GLOBAL const int *words)
{
    return words[0];
}

static inline void pt_store_ints(BRDF_GLOBAL int *words, brdf_int values)
{
    words[0] = values;
}

union pt_lanes {
    brdf_int v;
    int lane[1];
};

static inline union pt_lanes pt_lanes_of(brdf_int values)
{
    union pt_lanes lanes;
    lanes.v = values;
    return lanes;
}

#endif

/* The 16 words of a record in every lane. */
struct pt_row {
    struct brdf_quad q0;
    struct brdf_quad q1;
    struct brdf_quad q2;
    struct brdf_quad q3;
};

static inline struct pt_row pt_load_row(BRDF_GLOBAL const float *words, brdf_int index)
{
    struct pt_row row;
    row.q0 = brdf_gather_quad(words, index);
    row.q1 = brdf_gather_quad(words + 4, index);
    row.q2 = brdf_gather_quad(words + 8, index);
    row.q3 = brdf_gather_quad(words + 12, index);
    return row;
}

/* The first three words of a quad as a vector or a colour, and back with a fourth. */
static inline brdf_vec3 pt_quad_vec3(struct brdf_quad q)
{
    return brdf_vec3_make(q.a, q.b, q.c);
}

static inline brdf_rgb pt_quad_rgb(struct brdf_quad q)
{
    return brdf_rgb_make(q.a, q.b, q.c);
}

static inline struct brdf_quad pt_quad_of_vec3(brdf_vec3 v, brdf_real d)
{
    return brdf_quad_make(v.x, v.y, v.z, d);
}

static inline struct brdf_quad pt_quad_of_rgb(brdf_rgb c, brdf_real d)
{
    return brdf_quad_make(c.r, c.g, c.b, d);
}

#endif
