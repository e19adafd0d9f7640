/*
 * make_seeds.c - the seeds of the fuzzers: small valid files, and valid beginnings of large ones.
 *
 *   cc -Iinclude tests/fuzz/make_seeds.c build/libbrdf.a -lm -o make_seeds && ./make_seeds
 * tests/fuzz
 */
#include <stdio.h>
#include <string.h>

#include <brdf/rgl.h>

static void shine(const double wo[3], const double wi[3], int channels, const float *wavelengths,
                  double *values, void *data)
{
    double x = wo[0] + wi[0], y = wo[1] + wi[1], z = wo[2] + wi[2];
    (void)data;
    for (int i = 0; i < channels; ++i) {
        double part = wavelengths ? (double)wavelengths[i] / 700.0 : 0.4 + 0.2 * i;
        values[i] = part * (0.1 + z * z / (z * z + 4.0 * x * x + 9.0 * y * y));
    }
}

static int rgl_seed(const char *folder, const char *name, const struct brdf_rgl_grid *grid,
                    int jacobian)
{
    char path[1024];
    struct brdf_rgl_file file;
    struct brdf_error error;
    snprintf(path, sizeof path, "%s/rgl/%s.bsdf", folder, name);
    brdf_status status = brdf_rgl_make(shine, NULL, grid, &file, &error);
    if (!status) {
        file.jacobian = jacobian;
        status = brdf_rgl_write(path, &file, &error);
        brdf_rgl_free(&file);
    }
    if (status) {
        fprintf(stderr, "%s\n", error.message);
    }
    return status;
}

/* The layout of fuzz_merl.c, 4 x 3 x phi_d; some bins are invalid, `values` is 3 times all. */
static int merl_seed(const char *folder, const char *name, int phi_d, int values)
{
    char path[1024];
    unsigned char bytes[12 + 8 * 3 * 4 * 3 * 10] = {4, 0, 0, 0, 3, 0, 0, 0};
    bytes[8] = (unsigned char)phi_d;
    for (int i = 0; i < values; ++i) { /* 1, or -1 */
        memcpy(bytes + 12 + 8 * i, i % 7 ? "\0\0\0\0\0\0\xf0\x3f" : "\0\0\0\0\0\0\xf0\xbf", 8);
    }
    snprintf(path, sizeof path, "%s/merl/%s", folder, name);
    FILE *stream = fopen(path, "wb");
    size_t size = 12 + 8 * (size_t)values;
    return !stream || fwrite(bytes, 1, size, stream) != size || fclose(stream) != 0;
}

int main(int count, char **arguments)
{
    static const float wavelengths[] = {400.0f, 500.0f, 600.0f, 700.0f};
    const char *folder = count > 1 ? arguments[1] : "tests/fuzz";
    const struct brdf_rgl_grid isotropic = {.thetas = 2, .normals = 4, .size = 2};
    const struct brdf_rgl_grid turned = {
        .phis = 3, .symmetry = 2, .thetas = 2, .normals = 4, .size = 2};
    const struct brdf_rgl_grid spectral = {
        .thetas = 2, .normals = 4, .size = 2, .channels = 4, .wavelengths = wavelengths};
    return rgl_seed(folder, "isotropic", &isotropic, 1) ||
           rgl_seed(folder, "plain", &isotropic, 0) ||
           rgl_seed(folder, "anisotropic", &turned, 1) ||
           rgl_seed(folder, "spectral", &spectral, 1) ||
           merl_seed(folder, "half_turn", 5, 3 * 4 * 3 * 5) ||
           merl_seed(folder, "whole_turn", 10, 3 * 4 * 3 * 10) ||
           merl_seed(folder, "empty", 5, 0) || merl_seed(folder, "other", 9, 4);
}
