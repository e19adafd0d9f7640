/* needs: brdf OpenCL */
/*
 * own_kernel.c - the shared source in a kernel of your own, and the same bits as in C.
 *
 * brdf_source_expand puts the headers that the kernel includes into its text, so neither files nor
 * include paths are needed where the program runs. For the same bits, C must not contract
 * a * b + c to one operation either: -ffp-contract=off, or -std=c99 with gcc.
 */
#define CL_TARGET_OPENCL_VERSION 120
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <CL/cl.h>

#include <brdf/brdf.h>
#include <brdf/model/roughconductor.h>

enum { COUNT = 1 << 16 };

static const char kernel_text[] =
    "#include \"brdf/model/roughconductor.h\"\n"
    "kernel void evaluate(global const float *direction, global float *f)\n"
    "{\n"
    "    size_t i = get_global_id(0);\n"
    "    struct brdf_roughconductor p = {0}; /* every option its first */\n"
    "    p.distribution = 0;\n"
    "    p.masking = 0;\n"
    "    p.eta = brdf_rgb_make(0.2586f, 1.0428f, 1.3037f);\n"
    "    p.k = brdf_rgb_make(3.1989f, 2.6243f, 2.3474f);\n"
    "    p.alpha_u = 0.2f;\n"
    "    p.alpha_v = 0.4f;\n"
    "    p.specular_reflectance = brdf_gray(1.0f);\n"
    "    brdf_vec3 wo = brdf_vec3_make(0.6f, 0.0f, 0.8f);\n"
    "    brdf_vec3 wi = brdf_vec3_make(direction[3 * i], direction[3 * i + 1],\n"
    "                                  direction[3 * i + 2]);\n"
    "    f[i] = brdf_roughconductor_eval(p, wo, wi, 0).r;\n"
    "}\n";

/* Directions over the upper half of the sphere; every bit of them is the same on both sides. */
static void spread_directions(float *direction)
{
    for (int i = 0; i < COUNT; ++i) {
        float x = 2.0f * (float)(i & 255) / 255.0f - 1.0f,
              y = 2.0f * (float)(i >> 8) / 255.0f - 1.0f;
        brdf_vec3 wi = brdf_normalize(brdf_vec3_make(x, y, 1.0f - 0.7f * x * x));
        memcpy(&direction[3 * i], (const float[3]){wi.x, wi.y, wi.z}, 3 * sizeof(float));
    }
}

/* The first device of the first platform that has one. */
static cl_device_id first_device(void)
{
    cl_platform_id platforms[16];
    cl_uint count = 0;
    cl_device_id device = NULL;
    clGetPlatformIDs(16, platforms, &count);
    for (cl_uint i = 0; i < count && i < 16 && !device; ++i) {
        clGetDeviceIDs(platforms[i], CL_DEVICE_TYPE_ALL, 1, &device, NULL);
    }
    return device;
}

/* Everything that is OpenCL; 0 if it worked. */
static int evaluate(cl_device_id device, const char *text, float *direction, float *f)
{
    size_t count = COUNT, bytes = COUNT * sizeof(float);
    cl_int status = CL_SUCCESS;
    cl_context context = clCreateContext(NULL, 1, &device, NULL, NULL, &status);
    cl_command_queue queue = clCreateCommandQueue(context, device, 0, &status);
    cl_program program = clCreateProgramWithSource(context, 1, &text, NULL, &status);
    status = clBuildProgram(program, 1, &device,
                            "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt", NULL, NULL);
    if (status) {
        char log[4096] = "";
        clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, sizeof log, log, NULL);
        fprintf(stderr, "the kernel does not compile (%d):\n%s\n", status, log);
    }
    cl_kernel kernel = clCreateKernel(program, "evaluate", &status);
    cl_mem in = clCreateBuffer(context, CL_MEM_COPY_HOST_PTR, 3 * bytes, direction, &status);
    cl_mem out = clCreateBuffer(context, CL_MEM_WRITE_ONLY, bytes, NULL, &status);
    clSetKernelArg(kernel, 0, sizeof in, &in);
    clSetKernelArg(kernel, 1, sizeof out, &out);
    clEnqueueNDRangeKernel(queue, kernel, 1, NULL, &count, NULL, 0, NULL, NULL);
    status = clEnqueueReadBuffer(queue, out, CL_TRUE, 0, bytes, f, 0, NULL, NULL);
    clReleaseMemObject(out);
    clReleaseMemObject(in);
    clReleaseKernel(kernel);
    clReleaseProgram(program);
    clReleaseCommandQueue(queue);
    clReleaseContext(context);
    return status != CL_SUCCESS;
}

/* How many of the results differ in any bit from those of the same text compiled as C. */
static int count_differences(const float *direction, const float *f)
{
    struct brdf_roughconductor p = {0};
    p.eta = brdf_rgb_make(0.2586f, 1.0428f, 1.3037f);
    p.k = brdf_rgb_make(3.1989f, 2.6243f, 2.3474f);
    p.alpha_u = 0.2f;
    p.alpha_v = 0.4f;
    p.specular_reflectance = brdf_gray(1.0f);
    brdf_vec3 wo = brdf_vec3_make(0.6f, 0.0f, 0.8f);
    int differences = 0;
    for (int i = 0; i < COUNT; ++i) {
        const float *d = &direction[3 * i];
        float here = brdf_roughconductor_eval(p, wo, brdf_vec3_make(d[0], d[1], d[2]), NULL).r;
        differences += memcmp(&here, &f[i], sizeof here) != 0;
    }
    return differences;
}

int main(void)
{
    static float direction[3 * COUNT], f[COUNT];
    struct brdf_error error;
    char *text;
    cl_device_id device = first_device();
    if (!device) {
        printf("no OpenCL device here: install one, such as pocl-opencl-icd, and run this again\n");
        return 0;
    }
    if (brdf_source_expand(kernel_text, "own_kernel.cl", NULL, &text, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    spread_directions(direction);
    int failed = evaluate(device, text, direction, f);
    free(text);
    if (failed) {
        fprintf(stderr, "the OpenCL device could not run the kernel\n");
        return 1;
    }
    int differences = count_differences(direction, f);
    printf("%d values, %d of them with other bits than in C\n", COUNT, differences);
    return differences > 0;
}
