/*
 * wavefront.cl - the stages as kernels: each finds its work-item's number and calls the stage.
 *
 * Kernels are launched for as many packets as there could be; those past the counter have nothing
 * to do. The host appends one shading kernel for each variant of the scene.
 */
#include "connect.h"
#include "film.h"
#include "generate.h"
#include "resolve.h"
#include "shade.h"
#include "sort.h"
#include "through.h"

__kernel void begin(__global const struct pt_settings *settings, __global const float *scene,
                    __global const float *tables, __global float *state, struct pt_pass pass,
                    int depth)
{
    pt_begin(pt_world_make(settings, scene, tables, state), pass);
}

__kernel void generate(__global const struct pt_settings *settings, __global const float *scene,
                       __global const float *tables, __global float *state, struct pt_pass pass,
                       int depth)
{
    int packet = (int)get_global_id(0);
    if (packet * BRDF_LANES < pass.path_count) {
        pt_generate(pt_world_make(settings, scene, tables, state), pass, packet);
    }
}

__kernel void extend_packets(__global const struct pt_settings *settings,
                             __global const float *scene, __global const float *tables,
                             __global float *state, struct pt_pass pass, int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int packet = (int)get_global_id(0);
    if (packet == 0) {
        pt_open_bounce(w, depth);
    }
    if (packet * BRDF_LANES < w.queues[PT_ACTIVE + (depth & 1)]) {
        pt_extend_packet(w, packet, depth);
    }
}

__kernel void extend_rays(__global const struct pt_settings *settings, __global const float *scene,
                          __global const float *tables, __global float *state, struct pt_pass pass,
                          int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int place = (int)get_global_id(0);
    if (place == 0) {
        pt_open_bounce(w, depth);
    }
    if (place < w.queues[PT_ACTIVE + (depth & 1)]) {
        pt_extend_ray(w, place, depth);
    }
}

#if (PT_FEATURES) & PT_HAS_FORKS
__kernel void resolve(__global const struct pt_settings *settings, __global const float *scene,
                      __global const float *tables, __global float *state, struct pt_pass pass,
                      int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int packet = (int)get_global_id(0);
    if (packet * BRDF_LANES < w.queues[PT_ACTIVE + (depth & 1)]) {
        pt_resolve(w, pass, packet, depth);
    }
}
#endif

__kernel void sort(__global const struct pt_settings *settings, __global const float *scene,
                   __global const float *tables, __global float *state, struct pt_pass pass,
                   int depth)
{
    pt_sort(pt_world_make(settings, scene, tables, state), (int)get_global_id(0), depth);
}

__kernel void shade_missed(__global const struct pt_settings *settings, __global const float *scene,
                           __global const float *tables, __global float *state, struct pt_pass pass,
                           int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int packet = (int)get_global_id(0);
    int variant = w.settings->variant_count - 1;
    if (packet < w.queues[PT_VARIANTS + variant]) {
        pt_shade_missed(w, w.queues[w.settings->variant_first + variant] + packet);
    }
}

__kernel void connect_packets(__global const struct pt_settings *settings,
                              __global const float *scene, __global const float *tables,
                              __global float *state, struct pt_pass pass, int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int packet = (int)get_global_id(0);
    if (packet == 0) {
        w.queues[PT_RAYS] += w.queues[PT_SHADOWS];
    }
    if (packet * BRDF_LANES < w.queues[PT_SHADOWS]) {
        pt_connect_packet(w, packet);
    }
}

__kernel void connect_rays(__global const struct pt_settings *settings, __global const float *scene,
                           __global const float *tables, __global float *state, struct pt_pass pass,
                           int depth)
{
    struct pt_world w = pt_world_make(settings, scene, tables, state);
    int place = (int)get_global_id(0);
    if (place == 0) {
        w.queues[PT_RAYS] += w.queues[PT_SHADOWS];
    }
    if (place < w.queues[PT_SHADOWS]) {
        pt_connect_ray(w, place);
    }
}

__kernel void film(__global const struct pt_settings *settings, __global const float *scene,
                   __global const float *tables, __global float *state, struct pt_pass pass,
                   int depth, __global float *sums)
{
    int number = (int)get_global_id(0);
    if (number < pass.path_count >> pass.sample_bits) {
        pt_film(pt_world_make(settings, scene, tables, state), pass, sums, number);
    }
}
