/*
 * opencl.h - the OpenCL side of libbrdfcl, for its own files: an open device and what runs on it.
 */
#ifndef BRDFCL_LIB_OPENCL_H
#define BRDFCL_LIB_OPENCL_H

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

#include <brdfcl/device.h>

struct brdfcl_device {
    cl_device_id id;
    cl_context context;
    cl_command_queue queue; /* in order */
    int lanes;              /* of renders and checks */
    int array_lanes;        /* of evaluators */
    struct brdfcl_device_info info;
};

/* Device `index` of all platforms together; 0 where there is none. */
int opencl_device_at(int index, cl_platform_id *platform, cl_device_id *id);

/* Fill in what the device says of itself. */
void opencl_describe(cl_platform_id platform, cl_device_id id, struct brdfcl_device_info *info);

/* The name of an OpenCL status, "CL_OUT_OF_RESOURCES". */
const char *opencl_status_name(cl_int status);

/* BRDF_OK where status is CL_SUCCESS; else the error says which call failed, how, and what helps.
 */
brdf_status opencl_check(cl_int status, const char *call, struct brdf_error *error);

enum { OPENCL_MODELS = 64 }; /* more than there are */

/* The materials that a program is for; begin with {0} and add each. */
struct opencl_materials {
    struct {
        int used;
        unsigned known;  /* 4 bits of each choice that is the same in all materials of this model */
        unsigned chosen; /* those choices, as in struct brdf_material */
    } model[OPENCL_MODELS];
};
void opencl_materials_add(struct opencl_materials *materials, unsigned model, unsigned choices);

/* The name of a model's tag in a program, "BRDF_MODEL_DIFFUSE": its number depends on the program.
 */
const char *opencl_model_tag(unsigned model);

/*
 * Build a program from text: quoted includes of shared headers and kernels are expanded, the lanes
 * and the flags of bit-exactness are set; `options` adds to them. The list of models that it sees
 * has only those of `materials`, and of their choices the program knows which are the same in all
 * materials (brdf/choices.h): what nobody uses costs no time to compile. Build errors carry the
 * compiler's log, whose places are those of the source files.
 */
brdf_status opencl_build(struct brdfcl_device *device, int lanes,
                         const struct opencl_materials *materials, const char *text,
                         const char *text_name, const char *options, cl_program *program,
                         struct brdf_error *error);

/* The text of such a program; *out is malloc'd. */
brdf_status opencl_expand(const struct opencl_materials *materials, const char *text,
                          const char *text_name, char **out, struct brdf_error *error);

/*
 * A buffer over host memory: the same bytes on a processor (no copy where the memory is aligned to
 * 64 bytes), a copy elsewhere. The memory must outlive the buffer. Zero bytes give a small buffer.
 */
brdf_status opencl_buffer_over(struct brdfcl_device *device, const void *data, size_t bytes,
                               cl_mem *buffer, struct brdf_error *error);

/* A buffer of the device's own, for reading and writing by kernels. */
brdf_status opencl_buffer(struct brdfcl_device *device, size_t bytes, cl_mem *buffer,
                          struct brdf_error *error);

#endif
