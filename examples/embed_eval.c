/* needs: brdf */
/*
 * embed_eval.c - libbrdf in 30 lines: a material from one line of text, evaluated and sampled.
 */
#include <stdio.h>

#include <brdf/brdf.h>

int main(int argc, char **argv)
{
    const char *description = argc > 1 ? argv[1] : "roughconductor:material=Cu,alpha=0.2";
    struct brdf_bsdf *bsdf;
    struct brdf_error error;
    if (brdf_bsdf_create(description, &bsdf, &error)) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    brdf_vec3 wo = brdf_vec3_make(0.6f, 0.0f, 0.8f);
    brdf_vec3 wi = brdf_vec3_make(-0.6f, 0.0f, 0.8f);
    brdf_rgb f = brdf_eval(bsdf, wo, wi);
    struct brdf_sample s = brdf_sample(bsdf, wo, brdf_vec3_make(0.3f, 0.7f, 0.5f));
    printf("f      = %g %g %g [1/sr]\n", (double)f.r, (double)f.g, (double)f.b);
    printf("pdf    = %g [1/sr]\n", (double)brdf_pdf(bsdf, wo, wi));
    printf("sample = %g %g %g, weight %g %g %g\n", (double)s.wi.x, (double)s.wi.y, (double)s.wi.z,
           (double)s.weight.r, (double)s.weight.g, (double)s.weight.b);
    brdf_bsdf_destroy(bsdf);
    return 0;
}
