/*
 * test_models_coating.c - a rough interface over a diffuse base: the table, and roughplastic.
 *
 * What passes and what is thrown back is from quadratures made apart from this project's code: over
 * visible normals, or over slopes, with hundreds of thousands of nodes each.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include <brdf/coating.h>
#include <brdf/microfacet.h>

#include "support_bsdf.h"
#include "support_models.h"

enum { COSINES = 5 };

static const float cosines[COSINES] = {0.05f, 0.2f, 0.5f, 0.8f, 1.0f};

static const struct {
    int distribution;
    float alpha;
    float eta;
    double pass[COSINES];
    double inside;
} known[] = {
    {BRDF_BECKMANN, 0.05f, 1.49f, {0.32661, 0.66705, 0.91203, 0.95733, 0.96127}, 0.58854},
    {BRDF_BECKMANN, 0.2f, 1.33f, {0.64354, 0.77066, 0.93454, 0.97581, 0.97991}, 0.44275},
    {BRDF_BECKMANN, 0.5f, 1.5f, {0.78777, 0.83789, 0.90282, 0.94479, 0.95855}, 0.44774},
    {BRDF_BECKMANN, 1.0f, 1.8f, {0.66877, 0.73944, 0.83315, 0.87961, 0.90417}, 0.35669},
    {BRDF_BECKMANN, 2.0f, 2.4f, {0.35670, 0.41832, 0.53376, 0.64096, 0.70356}, 0.17471},
    {BRDF_GGX, 0.05f, 1.49f, {0.43016, 0.68317, 0.91082, 0.95663, 0.96108}, 0.57859},
    {BRDF_GGX, 0.2f, 1.33f, {0.69846, 0.79358, 0.92529, 0.96908, 0.97726}, 0.36930},
    {BRDF_GGX, 0.5f, 1.5f, {0.57267, 0.69700, 0.83976, 0.91387, 0.93993}, 0.29386},
    {BRDF_GGX, 1.0f, 1.8f, {0.34273, 0.44855, 0.62123, 0.75603, 0.82365}, 0.18692},
    {BRDF_GGX, 2.0f, 2.4f, {0.14386, 0.19450, 0.29688, 0.41161, 0.50447}, 0.07356},
    {BRDF_BECKMANN, 0.05f, 0.67114094f, {0.00000, 0.00000, 0.00000, 0.87362, 0.96127}, 0.08852},
    {BRDF_BECKMANN, 0.4f, 0.67114094f, {0.00000, 0.00000, 0.08232, 0.58372, 0.94699}, 0.06008},
    {BRDF_BECKMANN, 1.2f, 1.05f, {0.25378, 0.51427, 0.83297, 0.97778, 0.99779}, 0.00452},
    {BRDF_GGX, 0.1f, 0.41666667f, {0.00126, 0.00288, 0.00421, 0.02717, 0.78932}, 0.19529},
    {BRDF_GGX, 0.3f, 1.05f, {0.53307, 0.78573, 0.94308, 0.98638, 0.99803}, 0.02825},
    {BRDF_GGX, 1.5f, 0.76923077f, {0.01041, 0.11510, 0.35489, 0.45019, 0.34609}, 0.00448},
};

static void table_has_the_quadratures(void **state)
{
    (void)state;
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        char text[120];
        size_t words;
        float eta = known[k].eta;
        snprintf(text, sizeof text, "roughplastic:distribution=%s,int_ior=%.9g,ext_ior=%.9g",
                 known[k].distribution == BRDF_GGX ? "ggx" : "beckmann",
                 (double)(eta > 1.0f ? eta : 1.0f), (double)(eta > 1.0f ? 1.0f : 1.0f / eta));
        struct brdf_bsdf *bsdf = bsdf_make(text);
        const float *table = brdf_bsdf_table(bsdf, &words);
        struct brdf_coating coating = brdf_coating_make(table, known[k].alpha, 0);
        for (int i = 0; i < COSINES; ++i) {
            double pass = (double)brdf_coating_view_of(table, coating, 0, cosines[i]).pass;
            if (!(fabs(pass - known[k].pass[i]) <= 7e-4)) {
                fail_msg("row %zu, cos = %g: %.5f passes, known %.5f", k, (double)cosines[i], pass,
                         known[k].pass[i]);
            }
        }
        double inside = 1.0 - (double)coating.escape;
        if (!(fabs(inside - known[k].inside) <= 5e-4)) {
            fail_msg("row %zu: %.5f is thrown back, known %.5f", k, inside, known[k].inside);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* What is sent to wo of light from everywhere, deltas included. */
static double albedo_of(const struct brdf_bsdf *bsdf, float cosine)
{
    size_t count = models_long() ? 1 << 20 : 1 << 15;
    brdf_vec3 wo = brdf_vec3_make(sqrtf(1.0f - cosine * cosine), 0.0f, cosine);
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        sum += (double)brdf_sample(bsdf, wo, models_even_point(i, count)).weight.g;
    }
    return sum / (double)count;
}

/* As the roughness vanishes, so does the difference from plastic. */
static void smooth_is_plastic(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        {"roughplastic:alpha=0.0002,nonlinear=true,diffuse_reflectance=0.8",
         "plastic:nonlinear=true,diffuse_reflectance=0.8"},
        {"roughplastic:alpha=0.0002,distribution=ggx,int_ior=1.8",
         "plastic:int_ior=1.8,nonlinear=false"},
    };
    for (size_t k = 0; k < 2; ++k) {
        struct brdf_bsdf *rough = bsdf_make(pairs[k][0]);
        struct brdf_bsdf *smooth = bsdf_make(pairs[k][1]);
        for (int i = 0; i < COSINES; ++i) {
            double a = albedo_of(rough, cosines[i]);
            double b = albedo_of(smooth, cosines[i]);
            if (!(fabs(a - b) <= 5e-3)) {
                fail_msg("%s, cos = %g: %.5f, smooth %.5f", pairs[k][0], (double)cosines[i], a, b);
            }
        }
        brdf_bsdf_destroy(rough);
        brdf_bsdf_destroy(smooth);
    }
}

/* Even over a white base never more than all, and of little roughness nearly all. */
static void white_base_gains_nothing(void **state)
{
    (void)state;
    static const float alphas[] = {1e-3f, 0.01f, 0.1f, 0.3f, 1.0f, 2.0f};
    for (size_t k = 0; k < 2 * sizeof alphas / sizeof alphas[0]; ++k) {
        char text[160];
        snprintf(text, sizeof text,
                 "roughplastic:distribution=%s,alpha=%g,nonlinear=true,diffuse_reflectance=1",
                 k % 2 ? "ggx" : "beckmann", (double)alphas[k / 2]);
        struct brdf_bsdf *bsdf = bsdf_make(text);
        for (int i = 0; i < COSINES; ++i) {
            double all = albedo_of(bsdf, cosines[i]);
            double least = alphas[k / 2] > 0.01f ? 0.0 : cosines[i] < 0.1f ? 0.9 : 0.98;
            if (!(all <= 1.004 && all >= least)) {
                fail_msg("%s reflects %.5f at cos = %g", text, all, (double)cosines[i]);
            }
        }
        brdf_bsdf_destroy(bsdf);
    }
}

/* The lobe alone: known reflectances of GGX, alpha = 0.5, index 1.5, separable masking. */
static void black_base_is_the_interface(void **state)
{
    (void)state;
    static const float places[4] = {0.1f, 0.25f, 0.5f, 1.0f};
    static const double reflected[4] = {0.08352, 0.06407, 0.04285, 0.02817};
    struct brdf_bsdf *bsdf = bsdf_make(
        "roughplastic:distribution=ggx,alpha=0.5,int_ior=1.5,ext_ior=1,diffuse_reflectance=0");
    for (int i = 0; i < 4; ++i) {
        double all = albedo_of(bsdf, places[i]);
        if (!(fabs(all - reflected[i]) <= 5e-4)) {
            fail_msg("%.5f at cos = %g, known %.5f", all, (double)places[i], reflected[i]);
        }
    }
    brdf_bsdf_destroy(bsdf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(table_has_the_quadratures),
        cmocka_unit_test(smooth_is_plastic),
        cmocka_unit_test(white_base_gains_nothing),
        cmocka_unit_test(black_base_is_the_interface),
    };
    return cmocka_run_group_tests_name("coating", tests, NULL, NULL);
}
