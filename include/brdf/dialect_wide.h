/*
 * dialect_wide.h - packets of 32 lanes, for which OpenCL C has no types: clang's vectors of any
 * length, and the functions that OpenCL has for its own ones, by halves.
 */
#ifndef BRDF_DIALECT_WIDE_H
#define BRDF_DIALECT_WIDE_H

#ifndef __clang__
#error "BRDF_LANES 32 needs a compiler with clang's vectors: use 16"
#endif

typedef float brdf_real __attribute__((ext_vector_type(32)));
typedef int brdf_int __attribute__((ext_vector_type(32)));
typedef uint brdf_uint __attribute__((ext_vector_type(32)));
#define BRDF_AS_REAL(x) __builtin_astype(x, brdf_real)
#define BRDF_AS_INT(x) __builtin_astype(x, brdf_int)
#define BRDF_AS_UINT(x) __builtin_astype(x, brdf_uint)
#define BRDF_TO_REAL(x) __builtin_convertvector(x, brdf_real)
#define BRDF_TO_INT(x) __builtin_convertvector(x, brdf_int)

/* Lanes by a digit to the base of 32, after that of OpenCL's own vectors. */
enum {
    BRDF_LANE_0,
    BRDF_LANE_1,
    BRDF_LANE_2,
    BRDF_LANE_3,
    BRDF_LANE_4,
    BRDF_LANE_5,
    BRDF_LANE_6,
    BRDF_LANE_7,
    BRDF_LANE_8,
    BRDF_LANE_9,
    BRDF_LANE_a,
    BRDF_LANE_b,
    BRDF_LANE_c,
    BRDF_LANE_d,
    BRDF_LANE_e,
    BRDF_LANE_f,
    BRDF_LANE_g,
    BRDF_LANE_h,
    BRDF_LANE_i,
    BRDF_LANE_j,
    BRDF_LANE_k,
    BRDF_LANE_l,
    BRDF_LANE_m,
    BRDF_LANE_n,
    BRDF_LANE_o,
    BRDF_LANE_p,
    BRDF_LANE_q,
    BRDF_LANE_r,
    BRDF_LANE_s,
    BRDF_LANE_t,
    BRDF_LANE_u,
    BRDF_LANE_v
};
#define BRDF_LANE_NUMBER(k) BRDF_LANE_##k
#define BRDF_LANE_OF(vector, k) (vector)[BRDF_LANE_##k]
#define BRDF_EACH_LANE(F)                                                                          \
    (F(0), F(1), F(2), F(3), F(4), F(5), F(6), F(7), F(8), F(9), F(a), F(b), F(c), F(d), F(e),     \
     F(f), F(g), F(h), F(i), F(j), F(k), F(l), F(m), F(n), F(o), F(p), F(q), F(r), F(s), F(t),     \
     F(u), F(v))

/* Of packets, and of the floats that are one for all lanes. */
#define BRDF_BY_HALVES(name, function)                                                             \
    static inline __attribute__((overloadable)) brdf_real name(brdf_real x)                        \
    {                                                                                              \
        return (brdf_real)(function(x.lo), function(x.hi));                                        \
    }                                                                                              \
    static inline __attribute__((overloadable)) float name(float x)                                \
    {                                                                                              \
        return function(x);                                                                        \
    }
BRDF_BY_HALVES(sqrtf, sqrt)
BRDF_BY_HALVES(fabsf, fabs)
BRDF_BY_HALVES(floorf, floor)
#undef BRDF_BY_HALVES

#endif
