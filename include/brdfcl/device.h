/*
 * device.h - OpenCL devices, and programs built from the shared source.
 */
#ifndef BRDFCL_DEVICE_H
#define BRDFCL_DEVICE_H

#include <stddef.h>

#include <brdf/status.h>
#include <brdfcl/api.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a device says of itself; the strings are cut to their arrays, always terminated. */
struct brdfcl_device_info {
    char platform[128];
    char platform_version[128]; /* on PoCL: its version and LLVM's */
    char name[128];
    char version[128];
    char driver[128];
    int cpu;                    /* 1 for a processor: memory is shared with the host */
    int compute_units;          /* cores */
    int native_lanes;           /* CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT, at least 1 */
    unsigned long long memory;  /* bytes */
    unsigned long long largest; /* bytes of the largest buffer */
    int available;              /* 0: the device says that it cannot be used now */
};

/* How many devices all platforms have together; 0 where there is no OpenCL at all. */
BRDFCL_API int brdfcl_device_count(void);

/* Device `index`, 0 <= index < count, in the order of platforms and devices. */
BRDFCL_API brdf_status brdfcl_device_describe(int index, struct brdfcl_device_info *info,
                                              struct brdf_error *error);

/* An open device: context, queue, programs. One thread at a time. */
struct brdfcl_device;

/*
 * Open a device by number ("0") or by a part of its name or platform ("pocl", case ignored); NULL
 * or "" opens the first processor, or else the first device. `lanes` is 1, 4, 8, 16 or, for
 * evaluators and checks only, 32; 0 is the device's native width for renders and, on a processor,
 * twice that for evaluators. `threads` limits the cores of a processor, 0 = all (PoCL reads it once
 * a process, at its first use). BRDF_NO_DEVICE says what was looked for and what there is.
 */
BRDFCL_API brdf_status brdfcl_device_open(const char *choice, int lanes, int threads,
                                          struct brdfcl_device **device, struct brdf_error *error);

/* NULL is fine. */
BRDFCL_API void brdfcl_device_close(struct brdfcl_device *device);

BRDFCL_API struct brdfcl_device_info brdfcl_device_get_info(const struct brdfcl_device *device);

/* Lanes of renders, and of evaluators (brdfcl/evaluate.h). */
BRDFCL_API int brdfcl_device_lanes(const struct brdfcl_device *device);
BRDFCL_API int brdfcl_device_array_lanes(const struct brdfcl_device *device);

#ifdef __cplusplus
}
#endif

#endif
