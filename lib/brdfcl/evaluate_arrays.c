/*
 * evaluate_arrays.c - see evaluate_arrays.h.
 */
#include "evaluate_arrays.h"

/*
 * Planes are some cache lines further apart than their elements: at a power of two all of them
 * would fall into one set of the cache, which has room for fewer than an operation uses (five times
 * slower for `diffuse`). A multiple of all lanes, or packets would not begin where planes do.
 */
enum { APART = 96, COUNT_MAX = 1 << 30 };

void evaluate_arrays_release(struct evaluate_arrays *arrays)
{
    if (arrays->input) {
        clReleaseMemObject(arrays->input);
    }
    if (arrays->output) {
        clReleaseMemObject(arrays->output);
    }
    arrays->input = NULL;
    arrays->output = NULL;
    arrays->padded = 0;
    arrays->stride = 0;
}

/* One number in a whole plane: what pads the arrays must be a direction, too. */
static brdf_status fill_plane(struct evaluate_arrays *arrays, size_t plane, float value,
                              struct brdf_error *error)
{
    size_t bytes = arrays->stride * sizeof(float);
    cl_int cl = clEnqueueFillBuffer(arrays->device->queue, arrays->input, &value, sizeof value,
                                    plane * bytes, bytes, 0, NULL, NULL);
    return opencl_check(cl, "clEnqueueFillBuffer", error);
}

brdf_status evaluate_arrays_fit(struct evaluate_arrays *arrays, size_t count,
                                struct brdf_error *error)
{
    if (count > COUNT_MAX) {
        return brdf_fail(error, BRDF_OUT_OF_RANGE,
                         "%zu elements are too many for one call: at most %d", count, COUNT_MAX);
    }
    size_t padded = (count + EVALUATE_PADDING - 1) / EVALUATE_PADDING * EVALUATE_PADDING;
    size_t stride = padded + APART;
    if (padded == arrays->padded) {
        return BRDF_OK;
    }
    evaluate_arrays_release(arrays);
    brdf_status status = opencl_buffer(arrays->device, EVALUATE_IN_PLANES * stride * sizeof(float),
                                       &arrays->input, error);
    if (!status) {
        status = opencl_buffer(arrays->device, EVALUATE_OUT_PLANES * stride * sizeof(float),
                               &arrays->output, error);
    }
    if (status) {
        evaluate_arrays_release(arrays);
        return status;
    }
    arrays->padded = padded;
    arrays->stride = stride;
    for (size_t plane = 0; plane < EVALUATE_IN_PLANES && !status; ++plane) {
        float value = plane >= EVALUATE_IN_U ? 0.5f : plane % 3 == 2 ? 1.0f : 0.0f;
        status = fill_plane(arrays, plane, value, error);
    }
    return status;
}

brdf_status evaluate_arrays_put(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                struct brdf_vectors vectors, struct brdf_error *error)
{
    const float *const axes[3] = {vectors.x, vectors.y, vectors.z};
    cl_int cl = CL_SUCCESS;
    for (size_t i = 0; i < 3 && cl == CL_SUCCESS; ++i) {
        cl = clEnqueueWriteBuffer(arrays->device->queue, arrays->input, CL_TRUE,
                                  (plane + i) * arrays->stride * sizeof(float),
                                  count * sizeof(float), axes[i], 0, NULL, NULL);
    }
    return opencl_check(cl, "clEnqueueWriteBuffer", error);
}

brdf_status evaluate_arrays_get(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                void *to, struct brdf_error *error)
{
    if (!to) {
        return BRDF_OK;
    }
    cl_int cl = clEnqueueReadBuffer(arrays->device->queue, arrays->output, CL_TRUE,
                                    plane * arrays->stride * sizeof(float), count * sizeof(float),
                                    to, 0, NULL, NULL);
    return opencl_check(cl, "clEnqueueReadBuffer", error);
}

brdf_status evaluate_arrays_get_colors(struct evaluate_arrays *arrays, size_t plane, size_t count,
                                       struct brdf_colors to, struct brdf_error *error)
{
    brdf_status status = evaluate_arrays_get(arrays, plane, count, to.r, error);
    status = status ? status : evaluate_arrays_get(arrays, plane + 1, count, to.g, error);
    return status ? status : evaluate_arrays_get(arrays, plane + 2, count, to.b, error);
}
