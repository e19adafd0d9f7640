/* needs: brdf */
/*
 * one_header.c - a single model header in a hot loop: no library, no calls, everything inlined.
 *
 * It measures how much of the light that falls in at an angle a rough metal sends back, by
 * sampling.
 */
#include <stdio.h>

#include <brdf/model/roughconductor.h>

/* Numbers in [0, 1), well spread: the R3 sequence [Roberts 2018]. */
static float spread(unsigned i, unsigned step)
{
    return (float)(i * step >> 8) / 16777216.0f;
}

static double albedo(struct brdf_roughconductor p, brdf_vec3 wo, unsigned count)
{
    double sum = 0.0;
    for (unsigned i = 0; i < count; ++i) {
        brdf_vec3 u =
            brdf_vec3_make(spread(i, 3518319155u), spread(i, 2882110345u), spread(i, 2360945575u));
        struct brdf_sample s = brdf_roughconductor_sample(p, wo, u, NULL);
        sum += (double)s.weight.r;
    }
    return sum / count;
}

int main(void)
{
    struct brdf_roughconductor p = {0};
    p.eta = brdf_rgb_make(0.2586f, 1.0428f, 1.3037f); /* copper */
    p.k = brdf_rgb_make(3.1989f, 2.6243f, 2.3474f);
    p.specular_reflectance = brdf_gray(1.0f);
    for (int i = 1; i <= 8; ++i) {
        p.alpha_u = p.alpha_v = 0.1f * (float)i;
        printf("alpha %.1f: red albedo %.4f at 0 degrees, %.4f at 60\n", (double)p.alpha_u,
               albedo(p, brdf_vec3_make(0.0f, 0.0f, 1.0f), 100000),
               albedo(p, brdf_vec3_make(0.8660254f, 0.0f, 0.5f), 100000));
    }
    return 0;
}
