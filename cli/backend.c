/* backend.c - where to compute. */
#include "backend.h"

#include <stddef.h>

#include "options.h"
#include "say.h"

int backend_check(const struct backend *backend)
{
    if (backend->kind == BACKEND_C && backend->device) {
        return say_usage("--device chooses among OpenCL devices; --backend c uses none");
    }
    if (backend->kind == BACKEND_C && backend->lanes) {
        return say_usage("--lanes is about OpenCL kernels; --backend c has none");
    }
    return OPTIONS_GO_ON;
}

brdf_status backend_open(const struct backend *backend, struct brdfcl_device **device,
                         struct brdf_error *error)
{
    *device = NULL;
    if (backend->kind == BACKEND_C) {
        return BRDF_OK;
    }
    return brdfcl_device_open(backend->device, backend->lanes, backend->threads, device, error);
}
