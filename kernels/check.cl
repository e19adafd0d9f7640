/*
 * check.cl - eval, pdf and sample of one material over arrays, to be compared with C.
 *
 * CHECK_MODEL, CHECK_FLAGS and CHECK_CHOICES are what struct brdf_material holds, as constants, so
 * that only the code of this variant is compiled, as in a render. Arrays are planes of `packets`
 * packets: of `input` wo, wi and u, of `output` f, pdf, and a sample's wi, weight, pdf, eta and
 * delta.
 */
#include "brdf/surface.h"

static inline brdf_vec3 check_load(global const brdf_real *input, unsigned packets, unsigned packet)
{
    return brdf_vec3_make(input[packet], input[packets + packet], input[2u * packets + packet]);
}

static inline void check_store(global brdf_real *output, unsigned packets, unsigned packet,
                               brdf_vec3 v)
{
    output[packet] = v.x;
    output[packets + packet] = v.y;
    output[2u * packets + packet] = v.z;
}

static inline brdf_vec3 check_color(brdf_rgb c)
{
    return brdf_vec3_make(c.r, c.g, c.b);
}

kernel void check(global const float *word, global const float *table, unsigned packets,
                  global const brdf_real *input, global brdf_real *output)
{
    unsigned packet = (unsigned)get_global_id(0);
    brdf_vec3 wo = check_load(input, packets, packet);
    brdf_vec3 wi = check_load(input + 3u * packets, packets, packet);
    brdf_vec3 u = check_load(input + 6u * packets, packets, packet);
    brdf_parameters p = brdf_parameters_load(CHECK_MODEL, CHECK_CHOICES, word);
    brdf_rgb f = brdf_surface_eval(CHECK_MODEL, CHECK_FLAGS, p, wo, wi, table);
    struct brdf_sample s = brdf_surface_sample(CHECK_MODEL, CHECK_FLAGS, p, wo, u, table);
    check_store(output, packets, packet, check_color(f));
    output[3u * packets + packet] = brdf_surface_pdf(CHECK_MODEL, CHECK_FLAGS, p, wo, wi, table);
    check_store(output + 4u * packets, packets, packet, s.wi);
    check_store(output + 7u * packets, packets, packet, check_color(s.weight));
    output[10u * packets + packet] = s.pdf;
    output[11u * packets + packet] = s.eta;
    output[12u * packets + packet] = brdf_pick(s.delta != 0, 1.0f, 0.0f);
}
