/*
 * test_measured.c - values of the model measured: against the materials that its files were made
 * of, and published measurements where they are at hand.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include "rgl_pair.h"
#include "support_bsdf.h"

/* Albedo of `made` over that of `original`, and the mean |difference| over it. */
struct fidelity {
    double albedo;
    double difference;
};

static struct fidelity fidelity_of(const struct brdf_bsdf *made, const char *original)
{
    struct brdf_bsdf *truth = bsdf_make(original);
    struct brdfcl_random random = {1};
    double all = 0.0, sum = 0.0, off = 0.0;
    for (int i = 0; i < 50000; ++i) {
        brdf_vec3 wo = random_above(&random);
        struct brdf_sample s = brdf_sample(made, wo, random_cube(&random));
        if (s.pdf > 0.0f) {
            double wanted = (double)(brdf_eval(truth, wo, s.wi).g * s.wi.z / s.pdf);
            all += wanted;
            sum += (double)s.weight.g;
            off += fabs((double)s.weight.g - wanted);
        }
    }
    brdf_bsdf_destroy(truth);
    struct fidelity result = {sum / all, off / all};
    return result;
}

static void files_hold_what_they_were_made_of(void **state)
{
    struct rgl_pair *m = *state;
    struct fidelity glossy = fidelity_of(m->glossy, GLOSSY);
    struct fidelity brushed = fidelity_of(m->brushed, BRUSHED);
    print_message("    isotropic: albedo off by %.2f %%, f by %.2f %%; anisotropic %.2f, %.2f %%\n",
                  100.0 * (glossy.albedo - 1.0), 100.0 * glossy.difference,
                  100.0 * (brushed.albedo - 1.0), 100.0 * brushed.difference);
    assert_true(fabs(glossy.albedo - 1.0) < 0.01 && glossy.difference < 0.02);
    assert_true(fabs(brushed.albedo - 1.0) < 0.01 && brushed.difference < 0.022);
}

/* Finer grids come closer: what is off is the grid, not the model. */
static void finer_grids_come_closer(void **state)
{
    (void)state;
    double before = 1.0;
    for (int scale = 1; scale <= 2; ++scale) {
        struct brdf_rgl_grid grid = {
            .thetas = 8 * scale, .normals = 64 * scale, .size = 16 * scale};
        struct brdf_rgl_file file = rgl_test_make("roughconductor:alpha=0.4", &grid);
        struct brdf_bsdf *bsdf = rgl_test_load(&file);
        struct fidelity now = fidelity_of(bsdf, "roughconductor:alpha=0.4");
        print_message("    off by %.2f %%\n", 100.0 * now.difference);
        assert_true(now.difference < 0.75 * before);
        before = now.difference;
        brdf_bsdf_destroy(bsdf);
        brdf_rgl_free(&file);
    }
    assert_true(before < 0.018);
}

/* A constant spectrum is gray, and one that rises has the colour computed apart from this code. */
static void spectra_become_colours(void **state)
{
    (void)state;
    enum { COUNT = 48 };
    float wavelengths[COUNT];
    for (int i = 0; i < COUNT; ++i) {
        wavelengths[i] = 360.0f + 10.0f * (float)i;
    }
    struct brdf_rgl_grid grid = {
        .thetas = 3, .normals = 16, .size = 4, .channels = COUNT, .wavelengths = wavelengths};
    struct brdf_rgl_file rising = rgl_test_make("diffuse:reflectance=1", &grid);
    size_t square = 16, views = 3;
    struct brdf_rgl_file flat = rising;
    flat.values = malloc(views * COUNT * square * sizeof(float));
    flat.wavelengths = malloc(sizeof wavelengths);
    memcpy(flat.wavelengths, wavelengths, sizeof wavelengths);
    for (size_t i = 0; i < views * COUNT * square; ++i) {
        flat.values[i] = 0.75f;
    }
    float top = rising.values[47 * square]; /* at 830 nm the rising spectrum is f itself */
    assert_int_equal(brdf_rgl_to_rgb(&rising, NULL), BRDF_OK);
    assert_int_equal(brdf_rgl_to_rgb(&flat, NULL), BRDF_OK);
    assert_null(rising.wavelengths);
    /* CIE 1931 every nanometre, D65, the primaries and white of BT.709. */
    const double ramp[3] = {0.60093, 0.38938, 0.17196};
    for (size_t c = 0; c < 3; ++c) {
        assert_float_equal(flat.values[c * square], 0.75f, 1e-6f);
        assert_float_equal(rising.values[c * square] / top, (float)ramp[c], 3e-4f);
    }
    free(flat.values);
    brdf_rgl_free(&rising);
}

/* Mirrored in x and in y an anisotropic material of a quarter turn is the same. */
static void symmetries_hold(void **state)
{
    struct rgl_pair *m = *state;
    struct brdfcl_random random = {3};
    double asymmetric = 0.0;
    for (int i = 0; i < 50000; ++i) {
        brdf_vec3 wo = random_above(&random);
        brdf_vec3 wi = random_above(&random);
        float f = brdf_eval(m->brushed, wo, wi).g;
        brdf_vec3 a = brdf_vec3_make(-wo.x, wo.y, wo.z), b = brdf_vec3_make(-wi.x, wi.y, wi.z);
        assert_true(brdf_eval(m->brushed, a, b).g == f);
        a = brdf_vec3_make(wo.x, -wo.y, wo.z);
        b = brdf_vec3_make(wi.x, -wi.y, wi.z);
        assert_true(brdf_eval(m->brushed, a, b).g == f);
        a = brdf_vec3_make(-wo.y, wo.x, wo.z);
        b = brdf_vec3_make(-wi.y, wi.x, wi.z);
        asymmetric += fabs((double)(brdf_eval(m->brushed, a, b).g - f)) > 0.1 * (double)f;
    }
    assert_true(asymmetric > 25000.0); /* turned by a quarter it is another one */
}

/* Published measurements: albedos at 30 degrees as others find them. */
static void published_files_have_their_albedos(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        double albedo[3];
    } known[] = {{"paper_white", {0.826, 0.839, 0.980}},
                 {"acrylic_felt_pink", {0.583, 0.043, 0.181}},
                 {"colodur_azure_4e", {0.096, 0.158, 0.306}}};
    const char *data = getenv("BRDFCL_DATA") ? getenv("BRDFCL_DATA") : "../shared/data";
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        char path[4200];
        snprintf(path, sizeof path, "%s/rgl/%s_rgb.bsdf", data, known[k].name);
        if (access(path, R_OK) != 0) {
            print_message("    skipped, no data\n");
            skip();
        }
        enum { COUNT = 200000 };
        struct brdf_bsdf *bsdf = NULL;
        struct brdf_setting setting = brdf_setting_text("filename", path);
        assert_int_equal(brdf_bsdf_create_from("measured", &setting, 1, &bsdf, NULL), BRDF_OK);
        struct brdfcl_random random = {7};
        double sum[3] = {0.0, 0.0, 0.0};
        brdf_vec3 wo = brdf_vec3_make(0.5f, 0.0f, 0.866025404f);
        for (int i = 0; i < COUNT; ++i) {
            brdf_rgb weight = brdf_sample(bsdf, wo, random_cube(&random)).weight;
            sum[0] += (double)weight.r / COUNT;
            sum[1] += (double)weight.g / COUNT;
            sum[2] += (double)weight.b / COUNT;
        }
        for (int c = 0; c < 3; ++c) {
            assert_true(fabs(sum[c] - known[k].albedo[c]) < 0.005);
        }
        brdf_bsdf_destroy(bsdf);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_hold_what_they_were_made_of),
        cmocka_unit_test(finer_grids_come_closer),
        cmocka_unit_test(spectra_become_colours),
        cmocka_unit_test(symmetries_hold),
        cmocka_unit_test(published_files_have_their_albedos),
    };
    return cmocka_run_group_tests(tests, rgl_pair_make, rgl_pair_free);
}
