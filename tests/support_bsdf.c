/*
 * support_bsdf.c - see support_bsdf.h.
 */
#include "support_bsdf.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

struct brdf_bsdf *bsdf_make(const char *description)
{
    struct brdf_bsdf *bsdf = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    if (brdf_bsdf_create(description, &bsdf, &error)) {
        fail_msg("%s: %s", description, error.message);
    }
    return bsdf;
}
