/*
 * support_bsdf.h - materials for tests.
 */
#ifndef SUPPORT_BSDF_H
#define SUPPORT_BSDF_H

#include <brdf/material.h>

/* A material from its description; the test fails, with the reason, where there is none. */
struct brdf_bsdf *bsdf_make(const char *description);

#endif
