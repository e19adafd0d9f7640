/* test_surface.c - evaluating bsdfs: the model itself, both sides of it, and arrays of directions.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include <brdf/brdf.h>
#include <brdf/surface.h>

#include "support_bsdf.h"

enum { COUNT = 1003 }; /* no multiple of any number of lanes */

/* Every model that needs no file; tables have tests of their own. */
static const char *const descriptions[] = {
    "diffuse:reflectance=0.2/0.4/0.6",
    "diffuse:reflectance=0.2/0.4/0.6,twosided",
    "phong:exponent=20,twosided",
    "roughconductor:material=Au,alpha_u=0.1,alpha_v=0.4",
    "roughconductor:distribution=ggx,masking=separable,alpha=0.3,twosided",
    "dielectric:int_ior=bk7",
};

struct arrays {
    float wo[3][COUNT];
    float wi[3][COUNT];
    float u[3][COUNT];
};

static float uniform(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(*state >> 8) / 16777216.0f;
}

static brdf_vec3 get(float a[3][COUNT], int i)
{
    return brdf_vec3_make(a[0][i], a[1][i], a[2][i]);
}

static struct brdf_vectors vectors(float a[3][COUNT])
{
    struct brdf_vectors v = {a[0], a[1], a[2]};
    return v;
}

/* Directions on the whole sphere, wi near the mirror direction half of the time. */
static void fill(struct arrays *a)
{
    uint32_t state = 1;
    for (int i = 0; i < COUNT; ++i) {
        brdf_vec3 w[2];
        for (int k = 0; k < 2; ++k) {
            float x = uniform(&state), y = uniform(&state);
            w[k] = brdf_warp_sphere(x, y);
        }
        if (i % 2) {
            w[1] = brdf_add(brdf_vec3_make(-w[0].x, -w[0].y, w[0].z), brdf_scale(w[1], 0.2f));
            w[1] = brdf_normalize(w[1]);
        }
        for (int k = 0; k < 2; ++k) {
            float(*to)[COUNT] = k ? a->wi : a->wo;
            to[0][i] = w[k].x;
            to[1][i] = w[k].y;
            to[2][i] = w[k].z;
        }
        for (int k = 0; k < 3; ++k) {
            a->u[k][i] = uniform(&state);
        }
    }
}

static void arrays_give_the_same_bits(void **state)
{
    (void)state;
    static struct arrays a;
    static float f[3][COUNT], pdf[COUNT], s[8][COUNT];
    static int delta[COUNT];
    fill(&a);
    for (size_t d = 0; d < sizeof descriptions / sizeof descriptions[0]; ++d) {
        struct brdf_bsdf *bsdf = bsdf_make(descriptions[d]);
        struct brdf_colors colors = {f[0], f[1], f[2]};
        struct brdf_samples samples = {s[0], s[1], s[2], {s[3], s[4], s[5]}, s[6], s[7], delta};
        brdf_eval_many(bsdf, COUNT, vectors(a.wo), vectors(a.wi), colors);
        brdf_pdf_many(bsdf, COUNT, vectors(a.wo), vectors(a.wi), pdf);
        brdf_sample_many(bsdf, COUNT, vectors(a.wo), vectors(a.u), samples);
        for (int i = 0; i < COUNT; ++i) {
            brdf_rgb c = brdf_eval(bsdf, get(a.wo, i), get(a.wi, i));
            float p = brdf_pdf(bsdf, get(a.wo, i), get(a.wi, i));
            struct brdf_sample one = brdf_sample(bsdf, get(a.wo, i), get(a.u, i));
            const float single[] = {c.r,          c.g,          c.b,      p,
                                    one.wi.x,     one.wi.y,     one.wi.z, one.weight.r,
                                    one.weight.g, one.weight.b, one.pdf,  one.eta};
            const float many[] = {f[0][i], f[1][i], f[2][i], pdf[i],  s[0][i], s[1][i],
                                  s[2][i], s[3][i], s[4][i], s[5][i], s[6][i], s[7][i]};
            assert_memory_equal(single, many, sizeof single);
            assert_int_equal(delta[i], one.delta != 0);
        }
        samples.eta = NULL;
        samples.delta = NULL;
        brdf_sample_many(bsdf, COUNT, vectors(a.wo), vectors(a.u), samples);
        brdf_bsdf_destroy(bsdf);
    }
}

/* The numbers that the host API gives are those of the model's own functions. */
static void the_api_adds_nothing(void **state)
{
    (void)state;
    static struct arrays a;
    fill(&a);
    struct brdf_bsdf *bsdf = bsdf_make("diffuse:reflectance=0.2/0.4/0.6");
    struct brdf_diffuse p = {brdf_rgb_make(0.2f, 0.4f, 0.6f)};
    int lit = 0;
    for (int i = 0; i < COUNT; ++i) {
        brdf_rgb x = brdf_eval(bsdf, get(a.wo, i), get(a.wi, i));
        brdf_rgb y = brdf_diffuse_eval(p, get(a.wo, i), get(a.wi, i), NULL);
        assert_memory_equal(&x, &y, sizeof x);
        lit += x.g > 0.0f;
    }
    assert_in_range(lit, COUNT / 5, COUNT / 2);
    brdf_bsdf_destroy(bsdf);
}

static brdf_vec3 mirrored(brdf_vec3 w)
{
    return brdf_vec3_make(w.x, w.y, -w.z);
}

static void two_sides_are_mirror_images(void **state)
{
    (void)state;
    static struct arrays a;
    fill(&a);
    struct brdf_bsdf *one = bsdf_make("roughconductor:alpha=0.4");
    struct brdf_bsdf *two = bsdf_make("roughconductor:alpha=0.4,twosided");
    int below = 0;
    for (int i = 0; i < COUNT; ++i) {
        brdf_vec3 wo = get(a.wo, i), wi = get(a.wi, i), u = get(a.u, i);
        int flip = wo.z < 0.0f;
        brdf_vec3 up_o = flip ? mirrored(wo) : wo, up_i = flip ? mirrored(wi) : wi;
        brdf_rgb x = brdf_eval(two, wo, wi), y = brdf_eval(one, up_o, up_i);
        assert_memory_equal(&x, &y, sizeof x);
        float px = brdf_pdf(two, wo, wi), py = brdf_pdf(one, up_o, up_i);
        assert_memory_equal(&px, &py, sizeof px);
        struct brdf_sample sx = brdf_sample(two, wo, u), sy = brdf_sample(one, up_o, u);
        sy.wi = flip ? mirrored(sy.wi) : sy.wi;
        assert_memory_equal(&sx, &sy, sizeof sx);
        below += flip && x.r > 0.0f;
        if (flip) {
            assert_true(brdf_eval(one, wo, wi).r == 0.0f);
            assert_true(brdf_sample(one, wo, u).pdf == 0.0f);
        }
    }
    assert_true(below > COUNT / 8);
    brdf_bsdf_destroy(one);
    brdf_bsdf_destroy(two);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays_give_the_same_bits),
        cmocka_unit_test(the_api_adds_nothing),
        cmocka_unit_test(two_sides_are_mirror_images),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
