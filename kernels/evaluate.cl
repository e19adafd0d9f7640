/*
 * evaluate.cl - eval, pdf, sample, and the three together, of one material over arrays.
 *
 * EVALUATE_MODEL, EVALUATE_FLAGS and EVALUATE_CHOICES are members of struct brdf_material as
 * constants, so that only the code of that variant is compiled. Arrays are planes of packets,
 * `apart` packets from one to the next (evaluate.c numbers them); there is a packet for every
 * work-item, so none has to look whether there is one.
 */
#include "brdf/surface.h"

#define EVALUATE_ARGUMENTS                                                                         \
    global const float *restrict word, global const float *restrict table, ulong apart,            \
        global const brdf_real *restrict input, global brdf_real *restrict output

static inline brdf_parameters evaluate_parameters(global const float *word)
{
    return brdf_parameters_load(EVALUATE_MODEL, EVALUATE_CHOICES, word);
}

static inline brdf_vec3 evaluate_load(global const brdf_real *planes, size_t apart, size_t packet)
{
    return brdf_vec3_make(planes[packet], planes[apart + packet], planes[2 * apart + packet]);
}

static inline void evaluate_store_color(global brdf_real *planes, size_t apart, size_t packet,
                                        brdf_rgb c)
{
    planes[packet] = c.r;
    planes[apart + packet] = c.g;
    planes[2 * apart + packet] = c.b;
}

static inline void evaluate_store_sample(global brdf_real *planes, size_t apart, size_t packet,
                                         struct brdf_sample s)
{
    planes[packet] = s.wi.x;
    planes[apart + packet] = s.wi.y;
    planes[2 * apart + packet] = s.wi.z;
    evaluate_store_color(planes + 3 * apart, apart, packet, s.weight);
    planes[6 * apart + packet] = s.pdf;
    planes[7 * apart + packet] = s.eta;
    planes[8 * apart + packet] = brdf_from_bits(brdf_pick_int(s.delta != 0, 1, 0));
}

kernel void evaluate_eval(EVALUATE_ARGUMENTS)
{
    size_t packet = get_global_id(0);
    brdf_vec3 wo = evaluate_load(input, apart, packet);
    brdf_vec3 wi = evaluate_load(input + 3 * apart, apart, packet);
    evaluate_store_color(output, apart, packet,
                         brdf_surface_eval(EVALUATE_MODEL, EVALUATE_FLAGS,
                                           evaluate_parameters(word), wo, wi, table));
}

kernel void evaluate_pdf(EVALUATE_ARGUMENTS)
{
    size_t packet = get_global_id(0);
    brdf_vec3 wo = evaluate_load(input, apart, packet);
    brdf_vec3 wi = evaluate_load(input + 3 * apart, apart, packet);
    output[3 * apart + packet] =
        brdf_surface_pdf(EVALUATE_MODEL, EVALUATE_FLAGS, evaluate_parameters(word), wo, wi, table);
}

kernel void evaluate_sample(EVALUATE_ARGUMENTS)
{
    size_t packet = get_global_id(0);
    brdf_vec3 wo = evaluate_load(input, apart, packet);
    brdf_vec3 u = evaluate_load(input + 6 * apart, apart, packet);
    evaluate_store_sample(output + 4 * apart, apart, packet,
                          brdf_surface_sample(EVALUATE_MODEL, EVALUATE_FLAGS,
                                              evaluate_parameters(word), wo, u, table));
}

kernel void evaluate_bounce(EVALUATE_ARGUMENTS)
{
    size_t packet = get_global_id(0);
    brdf_vec3 wo = evaluate_load(input, apart, packet);
    brdf_vec3 u = evaluate_load(input + 6 * apart, apart, packet);
    brdf_parameters p = evaluate_parameters(word);
    struct brdf_sample s = brdf_surface_sample(EVALUATE_MODEL, EVALUATE_FLAGS, p, wo, u, table);
    evaluate_store_color(output, apart, packet,
                         brdf_surface_eval(EVALUATE_MODEL, EVALUATE_FLAGS, p, wo, s.wi, table));
    output[3 * apart + packet] =
        brdf_surface_pdf(EVALUATE_MODEL, EVALUATE_FLAGS, p, wo, s.wi, table);
    evaluate_store_sample(output + 4 * apart, apart, packet, s);
}
