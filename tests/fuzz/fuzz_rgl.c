/*
 * fuzz_rgl.c - any bytes as an RGL file: refused, or a material whose values are numbers.
 */
#define _POSIX_C_SOURCE 200809L

#include <math.h>
#include <string.h>

#include <brdf/material.h>
#include <brdf/rgl.h>

#include "fuzz_file.h"

static void demand(int truth)
{
    if (!truth) {
        abort();
    }
}

/* The material of an accepted file, from a few directions, grazing ones among them. */
static void evaluate(const struct brdf_bsdf *bsdf)
{
    static const float cosines[] = {1.0f, 0.7f, 0.1f, 1e-7f};
    for (int i = 0; i < 64; ++i) {
        float z = cosines[i % 4];
        float r = sqrtf(1.0f - z * z);
        brdf_vec3 wo = {i & 4 ? r : -0.6f * r, i & 4 ? 0.0f : 0.8f * r, z};
        brdf_vec3 u = {(float)(i / 8 % 3) / 2.0f * 0.99999994f, (float)(i % 5) / 5.0f, 0.5f};
        struct brdf_sample s = brdf_sample(bsdf, wo, u);
        brdf_vec3 wi = {0.36f, -0.48f, 0.8f};
        brdf_rgb f = brdf_eval(bsdf, wo, wi);
        float pdf = brdf_pdf(bsdf, wo, wi);
        demand(isfinite(s.wi.x) && isfinite(s.wi.y) && isfinite(s.wi.z));
        demand(isfinite(s.pdf) && s.pdf >= 0.0f && isfinite(pdf) && pdf >= 0.0f);
        demand(isfinite(s.weight.r) && isfinite(s.weight.g) && isfinite(s.weight.b));
        demand(isfinite(f.r) && f.r >= 0.0f && isfinite(f.g) && isfinite(f.b));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct brdf_rgl_file file;
    struct brdf_error error = {BRDF_OK, ""};
    const char *path = fuzz_file(bytes, size);
    brdf_status status = brdf_rgl_read(path, &file, &error);
    demand(status == BRDF_OK || (error.status == status && strlen(error.message) > 10));
    if (status == BRDF_OK) {
        struct brdf_bsdf *bsdf = NULL;
        struct brdf_setting setting = brdf_setting_text("filename", path);
        demand(brdf_bsdf_create_from("measured", &setting, 1, &bsdf, &error) == BRDF_OK);
        evaluate(bsdf);
        brdf_bsdf_destroy(bsdf);
    }
    brdf_rgl_free(&file);
    return 0;
}
