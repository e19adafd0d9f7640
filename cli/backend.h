/*
 * backend.h - the options that choose where to compute, the same in every subcommand that has them.
 */
#ifndef BRDFCL_BACKEND_H
#define BRDFCL_BACKEND_H

#include <brdfcl/device.h>

enum backend_kind { BACKEND_OPENCL, BACKEND_C };

/* The names in the order of enum backend_kind, for OPTION_CHOICE. */
#define BACKEND_NAMES "opencl|c"

struct backend {
    int kind;           /* enum backend_kind */
    const char *device; /* NULL = the first processor */
    int lanes;          /* 0 = the device's own */
    int threads;        /* 0 = all */
};

/* Refuse options of OpenCL where the backend is C; EXIT_USAGE, or OPTIONS_GO_ON. */
int backend_check(const struct backend *backend);

/* Open the device of the backend; leaves NULL for C. The caller closes it. */
brdf_status backend_open(const struct backend *backend, struct brdfcl_device **device,
                         struct brdf_error *error);

#endif
